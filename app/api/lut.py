"""`/lut` and `/lut/errors`: tables for a renderer, each with the error of reading between its texels."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.answers.film_media import FilmMedia, Side
from app.answers.films import exact_alone
from app.answers.lookup import (
    MOST_TEXELS,
    CoatedLookupTable,
    FilmLookupTable,
    LookupErrors,
    LookupTable,
    Tabulated,
    albedo_over_index,
    coated_over_mu,
    color_over_mu,
    film_color_over_mu,
    lookup_errors,
    lookup_table,
    reflectance_over_mu,
    reflectance_over_mu_and_index,
)
from app.answers.lookup_files import ERROR_HEADER, MEDIA, file_bytes
from app.api.axes import end, swept
from app.api.model_parameters import ModelQuery, with_parameters_of
from app.api.params import LayersQuery, reported_as
from app.http.query import Count, LongQuery, Number
from app.http.route import QueryRoute
from app.http.writing import shown_as, write
from app.materials.films import read_layers
from app.materials.front import Front
from app.materials.media import default_catalog
from app.optics.errors import NotAllowed
from app.optics.lookup import Depth
from app.optics.registry import Registry

Over = Literal["mu", "mu,n_t", "mu,k_t", "n_t", "k_t"]
Format = Literal["json", "csv", "npy", "png", "exr"]

_NUMBERS: dict[str, Depth] = {"8": "unorm8", "16": "unorm16", "32": "float"}
_DEPTHS: dict[Format, dict[str, Depth]] = {
    "json": _NUMBERS,
    "csv": _NUMBERS,
    "npy": _NUMBERS,
    "png": {"8": "unorm8", "16": "unorm16"},
    "exr": {"16": "half", "32": "float"},
}


class TabulatedQuery(ModelQuery, LayersQuery, LongQuery):
    """Which function is tabulated."""

    over: Over = Field(
        "mu",
        description="What the table runs over: mu, the cosine of the angle of incidence, from 0 to "
        "1; mu and an index, a row each; or an index alone, for the hemispherical albedo of exact.",
    )
    minimum: Number | None = end("First n_t or k_t; 0.1 or 0 unless given.")
    maximum: Number | None = end("Last n_t or k_t; 5 unless given.")
    channels: Literal["1", "3"] = Field(
        "1",
        description="3 for linear sRGB of a material or of layers: the spectrum integrated under D65 "
        "at every angle. A model with three values of a parameter has three in any case.",
    )


class LutErrorsQuery(TabulatedQuery):
    """Errors of tables of all sizes."""

    over: Literal["mu", "n_t", "k_t"] = Field(
        "mu", description="mu for R, n_t or k_t for the albedo."
    )


class LutQuery(TabulatedQuery):
    """A lookup table."""

    size: Count = Field(
        256, ge=2, le=MOST_TEXELS, description="Texels over mu, or over the index alone."
    )
    rows: Count = Field(
        64, ge=2, le=MOST_TEXELS, description="Texels over the index, of a table over two."
    )
    bits: Literal["8", "16", "32"] | None = Field(
        None,
        description="Depth: 8 or 16 bits as integers from 0 to 1, or 32 bit floats; in OpenEXR 16 "
        "are half floats. 32 unless given, 16 in PNG.",
    )
    format: Format = Field("json", description="How the table is sent.")


def tabulated(query: TabulatedQuery, size: int) -> Tabulated:
    """Find the function that a query asks for, to be tabulated in a size.

    Raises
    ------
    NotAllowed
        If parameters contradict one another.
    """
    chosen, over = query.chosen(), query.over
    colored = query.channels == "3"
    unused = ["minimum", "maximum"] if over == "mu" else []
    unused += [] if "mu," in over else ["rows"]
    for name in unused:
        if name in query.model_fields_set:
            raise NotAllowed(name, getattr(query, name), f"not with over = {over}")
    if query.layers is not None:
        if over != "mu":
            raise NotAllowed("over", over, "mu where there are layers")
        exact_alone([chosen.model.id], "model")
        if colored:
            return _of_films(query, query.layers, size)
    coated = query.coated()
    if coated is not None:
        return coated_over_mu(coated, size)
    if colored:
        return _spectral(query, size)
    if over == "mu":
        return reflectance_over_mu(chosen, query.interface(), size)
    index: Literal["n_t", "k_t"] = "n_t" if "n_t" in over else "k_t"
    if isinstance(query, LutQuery) and "mu" in over:
        axis = swept(query, index, "", query.rows)
        return reflectance_over_mu_and_index(chosen, query.interface(), axis, size)
    return albedo_over_index(chosen, query.interface(), swept(query, index, "", size))


def _of_films(query: TabulatedQuery, layers: str, size: int) -> Tabulated:
    """Films in linear sRGB, of media that vary with the wavelength where they have a spectrum."""
    if query.wavelength_nm is not None:
        why = "not beside channels = 3, which are of all wavelengths"
        raise NotAllowed("wavelength_nm", query.wavelength_nm, why)
    front = Front(query.n_i)
    if query.incident is not None:
        with reported_as(material="incident"):
            front = Front.named(query.incident)
    index, material = complex(query.n_t, query.k_t), query.material
    varies = material is not None and default_catalog().get(material).kind == "spectrum"
    media = FilmMedia(front, read_layers(layers), Side(index, material if varies else None))
    return film_color_over_mu(media, query.interface(), size)


def _spectral(query: TabulatedQuery, size: int) -> Tabulated:
    if query.material is None or query.over != "mu" or query.model != "exact":
        why = "1, but for exact over mu of layers or of a material with a spectrum"
        raise NotAllowed("channels", 3, why)
    for name in ("incident", "wavelength_nm"):
        if getattr(query, name) is not None:
            raise NotAllowed(name, getattr(query, name), "not beside channels = 3; give n_i")
    spectrum = default_catalog().spectrum(query.material)
    return color_over_mu(spectrum, query.interface(), size)


def depth_of(query: LutQuery) -> Depth:
    """Depth of the texels that the format has for these bits.

    Raises
    ------
    NotAllowed
        If it has none.
    """
    allowed = _DEPTHS[query.format]
    bits = query.bits or ("16" if query.format == "png" else "32")
    if bits not in allowed:
        raise NotAllowed("bits", bits, f"{' or '.join(allowed)} in {query.format.upper()}")
    return allowed[bits]


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["shaders"])
    files = {kind: {"schema": {"type": "string"}} for kind in ("text/csv", *MEDIA.values())}

    @routes.get(
        "/lut",
        response_model=LookupTable | CoatedLookupTable | FilmLookupTable,
        responses={200: {"content": files}},
        summary="A lookup table of R or of the albedo, with its interpolation error",
    )
    @with_parameters_of(registry)
    def lut(query: Annotated[LutQuery, Query()]) -> Response:
        table = lookup_table(tabulated(query, query.size), depth_of(query))
        if query.format in MEDIA:
            named = shown_as(table.filename(query.format))
            body = file_bytes(table, query.format)
            response = Response(body, headers=named, media_type=MEDIA[query.format])
        else:
            response = write(table, query.format)
        response.headers[ERROR_HEADER] = f"{table.error.max_abs:g}"
        return response

    @routes.get("/lut/errors", summary="Interpolation errors of tables of 2 to 4096 texels")
    @with_parameters_of(registry)
    def errors(query: Annotated[LutErrorsQuery, Query()]) -> LookupErrors:
        return lookup_errors(lambda size: tabulated(query, size))

    return routes
