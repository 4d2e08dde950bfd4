"""The form of the generated JSON: one key or preset to a line, so that differences can be read."""

import json
from typing import Any

from pydantic import BaseModel


def object_text(model: BaseModel) -> str:
    """Return a JSON object with one line for each of its keys."""
    fields = model.model_dump(mode="json")
    return "{\n" + ",\n".join(f" {_text(key)}: {_text(fields[key])}" for key in fields) + "\n}\n"


def list_text(head: dict[str, Any], name: str, items: list[dict[str, Any]]) -> str:
    """Return a JSON object with a head and a list with one line for each of its items."""
    lines = [f" {_text(key)}: {_text(value)}" for key, value in head.items()]
    body = ",\n".join(f"  {_text(item)}" for item in items)
    return "{\n" + ",\n".join([*lines, f" {_text(name)}: [\n{body}\n ]"]) + "\n}\n"


def _text(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
