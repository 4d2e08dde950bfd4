"""How wrong a model is over the hemisphere: largest, root mean square and cosine-weighted error.

The error is e = R_model - R_exact, signed. Nothing here depends on the angles that a curve was
sampled at: integrals are taken by quadrature, and the largest error is sought between the nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np

from app.optics.amplitudes import power
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.lagarde_conductor import lagarde_conductor
from app.optics.parameters import Array
from app.optics.quadrature import (
    Rule,
    crowded_gauss_legendre,
    double_exponential,
    gauss_legendre,
    hemisphere,
)
from app.optics.registry import Model

Metric = Literal[
    "max_abs",
    "max_abs_at_deg",
    "error_at_max",
    "rms",
    "cosine_weighted_mean",
    "max_relative",
    "max_relative_at_deg",
]
METRICS: tuple[Metric, ...] = get_args(Metric)
DESCRIPTIONS: dict[Metric, str] = {
    "max_abs": "Largest absolute error.",
    "max_abs_at_deg": "Angle of incidence of the largest absolute error.",
    "error_at_max": "Signed error there; positive where the model reflects too much.",
    "rms": "Root mean square error over the hemisphere, each solid angle alike.",
    "cosine_weighted_mean": "Mean signed error weighted by the cosine: the error of the albedo.",
    "max_relative": "Largest absolute error relative to the exact R.",
    "max_relative_at_deg": "Angle of incidence of the largest relative error.",
}

PointMetric = Literal["error", "absolute", "relative"]
POINT_METRICS: tuple[PointMetric, ...] = get_args(PointMetric)

_LARGEST: frozenset[Metric] = frozenset({"max_abs", "max_abs_at_deg", "error_at_max"})
_RELATIVE: frozenset[Metric] = frozenset({"max_relative", "max_relative_at_deg"})

MOST_EVALUATIONS = 60_000_000
"""Evaluations of the model that one call of `measure` may take, some seconds' worth."""

_CACHE_SIZE = 1 << 15  # values a block holds at once, so that its temporaries stay in the cache
_GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


@dataclass(frozen=True, slots=True)
class Quality:
    """How fine to look.

    Attributes
    ----------
    rule
        Quadrature in each interval.
    kinked_rule
        Quadrature between two kinks of a model that has them.
    refinements
        Steps of golden section about the largest error, each leaving 0.62 of the interval.
    reference
        The exact R.
    """

    rule: Rule
    kinked_rule: Rule
    refinements: int
    reference: Callable[[Interface, Incidence], Array]


def _exact(interface: Interface, incidence: Incidence) -> Array:
    return power(interface, incidence).R


PRECISE = Quality(double_exponential(), crowded_gauss_legendre(8), 32, _exact)
"""Integrals to 1e-12, the largest error to 1e-13, its angle to 1e-5 degrees."""

FAST = Quality(crowded_gauss_legendre(12), gauss_legendre(3), 8, lagarde_conductor)
"""For maps of many interfaces, to 1e-4; the reference is as exact but for relative errors near
N = n_i."""


def point_error(
    model: Model,
    interface: Interface,
    incidence: Incidence,
    arguments: Mapping[str, Array],
    metric: PointMetric = "error",
) -> Array:
    """Signed, absolute or relative error at each angle, of the broadcast shape.

    The relative error (R - exact)/exact is NaN where the exact R is 0.
    """
    exact = power(interface, incidence).R
    error = np.asarray(model.evaluate(interface, incidence, arguments) - exact)
    if metric == "absolute":
        return np.abs(error)
    if metric == "relative":
        out = np.full(error.shape, np.nan)
        return np.asarray(np.divide(error, exact, out=out, where=exact > 0.0))
    return error


