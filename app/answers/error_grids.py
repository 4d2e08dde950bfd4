"""Errors of one model along a line and over a rectangle of interfaces."""

from collections.abc import Mapping
from typing import Literal, cast

import numpy as np

from app.answers.answer import Gaps, Rows, Table, Values, answer
from app.answers.axes import SETS, Axis, Grid, held, interfaces
from app.answers.curves import Chosen
from app.answers.errors import FIGURES, MEASURE, FigureName, figures, metric_of
from app.answers.interface import CONVENTION
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import (
    FAST,
    POINT_METRICS,
    Metric,
    PointMetric,
    affordable,
    measure,
    point_error,
)
from app.optics.numerics.peaks import SUMMIT_VALUES, summit
from app.optics.parameters import Array

MapMetric = Literal[Metric, PointMetric, "albedo_error"]


@answer
class ErrorGrid:
    """Errors of one model at many interfaces."""

    model: str
    convention: str = CONVENTION
    measure: str = MEASURE
    n_i: float | None
    """Null if it varies."""
    n_t: float | None
    """Null if it or eta varies."""
    k_t: float | None
    """Null if it varies."""


@answer
class ErrorSweep(ErrorGrid):
    """Errors of one model along a line of interfaces; every list has the length of `values`."""

    over: str
    values: Values
    in_domain: list[bool]
    max_abs: Gaps
    max_abs_at_deg: Gaps
    error_at_max: Gaps
    rms: Gaps
    cosine_weighted_mean: Gaps
    max_relative: Gaps
    max_relative_at_deg: Gaps
    albedo_error: Gaps

    def table(self) -> Table:
        """Lay out a row each interface."""
        columns: dict[str, Array] = {name: getattr(self, name) for name in FIGURES}
        return Table({self.over: self.values} | columns, "fresnel_error_sweep.csv")


@answer
class LargestError:
    """Where the modulus of a map is largest, found by a search that its grid does not bound."""

    value: float
    x: float
    y: float


@answer
class ErrorMap(ErrorGrid):
    """Errors of one model over a rectangle."""

    metric: str
    x: Axis
    y: Axis
    values: Rows
    """A row for every y, a column for every x."""
    largest: LargestError | None
    """Between the points too; null where it grows without bound, is an angle, or would take too long, as
    with large tables."""

    def table(self) -> Table:
        """Lay out a row each point."""
        columns = Grid(Interface(), self.x, self.y).columns()
        return Table(columns | {self.metric: self.values.ravel()}, "fresnel_error_map.csv")


def error_sweep(chosen: Chosen, fixed: Interface, axis: Axis) -> ErrorSweep:
    """Measure a model along an axis."""
    interface, model = Grid(fixed, axis).interface, chosen.model
    metrics = measure(model, interface, chosen.of_one_color().arguments(interface))
    media = np.broadcast_arrays(interface.n_i, interface.n_t, interface.k_t)
    points = (Interface(*point) for point in zip(*(m.tolist() for m in media), strict=True))
    return ErrorSweep(
        model=model.id,
        **held(fixed, axis.name),
        over=axis.name,
        values=axis.values,
        in_domain=[model.reason_outside(point) is None for point in points],
        **figures(metrics),
    )


def map_metric(x: str, y: str, metric: MapMetric | None) -> MapMetric:
    """Choose the metric that fits the axes of a map.

    Raises
    ------
    NotAllowed
        If the one asked for does not, or if the axes are the same.
    """
    if SETS.get(x, x) == SETS.get(y, y):
        raise NotAllowed("y", y, f"something else than x, {x}, varies")
    by_angle = "theta_i_deg" in (x, y)
    allowed: tuple[MapMetric, ...] = POINT_METRICS if by_angle else FIGURES
    metric = metric or ("error" if by_angle else "max_abs")
    if metric not in allowed:
        where = "with theta_i_deg as an axis" if by_angle else "without theta_i_deg as an axis"
        raise NotAllowed("metric", metric, f"one of {', '.join(allowed)} {where}")
    return metric


def error_map(chosen: Chosen, fixed: Interface, x: Axis, y: Axis, metric: MapMetric) -> ErrorMap:
    """Measure a model over a rectangle, by the metric that `map_metric` chose."""
    model, one_color = chosen.model, chosen.of_one_color()

    def at(varied: Mapping[str, Array]) -> Array:
        interface = interfaces(fixed, varied)
        arguments = one_color.arguments(interface)
        if "theta_i_deg" in varied:
            incidence = Incidence.from_degrees(varied["theta_i_deg"])
            at_points = cast("PointMetric", metric)
            return point_error(model, interface, incidence, arguments, at_points)
        name = metric_of(cast("FigureName", metric))
        return measure(model, interface, arguments, FAST, [name])[name]

    def anywhere(x_values: Array, y_values: Array) -> Array:
        return at({x.name: x_values, y.name: y_values})

    # The grid first: one of more nodes than a call may take is refused before anything is sought.
    values = np.ascontiguousarray(at(Grid(fixed, x, y).varied))
    ends = [(float(axis.values[0]), float(axis.values[-1])) for axis in (x, y)]
    is_sought = not metric.endswith("_deg") and (
        metric in POINT_METRICS
        or affordable(model, one_color.arguments(fixed), FAST, SUMMIT_VALUES)
    )
    found = summit(anywhere, *ends) if is_sought else None
    return ErrorMap(
        model=model.id,
        **held(fixed, x.name, y.name),
        metric=metric,
        x=x,
        y=y,
        values=values,
        largest=found and LargestError(value=found.value, x=found.x, y=found.y),
    )
