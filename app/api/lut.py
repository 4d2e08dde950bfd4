"""`/lut` and `/lut/errors`: tables for a renderer, each with the error of reading between its texels."""

# No `from __future__ import annotations` here: the query's type is made from the registry at run
# time, and FastAPI could not look up its name.

from collections.abc import Callable
from typing import Annotated, Any, Literal, NamedTuple

import numpy as np
from fastapi import APIRouter, Query
from pydantic import BaseModel, Field
from starlette.responses import Response

from app.answers.axes import AxisName, held, interfaces, refuse_many_cells
from app.answers.curves import Chosen
from app.api.answers import Answer, Large
from app.api.axes import swept
from app.api.lut_files import exr_bytes, npy_bytes, png_bytes
from app.api.model_parameters import (
    ModelId,
    model_arguments,
    refuse_foreign_parameters,
    with_model_parameters,
)
from app.api.params import InterfaceQuery
from app.api.presets import reported_as
from app.api.responses import CONVENTION, ReadyBody, csv_body, interface_json, json_body, shown_as
from app.api.schemas import InterfaceOut
from app.http.query import Count, Number
from app.http.route import QueryRoute
from app.materials import default_catalog
from app.materials.appearance import color_curve
from app.optics.albedo import albedo
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.lookup import Depth, TableError, line_error, quantize, sheet_error
from app.optics.parameters import Array
from app.optics.registry import Model, Registry

MOST_TEXELS = 4096
ERROR_HEADER = "Interpolation-Error"
SIZES = tuple(2**power for power in range(1, 13))

Over = Literal["mu", "mu,n_t", "mu,k_t", "n_t", "k_t"]
Format = Literal["json", "csv", "npy", "png", "exr"]

READING = (
    "texel j of N stands at the j-th of N equally spaced values, both ends included; sample a "
    "texture at (x (N - 1) + 1/2) / N, x from 0 to 1 between the ends, with linear filtering"
)
_NUMBERS: dict[str, Depth] = {"8": "unorm8", "16": "unorm16", "32": "float"}
_DEPTHS: dict[Format, dict[str, Depth]] = {
    "json": _NUMBERS,
    "csv": _NUMBERS,
    "npy": _NUMBERS,
    "png": {"8": "unorm8", "16": "unorm16"},
    "exr": {"16": "half", "32": "float"},
}
_MEDIA = {"npy": "application/octet-stream", "png": "image/png", "exr": "image/x-exr"}


class _TableQuery(InterfaceQuery):
    """Which function is tabulated."""

    model: ModelId = "exact"
    over: Over = Field(
        "mu",
        description="What the table runs over: mu, the cosine of the angle of incidence, from 0 to "
        "1; mu and an index, a row each; or an index alone, for the hemispherical albedo of exact.",
    )
    minimum: Number | None = Field(
        None, allow_inf_nan=False, description="First n_t or k_t; 0.1 or 0 unless given."
    )
    maximum: Number | None = Field(
        None, allow_inf_nan=False, description="Last n_t or k_t; 5 unless given."
    )


class LutErrorsQuery(_TableQuery):
    """Errors of tables of all sizes."""

    over: Literal["mu", "n_t", "k_t"] = Field(
        "mu", description="mu for R, n_t or k_t for the albedo."
    )


class LutQuery(_TableQuery):
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
    channels: Literal["1", "3"] = Field(
        "1",
        description="3 for linear sRGB of a material: its spectrum integrated under D65 at every "
        "angle. A model with three values of a parameter has three in any case.",
    )
    format: Format = Field("json", description="How the table is sent.")


class Table(NamedTuple):
    """A function over one or two coordinates; texels are of shape (rows, size, channels)."""

    quantity: str
    axes: tuple[tuple[str, float, float, int], ...]
    true: Array
    error: Callable[[Array], TableError]
    said: dict[str, Any]


class LutAxisOut(BaseModel):
    """What one direction of the table runs over."""

    name: str
    minimum: float
    maximum: float
    size: int


class LutErrorOut(BaseModel):
    """The largest error of what is read between the texels."""

    max_abs: float = Field(description="Measured, rounding of the texels included; rounded up.")
    at: dict[str, float] = Field(description="Where it is reached.")


class LutOut(BaseModel):
    """A lookup table."""

    model: str
    quantity: str
    interface: InterfaceOut | None = Field(description="Null where an index varies.")
    n_i: float
    n_t: float | None
    k_t: float | None
    convention: str
    axes: list[LutAxisOut] = Field(description="The innermost, along a row, first.")
    channels: list[str]
    depth: Literal["unorm8", "unorm16", "half", "float"]
    reading: str
    error: LutErrorOut
    texels: list[Any] = Field(description="Rows of the last axis; a list where channels are three.")
    warnings: list[str]


