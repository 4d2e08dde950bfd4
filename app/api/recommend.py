"""`/recommend`: the cheapest models that stay within an error."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.recommendation import Recommendation, recommendation
from app.api.params import InterfaceQuery
from app.http.query import LongQuery, Number, TableQuery
from app.http.route import QueryRoute
from app.optics.registry import Registry


class RecommendQuery(InterfaceQuery, TableQuery, LongQuery):
    """An interface and the error that is acceptable."""

    max_error: Number = Field(
        0.02, gt=0.0, le=1.0, allow_inf_nan=False, description="Largest acceptable error."
    )
    metric: Literal["max_abs", "rms", "cosine_weighted_mean", "albedo_error", "max_relative"] = (
        Field("max_abs", description="What has to stay within max_error; a mean by its modulus.")
    )


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["errors"])

    @routes.get("/recommend", summary="The cheapest models that will do")
    def recommend(query: Annotated[RecommendQuery, Query()]) -> Recommendation:
        models = registry.values()
        return recommendation(models, query.interface(), query.max_error, query.metric)

    return routes
