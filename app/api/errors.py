"""`/errors`: how wrong models are at one interface."""

# No `from __future__ import annotations` here: the query's type is made from the registry at run
# time, and FastAPI could not look up its name.

from collections.abc import Mapping
from typing import Annotated, Any, Literal

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.answers.curves import sampled_incidence
from app.api.answers import Answer, Large
from app.api.error_schemas import MEASURE, ErrorsOut, figures_json
from app.api.model_parameters import (
    ModelsParameter,
    model_arguments,
    parse_models,
    refuse_foreign_parameters,
    with_model_parameters,
)
from app.api.params import InterfaceQuery, SamplesQuery
from app.api.responses import CONVENTION, csv_body, interface_json, json_body
from app.api.row_table import rows_csv_body
from app.http.query import TableQuery
from app.http.route import QueryRoute
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import METRICS, measure, point_error
from app.optics.parameters import Array
from app.optics.registry import Model, Registry

COLUMNS = ["model", "quantity", "in_domain", "reason", *METRICS, "albedo_error"]

_COLORS = ("R_red", "R_green", "R_blue")


class ErrorsQuery(InterfaceQuery, SamplesQuery, TableQuery):
    """Errors of models at one interface."""

    models: ModelsParameter = "schlick"
    relative: bool = Field(False, description="Add the relative error over the angle.")
    table: Literal["metrics", "curves"] = Field(
        "metrics", description="What CSV holds: a row a model, or the error over the angle."
    )


def model_errors(
    model: Model,
    interface: Interface,
    incidence: Incidence,
    arguments: Mapping[str, Array],
    relative: bool,
) -> list[dict[str, Any]]:
    """Describe the errors of a model, one row or, for a triple, three."""
    reason = model.reason_outside(interface)
    metrics = measure(model, interface, arguments)
    curves = {"error": point_error(model, interface, incidence, arguments)}
    if relative:
        curves["relative_error"] = point_error(model, interface, incidence, arguments, "relative")
    triple = metrics["rms"].ndim > 0
    rows = []
    for channel, quantity in enumerate(_COLORS if triple else ("R",)):

        def of(values: Array, channel: int = channel) -> float:
            return float(values.ravel()[channel if values.size > 1 else 0])

        rows.append(
            {
                "model": model.id,
                "title": model.title,
                "quantity": quantity,
                "in_domain": reason is None,
                "reason": reason,
                "parameters": {name: of(value) for name, value in arguments.items()},
                **figures_json({name: of(values) for name, values in metrics.items()}),
                **{
                    name: np.ascontiguousarray(np.atleast_2d(curve)[channel])
                    for name, curve in curves.items()
                },
            }
        )
    return rows


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["errors"])
    Query_ = with_model_parameters(ErrorsQuery, registry)

    def respond(query: ErrorsQuery, models: list[Model], interface: Interface) -> Response:
        incidence = sampled_incidence(interface, query.samples, query.landmarks)
        rows = [
            row
            for model in models
            for row in model_errors(
                model,
                interface,
                incidence,
                model.arguments(interface, **model_arguments(query, model)),
                query.relative,
            )
        ]
        rows.sort(key=lambda row: (np.isnan(row["rms"]), row["rms"], row["model"]))
        if query.format == "csv" and query.table == "curves":
            columns = {
                f"{row['model']}.{row['quantity']}.{name}": row[name]
                for row in rows
                for name in ("error", "relative_error")
                if name in row
            }
            columns = {"theta_i_deg": incidence.theta_i_deg} | columns
            return csv_body(columns, query.digits, "fresnel_errors.csv")
        if query.format == "csv":
            return rows_csv_body(COLUMNS, rows, query.digits, "fresnel_errors.csv")
        payload = {
            "interface": interface_json(interface),
            "convention": CONVENTION,
            "reference": "exact",
            "measure": MEASURE,
            "theta_i_deg": incidence.theta_i_deg,
            "errors": rows,
        }
        return json_body(payload, query.digits)

    @routes.get("/errors", response_model=ErrorsOut, summary="How wrong models are")
    def errors(query: Annotated[Query_, Query()]) -> Answer:  # type: ignore[valid-type]
        return answer(query)

    def answer(query: ErrorsQuery) -> Answer:
        models = parse_models(query.models, registry)
        refuse_foreign_parameters(query, models, registry)
        return Large(respond, query, models, query.interface())

    return routes
