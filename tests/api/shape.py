"""Answers are of the shape that OpenAPI tells, and have nothing beside."""

import json
import re
from functools import cache
from types import SimpleNamespace
from typing import Any

import jsonschema_rs
from fastapi import FastAPI


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
        if re.fullmatch(re.sub(r"\{\w+\}", "[^/]+", template), path):
            validator.validate(answer)
            return
    raise LookupError(path)


def fields_of(body: bytes) -> Any:
    """Read JSON with its keys as attributes."""
    return json.loads(body, object_hook=lambda entries: SimpleNamespace(**entries))


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
