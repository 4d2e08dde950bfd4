"""What an answer is: a frozen dataclass that orjson writes and pydantic describes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Annotated, Any, TypeVar, dataclass_transform

import numpy as np
from pydantic import ConfigDict, Field, GetCoreSchemaHandler
from pydantic_core import CoreSchema

from app.optics.errors import NotAllowed
from app.optics.parameters import Array

T = TypeVar("T")

_CONFIG = ConfigDict(
    use_attribute_docstrings=True,
    arbitrary_types_allowed=True,
    json_schema_serialization_defaults_required=True,  # every field is sent
)


@dataclass_transform(frozen_default=True, kw_only_default=True)
def answer(cls: type[T]) -> type[T]:
    """Make a class an answer: a frozen dataclass of keywords whose fields OpenAPI describes.

    A string below a field is its description. Arrays are annotated by `Values` or `Rows`, which
    say what JSON they become.
    """
    # Without slots, which orjson takes twice as long to write and which leave room for one parent.
    made = dataclass(frozen=True, kw_only=True)(cls)
    made.__pydantic_config__ = _CONFIG  # type: ignore[attr-defined]
    return made


def filled(kind: type[T], source: object, /, **given: Any) -> T:
    """Make an answer of what is given and, for its other fields, of the attributes of `source`."""
    names = {field.name for field in fields(kind)} - given.keys()  # type: ignore[arg-type]
    return kind(**{name: getattr(source, name) for name in names}, **given)


@dataclass(frozen=True, slots=True)
class SentAs:
    """Tells pydantic which JSON an array becomes."""

    kind: Any

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Describe the array as what it is sent as."""
        return handler.generate_schema(self.kind)


Values = Annotated[Array, SentAs(list[float])]
"""Numbers that are all defined."""

Gaps = Annotated[Array, SentAs(list[float | None])]
"""Numbers of which NaN stands for undefined ones, null in JSON."""

Rows = Annotated[Array, SentAs(list[list[float | None]])]
"""Rows of numbers; NaN is null in JSON."""


@dataclass(frozen=True, slots=True)
class Table:
    """An answer in columns, for CSV."""

    columns: Mapping[str, Array | Sequence[Any]]
    """What stands below each header: arrays of numbers, or lists of words and numbers."""
    filename: str = "fresnel.csv"
    """Name for the file."""


ChosenFields = Annotated[
    dict[str, Any], Field(description="The fields named in `fields`, where it is given.")
]
"""A row of which only some fields were asked for."""


def chosen_fields(text: str | None, known: Sequence[str]) -> list[str] | None:
    """Read the comma-separated names of fields to send, in the order of all; None for all.

    Raises
    ------
    NotAllowed
        If a row has no such field.
    """
    if text is None:
        return None
    names = {name.strip() for name in text.split(",")}
    if not names <= set(known):
        raise NotAllowed("fields", text, f"names among {', '.join(known)}")
    return [name for name in known if name in names]


def number_or_none(value: Array | float) -> float | None:
    """Turn a zero-dimensional array into a float, NaN into None."""
    number = float(value)
    return None if np.isnan(number) else number
