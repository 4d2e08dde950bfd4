"""`/materials`: presets, their constants over the wavelength, their curves and colors."""

from dataclasses import fields
from typing import Annotated

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.answers.answer import chosen_fields
from app.answers.materials.covered import Covered, covered
from app.answers.materials.curves import MaterialCurves
from app.answers.materials.curves import curves as evaluated
from app.answers.materials.detail import MaterialDetail, detail
from app.answers.materials.export import Export
from app.answers.materials.listing import Material, Materials
from app.answers.materials.listing import materials as listed
from app.answers.materials.map import MaterialMap, reflectance_map
from app.answers.materials.rgb_nk import RgbNk, rgb_nk
from app.answers.materials.spectrum import MaterialSpectrum
from app.answers.materials.spectrum import spectrum as constants
from app.api.materials.exporting import FILES, exported
from app.api.materials.queries import (
    CoveredQuery,
    DetailQuery,
    ExportQuery,
    ListQuery,
    MapQuery,
    MaterialCurvesQuery,
    RgbNkQuery,
    SpectrumQuery,
)
from app.api.params import reported_as
from app.http.problems import MissingResource
from app.http.route import QueryRoute
from app.materials.errors import UnknownMaterial
from app.materials.media import default_catalog
from app.materials.schema import Preset
from app.optics.registry import Registry, default_registry


def router(registry: Registry | None = None) -> APIRouter:
    """Routes over the catalog; colors are compared by those of `registry`'s models that take them."""
    routes = APIRouter(route_class=QueryRoute, tags=["materials"])
    models = registry or default_registry()

    @routes.get("/materials", summary="Media and materials by name")
    def materials(query: Annotated[ListQuery, Query()]) -> Materials:
        return listed(
            query.q,
            query.category,
            query.kind,
            query.catalog,
            offset=query.offset,
            limit=query.limit,
            gamut=query.gamut,
            fields=chosen_fields(query.fields, [field.name for field in fields(Material)]),
        )

    @routes.get("/materials/{material:path}/spectrum", summary="n, k and F0 over the wavelength")
    def spectrum(material: str, query: Annotated[SpectrumQuery, Query()]) -> MaterialSpectrum:
        return constants(found(material), query.minimum_nm, query.maximum_nm, query.step_nm)

    @routes.get("/materials/{material:path}/map", summary="Reflectance over angle and wavelength")
    def theta_by_wavelength(material: str, query: Annotated[MapQuery, Query()]) -> MaterialMap:
        return reflectance_map(
            found(material),
            query.front(),
            query.quantity,
            minimum_nm=query.minimum_nm,
            maximum_nm=query.maximum_nm,
            steps=query.steps,
            samples=query.samples,
        )

    @routes.get(
        "/materials/{material:path}/rgb_nk",
        summary="n and k a channel for engines without spectra, and how far they are off",
    )
    def pairs(material: str, query: Annotated[RgbNkQuery, Query()]) -> RgbNk:
        return rgb_nk(found(material), query.viewing(), query.gamut, query.space)

    @routes.get(
        "/materials/{material:path}/export",
        response_model=Export,
        responses=FILES,
        summary="A material for a render engine, with what is lost and how far the engine is off",
    )
    def taken(material: str, query: Annotated[ExportQuery, Query()]) -> Export | Response:
        return exported(found(material), query)

    @routes.get(
        "/materials/{material:path}/covered",
        summary="F0, F82 and tint in a medium, under a coat or behind a pane, and engines' shortcuts",
    )
    def under(material: str, query: Annotated[CoveredQuery, Query()]) -> Covered:
        with reported_as(incident="of"):
            return covered(found(material), query.covered_by(), query.viewing(), query.gamut)

    @routes.get(
        "/materials/{material:path}/curves",
        summary="R over the angle, per wavelength and as R, G and B",
    )
    def curves(material: str, query: Annotated[MaterialCurvesQuery, Query()]) -> MaterialCurves:
        preset, chosen = found(material), query.chosen(models)
        with reported_as(wavelength_nm="wavelengths_nm"):
            return evaluated(
                preset,
                query.front(),
                wavelengths_nm=query.wavelengths(),
                samples=query.samples,
                models=chosen,
                viewing=query.viewing(),
                gamut=query.gamut,
            )

    # Ids of pages have slashes, so that this one is asked after those that end in a word.
    @routes.get(
        "/materials/{material:path}", summary="One material: constants, color, provenance, rivals"
    )
    def one(material: str, query: Annotated[DetailQuery, Query()]) -> MaterialDetail:
        return detail(
            found(material),
            wavelength_nm=query.wavelength_nm,
            viewing=query.viewing(),
            gamut=query.gamut,
        )

    return routes


def found(material: str) -> Preset:
    """Look up the preset of a path.

    Raises
    ------
    MissingResource
        If there is none, naming the nearest.
    """
    try:
        return default_catalog().get(material)
    except UnknownMaterial as error:
        raise MissingResource(error) from None
