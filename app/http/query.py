"""Queries as pydantic models: strict numbers, how much one asks for, and how it is to be sent."""

import math
import re
from typing import Annotated, ClassVar, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field
from pydantic_core import PydanticCustomError

from app.http.problems import BadParameters

_ZERO = re.compile(r"-(0+\.?0*|\.0+)(e[+-]?\d+)?", re.IGNORECASE)


def plain(text: object) -> object:
    """Refuse what Python reads as a number though no one writes it, 1_5 for 15; read -0 as 0."""
    if isinstance(text, str):
        if "_" in text and _is_number(text.replace("_", "")):
            raise PydanticCustomError("number", "a number has no underscore")
        if text.startswith("-") and _ZERO.fullmatch(text):
            return "0"
    return text


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


Number = Annotated[float, BeforeValidator(plain)]
Count = Annotated[int, BeforeValidator(plain)]


class QueryModel(BaseModel):
    """Base of all queries; unknown and repeated names are refused by `QueryRoute`."""

    model_config = ConfigDict(frozen=True, validate_default=False)

    cells: ClassVar[tuple[str, ...]] = ()
    """The fields whose product is the number of cells of a map."""

    @property
    def takes_long(self) -> bool:
        """Whether the answer is computed in a thread, so that others do not wait for it."""
        return False

    @property
    def is_picture(self) -> bool:
        """Whether a browser draws the answer, for which nothing else waits."""
        return False

    @property
    def lasts(self) -> bool:
        """Whether many ask for just this, so that it is compressed thoroughly."""
        return False

    def refuse_beyond(self, max_samples: int, max_cells: int) -> None:
        """Refuse more than an operator lets the server compute at once.

        Raises
        ------
        BadParameters
            Naming what there is too much of, and the setting.
        """
        samples = getattr(self, "samples", None) or 0
        if samples > max_samples:
            message = f"this server computes at most {max_samples} (FRESNEL_MAX_SAMPLES)"
            raise BadParameters({"parameter": "samples", "value": samples, "message": message})
        if self.cells and math.prod(getattr(self, name) for name in self.cells) > max_cells:
            first, names = self.cells[0], " times ".join(self.cells)
            message = f"this server computes {names} at most {max_cells} (FRESNEL_MAX_CELLS)"
            value = getattr(self, first)
            raise BadParameters({"parameter": first, "value": value, "message": message})


class LongQuery(QueryModel):
    """A query whose answer takes long, whatever it asks for."""

    @property
    def takes_long(self) -> bool:
        """Always."""
        return True


class DigitsQuery(QueryModel):
    """How numbers are sent."""

    digits: Count = Field(17, ge=3, le=17, description="Significant digits of the numbers sent.")


class TableQuery(DigitsQuery):
    """How an answer that is a table is sent."""

    format: Literal["json", "csv"] = Field("json", description="JSON, or CSV with a header row.")
