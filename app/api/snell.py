"""`/snell`: one ray at the interface."""

from typing import Annotated

from fastapi import APIRouter, Query

from app.answers.snell import CoatedRay, Ray, ray
from app.api.params import AngleQuery, ConventionQuery, LayersQuery, number
from app.http.query import DigitsQuery, Number
from app.http.route import QueryRoute
from app.optics.parameters import K_I


class SnellQuery(DigitsQuery, ConventionQuery, AngleQuery, LayersQuery):
    """One ray."""

    k_i: Number = number(K_I)


def router() -> APIRouter:
    """Routes about one ray."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get("/snell", summary="One ray at the surface")
    def snell(query: Annotated[SnellQuery, Query()]) -> Ray | CoatedRay:
        return ray(query.interface(), query.incidence(), query.coated(), query.signs())

    return routes
