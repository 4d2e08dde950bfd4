"""`/atlas`: the errors of every model at every material, and which formula will do for which."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.answers.atlas import AtlasAnswer, which_formula
from app.answers.atlas_material import AtlasMaterial, of_material
from app.api.model_parameters import ModelId
from app.atlas.grid import Band
from app.atlas.pages import Kind
from app.atlas.published import Metric, atlas_path
from app.http.query import Count, LongQuery, Number, TableQuery
from app.http.route import QueryRoute
from app.http.writing import shown_as
from app.optics.registry import Registry

_PARQUET = "application/vnd.apache.parquet"


class AtlasQuery(TableQuery, LongQuery):
    """A model, an error and which materials."""

    model: ModelId = "schlick"
    metric: Metric = Field(
        "max_abs",
        description="Largest error over the angle, root mean square over the hemisphere, error of the "
        "albedo, or CIEDE2000 of the RGB form against the spectrum; the largest over the wavelengths.",
    )
    within: Number | None = Field(
        None,
        gt=0,
        le=100,
        description="What size of the error counts as small; 0.01, and 1 for delta_e, unless given.",
    )
    kind: Kind | None = Field(
        None,
        description="Of which kind alone: clear, where k counts as 0 at all wavelengths; metal, where "
        "k is more than half of n at all; absorbing, in between.",
    )
    band: Band = Field(
        "visible", description="Materials known at visible wavelengths, or those that are not."
    )
    shelf: str | None = Field(
        None,
        max_length=100,
        description="Of which shelf of refractiveindex.info alone, or `curated`.",
    )
    q: str | None = Field(
        None, max_length=100, description="Words that all stand in a material's id or name."
    )
    F0_minimum: Number = Field(0.0, ge=0, le=1, description="Least reflectance along the normal.")
    F0_maximum: Number = Field(1.0, ge=0, le=1, description="Largest reflectance along the normal.")
    limit: Count | None = Field(
        None, ge=1, le=10_000, description="How many materials to list at most; all unless given."
    )


class AtlasMaterialQuery(TableQuery, LongQuery):
    """Which material."""

    material: str = Field(
        max_length=1000, description="Id, alias or name of a material.", examples=["Au"]
    )


def router(registry: Registry) -> APIRouter:
    """Routes over the atlas, for the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["errors"])

    @routes.get("/atlas", summary="Which formula for which material")
    def atlas(query: Annotated[AtlasQuery, Query()]) -> AtlasAnswer:
        return which_formula(
            registry,
            registry.find(query.model, "model"),
            metric=query.metric,
            within=query.within,
            kind=query.kind,
            band=query.band,
            shelf=query.shelf,
            q=query.q,
            F0=(query.F0_minimum, query.F0_maximum),
            limit=query.limit,
        )

    @routes.get("/atlas/material", summary="Which formula for one material")
    def material(query: Annotated[AtlasMaterialQuery, Query()]) -> AtlasMaterial:
        return of_material(registry, query.material)

    @routes.get(
        "/atlas/errors.parquet",
        summary="The whole atlas as Parquet",
        response_class=Response,
        responses={
            200: {"content": {_PARQUET: {"schema": {"type": "string", "format": "binary"}}}}
        },
    )
    def file() -> Response:
        named = shown_as("fresnel_atlas.parquet")
        return Response(atlas_path().read_bytes(), headers=named, media_type=_PARQUET)

    return routes
