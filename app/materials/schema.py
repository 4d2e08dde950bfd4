"""What the files of the data directory may contain; an unknown key is an error."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

Category = Literal[
    "vacuum",
    "gas",
    "liquid",
    "glass",
    "polymer",
    "crystal",
    "metal",
    "alloy",
    "semimetal",
    "semiconductor",
    "ceramic",
    "generic",
]
Id = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9.-]*$")]


class Strict(BaseModel):
    """Immutable, with no keys but its own."""

    model_config = ConfigDict(extra="forbid", frozen=True)


class Preset(Strict):
    """A material as lists show it, with its constants at one reference wavelength.

    `n_min` and `n_max` are given where the source gives a range; `n` is then its middle.
    `k` is None where the source does not give it, which is not the same as 0.
    `wavelength_nm` is None where the source names no wavelength.
    """

    id: Id
    name: str
    category: Category
    aliases: tuple[str, ...] = ()
    n: float = Field(gt=0)
    n_min: float | None = None
    n_max: float | None = None
    k: float | None = None
    wavelength_nm: float | None
    source: str
    note: str | None = None


class Table(Strict):
    """A published table of single indices."""

    id: Id
    title: str
    source: str
    rows: tuple[Preset, ...]
