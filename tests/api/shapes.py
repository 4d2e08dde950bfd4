"""Answers of the API read back as what they are declared to be, nothing more and nothing less."""

from __future__ import annotations

from typing import TypeVar

import httpx
from pydantic import TypeAdapter

T = TypeVar("T")


def read_as(kind: type[T], answer: httpx.Response) -> T:
    """Read an answer, strictly; arrays become lists."""
    assert answer.status_code == 200, answer.text
    return TypeAdapter(kind).validate_json(answer.content, strict=True, extra="forbid")