def measure(
    model: Model,
    interface: Interface,
    arguments: Mapping[str, Array] | None = None,
    quality: Quality = PRECISE,
    wanted: Collection[Metric] = METRICS,
) -> dict[Metric, Array]:
    r"""Errors of a model over the hemisphere, one of each for every interface.

    .. math::
        e_{rms}^2 = \int_0^1 e^2\, d\mu, \qquad \bar e = 2 \int_0^1 e\, \mu\, d\mu

    Parameters
    ----------
    model
        The model under test.
    interface
        Boundaries of any shape.
    arguments
        What `model.arguments` returned, broadcasting against the interface; solved if not given.
    quality
        PRECISE, or FAST for many interfaces.
    wanted
        The metrics to compute.

    Returns
    -------
    dict
        Arrays of the broadcast shape; NaN where the model is undefined over a range of angles.
        Relative errors are infinite where the exact R is 0 and the model's is not.

    Raises
    ------
    NotAllowed
        If it would take more than `MOST_EVALUATIONS`.

    Examples
    --------
    The cosine-weighted mean is the albedo's error, and Schlick's albedo is F0 + (1 - F0)/21:

    >>> from app.optics.registry import default_registry
    >>> glass = measure(default_registry()["schlick"], Interface(n_t=1.5))
    >>> albedo = 0.04 + 0.96 / 21 - float(glass["cosine_weighted_mean"])
    >>> round(albedo, 9)
    0.091775932
    """
    values = model.arguments(interface) if arguments is None else arguments
    kinks = None if model.kinks is None else model.kinks(**values)
    rule = quality.rule if kinks is None else quality.kinked_rule
    intervals = 2 if kinks is None else kinks.size + 2
    nodes = intervals * (rule.x.size + 1) + 1
    media = (interface.n_i, interface.n_t, interface.k_t)
    shape = np.broadcast_shapes(*(a.shape for a in (*media, *values.values())))
    total = int(np.prod(shape, dtype=np.int64))
    if total * nodes > MOST_EVALUATIONS:
        most = MOST_EVALUATIONS // nodes
        raise NotAllowed("steps", total, f"at most {most} interfaces at once with {model.id}")
    # Lagarde's form loses its digits where R is small, which an absolute error never shows.
    relative = not _RELATIVE.isdisjoint(wanted)
    curves = _ErrorCurves(
        model,
        [np.broadcast_to(m, shape).reshape(-1, 1) for m in media],
        {
            n: v if v.ndim == 0 else np.broadcast_to(v, shape).reshape(-1, 1)
            for n, v in values.items()
        },
        _exact if relative else quality.reference,
    )
    result = _metrics(curves, rule, kinks, quality.refinements, wanted)
    return {name: result[name].reshape(shape) for name in wanted}


@dataclass(frozen=True, slots=True)
class _ErrorCurves:
    """Signed error over mu, a row for each interface; media and arguments are columns."""

    model: Model
    media: list[Array]
    arguments: Mapping[str, Array]
    reference: Callable[[Interface, Incidence], Array]

    def rows(self, size: int) -> Iterator[tuple[slice, _ErrorCurves]]:
        """Parts of so many rows."""
        for start in range(0, len(self.media[0]), size):
            rows = slice(start, start + size)
            media = [column[rows] for column in self.media]
            arguments = {n: v if v.ndim == 0 else v[rows] for n, v in self.arguments.items()}
            yield rows, replace(self, media=media, arguments=arguments)

    def at(self, mu: Array) -> tuple[Array, Array]:
        """Error and exact R at cosines of shape (rows, any)."""
        interface = Interface(*self.media)
        incidence = Incidence(mu, np.sqrt((1.0 - mu) * (1.0 + mu)))
        exact = self.reference(interface, incidence)
        return self.model.evaluate(interface, incidence, self.arguments) - exact, exact

    def error_at(self, mu: Array) -> Array:
        """Error alone."""
        return self.at(mu)[0]

    def relative_at(self, mu: Array) -> Array:
        """Error over exact R; infinite where only the exact R is 0."""
        return _relative(*self.at(mu))


