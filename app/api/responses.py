"""Answers written by hand; they go as routes return typed ones."""

from collections.abc import Mapping
from typing import Any

import orjson
from starlette.responses import Response

from app.answers.answer import Table
from app.answers.answer import number_or_none as number_or_null
from app.answers.interface import CONVENTION, InterfaceFacts
from app.answers.rounding import round_significant, rounded
from app.http.writing import CSV, JSON, csv_bytes, shown_as
from app.optics.parameters import Array

__all__ = [
    "CONVENTION",
    "CSV",
    "ReadyBody",
    "csv_body",
    "interface_json",
    "json_body",
    "number_or_null",
    "round_significant",
    "rounded",
    "shown_as",
]

interface_json = InterfaceFacts.of


def json_body(payload: Any, digits: int = 17, headers: Mapping[str, str] | None = None) -> Response:
    """Write by hand."""
    body = orjson.dumps(rounded(payload, digits), option=orjson.OPT_SERIALIZE_NUMPY)
    return Response(body, headers=headers, media_type=JSON)


def csv_body(
    columns: Mapping[str, Array],
    digits: int = 17,
    filename: str = "fresnel.csv",
    headers: Mapping[str, str] | None = None,
) -> Response:
    """Write by hand."""
    headers = {**shown_as(filename), **(headers or {})}
    return Response(csv_bytes(Table(columns), digits), headers=headers, media_type=CSV)


def ReadyBody(
    body: bytes, media_type: str, headers: Mapping[str, str] | None = None, **_: Any
) -> Response:
    """Write by hand."""
    return Response(body, headers=headers, media_type=media_type)
