"""`/health`: whether the server works, and what it is made of."""

from __future__ import annotations

from importlib.metadata import version

from fastapi import APIRouter, Request
from starlette.responses import JSONResponse

from app import __version__
from app.api.route import QueryRoute
from app.api.schemas import HealthOut

_LIBRARIES = {
    name: version(name) for name in ("fastapi", "numpy", "orjson", "pydantic", "scipy", "uvicorn")
}


def router() -> APIRouter:
    """Routes about the server itself."""
    routes = APIRouter(route_class=QueryRoute, tags=["server"])

    @routes.get("/health", response_model=HealthOut, summary="Is the server well?")
    async def health(request: Request) -> JSONResponse:  # noqa: ARG001 - QueryRoute hands it over
        body = {"status": "ok", "version": __version__, "libraries": _LIBRARIES}
        return JSONResponse(body, headers={"Cache-Control": "no-store"})

    return routes
