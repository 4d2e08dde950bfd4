"""`/materials`: presets, their constants over the wavelength, their curves and colors."""

from __future__ import annotations

from fastapi import APIRouter

from app.api.materials.color_curves import add_curves
from app.api.materials.detail import add_detail
from app.api.materials.listing import add_list
from app.api.materials.spectral import add_spectrum_and_map
from app.http.route import QueryRoute
from app.optics.registry import Registry, default_registry


def router(registry: Registry | None = None) -> APIRouter:
    """Routes over the catalog; colors are compared by those of `registry`'s models that take them."""
    routes = APIRouter(route_class=QueryRoute, tags=["materials"])
    add_list(routes)
    add_detail(routes)
    add_spectrum_and_map(routes)
    add_curves(routes, registry or default_registry())
    return routes
