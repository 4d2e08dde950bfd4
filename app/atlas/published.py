"""The atlas that comes with the program, read when it is first asked for.

Here by arro3, which needs a fifth of the memory and of the room of pyarrow, by which it is written.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast, get_args

import numpy as np
from numpy.typing import NDArray

from app.atlas.grid import Band
from app.atlas.pages import KINDS, Kind
from app.materials.location import data_directory
from app.optics.parameters import Array

if TYPE_CHECKING:
    from arro3.core import ChunkedArray, Table

METADATA = "fresnel_explorer_atlas"
"""Key of what the file says of itself, as JSON."""

Metric = Literal["max_abs", "rms", "albedo_error", "delta_e"]
METRICS: tuple[Metric, ...] = get_args(Metric)

Floats = NDArray[np.float32]
Codes = NDArray[np.int32]


def atlas_path() -> Path:
    """Where the atlas is published."""
    return data_directory() / "atlas" / "errors.parquet"


@dataclass(frozen=True, eq=False)
class Material:
    """A material of the atlas, by the wavelength that stands for all."""

    number: int
    id: str
    page: str
    """Of the database; empty for a single index."""
    name: str
    shelf: str
    kind: Kind
    band: Band
    wavelength_nm: float | None
    n: float
    k: float | None
    wavelengths: int
    """How many there are of it."""
    searched: str
    """What a search looks at."""


@dataclass(frozen=True, eq=False)
class Spots:
    """Materials at one wavelength each, which many rows share."""

    wavelength_nm: Array
    """NaN where the source of a single index names none."""
    n: Array
    """Against vacuum."""
    k: Array
    """NaN where the source gives none."""


@dataclass(frozen=True, eq=False)
class Atlas:
    """Errors of every model at every material and wavelength; one row each, materials in order."""

    about: Mapping[str, Any]
    """How it was made."""
    materials: tuple[Material, ...]
    models: tuple[str, ...]
    spots: Spots
    material: Codes
    """Of each row, its number among the materials."""
    model: Codes
    """And among the models."""
    spot: Codes
    """And among the spots."""
    in_domain: NDArray[np.bool_]
    max_abs_at_deg: Floats
    errors: Mapping[Metric, Floats]
    """NaN where undefined, or where there is no RGB form."""
    worst: Mapping[Metric, Codes]
    """Row of each material (first axis) and model where the size of an error is largest over the
    wavelengths, an undefined one above all; -1 where the model is not made for it at all of them."""

    @cached_property
    def by_id(self) -> Mapping[str, Material]:
        """Materials by their ids, and by those of the pages that they stand for."""
        pages = {material.page: material for material in self.materials if material.page}
        return pages | {material.id: material for material in self.materials}

    @cached_property
    def kinds(self) -> Codes:
        """Kind of each material by its number among `KINDS`."""
        return np.array([KINDS.index(material.kind) for material in self.materials], np.int32)

    def rows_of(self, material: Material) -> slice:
        """Rows of a material."""
        first, last = np.searchsorted(self.material, [material.number, material.number + 1])
        return slice(int(first), int(last))


def read_atlas(path: Path) -> Atlas:
    """Read an atlas as `fresnel-explorer atlas` writes it."""
    from arro3.io import read_parquet

    table = read_parquet(path).read_all()
    told = {_text(key): value for key, value in table.schema.metadata.items()}
    material, ids = _names(table, "material")
    model, models = _names(table, "model")
    spots, spot, counts = _spots(table, material)
    of_each = np.zeros((len(ids), len(models)), np.int32)
    np.add.at(of_each, (material, model), 1)
    # A model that is made for a material at some wavelengths alone is not made for it.
    of_each[of_each < counts[:, np.newaxis]] = 0
    errors: dict[Metric, Floats] = {name: _singles(table, name) for name in METRICS}
    return Atlas(
        about=json.loads(_text(told[METADATA])),
        materials=_materials(table, material, ids, spots, spot, counts),
        models=tuple(models),
        spots=spots,
        material=material,
        model=model,
        spot=spot,
        in_domain=_singles(table, "in_domain") > 0.0,
        max_abs_at_deg=_singles(table, "max_abs_at_deg"),
        errors=errors,
        worst={name: _worst(values, material, model, of_each) for name, values in errors.items()},
    )


@cache
def atlas() -> Atlas:
    """The atlas that comes with the program, read once a process."""
    return read_atlas(atlas_path())


def _spots(table: Table, material: Codes) -> tuple[Spots, Codes, NDArray[np.intp]]:
    """Wavelengths of materials, which of them each row is at, and how many each material has."""
    wavelength_nm = _doubles(table, "wavelength_nm")
    distinct, rank = np.unique(wavelength_nm, return_inverse=True)  # NaN is one of them
    _, first, spot = np.unique(
        material.astype(np.int64) * distinct.size + rank, return_index=True, return_inverse=True
    )
    spots = Spots(wavelength_nm[first], _doubles(table, "n")[first], _doubles(table, "k")[first])
    return spots, spot.astype(np.int32), np.bincount(material[first])


def _worst(errors: Floats, material: Codes, model: Codes, of_each: Codes) -> Codes:
    """Row of the largest error of each material and model that there are rows of, else -1."""
    sizes = np.nan_to_num(np.abs(errors), nan=np.inf)
    order = np.argsort(sizes, kind="stable")
    worst = np.full(of_each.shape, -1, np.int32)
    worst[material[order], model[order]] = order  # sorted by size, the last one stays
    return np.where(of_each > 0, worst, np.int32(-1))


def _materials(
    table: Table,
    material: Codes,
    ids: list[str],
    spots: Spots,
    spot: Codes,
    counts: NDArray[np.intp],
) -> tuple[Material, ...]:
    facts = {name: _names(table, name) for name in ("page", "name", "shelf", "kind", "band")}
    middle = np.flatnonzero(_singles(table, "middle"))
    # One row of each material stands for it: of the first model that has one there.
    _, first = np.unique(material[middle], return_index=True)
    rows = middle[first].tolist()

    def told(name: str, row: int) -> str:
        codes, names = facts[name]
        return names[int(codes[row])]

    return tuple(
        Material(
            number=number,
            id=ids[number],
            page=told("page", row),
            name=told("name", row),
            shelf=told("shelf", row),
            kind=cast("Kind", told("kind", row)),
            band=cast("Band", told("band", row)),
            wavelength_nm=_or_none(spots.wavelength_nm[place]),
            n=float(spots.n[place]),
            k=_or_none(spots.k[place]),
            wavelengths=int(counts[number]),
            searched=f"{ids[number]} {told('page', row)} {told('name', row)}".casefold(),
        )
        for number, row in enumerate(rows)
        for place in (spot[row],)
    )


def _or_none(value: float) -> float | None:
    return None if np.isnan(value) else float(value)


def _text(value: bytes | str) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)


def _doubles(table: Table, name: str) -> Array:
    """A column of doubles."""
    chunks: ChunkedArray = table[name]
    return np.concatenate([np.asarray(chunk.to_numpy()) for chunk in chunks.chunks])


def _singles(table: Table, name: str) -> Floats:
    """A column in single precision, in which true is 1."""
    from arro3.core import DataType

    chunks: ChunkedArray = table[name].cast(DataType.float32())
    return np.concatenate([np.asarray(chunk.to_numpy()) for chunk in chunks.chunks])


def _names(table: Table, name: str) -> tuple[Codes, list[str]]:
    """A column of words as codes, and the words in the order in which they first occur."""
    from arro3.core import dictionary_dictionary, dictionary_indices

    words: dict[str, int] = {}
    codes = []
    for chunk in table[name].chunks:
        own = [words.setdefault(w, len(words)) for w in dictionary_dictionary(chunk).to_pylist()]
        codes.append(np.array(own, np.int32)[np.asarray(dictionary_indices(chunk).to_numpy())])
    return np.concatenate(codes), list(words)
