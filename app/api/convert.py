"""`/convert`: an interface in every other form, each with what is lost."""

from typing import Annotated, Any, Literal

from fastapi import APIRouter, Query
from pydantic import BeforeValidator, Field, WithJsonSchema

from app.answers.answer import Table
from app.answers.conversions import Conversions, conversions, table
from app.answers.materials.rgb_nk import rgb_nk
from app.api.model_parameters import one_or_three
from app.api.params import InterfaceQuery, number, preset_name, refuse_beside, reported_as
from app.http.problems import BadParameters, ParameterError
from app.http.query import Number, TableQuery, plain
from app.http.route import QueryRoute
from app.materials.media import default_catalog
from app.materials.schema import Preset
from app.optics.conversions import (
    F0_LINEAR,
    F0_SRGB,
    SEEN_FROM,
    TAKES,
    Form,
    hex_channels,
)
from app.optics.edge_tint import EDGE_TINT, REFLECTANCE, TINT_ANGLE
from app.optics.knobs.dispersion import ABBE
from app.optics.knobs.reflectance import (
    COLOR_FACTOR,
    FACTOR,
    FILAMENT,
    GODOT,
    IOR,
    KNOBS,
    LEVEL,
    REFLECTIVITY,
    SPECULAR,
    SPECULAR_IOR,
    WEIGHT,
)
from app.optics.parameters import Parameter


def _without_underscores(text: object) -> object:
    """Refuse numbers that Python alone would read."""
    for part in str(text).split(","):
        plain(part)
    return text


OneOrThree = Annotated[
    Any,
    BeforeValidator(one_or_three),
    BeforeValidator(_without_underscores),  # the last is the first to be asked
    WithJsonSchema({"type": "string", "examples": ["0.04", "1.0,0.766,0.336"]}),
]


def _one_or_three(parameter: Parameter) -> Any:
    # The core checks the bounds, which pydantic cannot put on one number or three.
    return Field(
        None, description=f"{parameter.description} One number, or three for red, green and blue."
    )


class ConvertQuery(InterfaceQuery, TableQuery):
    """What is given, in one form."""

    from_: Form = Field(
        "ior",
        alias="from",
        description="The form that is given: ior takes n_t (or a material that does not absorb), "
        "nk takes n_t and k_t (or any material), f0 F0, f0_srgb F0_srgb or hex, rg r and g, dg r and "
        "G, specular (Disney's) and reflectance (Filament's) what they are called, blender, gltf, "
        "openpbr, three, unreal (specular) and godot the numbers of their knobs, as listed in `knobs`; "
        "of several numbers those that are left out are the engine's defaults.",
    )
    F0: OneOrThree = _one_or_three(F0_LINEAR)
    F0_srgb: OneOrThree = _one_or_three(F0_SRGB)
    hex: str | None = Field(None, max_length=7, description="F0 as an 8-bit sRGB color, #rrggbb.")
    r: OneOrThree = _one_or_three(REFLECTANCE)
    g: OneOrThree = _one_or_three(EDGE_TINT)
    G: OneOrThree = _one_or_three(TINT_ANGLE)
    specular: Number | None = number(SPECULAR)
    reflectance: Number | None = number(FILAMENT)
    ior: Number | None = number(IOR)
    specular_ior_level: Number | None = number(LEVEL)
    specularFactor: Number | None = number(FACTOR)
    specularColorFactor: OneOrThree = _one_or_three(COLOR_FACTOR)
    specular_ior: Number | None = number(SPECULAR_IOR)
    specular_weight: Number | None = number(WEIGHT)
    reflectivity: Number | None = number(REFLECTIVITY)
    metallic_specular: Number | None = number(GODOT)
    abbe: Number | None = Field(
        None,
        gt=ABBE.minimum,
        le=ABBE.maximum,
        allow_inf_nan=False,
        description=f"{ABBE.description} It adds the knobs of dispersion.",
    )
    dispersion_of: str | None = preset_name(
        "Id or alias of a clear preset whose measured dispersion tells the Abbe number, in place of "
        "abbe; the material unless given.",
        "N-BK7",
    )
    seen_from: Number = number(SEEN_FROM)
    to: Literal["rgb_nk"] | None = Field(
        None,
        description="`rgb_nk` adds three pairs of n and k that match the color of the material at all "
        "angles, for engines that keep one pair a channel; it takes a material and n_i = 1.",
    )


