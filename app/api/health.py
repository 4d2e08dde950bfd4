"""`/health`: whether the server works, and what it is made of."""

from __future__ import annotations

from importlib.metadata import version

import orjson
from fastapi import APIRouter

from app import __version__
from app.api.route import QueryRoute
from app.api.schemas import HealthOut
from app.ready import ReadyBody

_LIBRARIES = {
    name: version(name) for name in ("fastapi", "numpy", "orjson", "pydantic", "scipy", "uvicorn")
}


def router() -> APIRouter:
    """Routes about the server itself."""
    routes = APIRouter(route_class=QueryRoute, tags=["server"])

    @routes.get("/health", response_model=HealthOut, summary="Is the server well?")
    def health() -> ReadyBody:
        body = {"status": "ok", "version": __version__, "libraries": _LIBRARIES}
        return ReadyBody(orjson.dumps(body), "application/json", cacheable=False)

    return routes
