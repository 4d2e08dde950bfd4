"""`/health`: whether the server works, what it is made of, and whether it wants more to do."""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import orjson
from fastapi import APIRouter

from app import __version__
from app.api.schemas import HealthOut, StatusOut
from app.http.body import ReadyBody
from app.http.route import QueryRoute
from app.server.drain import Drain
from app.server.pool import Overloaded

_LIBRARIES = {
    name: version(name) for name in ("fastapi", "numpy", "orjson", "pydantic", "scipy", "uvicorn")
}


def router(drain: Drain) -> APIRouter:
    """Routes about the server itself, ready unless `drain` says that it is about to stop."""
    routes = APIRouter(route_class=QueryRoute, tags=["server"])

    @routes.get("/health", response_model=HealthOut, summary="Is the server well?")
    def health() -> ReadyBody:
        body = {"status": "ok", "version": __version__, "libraries": _LIBRARIES}
        return _told(body)

    @routes.get("/health/live", response_model=StatusOut, summary="Is the process alive?")
    def live() -> ReadyBody:
        """Answer as long as the event loop turns; a server that does not wants to be restarted."""
        return _told({"status": "ok"})

    @routes.get("/health/ready", response_model=StatusOut, summary="Does it take requests?")
    def ready() -> ReadyBody:
        """Answer 503 once the server was told to stop, while it still answers everything else."""
        if drain.draining:
            raise Overloaded("the server is about to stop")
        return _told({"status": "ok"})

    return routes


def _told(body: dict[str, Any]) -> ReadyBody:
    return ReadyBody(orjson.dumps(body), "application/json", cacheable=False)
