"""`/benchmarks`: printed tables of R, beside what a model answers."""

from typing import Annotated

from fastapi import APIRouter, Query

from app.answers.benchmark import BenchmarkTable, deon_table
from app.api.model_parameters import ModelQuery, with_parameters_of
from app.http.query import TableQuery
from app.http.route import QueryRoute
from app.optics.registry import Registry


class BenchmarkQuery(ModelQuery, TableQuery):
    """Which model."""


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get("/benchmarks/deon2019", summary="All 108 cells of d'Eon's printed tables of R")
    @with_parameters_of(registry)
    def deon(query: Annotated[BenchmarkQuery, Query()]) -> BenchmarkTable:
        return deon_table(query.chosen())

    return routes
