"""Answers of the API, checked to be what they are declared to be, nothing more and nothing less."""

from __future__ import annotations

from typing import Any

import httpx
from pydantic import TypeAdapter


def json_of(kind: type, answer: httpx.Response) -> Any:
    """The JSON of an answer of this kind."""
    assert answer.status_code == 200, answer.text
    TypeAdapter(kind).validate_json(answer.content, strict=True, extra="forbid")
    return answer.json()
