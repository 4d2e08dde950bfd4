"""Answers as they are read: of the shape that OpenAPI tells, a table, or one error."""

import csv
import io
import re
from collections.abc import Callable
from functools import cache
from typing import Any

import httpx
import jsonschema_rs
from fastapi import FastAPI

Ask = Callable[..., httpx.Response]
"""The fixture `ask`, which checks the shape of every JSON answer."""


def check_shape(app: FastAPI, path: str, answer: Any) -> None:
    """Compare a JSON answer to GET with what the schema of its route says.

    Parameters
    ----------
    app
        The application.
    path
        The whole path, without query.
    answer
        The JSON, read.
    """
    for template, validator in _validators(app).items():
        if re.fullmatch(
            re.sub(r"\{\w+\}", ".+" if "{material}" in template else "[^/]+", template), path
        ):
            validator.validate(answer)
            return
    raise LookupError(path)


def json_of(answer: httpx.Response) -> Any:
    """The JSON of a good answer."""
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "application/json"
    return answer.json()


def rows_of(answer: httpx.Response) -> list[dict[str, str]]:
    """The rows of a good answer in CSV."""
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    return list(csv.DictReader(io.StringIO(answer.text)))


def error_of(answer: httpx.Response, status: int = 422) -> dict[str, Any]:
    """The one error of a refusal."""
    assert answer.status_code == status, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    (error,) = answer.json()["errors"]
    return dict(error)


@cache
def _validators(app: FastAPI) -> dict[str, jsonschema_rs.Validator]:
    told = app.openapi()
    components = _closed(told["components"])
    found: dict[str, jsonschema_rs.Validator] = {}
    # What has no parameter in its path is told apart first: /models/{id} is not /models/id.
    for path, operations in sorted(told["paths"].items(), key=lambda item: "{" in item[0]):
        content = operations.get("get", {}).get("responses", {}).get("200", {}).get("content", {})
        if "application/json" in content:
            schema = {**content["application/json"]["schema"], "components": components}
            found[path] = jsonschema_rs.Draft202012Validator(schema)
    return found


def _closed(schema: Any) -> Any:
    """Allow no keys but those that are described, where some are."""
    if isinstance(schema, list):
        return [_closed(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    closed = {key: _closed(part) for key, part in schema.items()}
    if "properties" in schema and schema.get("type") == "object":
        closed.setdefault("additionalProperties", False)
    return closed