_DEFAULTS: dict[Form, dict[str, float]] = {
    knob.id: {given.parameter.name: given.default for given in knob.inputs}
    for knob in KNOBS
    if len(knob.inputs) > 1
}


def given_values(query: ConvertQuery) -> dict[str, tuple[float, ...]]:
    """The numbers of the form that is given, each as often as there are channels.

    Raises
    ------
    BadParameters
        If one is missing, is another form's or comes in another number than the rest.
    NotAllowed
        If the hexadecimal color is none.
    """
    form, wanted = query.from_, [parameter.name for parameter in TAKES[query.from_]]
    found: dict[str, tuple[float, ...]] = {}
    errors: list[ParameterError] = []
    own = {*wanted, "hex"} if form == "f0_srgb" else {*wanted}
    foreign = {p.name for parameters in TAKES.values() for p in parameters} | {"hex"}
    for name in sorted(foreign - own):
        # What a material does not say of itself is not asked for: its k belongs to nk alone.
        if name in query.model_fields_set and getattr(query, name) is not None:
            message = f"not beside from={form}, which takes {' and '.join(sorted(own))}"
            errors.append({"parameter": name, "value": getattr(query, name), "message": message})
    if query.material is not None and form not in ("ior", "nk"):
        message = f"not beside from={form}; from=nk takes it"
        errors.append({"parameter": "material", "value": query.material, "message": message})
    if query.hex is not None and form == "f0_srgb":
        if query.F0_srgb is not None:
            message = "either hex or F0_srgb"
            errors.append({"parameter": "hex", "value": query.hex, "message": message})
        found["F0_srgb"] = hex_channels(query.hex)
    defaults = _DEFAULTS.get(form, {})
    for name in [name for name in wanted if name not in found]:
        value = getattr(query, name)
        if value is None:
            value = defaults.get(name)
        if value is None:
            errors.append({"parameter": name, "value": None, "message": f"needed by from={form}"})
        else:
            found[name] = value if isinstance(value, tuple) else (value,)
    if errors:
        raise BadParameters(*errors)
    if query.material is not None and form == "ior" and query.k_t > 0.0:
        message = f"absorbs, k_t = {query.k_t:g}; from=nk takes it"
        raise BadParameters({"parameter": "material", "value": query.material, "message": message})
    channels = max(len(values) for values in found.values())
    return {n: v if len(v) == channels else v * channels for n, v in found.items()}


def _dispersive(query: ConvertQuery) -> Preset | None:
    """Return the preset that is asked for its dispersion.

    Raises
    ------
    BadParameters
        If an Abbe number is given besides.
    UnknownMaterial
        If there is no such preset.
    """
    if query.dispersion_of is None:
        return None
    refuse_beside(query, "dispersion_of", "abbe")
    with reported_as(material="dispersion_of"):
        return default_catalog().get(query.dispersion_of)


def _colored(query: ConvertQuery) -> Preset:
    """Return the preset whose color is to be matched.

    Raises
    ------
    BadParameters
        If there is none, if it is seen from another medium, or if a table is asked for.
    """
    errors: list[ParameterError] = []
    if query.material is None:
        message = "needed by to=rgb_nk: three channels are not known from one interface"
        errors.append({"parameter": "material", "value": None, "message": message})
    if query.n_i != 1.0:
        message = "1 beside to=rgb_nk, whose pairs are for a surface in air or vacuum"
        errors.append({"parameter": "n_i", "value": query.n_i, "message": message})
    if query.format == "csv":
        message = "json beside to=rgb_nk"
        errors.append({"parameter": "format", "value": query.format, "message": message})
    if errors or query.material is None:
        raise BadParameters(*errors)
    return default_catalog().get(query.material)


def router() -> APIRouter:
    """Routes about conversions."""
    routes = APIRouter(route_class=QueryRoute, tags=["convert"])

    @routes.get("/convert", response_model=Conversions, summary="n, k, F0, tints and engine values")
    def converted(query: Annotated[ConvertQuery, Query()]) -> Conversions | Table:
        found = conversions(
            query.from_,
            given_values(query),
            n_i=query.n_i,
            seen_from=query.seen_from,
            hex=query.hex,
            material=query.interface().material,
            abbe=query.abbe,
            dispersion_of=_dispersive(query),
        )
        if query.to == "rgb_nk":
            found["rgb_nk"] = rgb_nk(_colored(query))
        return table(found) if query.format == "csv" else found

    return routes
