"""How wrong a model is over the hemisphere: largest, root mean square and cosine-weighted error.

The error is e = R_model - R_exact, signed. Nothing here depends on the angles that a curve was
sampled at: integrals are taken by quadrature, and the largest error is sought between the nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from app.optics.amplitudes import reflectance
from app.optics.errors import NotAllowed
from app.optics.hemisphere import bends_gently, hemisphere
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.lagarde_conductor import lagarde_conductor
from app.optics.numerics.peaks import Peaks, largest, largest_of_smooth
from app.optics.numerics.quadrature import (
    Nodes,
    Rule,
    crowded_gauss_legendre,
    double_exponential,
    gauss_legendre,
    root_gauss_legendre,
    whole,
)
from app.optics.parameters import Array
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

_ASTRAY = 1e-4
"""Share of an error by which a polynomial may miss it where it is largest; beyond, it is sought."""

ROUNDING = 1e-13
"""What an error may be made of that is nothing but rounding."""

_CACHE_SIZE = 1 << 14  # values a block holds at once, so that its temporaries stay in the cache


@dataclass(frozen=True, slots=True)
class Quality:
    """How fine to look."""

    rule: Rule
    """Quadrature in each interval."""
    kinked_rule: Rule
    """Quadrature between two kinks of a model that has them."""
    gentle_rule: Rule | None
    """Quadrature in one interval where the exact curve bends gently, with nodes so good that the
    polynomial through them has the largest error too; None to split everywhere."""
    points: int
    rounds: int
    """How the largest error is sought, see `app.optics.numerics.peaks.largest`."""
    reference: Callable[[Interface, Incidence], Array]
    """The exact R; where it is small and relative errors are wanted, `exact` takes its place."""
    most_nodes: int
    """Nodes that one call of `measure` may have, some seconds' worth."""


PRECISE = Quality(
    double_exponential(), crowded_gauss_legendre(20), None, 15, 5, reflectance, 20_000_000
)
"""Integrals to 1e-12, the largest error to 1e-13, its angle to 1e-5 degrees."""

FAST = Quality(
    crowded_gauss_legendre(20),
    gauss_legendre(3),
    root_gauss_legendre(14),
    7,
    4,
    lagarde_conductor,
    25_000_000,
)
"""For maps of many interfaces: integrals to 1e-4, the largest error to 0.2 % of itself, most of them
far better. The exact R is taken from a form that is cheaper."""


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
    exact = reflectance(interface, incidence)
    error = np.asarray(model.evaluate(interface, incidence, arguments) - exact)
    if metric == "absolute":
        return np.abs(error)
    if metric == "relative":
        out = np.full(error.shape, np.nan)
        return np.asarray(np.divide(error, exact, out=out, where=exact > 0.0))
    return error


def root_mean_square(error: Array, nodes: Nodes) -> Array:
    """Root mean square over the hemisphere of errors at nodes, each solid angle alike."""
    return np.asarray(np.sqrt(np.sum(nodes.w * error * error, axis=-1)))


