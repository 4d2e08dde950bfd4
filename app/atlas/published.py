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
    from arro3.core import RecordBatch

METADATA = "fresnel_explorer_atlas"
"""Key of what the file says of itself, as JSON."""

Metric = Literal["max_abs", "rms", "albedo_error", "delta_e"]
METRICS: tuple[Metric, ...] = get_args(Metric)

_BATCH = 65_536
"""Rows that are read at once."""

_CODED = ("material", "model")
_FACTS = ("page", "name", "shelf", "kind", "band")
"""Columns of words: one each row, and one each material."""

_LONGEST_NM = 1e8
"""Beyond every wavelength that the core takes."""

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
    """Read an atlas as `fresnel-explorer atlas` writes it.

    Batch by batch into the arrays that stay: all at once takes three times their memory.
    """
    from arro3.io import read_parquet

    reader = read_parquet(path, batch_size=_BATCH)
    told = {_text(key): value for key, value in reader.schema.metadata.items()}
    about = json.loads(_text(told[METADATA]))
    columns = _Columns(about["rows"])
    for batch in reader:
        columns.take(batch)
    names, material, model = columns.names, columns.codes["material"], columns.codes["model"]
    spots, owner, middle = columns.spots()
    counts = np.bincount(owner)
    # Rows of a material and model stand together, a wavelength each.
    pairs = material * np.int32(len(names["model"])) + model
    first = np.flatnonzero(np.diff(pairs, prepend=-1))
    many = np.diff(first, append=pairs.size)
    # A model that is made for a material at some wavelengths alone is not made for it.
    whole = many == counts[material[first]]
    shape = len(names["material"]), len(names["model"])
    return Atlas(
        about=about,
        materials=_materials(columns, spots, counts, middle),
        models=tuple(names["model"]),
        spots=spots,
        material=material,
        model=model,
        spot=np.searchsorted(_keys(owner, spots.wavelength_nm), columns.keys).astype(np.int32),
        in_domain=columns.in_domain,
        max_abs_at_deg=columns.singles["max_abs_at_deg"],
        errors={name: columns.singles[name] for name in METRICS},
        worst={
            name: _worst(columns.singles[name], pairs, first, many, whole, shape)
            for name in METRICS
        },
    )


class _Columns:
    """Columns of an atlas, filled a batch at a time."""

    def __init__(self, rows: int) -> None:
        self._filled = 0
        self.names: dict[str, dict[str, int]] = {name: {} for name in (*_CODED, *_FACTS)}
        """Words of each column by their codes, in the order in which they first occur."""
        self.codes = {name: np.empty(rows, np.int32) for name in _CODED}
        self.singles = {name: np.empty(rows, np.float32) for name in (*METRICS, "max_abs_at_deg")}
        self.in_domain = np.empty(rows, np.bool_)
        self.keys = np.empty(rows)
        """Of material and wavelength together."""
        self.facts: dict[int, tuple[int, ...]] = {}
        """By material, what is told of it, as codes."""
        self._spots: list[Array] = []

    def take(self, batch: RecordBatch) -> None:
        """Append a batch."""
        rows = slice(self._filled, self._filled + batch.num_rows)
        self._filled = rows.stop
        for name in _CODED:
            self.codes[name][rows] = self._coded(batch, name)
        for name, column in self.singles.items():
            column[rows] = _numbers(batch, name)
        self.in_domain[rows] = _numbers(batch, "in_domain") > 0.0
        material, (wavelength_nm, n, k) = (
            self.codes["material"][rows],
            (_numbers(batch, name) for name in ("wavelength_nm", "n", "k")),
        )
        self.keys[rows] = _keys(material, wavelength_nm)
        # The exact solution is made for all, so that its rows have each material at each wavelength.
        exact = self.codes["model"][rows] == self.names["model"]["exact"]
        spots = (material, wavelength_nm, n, k, _numbers(batch, "middle"))
        self._spots.append(np.stack([column[exact] for column in spots]))
        distinct, first = np.unique(material, return_index=True)
        told = np.stack([self._coded(batch, name)[first] for name in _FACTS], axis=1)
        self.facts |= zip(distinct.tolist(), map(tuple, told.tolist()), strict=True)

    def spots(self) -> tuple[Spots, NDArray[np.intp], NDArray[np.intp]]:
        """Materials at each wavelength, whose each is, and which stand for their materials."""
        material, wavelength_nm, n, k, middle = np.concatenate(self._spots, axis=1)
        spots = Spots(wavelength_nm, n, k)
        return spots, material.astype(np.intp), np.flatnonzero(middle)

    def _coded(self, batch: RecordBatch, name: str) -> Codes:
        from arro3.core import dictionary_dictionary, dictionary_indices

        column, words = batch[name], self.names[name]
        own = [words.setdefault(w, len(words)) for w in dictionary_dictionary(column).to_pylist()]
        places = np.asarray(dictionary_indices(column).to_numpy())
        return np.asarray(np.array(own, np.int32)[places])


def _numbers(batch: RecordBatch, name: str) -> Array:
    """A column as doubles, in which true is 1."""
    from arro3.core import DataType

    return np.asarray(batch[name].cast(DataType.float64()).to_numpy())


def _keys(material: NDArray[np.integer[Any]], wavelength_nm: Array) -> Array:
    """Numbers that rise with the material and then with the wavelength, which may be NaN."""
    return np.asarray(material * _LONGEST_NM + np.nan_to_num(wavelength_nm, nan=0.0), np.float64)


@cache
def atlas() -> Atlas:
    """The atlas that comes with the program, read once a process."""
    return read_atlas(atlas_path())


def _worst(
    errors: Floats,
    pairs: Codes,
    first: NDArray[np.intp],
    many: NDArray[np.intp],
    whole: NDArray[np.bool_],
    shape: tuple[int, int],
) -> Codes:
    """Row of the largest error of each pair of material and model, else -1.

    Parameters
    ----------
    errors, pairs
        Of each row, which pair it is of.
    first, many, whole
        Of each pair that has rows: where they begin, how many they are, and whether it counts.
    shape
        Of materials by models.
    """
    sizes = np.nan_to_num(np.abs(errors), nan=np.inf)
    largest = np.maximum.reduceat(sizes, first)
    rows = np.flatnonzero((sizes == np.repeat(largest, many)) & np.repeat(whole, many))
    worst = np.full(shape, -1, np.int32)
    worst.reshape(-1)[pairs[rows]] = rows
    return worst


def _materials(
    columns: _Columns, spots: Spots, counts: NDArray[np.intp], middle: NDArray[np.intp]
) -> tuple[Material, ...]:
    ids = list(columns.names["material"])
    words = [list(columns.names[name]) for name in _FACTS]
    made = []
    for number, place in enumerate(middle.tolist()):
        codes = columns.facts[number]
        page, name, shelf, kind, band = (own[code] for own, code in zip(words, codes, strict=True))
        made.append(
            Material(
                number=number,
                id=ids[number],
                page=page,
                name=name,
                shelf=shelf,
                kind=cast("Kind", kind),
                band=cast("Band", band),
                wavelength_nm=_or_none(spots.wavelength_nm[place]),
                n=float(spots.n[place]),
                k=_or_none(spots.k[place]),
                wavelengths=int(counts[number]),
                searched=f"{ids[number]} {page} {name}".casefold(),
            )
        )
    return tuple(made)


def _or_none(value: float) -> float | None:
    return None if np.isnan(value) else float(value)


def _text(value: bytes | str) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