class LutErrorsOut(BaseModel):
    """Errors of tables of many sizes."""

    model: str
    quantity: str
    n_i: float
    n_t: float | None
    k_t: float | None
    over: str
    sizes: list[int]
    max_abs: dict[str, list[float | None]] = Field(
        description="By depth: the largest error a size; null where the texels cannot hold the values."
    )


def _curve(query: _TableQuery, model: Model, size: int) -> Table:
    """R over mu, one channel or three."""
    interface = query.interface()
    arguments = model.arguments(interface, **model_arguments(query, model))

    def values(mu: Array) -> Array:
        R = model.evaluate(interface, Incidence.from_cosine(mu.ravel()), arguments)
        return np.moveaxis(np.atleast_2d(R), 0, -1).reshape(*mu.shape, -1)

    said = {"interface": interface_json(interface), **held(query.interface())._asdict()}
    return _line("R", "mu", (0.0, 1.0), size, values, said)


def _spectral(query: LutQuery, model: Model) -> Table:
    """R, G and B over mu, integrated from a spectrum."""
    if query.material is None or query.over != "mu" or model.id != "exact":
        raise NotAllowed("channels", 3, "1, but for exact over mu of a material with a spectrum")
    for name in ("incident", "wavelength_nm"):
        if getattr(query, name) is not None:
            raise NotAllowed(name, getattr(query, name), "not beside channels = 3; give n_i")
    with reported_as():
        spectrum = default_catalog().spectrum(query.material)

    def values(mu: Array) -> Array:
        return color_curve(spectrum, Incidence.from_cosine(mu), query.n_i)

    said = {
        "interface": interface_json(query.interface()),
        **held(query.interface())._asdict(),
        "warnings": list(spectrum.visible.warnings),
    }
    return _line("R in linear sRGB", "mu", (0.0, 1.0), query.size, values, said)


def _albedo(query: _TableQuery, model: Model, size: int) -> Table:
    """The albedo of exact over an index."""
    if model.id != "exact":
        raise NotAllowed("model", model.id, "exact where the table is one of albedos")
    axis = swept(query, "n_t" if query.over == "n_t" else "k_t", "", 2)

    def values(index: Array) -> Array:
        flat = index.ravel()
        shares = albedo(interfaces(query.interface(), {query.over: flat})).unpolarized
        return shares.reshape(*index.shape, 1)

    low, high = axis.values.tolist()
    said = {"interface": None, **held(query.interface(), axis.name)._asdict()}
    return _line("albedo", query.over, (low, high), size, values, said)


def _line(
    quantity: str,
    name: str,
    ends: tuple[float, float],
    size: int,
    values: Callable[[Array], Array],
    said: dict[str, Any],
) -> Table:
    true = values(np.linspace(*ends, size))[np.newaxis]
    axes = ((name, *ends, size),)
    return Table(quantity, axes, true, lambda texels: line_error(texels[0], ends, values), said)


def _sheet(query: LutQuery, model: Model) -> Table:
    """R over mu and an index."""
    refuse_many_cells("rows", size=query.size, rows=query.rows)
    name: AxisName = "n_t" if query.over == "mu,n_t" else "k_t"
    axis = swept(query, name, "", query.rows)
    own = Chosen(model, model_arguments(query, model)).of_one_color().given

    def values(mu: Array, index: Array) -> Array:
        interface = interfaces(query.interface(), {name: index})
        R = model.evaluate(interface, Incidence.from_cosine(mu), model.arguments(interface, **own))
        return R[..., np.newaxis]

    low, high = float(axis.values[0]), float(axis.values[-1])
    true = values(np.linspace(0.0, 1.0, query.size), axis.values[:, np.newaxis])
    said = {"interface": None, **held(query.interface(), name)._asdict()}
    axes = (("mu", 0.0, 1.0, query.size), (name, low, high, query.rows))
    ends = ((0.0, 1.0), (low, high))
    return Table("R", axes, true, lambda texels: sheet_error(texels, ends, values), said)


def _table(query: _TableQuery, model: Model, size: int) -> Table:
    if query.over in ("n_t", "k_t"):
        return _albedo(query, model, size)
    return _curve(query, model, size)


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


def _refuse_unused(query: _TableQuery) -> None:
    """Refuse the ends and the number of what does not vary."""
    unused = ["minimum", "maximum"] if query.over == "mu" else []
    unused += [] if query.over.startswith("mu,") else ["rows"]
    for name in set(unused) & query.model_fields_set:
        raise NotAllowed(name, getattr(query, name), f"not with over = {query.over}")


