"""`/errors`, `/errors/sweep`, `/errors/map` and `/errors/mesh`: how wrong models and meshes are."""

from typing import Annotated, ClassVar, Literal

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.answer import Table
from app.answers.axes import (
    MOST_CELLS,
    MOST_STEPS,
    AxisName,
    Scale,
    SweptName,
    refuse_many_cells,
)
from app.answers.error_grids import (
    ErrorMap,
    ErrorSweep,
    MapMetric,
    error_map,
    error_sweep,
    map_metric,
)
from app.answers.errors import Errors
from app.answers.errors import errors as measured
from app.answers.mesh import MeshErrors, errors_of_mesh
from app.api.axes import end, swept
from app.api.model_parameters import (
    ModelId,
    ModelQuery,
    ModelsParameter,
    ModelsQuery,
    with_parameters_of,
)
from app.api.params import InterfaceQuery, SamplesQuery
from app.http.query import Count, LongQuery, Number, TableQuery
from app.http.route import QueryRoute
from app.optics.mesh import LATITUDES, Spacing
from app.optics.registry import Registry


class ErrorsQuery(ModelsQuery, InterfaceQuery, SamplesQuery, TableQuery, LongQuery):
    """Errors of models at one interface."""

    models: ModelsParameter = "schlick"
    relative: bool = Field(False, description="Add the relative error over the angle.")
    table: Literal["metrics", "curves"] = Field(
        "metrics", description="What CSV holds: a row a model, or the error over the angle."
    )


class ErrorSweepQuery(ModelQuery, InterfaceQuery, TableQuery, LongQuery):
    """Errors of a model along a line of interfaces."""

    model: ModelId = "schlick"
    over: SweptName = Field("n_t", description="What is swept; eta = n_t / n_i.")
    minimum: Number | None = end("First value; 0.1 for indices and 0 for k_t unless given.")
    maximum: Number | None = end("Last value; 5 unless given.")
    steps: Count = Field(101, ge=2, le=MOST_STEPS, description="Number of values.")
    scale: Scale = Field("linear", description="Equal differences or equal ratios.")


class ErrorMapQuery(ModelQuery, InterfaceQuery, TableQuery, LongQuery):
    """Errors of a model over a rectangle: angle by index, or index by extinction."""

    cells: ClassVar[tuple[str, ...]] = ("x_steps", "y_steps")

    model: ModelId = "schlick"
    x: AxisName = Field("theta_i_deg", description="Horizontal axis.")
    x_minimum: Number | None = end("First x; d'Eon's ranges unless given.")
    x_maximum: Number | None = end("Last x.")
    x_steps: Count = Field(181, ge=2, le=MOST_CELLS // 2, description="Number of x.")
    y: AxisName = Field("n_t", description="Vertical axis.")
    y_minimum: Number | None = end("First y.")
    y_maximum: Number | None = end("Last y.")
    y_steps: Count = Field(121, ge=2, le=MOST_CELLS // 2, description="Number of y.")
    metric: MapMetric | None = Field(
        None,
        description="With theta_i_deg as an axis error (the default), absolute or relative, at each "
        "angle; otherwise a figure over the hemisphere, max_abs by default.",
    )


class MeshQuery(InterfaceQuery, TableQuery):
    """A sphere of facets."""

    latitudes: Count = Field(
        int(LATITUDES.default or 0),
        ge=int(LATITUDES.minimum),
        le=int(LATITUDES.maximum),
        description=LATITUDES.description,
    )
    spacing: Spacing = Field(
        "angle", description="Rings at equal differences of the angle, or of its cosine."
    )


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["errors"])

    @routes.get("/errors", response_model=Errors, summary="How wrong models are")
    @with_parameters_of(registry)
    def errors(query: Annotated[ErrorsQuery, Query()]) -> Errors | Table:
        answer = measured(
            query.interface(),
            query.chosen(),
            samples=query.samples,
            landmarks=query.landmarks,
            relative=query.relative,
        )
        over_angle = query.format == "csv" and query.table == "curves"
        return answer.curves() if over_angle else answer

    @routes.get("/errors/sweep", summary="Errors over n_t, k_t or eta")
    @with_parameters_of(registry)
    def sweep(query: Annotated[ErrorSweepQuery, Query()]) -> ErrorSweep:
        chosen = query.chosen()
        axis = swept(query, query.over, "", query.steps, query.scale)
        return error_sweep(chosen, query.interface(), axis)

    @routes.get("/errors/map", summary="Errors over a rectangle")
    @with_parameters_of(registry)
    def rectangle(query: Annotated[ErrorMapQuery, Query()]) -> ErrorMap:
        chosen = query.chosen()
        refuse_many_cells("x_steps", x_steps=query.x_steps, y_steps=query.y_steps)
        metric = map_metric(query.x, query.y, query.metric)
        x = swept(query, query.x, "x_", query.x_steps)
        y = swept(query, query.y, "y_", query.y_steps)
        return error_map(chosen, query.interface(), x, y, metric)

    @routes.get("/errors/mesh", summary="Errors of shading per vertex and per pixel")
    def mesh(query: Annotated[MeshQuery, Query()]) -> MeshErrors:
        return errors_of_mesh(query.interface(), query.latitudes, query.spacing)

    return routes
