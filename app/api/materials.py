"""`/materials`: the media and materials that have a name."""

from __future__ import annotations

from fastapi import APIRouter, Request
from starlette.responses import Response

from app.api.responses import json_response
from app.api.route import QueryRoute
from app.materials import load_catalog


def router() -> APIRouter:
    """Routes over the catalog."""
    routes = APIRouter(route_class=QueryRoute, tags=["materials"])
    catalog = load_catalog()

    @routes.get("/materials", summary="Media and materials by name")
    async def materials(request: Request) -> Response:
        presets = [preset.model_dump(mode="json") for preset in catalog.presets]
        return json_response(request, {"materials": presets, "total": len(presets)})

    return routes
