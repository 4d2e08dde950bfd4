"""How wrong every model is at some materials: what the atlas is put together from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.atlas.pages import Page
from app.materials.appearance import appearance, averaged_interface
from app.materials.colored import colored
from app.materials.rgb_index import ANGLES_DEG, distance, reflected
from app.materials.rgb_models import color_arguments, has_rgb_form
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import ROUNDING, Metric, measure
from app.optics.numerics.significant import round_significant
from app.optics.parameters import Array
from app.optics.registry import Model, Registry

DIGITS = 4
"""Significant ones that errors are kept with."""

MEASURED: tuple[Metric, ...] = ("max_abs", "max_abs_at_deg", "rms", "cosine_weighted_mean")

Places = NDArray[np.intp]

_AT_ONCE = 400
"""Interfaces whose errors are measured by one call; a model with many kinks has many nodes each."""


@dataclass(frozen=True, eq=False)
class Errors:
    """Errors of one model at one material; arrays are over the wavelengths where it is made for it."""

    page: Page
    model: str
    at: Places
    """Places among the page's wavelengths."""
    in_domain: Array
    """Whether the model's own limits admit the interface, as 0 and 1."""
    max_abs: Array
    max_abs_at_deg: Array
    rms: Array
    albedo_error: Array
    delta_e: float
    """Largest CIEDE2000 of its RGB form against the spectrum over the angle; NaN where it has none."""


def errors_of(pages: Sequence[Page], registry: Registry) -> Iterator[Errors]:
    """Measure every model at materials.

    A model is measured at the interfaces with vacuum of the kinds that it is made for, its own
    parameters solved from the interface or at their defaults, over all angles, by
    `app.optics.metrics.measure` in full precision. A model with an RGB form, which is given the
    color of the spectrum, unclamped, is compared with that by `app.materials.rgb_index.distance`.

    Parameters
    ----------
    pages
        The materials.
    registry
        The models.

    Yields
    ------
    Errors
        Of each material in order every model in order, but those made for none of its interfaces.
        Numbers have `DIGITS` digits; what is nothing but rounding is 0.
    """
    n = np.concatenate([page.n for page in pages])
    k = np.concatenate([page.k_counted for page in pages])
    owner = np.repeat(np.arange(len(pages)), [page.n.size for page in pages])
    first = np.concatenate([[0], np.cumsum([page.n.size for page in pages])])
    found = {model.id: _measured(model, n, k) for model in registry.values()}
    for number, page in enumerate(pages):
        colors = _color_errors(page, registry)
        for model in registry.values():
            places, in_domain, columns = found[model.id]
            own = owner[places] == number
            if own.any():
                yield Errors(
                    page=page,
                    model=model.id,
                    at=places[own] - first[number],
                    in_domain=in_domain[own],
                    **{name: column[own] for name, column in columns.items()},
                    delta_e=colors.get(model.id, np.nan),
                )


def _measured(model: Model, n: Array, k: Array) -> tuple[Places, Array, dict[str, Array]]:
    """Where a model is made for the interface, whether within its limits, and its errors there."""
    kinds = {"dielectric": k == 0.0, "conductor": k > 0.0}
    places, domain = [], []
    columns: dict[Metric, list[Array]] = {name: [] for name in MEASURED}
    for kind in model.applies_to:
        which = np.flatnonzero(kinds[kind])
        for start in range(0, which.size, _AT_ONCE):
            some = which[start : start + _AT_ONCE]
            interface = Interface(1.0, n[some], k[some])
            metrics = measure(model, interface, wanted=MEASURED)
            places.append(some)
            domain.append(_in_domain(model, n[some], k[some]))
            for name in MEASURED:
                columns[name].append(np.broadcast_to(metrics[name], some.shape))
    if not places:
        return np.empty(0, np.intp), np.empty(0), {}
    order = np.argsort(np.concatenate(places), kind="stable")
    joined = {name: np.concatenate(parts)[order] for name, parts in columns.items()}
    largest = kept(joined["max_abs"])
    return (
        np.concatenate(places)[order],
        np.concatenate(domain)[order],
        {
            "max_abs": largest,
            # Where there is no error, no angle has the largest.
            "max_abs_at_deg": np.where(largest > 0.0, joined["max_abs_at_deg"].round(2), np.nan),
            "rms": kept(joined["rms"]),
            "albedo_error": kept(joined["cosine_weighted_mean"]),
        },
    )


def _in_domain(model: Model, n: Array, k: Array) -> Array:
    """Ask of all at once, and of each where that does not do for all."""
    if model.reason_outside(Interface(1.0, n, k)) is None:
        return np.ones(n.shape)
    if n.size == 1:
        return np.zeros(1)
    half = n.size // 2
    parts = [_in_domain(model, n[cut], k[cut]) for cut in (slice(half), slice(half, None))]
    return np.concatenate(parts)


def _color_errors(page: Page, registry: Registry) -> dict[str, float]:
    """How far the RGB forms of models are from the spectrum, by their ids."""
    if not page.spans_the_visible:
        return {}
    medium = colored(page.preset)
    incidence = Incidence.from_degrees(ANGLES_DEG)
    truth = reflected(page.preset, incidence)
    look, averaged = appearance(medium).of_white(), averaged_interface(medium)
    apart = {}
    for model in _with_colors(registry):
        curve = model.evaluate(averaged, incidence, color_arguments(model, look)).T
        apart[model.id] = distance(curve, truth).delta_e
    return dict(zip(apart, kept(np.array([*apart.values()])).tolist(), strict=True))


def _with_colors(registry: Registry) -> Iterable[Model]:
    return (model for model in registry.values() if has_rgb_form(model))


def kept(values: Array) -> Array:
    """Values as the atlas keeps them."""
    return round_significant(np.where(np.abs(values) < ROUNDING, 0.0, values), DIGITS)
