"""Which formula will do for which material: what the atlas of errors tells of a model."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from app.answers.answer import Gaps, Table, Values, answer
from app.answers.atlas_made import AtlasMade
from app.answers.atlas_shares import (
    KindShare,
    ModelShare,
    Numbers,
    degrees,
    digits,
    largest_errors,
    share_of,
)
from app.atlas.grid import Band
from app.atlas.pages import Kind, faint_as_zero
from app.atlas.published import METRICS, Atlas, Material, Metric, atlas
from app.optics.errors import NotAllowed, UnknownName
from app.optics.interface import normal_reflectance
from app.optics.parameters import Array
from app.optics.registry import Model, Registry

WITHIN: dict[Metric, float] = {"max_abs": 0.01, "rms": 0.01, "albedo_error": 0.01, "delta_e": 1.0}
"""Errors that count as small unless another is given: a hundredth of the light, a visible ΔE."""


@answer
class AtlasPoints:
    """Materials, the one with the largest error first and undefined ones last, a list a field."""

    material: list[str]
    """Ids."""
    name: list[str]
    shelf: list[str]
    kind: list[Kind]
    wavelength_nm: Gaps
    """Where n, k and F0 are told: 550 nm or the nearest of the grid, elsewhere the middle one."""
    n: Values
    """Against vacuum."""
    k: Gaps
    """Null where the source gives none."""
    F0: Values
    """From vacuum; a k that is not known, or too faint to matter, counts as 0."""
    wavelengths: list[int]
    """At how many the material was looked at."""
    error: Gaps
    """The largest in size over these, signed for albedo_error; null where undefined at one."""
    error_at_nm: Gaps
    """The wavelength of that; null for delta_e, which all of them make."""
    error_at_deg: Gaps
    """The angle, for max_abs."""
    in_domain: list[bool]
    """Whether the model's own limits admit the material there."""


@answer
class AtlasAnswer:
    """Errors of a model at every material, and of all models how often they are small."""

    made: AtlasMade
    model: str
    metric: Metric
    within: float
    """What size of the error counts as small."""
    band: Band
    sentence: str
    """What a person takes home."""
    kinds: list[KindShare]
    """For how many materials of each kind the error is small."""
    models: list[ModelShare]
    """The same of every model, in the order of /models."""
    shelves: dict[str, int]
    """How many materials of the band each shelf has."""
    total: int
    """How many materials are among those asked for and made for by the model."""
    limit: int | None
    points: AtlasPoints

    def table(self) -> Table:
        """Lay out a row each material."""
        names = AtlasPoints.__dataclass_fields__
        columns = {name: getattr(self.points, name) for name in names}
        return Table(columns, f"fresnel_atlas_{self.model}.csv")


def which_formula(
    models: Registry,
    model: Model,
    *,
    metric: Metric = "max_abs",
    within: float | None = None,
    kind: Kind | None = None,
    band: Band = "visible",
    shelf: str | None = None,
    q: str | None = None,
    F0: tuple[float, float] = (0.0, 1.0),
    limit: int | None = None,
) -> AtlasAnswer:
    """Tell the errors of a model at the materials of the atlas.

    Parameters
    ----------
    models, model
        All models, and the one whose errors are told.
    metric, within
        Which error, and what size of it is small; that of `WITHIN` unless given.
    kind, band, shelf
        Materials of these alone.
    q
        Words that all stand in a material's id or name.
    F0
        Least and largest normal reflectance of the materials.
    limit
        How many points to list at most.

    Raises
    ------
    UnknownName
        If there is no such shelf.
    NotAllowed
        If the model has no such error anywhere, or the least F0 is above the largest.
    """
    found = atlas()
    within = WITHIN[metric] if within is None else within
    _check(found, model, metric, shelf, F0)
    bounds = _asked(found.materials, kind=kind, band=band, shelf=shelf, q=q, F0=F0)
    shares = [
        share
        for one in models.values()
        if (share := share_of(found, one, metric, within, band, bounds)) is not None
    ]
    own = next((share for share in shares if share.model == model.id), None)
    rows, sizes = largest_errors(found, model.id, metric, bounds)
    order = np.argsort(-sizes, kind="stable")  # NaN comes last
    told = order[:limit]
    return AtlasAnswer(
        made=AtlasMade.of(found),
        model=model.id,
        metric=metric,
        within=within,
        band=band,
        sentence=own.sentence if own else "The atlas has no material of those asked for.",
        kinds=own.kinds if own else [],
        models=shares,
        shelves=_shelves(found.materials, band),
        total=int(rows.size),
        limit=limit,
        points=_points(found, rows[told], metric),
    )


