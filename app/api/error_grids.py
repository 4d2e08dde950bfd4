"""`/errors/sweep` and `/errors/map`: errors of one model along a line and over a rectangle."""

# No `from __future__ import annotations` here: the query's type is made from the registry at run
# time, and FastAPI could not look up its name.

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, cast

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.api.answers import Answer, Large
from app.api.error_schemas import MEASURE, ErrorMapOut, ErrorSweepOut, figures_json
from app.api.model_parameters import (
    model_arguments,
    refuse_foreign_parameters,
    with_model_parameters,
)
from app.api.params import InterfaceQuery
from app.api.responses import CONVENTION, csv_body, json_body
from app.http.query import Count, Number, TableQuery
from app.http.route import QueryRoute
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import (
    FAST,
    METRICS,
    POINT_METRICS,
    Metric,
    PointMetric,
    measure,
    point_error,
)
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, Array
from app.optics.registry import Model, Registry

MOST_STEPS = 2001
MOST_CELLS = 250_000

Swept = Literal["n_t", "k_t", "eta"]
AxisName = Literal["theta_i_deg", "n_t", "k_t", "eta", "n_i"]
Scale = Literal["linear", "log"]
MapMetric = Literal[Metric, PointMetric, "albedo_error"]

_DECLARED = {"theta_i_deg": THETA_I_DEG, "n_t": N_T, "k_t": K_T, "eta": N_T, "n_i": N_I}
_RANGES = {
    "theta_i_deg": (0.0, 90.0),
    "n_t": (0.1, 5.0),
    "k_t": (0.0, 5.0),
    "eta": (0.1, 5.0),
    "n_i": (1.0, 2.0),
}
_SETS = {"n_t": "n_t", "eta": "n_t", "k_t": "k_t", "n_i": "n_i"}
"""The parameter of the interface that an axis sets."""

ModelId = Annotated[str, Field(description="Id of a model, as listed at /models.")]


def _end(description: str) -> Any:
    return Field(None, allow_inf_nan=False, description=description)


class ErrorSweepQuery(InterfaceQuery, TableQuery):
    """Errors of a model along a line of interfaces."""

    model: ModelId = "schlick"
    over: Swept = Field("n_t", description="What is swept; eta = n_t / n_i.")
    minimum: Number | None = _end("First value; 0.1 for indices and 0 for k_t unless given.")
    maximum: Number | None = _end("Last value; 5 unless given.")
    steps: Count = Field(101, ge=2, le=MOST_STEPS, description="Number of values.")
    scale: Scale = Field("linear", description="Equal differences or equal ratios.")


