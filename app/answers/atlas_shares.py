"""For how many materials of the atlas the error of a model is small, counted and as a sentence."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.answers.answer import answer
from app.atlas.errors import DIGITS
from app.atlas.grid import Band
from app.atlas.pages import KINDS, Kind
from app.atlas.published import Atlas, Metric
from app.materials.rgb_models import rgb_title
from app.optics.numerics.significant import round_significant
from app.optics.parameters import Array
from app.optics.registry import Model

Numbers = NDArray[np.intp]


_STAYS: dict[Metric, str] = {
    "max_abs": "stays within {} of the incident light at every angle",
    "rms": "stays within {} of the incident light in root mean square over the hemisphere",
    "albedo_error": "has an albedo within {} of the incident light",
    "delta_e": "shows, from RGB, a color within ΔE {} of the spectrum's at every angle",
}
_MANY: dict[Kind, str] = {
    "clear": "clear materials",
    "absorbing": "absorbing materials",
    "metal": "metals",
}
_SEEN: dict[Band, str] = {
    "visible": "over the visible",
    "elsewhere": "at wavelengths that are not visible",
}


@answer
class KindShare:
    """For how many materials of a kind an error is small."""

    kind: Kind
    materials: int
    """How many the model is made for and measured with."""
    within: int
    """Of these, those whose error is small."""
    undefined: int
    """Of these, those where the model is undefined over part of the hemisphere; not within."""
    median: float | None
    """Of the sizes of their errors; null where there are none."""
    largest: float | None
    """Size of the largest error."""
    largest_of: str | None
    """The material that has it."""


@answer
class ModelShare:
    """For how many materials the error of a model is small."""

    model: str
    title: str
    trap: bool
    """Whether the model is kept to show a mistake."""
    kinds: list[KindShare]
    """Those that it is made for."""
    sentence: str


def share_of(
    found: Atlas, model: Model, metric: Metric, within: float, band: Band, asked: Numbers
) -> ModelShare | None:
    """Count materials for a model; None where it has none of them, or no such error.

    Parameters
    ----------
    found, model, metric
        The atlas, and which error of which model.
    within
        What size of it is small.
    band, asked
        Numbers of the materials, all of one band.
    """
    if model.id not in found.models:
        return None
    rows, sizes = largest_errors(found, model.id, metric, asked)
    owners = found.material[rows]
    of = found.kinds[owners]
    kinds = [
        _counted(found, kind, owners[of == place], sizes[of == place], within)
        for place, kind in enumerate(KINDS)
        if (of == place).any()
    ]
    if not kinds:
        return None
    return ModelShare(
        model=model.id,
        title=rgb_title(model) if metric == "delta_e" else model.title,
        trap=model.trap,
        kinds=kinds,
        sentence=_sentence(model, metric, within, band, kinds),
    )


def _counted(
    found: Atlas, kind: Kind, owners: NDArray[np.int32], sizes: Array, within: float
) -> KindShare:
    defined = np.isfinite(sizes)
    place = int(np.nanargmax(sizes)) if defined.any() else None
    return KindShare(
        kind=kind,
        materials=int(sizes.size),
        within=int(np.sum(sizes[defined] <= within)),
        undefined=int(np.sum(~defined)),
        median=_median(sizes[defined]),
        largest=None if place is None else float(sizes[place]),
        largest_of=None if place is None else found.materials[owners[place]].id,
    )


def _median(sizes: Array) -> float | None:
    """Half way between two is a digit more."""
    if not sizes.size:
        return None
    return float(round_significant(np.array([np.median(sizes)]), DIGITS + 1)[0])


def _sentence(
    model: Model, metric: Metric, within: float, band: Band, kinds: Sequence[KindShare]
) -> str:
    size = f"{within:g}" if metric == "delta_e" else f"{100.0 * within:g} %"
    counts = [f"{one.within:,} of {one.materials:,} {_MANY[one.kind]}" for one in kinds]
    *most, last = counts
    listed = f"{', '.join(most)} and {last}" if most else last
    where = "" if metric == "delta_e" else f", {_SEEN[band]}"
    title = rgb_title(model) if metric == "delta_e" else model.title
    return f"{title.partition(':')[0]} {_STAYS[metric].format(size)} for {listed}{where}."


def largest_errors(
    found: Atlas, model: str, metric: Metric, asked: Numbers
) -> tuple[Numbers, Array]:
    """Find the largest error over the wavelengths of each material that a model is made for.

    Returns
    -------
    tuple
        Rows of the atlas, and the sizes of the errors there, NaN where undefined.
    """
    rows = found.worst[metric][asked, found.models.index(model)]
    rows = rows[rows >= 0]
    if metric == "delta_e":  # materials that are not known over the visible have no color
        rows = rows[np.isfinite(found.errors[metric][rows])]
    return rows, np.abs(digits(found.errors[metric][rows]))


def digits(values: NDArray[np.float32]) -> Array:
    """The digits that were kept, which single precision blurs."""
    return round_significant(values.astype(np.float64), DIGITS)


def degrees(values: NDArray[np.float32]) -> Array:
    """Angles as they were kept, to the hundredth."""
    return np.asarray(np.round(values.astype(np.float64), 2), np.float64)
