"""`/engines`: what render engines reflect, as measured by running them."""

from typing import Annotated

from fastapi import APIRouter, Query

from app.answers.engines import EngineCurves, MeasuredEngine, MeasuredEngines, engine_curves
from app.engines.measured import UnknownEngine, engines
from app.http.problems import MissingResource
from app.http.query import DigitsQuery
from app.http.route import LastingRoute
from app.optics.registry import Registry


def router(registry: Registry) -> APIRouter:
    """Routes over the engines, explained by the models of `registry`."""
    routes = APIRouter(route_class=LastingRoute, tags=["engines"])

    @routes.get("/engines", summary="The render engines that were measured")
    def every() -> MeasuredEngines:
        return MeasuredEngines(engines=[MeasuredEngine.of(e) for e in engines().values()])

    @routes.get("/engines/{engine}", summary="What one engine reflects")
    def one(engine: str, query: Annotated[DigitsQuery, Query()]) -> EngineCurves:  # noqa: ARG001
        try:
            found = engines().find(engine)
        except UnknownEngine as error:
            raise MissingResource(error) from None
        return engine_curves(found, registry)

    return routes