@dataclass(frozen=True, slots=True)
class _Peak:
    """Where the error is largest among the nodes, and the nodes to either side, as columns."""

    low: Array
    best: Array
    high: Array
    error: Array

    @classmethod
    def empty(cls, rows: int) -> _Peak:
        return cls(*(np.empty((rows, 1)) for _ in range(4)))

    def set(self, rows: slice, mu: Array, error: Array) -> None:
        every = np.arange(len(mu))
        best = np.argmax(np.abs(error), axis=1)
        self.low[rows, 0] = mu[every, np.maximum(best - 1, 0)]
        self.best[rows, 0] = mu[every, best]
        self.high[rows, 0] = mu[every, np.minimum(best + 1, mu.shape[1] - 1)]
        self.error[rows, 0] = error[every, best]

    def part(self, rows: slice) -> _Peak:
        return _Peak(self.low[rows], self.best[rows], self.high[rows], self.error[rows])


def _metrics(
    curves: _ErrorCurves,
    rule: Rule,
    kinks: Array | None,
    refinements: int,
    wanted: Collection[Metric],
) -> dict[Metric, Array]:
    total = len(curves.media[0])
    result: dict[Metric, Array] = {name: np.empty(total) for name in METRICS}
    undefined = np.zeros(total, dtype=bool)
    peaks = None if _LARGEST.isdisjoint(wanted) else _Peak.empty(total)
    relative_peaks = None if _RELATIVE.isdisjoint(wanted) else _Peak.empty(total)
    intervals = 2 if kinks is None else kinks.size + 2
    for rows, part in curves.rows(max(1, _CACHE_SIZE // (intervals * (rule.x.size + 1)))):
        mu, w = hemisphere(Interface(*(column[:, 0] for column in part.media)), rule, kinks)
        error, exact = part.at(mu)
        gaps = np.isnan(error)
        if gaps.any():  # at a single angle, as at the tangent's 90 degrees, nothing is lost
            undefined[rows] = np.any(gaps & (w > 0.0), axis=1)
            error = np.where(gaps, 0.0, error)
        if "rms" in wanted:
            result["rms"][rows] = np.sqrt(np.einsum("ij,ij,ij->i", w, error, error))
        if "cosine_weighted_mean" in wanted:
            mean = 2.0 * np.einsum("ij,ij,ij->i", w, mu, error)
            result["cosine_weighted_mean"][rows] = mean
        if peaks:
            peaks.set(rows, mu, error)
        if relative_peaks:
            relative_peaks.set(rows, mu, _relative(error, exact))
    for rows, part in curves.rows(_CACHE_SIZE // 2):
        if peaks:
            error, angle = _refine(part.error_at, peaks.part(rows), refinements)
            result["max_abs"][rows] = np.abs(error)
            result["error_at_max"][rows] = error
            result["max_abs_at_deg"][rows] = angle
        if relative_peaks:
            error, angle = _refine(part.relative_at, relative_peaks.part(rows), refinements)
            result["max_relative"][rows] = np.abs(error)
            result["max_relative_at_deg"][rows] = angle
    return {name: np.where(undefined, np.nan, result[name]) for name in wanted}


def _relative(error: Array, exact: Array) -> Array:
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(error == 0.0, 0.0, error / exact)


def _refine(
    error_at: Callable[[Array], Array], peak: _Peak, refinements: int
) -> tuple[Array, Array]:
    """Error of largest modulus between the nodes by golden section, and its angle in degrees."""
    low, high = peak.low, peak.high
    left, right = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_left, at_right = error_at(left), error_at(right)
    for _ in range(refinements):
        down = np.abs(at_left) > np.abs(at_right)
        low, high = np.where(down, low, left), np.where(down, right, high)
        fresh = np.where(down, high - _GOLDEN * (high - low), low + _GOLDEN * (high - low))
        at_fresh = error_at(fresh)
        left, right = np.where(down, fresh, right), np.where(down, left, fresh)
        at_left, at_right = np.where(down, at_fresh, at_right), np.where(down, at_left, at_fresh)
    points = np.concatenate([peak.best, left, right], axis=1)
    found = np.concatenate([peak.error, at_left, at_right], axis=1)
    largest = np.argmax(np.abs(np.nan_to_num(found, posinf=np.inf)), axis=1)
    every = np.arange(len(found))
    cosine = points[every, largest]
    angle = np.degrees(np.arctan2(np.sqrt((1.0 - cosine) * (1.0 + cosine)), cosine))
    return found[every, largest], angle
