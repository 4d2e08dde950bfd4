"""Answers of the API, read once they are checked to be what they are declared to be."""

import csv
import io
from typing import Any

import httpx
from pydantic import TypeAdapter


def json_of(kind: type, answer: httpx.Response) -> Any:
    """The JSON of an answer of this kind."""
    assert answer.status_code == 200, answer.text
    TypeAdapter(kind).validate_json(answer.content, strict=True, extra="forbid")
    return answer.json()


def rows_of(answer: httpx.Response) -> list[dict[str, str]]:
    """The rows of an answer in CSV."""
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    return list(csv.DictReader(io.StringIO(answer.text)))


def refused(answer: httpx.Response) -> str:
    """The name of the one parameter that is refused."""
    assert answer.status_code == 422, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    (error,) = answer.json()["errors"]
    return str(error["parameter"])