def cosine_weighted_mean(error: Array, nodes: Nodes) -> Array:
    """Mean of signed errors at nodes weighted by the cosine: the error of the albedo."""
    return np.asarray(2.0 * np.sum(nodes.w * nodes.mu * error, axis=-1))


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
        If it would take more nodes than `quality` allows.

    Examples
    --------
    The cosine-weighted mean is the albedo's error, and Schlick's albedo is F0 + (1 - F0)/21:

    >>> from app.optics.registry import default_registry
    >>> glass = measure(default_registry()["schlick"], Interface(n_t=1.5))
    >>> albedo = 0.04 + 0.96 / 21 - float(glass["cosine_weighted_mean"])
    >>> round(albedo, 9)
    0.091777959
    """
    values = model.arguments(interface) if arguments is None else arguments
    kinks = None if model.kinks is None else model.kinks(**values)
    rule, nodes = _split_at(kinks, quality)
    media = (interface.n_i, interface.n_t, interface.k_t)
    shape = np.broadcast_shapes(*(a.shape for a in (*media, *values.values())))
    total = int(np.prod(shape, dtype=np.int64))
    if total * nodes > quality.most_nodes:
        most = quality.most_nodes // nodes
        raise NotAllowed("steps", total, f"at most {most} interfaces at once with {model.id}")
    curves = _ErrorCurves(
        model,
        Interface(*(np.broadcast_to(m, shape).reshape(-1, 1) for m in media)),
        {
            n: v if v.ndim == 0 else np.broadcast_to(v, shape).reshape(-1, 1)
            for n, v in values.items()
        },
        quality.reference,
    )
    gentle, own = np.zeros(total, dtype=bool), None
    if kinks is not None and kinks.ndim > 1:
        own = np.broadcast_to(kinks, (*(shape or (1,)), kinks.shape[-1]))
        own = own.reshape(total, -1)
    if quality.gentle_rule is not None and (kinks is None or own is not None):
        gentle = bends_gently(curves.interface)[:, 0]
        if own is not None:
            gentle &= np.isnan(own).all(axis=1)
        same = whole(quality.gentle_rule)
    result: dict[Metric, Array] = {name: np.empty(total) for name in wanted}
    # A cheap form loses its digits where R is small, near N = n_i, which only relative errors show.
    relative = not _RELATIVE.isdisjoint(wanted)
    sharp = replace(curves, reference=reflectance) if relative else curves
    for rows in _blocks(np.flatnonzero(gentle), 2 * same.mu.size if gentle.any() else 1):
        found, gentle[rows] = _metrics(curves.part(rows), same, quality, wanted)
        for name, column in found.items():
            result[name][rows] = column
    for rows in _blocks(np.flatnonzero(~gentle), nodes):
        part = sharp.part(rows)
        ends = kinks if own is None else _somewhere(own[rows])[:, np.newaxis]
        split = hemisphere(part.interface, rule, ends)
        flat = Nodes(split.mu[:, 0], split.w[:, 0])
        found, _ = _metrics(part, flat, quality, wanted)
        for name, column in found.items():
            result[name][rows] = column
    return {name: column.reshape(shape) for name, column in result.items()}


def affordable(model: Model, arguments: Mapping[str, Array], quality: Quality, count: int) -> bool:
    """Whether so many interfaces may be measured in one call."""
    kinks = None if model.kinks is None else model.kinks(**arguments)
    return count * _split_at(kinks, quality)[1] <= quality.most_nodes


def _split_at(kinks: Array | None, quality: Quality) -> tuple[Rule, int]:
    """The rule between kinks, and how many nodes an interface takes."""
    rule = quality.rule if kinks is None or kinks.ndim > 1 else quality.kinked_rule
    return rule, (2 if kinks is None else kinks.shape[-1] + 2) * (rule.x.size + 1) + 1


def _somewhere(kinks: Array) -> Array:
    """Put an end that is as good as any in the place of kinks that a curve does not have."""
    any_other = np.linspace(0.5, 0.75, kinks.shape[-1])
    return np.where(np.isnan(kinks), any_other, kinks)


def _blocks(rows: NDArray[np.intp], values_per_row: int) -> Iterator[NDArray[np.intp]]:
    size = max(1, _CACHE_SIZE // values_per_row)
    for start in range(0, rows.size, size):
        yield rows[start : start + size]


@dataclass(frozen=True, slots=True)
class _ErrorCurves:
    """Signed error over mu, a row for each interface; interface and arguments are columns."""

    model: Model
    interface: Interface
    arguments: Mapping[str, Array]
    reference: Callable[[Interface, Incidence], Array]

    def part(self, rows: NDArray[np.intp]) -> _ErrorCurves:
        """Some of the rows."""
        media = (self.interface.n_i, self.interface.n_t, self.interface.k_t)
        arguments = {n: v if v.ndim == 0 else v[rows] for n, v in self.arguments.items()}
        interface = Interface(*(column[rows] for column in media))
        return replace(self, interface=interface, arguments=arguments)

    def at(self, mu: Array) -> tuple[Array, Array]:
        """Error and exact R at cosines of shape (any,) or (rows, any)."""
        incidence = Incidence(mu, np.sqrt((1.0 - mu) * (1.0 + mu)))
        exact = self.reference(self.interface, incidence)
        return self.model.evaluate(self.interface, incidence, self.arguments) - exact, exact

    def error_at(self, mu: Array) -> Array:
        """Error alone."""
        return self.at(mu)[0]

    def relative_at(self, mu: Array) -> Array:
        """Error over exact R; infinite where only the exact R is 0."""
        return _relative(*self.at(mu))


def _relative(error: Array, exact: Array) -> Array:
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(error == 0.0, 0.0, error / exact)


def _metrics(
    curves: _ErrorCurves, nodes: Nodes, quality: Quality, wanted: Collection[Metric]
) -> tuple[dict[Metric, Array], NDArray[np.bool_]]:
    """Metrics of each curve, and whether the nodes tell enough of it to find the largest error."""
    error, exact = curves.at(nodes.mu)
    gaps = np.isnan(error)
    undefined = np.any(gaps & (nodes.w > 0.0), axis=1)
    if gaps.any():  # at a single angle, as at the tangent's 90 degrees, nothing is lost
        error = np.where(gaps, 0.0, error)
    result: dict[Metric, Array] = {}
    if "rms" in wanted:
        result["rms"] = root_mean_square(error, nodes)
    if "cosine_weighted_mean" in wanted:
        result["cosine_weighted_mean"] = cosine_weighted_mean(error, nodes)

    followed = np.ones(len(error), dtype=bool)

    def largest_of(values: Array, function: Callable[[Array], Array]) -> Peaks:
        if nodes.mu.ndim == 2:
            return largest(function, nodes.mu, values, quality.points, quality.rounds)
        # Nodes common to all curves lie closest, as a polynomial's should, in the root of mu.
        peak = largest_of_smooth(np.sqrt(nodes.mu), values)
        there = function((peak.at**2)[:, np.newaxis])[:, 0]
        apart = np.abs(there - peak.value)
        np.logical_and(followed, apart <= _ASTRAY * np.abs(there) + ROUNDING, out=followed)
        return Peaks(there, peak.at**2)

    if not _LARGEST.isdisjoint(wanted):
        peak = largest_of(error, curves.error_at)
        result["max_abs"] = np.abs(peak.value)
        result["error_at_max"] = peak.value
        result["max_abs_at_deg"] = _degrees(peak.at)
    if not _RELATIVE.isdisjoint(wanted):
        peak = largest_of(_relative(error, exact), curves.relative_at)
        result["max_relative"] = np.abs(peak.value)
        result["max_relative_at_deg"] = _degrees(peak.at)
    return {name: np.where(undefined, np.nan, result[name]) for name in wanted}, followed


def _degrees(mu: Array) -> Array:
    return np.degrees(np.arctan2(np.sqrt((1.0 - mu) * (1.0 + mu)), mu))