class ErrorMapQuery(InterfaceQuery, TableQuery):
    """Errors of a model over a rectangle: angle by index, or index by extinction."""

    cells: ClassVar[tuple[str, ...]] = ("x_steps", "y_steps")

    model: ModelId = "schlick"
    x: AxisName = Field("theta_i_deg", description="Horizontal axis.")
    x_minimum: Number | None = _end("First x; d'Eon's ranges unless given.")
    x_maximum: Number | None = _end("Last x.")
    x_steps: Count = Field(181, ge=2, le=MOST_CELLS // 2, description="Number of x.")
    y: AxisName = Field("n_t", description="Vertical axis.")
    y_minimum: Number | None = _end("First y.")
    y_maximum: Number | None = _end("Last y.")
    y_steps: Count = Field(121, ge=2, le=MOST_CELLS // 2, description="Number of y.")
    metric: MapMetric | None = Field(
        None,
        description="With theta_i_deg as an axis error (the default), absolute or relative, at each "
        "angle; otherwise a figure over the hemisphere, max_abs by default.",
    )


class Axis(NamedTuple):
    """What varies, and its values."""

    name: str
    values: Array


def make_axis(
    query: InterfaceQuery, name: str, prefix: str, steps: int, scale: Scale = "linear"
) -> Axis:
    """Spread an axis between the ends that the query gives, or its usual ones.

    Raises
    ------
    OutOfRange
        If an end is out of the bounds of what varies.
    NotAllowed
        If the ends are not in order, or what varies is given too.
    """
    fixed, unit = _SETS.get(name), query.n_i if name == "eta" else 1.0
    preset = {"n_t": "material", "k_t": "material", "n_i": "incident"}.get(fixed or "")
    for given in (fixed, preset):
        value = None if given is None else getattr(query, given)
        explicit = given == preset or given in query.model_fields_set
        if given is not None and explicit and value is not None:
            raise NotAllowed(given, value, f"not beside {name} as what varies, which sets it")
    low, high = _DECLARED[name].minimum / unit, _DECLARED[name].maximum / unit
    ends: list[float] = []
    for end, usual in zip(("minimum", "maximum"), _RANGES[name], strict=True):
        given_end = getattr(query, prefix + end)
        value = usual if given_end is None else given_end
        if not low <= value <= high:
            raise OutOfRange(prefix + end, value, f"from {low:g} to {high:g} for {name}")
        ends.append(value)
    if ends[0] >= ends[1]:
        raise NotAllowed(prefix + "minimum", ends[0], f"below {prefix}maximum, {ends[1]:g}")
    if scale == "linear":
        return Axis(name, np.linspace(ends[0], ends[1], steps))
    if ends[0] <= 0.0:
        raise NotAllowed(prefix + "minimum", ends[0], "above 0 where scale=log")
    return Axis(name, np.geomspace(ends[0], ends[1], steps))


def interface_over(query: InterfaceQuery, varied: Mapping[str, Array]) -> Interface:
    """Put the values of the axes in place of the query's."""
    n_i, n_t = varied.get("n_i", query.n_i), varied.get("n_t", query.n_t)
    if "eta" in varied:  # eta n_i may round past a bound
        n_t = np.clip(varied["eta"] * n_i, N_T.minimum, N_T.maximum)
    return Interface(n_i, n_t, varied.get("k_t", query.k_t))


def fixed_indices(query: InterfaceQuery, *names: str) -> dict[str, float | None]:
    """The indices that do not vary; None for those that do."""
    varied = {_SETS.get(name) for name in names}
    return {n: None if n in varied else getattr(query, n) for n in ("n_i", "n_t", "k_t")}


def scalar_arguments(query: InterfaceQuery, model: Model) -> dict[str, Any]:
    """The model's own parameters, one number each.

    Raises
    ------
    NotAllowed
        If one is a triple, of which a line or a map can show but one channel.
    """
    arguments = model_arguments(query, model)
    for name, value in arguments.items():
        if np.ndim(value) > 0:  # type: ignore[arg-type]
            given = ",".join(f"{number:g}" for number in np.ravel(value))  # type: ignore[arg-type]
            raise NotAllowed(f"{model.id}.{name}", given, "one number here, not three")
    return arguments


def _inside(model: Model, interface: Interface) -> list[bool]:
    media = np.broadcast_arrays(interface.n_i, interface.n_t, interface.k_t)
    points = zip(*(m.tolist() for m in media), strict=True)
    return [model.reason_outside(Interface(*point)) is None for point in points]


def _sweep(query: ErrorSweepQuery, model: Model) -> Response:
    axis = make_axis(query, query.over, "", query.steps, query.scale)
    interface = interface_over(query, {axis.name: axis.values})
    arguments = model.arguments(interface, **scalar_arguments(query, model))
    columns: dict[str, Array] = figures_json(measure(model, interface, arguments))
    if query.format == "csv":
        columns = {query.over: axis.values} | columns
        return csv_body(columns, query.digits, "fresnel_error_sweep.csv")
    payload = {
        "model": model.id,
        "convention": CONVENTION,
        "measure": MEASURE,
        **fixed_indices(query, axis.name),
        "over": query.over,
        "values": axis.values,
        "in_domain": _inside(model, interface),
        **columns,
    }
    return json_body(payload, query.digits)


def map_metric(query: ErrorMapQuery) -> MapMetric:
    """Choose the metric that fits the axes.

    Raises
    ------
    NotAllowed
        If the one asked for does not, if the axes are the same or there are too many cells.
    """
    cells = query.x_steps * query.y_steps
    if cells > MOST_CELLS:
        raise NotAllowed("x_steps", query.x_steps, f"x_steps times y_steps at most {MOST_CELLS}")
    if _SETS.get(query.x, query.x) == _SETS.get(query.y, query.y):
        raise NotAllowed("y", query.y, f"something else than x, {query.x}, varies")
    by_angle = "theta_i_deg" in (query.x, query.y)
    allowed = POINT_METRICS if by_angle else (*METRICS, "albedo_error")
    metric = query.metric or ("error" if by_angle else "max_abs")
    if metric not in allowed:
        where = "with theta_i_deg as an axis" if by_angle else "without theta_i_deg as an axis"
        raise NotAllowed("metric", metric, f"one of {', '.join(allowed)} {where}")
    return metric


def _map(query: ErrorMapQuery, model: Model, metric: MapMetric) -> Response:
    x, y = (
        make_axis(query, query.x, "x_", query.x_steps),
        make_axis(query, query.y, "y_", query.y_steps),
    )
    varied = {x.name: x.values[np.newaxis, :], y.name: y.values[:, np.newaxis]}
    interface = interface_over(query, varied)
    arguments = model.arguments(interface, **scalar_arguments(query, model))
    if "theta_i_deg" in varied:
        incidence = Incidence.from_degrees(varied["theta_i_deg"])
        values = point_error(model, interface, incidence, arguments, cast("PointMetric", metric))
    else:
        name: Metric = (
            "cosine_weighted_mean" if metric == "albedo_error" else cast("Metric", metric)
        )
        values = measure(model, interface, arguments, FAST, [name])[name]
    values = np.ascontiguousarray(values)
    if query.format == "csv":
        xs, ys = np.broadcast_arrays(x.values[np.newaxis, :], y.values[:, np.newaxis])
        columns = {x.name: xs.ravel(), y.name: ys.ravel(), metric: values.ravel()}
        return csv_body(columns, query.digits, "fresnel_error_map.csv")
    payload = {
        "model": model.id,
        "convention": CONVENTION,
        "measure": MEASURE,
        **fixed_indices(query, x.name, y.name),
        "metric": metric,
        "x": x._asdict(),
        "y": y._asdict(),
        "values": values,
    }
    return json_body(payload, query.digits)


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["errors"])
    Sweep_ = with_model_parameters(ErrorSweepQuery, registry)
    Map_ = with_model_parameters(ErrorMapQuery, registry)

    def asked_for(query: ErrorSweepQuery | ErrorMapQuery) -> Model:
        model = registry.find(query.model, "model")
        refuse_foreign_parameters(query, [model], registry)
        return model

    @routes.get(
        "/errors/sweep", response_model=ErrorSweepOut, summary="Errors over n_t, k_t or eta"
    )
    def sweep(query: Annotated[Sweep_, Query()]) -> Answer:  # type: ignore[valid-type]
        return answer_sweep(query)

    def answer_sweep(query: ErrorSweepQuery) -> Answer:
        return Large(_sweep, query, asked_for(query))

    @routes.get("/errors/map", response_model=ErrorMapOut, summary="Errors over a rectangle")
    def error_map(query: Annotated[Map_, Query()]) -> Answer:  # type: ignore[valid-type]
        return answer_map(query)

    def answer_map(query: ErrorMapQuery) -> Answer:
        model, metric = asked_for(query), map_metric(query)
        return Large(_map, query, model, metric)

    return routes