def _refuse_undefined(table: Table, model: Model) -> None:
    if not np.isfinite(table.true).all():
        raise NotAllowed("model", model.id, "one that is defined over the whole table")


def _lut(query: LutQuery, model: Model, depth: Depth) -> Response:
    if query.channels == "3":
        table = _spectral(query, model)
    elif query.over.startswith("mu,"):
        table = _sheet(query, model)
    else:
        table = _table(query, model, query.size)
    _refuse_undefined(table, model)
    texels = quantize(table.true, depth)
    worst = table.error(texels)
    names = [name for name, *_ in table.axes]
    channels = [table.quantity] if texels.shape[-1] == 1 else ["red", "green", "blue"]
    # Without the axes that only pictures need.
    plain = texels[0] if len(names) == 1 else texels
    plain = plain[..., 0] if len(channels) == 1 else plain
    header = {ERROR_HEADER: f"{worst.max_abs:g}"}
    filename = f"{model.id}_{query.over.replace(',', '_')}_{query.size}.{query.format}"
    if query.format == "json":
        payload = {
            "model": model.id,
            "quantity": table.quantity,
            "warnings": [],
            **table.said,
            "convention": CONVENTION,
            "axes": [
                dict(zip(("name", "minimum", "maximum", "size"), axis, strict=True))
                for axis in table.axes
            ],
            "channels": channels,
            "depth": depth,
            "reading": READING,
            "error": {
                "max_abs": worst.max_abs,
                "at": dict(zip(names, worst.at, strict=True)),
            },
            "texels": np.ascontiguousarray(plain),
        }
        return json_body(payload, headers=header)
    if query.format == "csv":
        grid = np.meshgrid(*(np.linspace(a, b, n) for _, a, b, n in table.axes))
        columns = {name: axis.ravel() for name, axis in zip(names, grid, strict=True)}
        columns |= {c: texels[..., i].ravel() for i, c in enumerate(channels)}
        return csv_body(columns, filename=filename, headers=header)
    media = ", ".join(f"{k} = {v:g}" for k, v in table.said.items() if isinstance(v, float))
    said = {
        "Title": f"{table.quantity} of {model.id} over {query.over}, {media}",
        "Description": READING,
        ERROR_HEADER: f"{worst.max_abs:g}",
    }
    if query.format == "npy":
        body = npy_bytes(plain, depth)
    else:
        body = (png_bytes if query.format == "png" else exr_bytes)(texels, depth, said)
    return ReadyBody(body, _MEDIA[query.format], header | shown_as(filename))


def _errors(query: LutErrorsQuery, model: Model) -> Response:
    found: dict[Depth, list[float | None]] = {depth: [] for depth in _NUMBERS.values()}
    for size in SIZES:
        table = _table(query, model, size)
        _refuse_undefined(table, model)
        for depth, errors in found.items():
            try:
                texels = quantize(table.true, depth)
            except NotAllowed:
                errors.append(None)
            else:
                errors.append(table.error(texels).max_abs)
    said = {name: table.said[name] for name in ("n_i", "n_t", "k_t")}
    payload = {
        "model": model.id,
        "quantity": table.quantity,
        **said,
        "over": query.over,
        "sizes": SIZES,
        "max_abs": found,
    }
    return json_body(payload)


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["shaders"])
    Lut_ = with_model_parameters(LutQuery, registry)
    LutErrors_ = with_model_parameters(LutErrorsQuery, registry)
    files = {kind: {"schema": {"type": "string"}} for kind in ("text/csv", *_MEDIA.values())}

    def found(query: _TableQuery) -> Model:
        model = registry.find(query.model, "model")
        refuse_foreign_parameters(query, [model], registry)
        _refuse_unused(query)
        return model

    @routes.get(
        "/lut",
        response_model=LutOut,
        responses={200: {"content": files}},
        summary="A lookup table of R or of the albedo, with its interpolation error",
    )
    def lut(query: Annotated[Lut_, Query()]) -> Answer:  # type: ignore[valid-type]
        model = found(query)
        return Large(_lut, query, model, depth_of(query))

    @routes.get(
        "/lut/errors",
        response_model=LutErrorsOut,
        summary="Interpolation errors of tables of 2 to 4096 texels",
    )
    def errors(query: Annotated[LutErrors_, Query()]) -> Answer:  # type: ignore[valid-type]
        return Large(_errors, query, found(query))

    return routes
