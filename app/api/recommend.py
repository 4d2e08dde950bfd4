"""`/recommend`: the cheapest models that stay within an error."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.api.answers import Answer, Large
from app.api.error_schemas import MEASURE, RecommendationOut, figures_json
from app.api.params import InterfaceQuery
from app.api.responses import CONVENTION, interface_json, json_body
from app.api.row_table import rows_csv_body
from app.http.query import Number, TableQuery
from app.http.route import QueryRoute
from app.optics.interface import Interface
from app.optics.metrics import METRICS, Metric
from app.optics.recommendation import WEIGHTS, Candidate, recommend
from app.optics.registry import Registry

COLUMNS = ["model", "accepted", "weighted_cost", *METRICS, "albedo_error", "reason"]


class RecommendQuery(InterfaceQuery, TableQuery):
    """An interface and the error that is acceptable."""

    max_error: Number = Field(
        0.02, gt=0.0, le=1.0, allow_inf_nan=False, description="Largest acceptable error."
    )
    metric: Literal["max_abs", "rms", "cosine_weighted_mean", "albedo_error", "max_relative"] = (
        Field("max_abs", description="What has to stay within max_error; a mean by its modulus.")
    )


def candidate_json(candidate: Candidate, interface: Interface) -> dict[str, Any]:
    """Describe a model with its figures and why it is refused, if it is."""
    model = candidate.model
    return {
        "model": model.id,
        "title": model.title,
        "kind": model.kind,
        "cost": asdict(model.cost),
        "weighted_cost": candidate.cost,
        "parameters": {n: float(value) for n, value in model.arguments(interface).items()},
        "figures": None if candidate.figures is None else figures_json(candidate.figures),
        "reason": candidate.reason,
    }


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["errors"])

    def respond(query: RecommendQuery) -> Response:
        interface = query.interface()
        metric: Metric = "cosine_weighted_mean" if query.metric == "albedo_error" else query.metric
        accepted, refused = (
            [candidate_json(candidate, interface) for candidate in candidates]
            for candidates in recommend(registry.values(), interface, query.max_error, metric)
        )
        if query.format == "csv":
            rows = [
                {**row, **(row["figures"] or {}), "accepted": row["reason"] is None}
                for row in (*accepted, *refused)
            ]
            return rows_csv_body(COLUMNS, rows, query.digits, "fresnel_models.csv")
        payload = {
            "interface": interface_json(interface),
            "convention": CONVENTION,
            "measure": MEASURE,
            "metric": query.metric,
            "max_error": query.max_error,
            "weights": WEIGHTS,
            "models": accepted,
            "refused": refused,
        }
        return json_body(payload, query.digits)

    @routes.get(
        "/recommend", response_model=RecommendationOut, summary="The cheapest models that will do"
    )
    def recommended(query: Annotated[RecommendQuery, Query()]) -> Answer:
        return Large(respond, query)

    return routes