def _check(
    found: Atlas, model: Model, metric: Metric, shelf: str | None, F0: tuple[float, float]
) -> None:
    known = {material.shelf for material in found.materials}
    if shelf is not None and shelf not in known:
        raise UnknownName("shelf", shelf, known)
    if F0[0] > F0[1]:
        raise NotAllowed("F0_minimum", F0[0], f"at most F0_maximum, {F0[1]:g}")
    has = [name for name in METRICS if _has(found, model.id, name)]
    if metric not in has:
        allowed = (
            f"{' or '.join(has)} for {model.id}, which makes no color of a color"
            if has
            else f"another model: the atlas has none of {model.id}"
        )
        raise NotAllowed("metric" if has else "model", metric if has else model.id, allowed)


def _has(found: Atlas, model: str, metric: Metric) -> bool:
    if model not in found.models:
        return False
    if metric != "delta_e":
        return True
    rows = found.worst[metric][:, found.models.index(model)]
    return bool(np.isfinite(found.errors[metric][rows[rows >= 0]]).any())


def _asked(
    materials: Sequence[Material],
    *,
    kind: Kind | None,
    band: Band,
    shelf: str | None,
    q: str | None,
    F0: tuple[float, float],
) -> Numbers:
    """Numbers of the materials that are asked for."""
    words = (q or "").casefold().split()
    normal = normal_reflectances(materials)
    return np.array(
        [
            material.number
            for material, at in zip(materials, normal.tolist(), strict=True)
            if material.band == band
            and kind in (None, material.kind)
            and shelf in (None, material.shelf)
            and F0[0] <= at <= F0[1]
            and all(word in material.searched for word in words)
        ],
        np.intp,
    )


def normal_reflectances(materials: Iterable[Material]) -> Array:
    """Reflectance of each material at normal incidence from vacuum, where it is told."""
    n, k = np.array([(m.n, np.nan if m.k is None else m.k) for m in materials]).reshape(-1, 2).T
    return np.asarray(normal_reflectance(np.ones(n.shape), n, faint_as_zero(n, k)))


def _shelves(materials: Sequence[Material], band: Band) -> dict[str, int]:
    counts: dict[str, int] = {}
    for material in materials:
        if material.band == band:
            counts[material.shelf] = counts.get(material.shelf, 0) + 1
    return counts


def _points(found: Atlas, rows: Numbers, metric: Metric) -> AtlasPoints:
    materials = [found.materials[number] for number in found.material[rows]]
    everywhere = np.full(rows.size, np.nan)
    return AtlasPoints(
        material=[m.id for m in materials],
        name=[m.name for m in materials],
        shelf=[m.shelf for m in materials],
        kind=[m.kind for m in materials],
        wavelength_nm=_gaps(m.wavelength_nm for m in materials),
        n=np.array([m.n for m in materials], np.float64),
        k=_gaps(m.k for m in materials),
        F0=normal_reflectances(materials),
        wavelengths=[m.wavelengths for m in materials],
        error=digits(found.errors[metric][rows]),
        error_at_nm=everywhere
        if metric == "delta_e"
        else found.spots.wavelength_nm[found.spot[rows]],
        error_at_deg=degrees(found.max_abs_at_deg[rows]) if metric == "max_abs" else everywhere,
        in_domain=found.in_domain[rows].tolist(),
    )


def _gaps(values: Iterable[float | None]) -> Array:
    return np.array([np.nan if value is None else value for value in values], np.float64)
