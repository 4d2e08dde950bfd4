"""MaterialX: its physically based nodes, and OpenPBR."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from app.export.surface import Surface, Typed, digits
from app.export.target import (
    ABSORPTION,
    DISPERSION,
    PAIRS,
    TINT,
    Basis,
    File,
    FilmMode,
    Mode,
    Target,
    by_f82,
    by_ior,
    by_pairs,
)
from app.optics.color import Space

COLOR_SPACES: Mapping[Space, str] = {"srgb": "lin_rec709", "acescg": "acescg"}
_TYPES = {"roughness": "vector2", "scatter_mode": "string"}
_MEDIA = "application/mtlx+xml"

_SPACES: Mapping[Space, str] = {
    "srgb": "",
    "acescg": "n and k of channels are for a renderer that works in ACEScg: they are no colors, and "
    "no color management converts them",
}


def _input(parent: Element, name: str, kind: str, attribute: str, value: str) -> None:
    SubElement(parent, "input", {"name": name, "type": kind, attribute: value})


def _typed(parent: Element, parameters: Mapping[str, Typed]) -> None:
    for name, value in parameters.items():
        kind = _TYPES.get(name, "color3" if isinstance(value, list) else "float")
        text = ", ".join(map(repr, value)) if isinstance(value, list) else str(value)
        _input(parent, name, kind, "value", text)


def _document(root: Element, surface: Surface) -> File:
    indent(root)
    text = tostring(root, encoding="unicode", xml_declaration=False)
    return File(f"{surface.name}.mtlx", f'<?xml version="1.0"?>\n{text}\n')


def _root(surface: Surface, managed: bool) -> Element:
    root = Element("materialx", version="1.39")
    if managed:
        root.set("colorspace", COLOR_SPACES[surface.space])
    return root


def _material(root: Element, surface: Surface, shader: str) -> None:
    material = SubElement(root, "surfacematerial", name=surface.name, type="material")
    _input(material, "surfaceshader", "surfaceshader", "nodename", shader)


def _bsdf(node: str, surface: Surface, parameters: Mapping[str, Typed], *, managed: bool) -> File:
    root = _root(surface, managed)
    bsdf = SubElement(root, node, name=f"{surface.name}_bsdf", type="BSDF")
    _typed(bsdf, parameters)
    shader = SubElement(root, "surface", name=f"{surface.name}_surface", type="surfaceshader")
    _input(shader, "bsdf", "BSDF", "nodename", f"{surface.name}_bsdf")
    _material(root, surface, f"{surface.name}_surface")
    return _document(root, surface)


def _open_pbr(surface: Surface, parameters: Mapping[str, Typed]) -> File:
    root = _root(surface, managed=True)
    name = f"{surface.name}_surface"
    shader = SubElement(root, "open_pbr_surface", name=name, type="surfaceshader")
    _typed(shader, parameters)
    _material(root, surface, name)
    return _document(root, surface)


def _conductor(surface: Surface) -> dict[str, Typed]:
    return {"ior": surface.n, "extinction": surface.k, "roughness": [0.0, 0.0]}


def _schlick(surface: Surface) -> dict[str, Typed]:
    return {
        "color0": surface.F0,
        "color82": surface.F82_tint,
        "color90": [1.0, 1.0, 1.0],
        "exponent": 5.0,
        "roughness": [0.0, 0.0],
    }


def _dielectric(surface: Surface) -> dict[str, Typed]:
    return {"ior": surface.ior, "roughness": [0.0, 0.0], "scatter_mode": "RT"}


def _metal(surface: Surface) -> dict[str, Typed]:
    return {
        "base_metalness": 1.0,
        "base_color": surface.F0,
        "specular_color": surface.F82_tint,
        "specular_weight": 1.0,
        "specular_roughness": 0.0,
    }


def _clear(surface: Surface) -> dict[str, Typed]:
    typed: dict[str, Typed] = {
        "base_metalness": 0.0,
        "transmission_weight": 1.0,
        "specular_ior": surface.ior,
        "specular_weight": 1.0,
        "specular_roughness": 0.0,
    }
    if surface.preset.abbe is not None:
        typed["transmission_dispersion_scale"] = 1.0
        typed["transmission_dispersion_abbe_number"] = surface.preset.abbe
    return typed


def _thin_film(n: float, nm: float) -> dict[str, Typed]:
    return {"thinfilm_thickness": digits(nm), "thinfilm_ior": digits(n)}


def _open_pbr_film(n: float, nm: float) -> dict[str, Typed]:
    """OpenPBR has micrometers."""
    return {
        "thin_film_weight": 1.0,
        "thin_film_thickness": digits(1e-3 * nm),
        "thin_film_ior": digits(n),
    }


_PREFILTERED = (
    "The generator's prefiltered environment, its default, shows a Schlick curve in its place; "
    "environments sampled by importance follow the node"
)

MATERIALX = Target(
    id="materialx",
    title="MaterialX",
    modes=(
        Mode(
            "nk",
            "conductor",
            "conductor_bsdf",
            _conductor,
            partial(_bsdf, "conductor_bsdf", managed=False),
            by_pairs,
            Basis("exact", "materialx", "conductor_bsdf"),
            (PAIRS, _PREFILTERED),
            film=FilmMode("materialx_airy", _thin_film),
        ),
        Mode(
            "f82",
            "conductor",
            "generalized_schlick_bsdf",
            _schlick,
            partial(_bsdf, "generalized_schlick_bsdf", managed=True),
            by_f82,
            Basis("f82_tint", "materialx", "generalized_schlick_bsdf"),
            (TINT, _PREFILTERED, "MaterialX's generator for OSL drops color82"),
            film=FilmMode("materialx_schlick_airy", _thin_film),
        ),
        Mode(
            "ior",
            "dielectric",
            "dielectric_bsdf",
            _dielectric,
            partial(_bsdf, "dielectric_bsdf", managed=False),
            by_ior,
            Basis("exact", "materialx", "dielectric_bsdf"),
            (DISPERSION, ABSORPTION, _PREFILTERED),
            film=FilmMode("materialx_airy", _thin_film),
        ),
    ),
    spaces=_SPACES,
    media_type=_MEDIA,
)

OPENPBR = Target(
    id="openpbr",
    title="OpenPBR, as MaterialX",
    modes=(
        Mode(
            "f82",
            "conductor",
            "open_pbr_surface, metal",
            _metal,
            _open_pbr,
            by_f82,
            Basis("f82_tint", "materialx", "generalized_schlick_bsdf"),
            (TINT, "MaterialX's generator for OSL drops specular_color of metals"),
            film=FilmMode("materialx_schlick_airy", _open_pbr_film),
        ),
        Mode(
            "ior",
            "dielectric",
            "open_pbr_surface, transmission",
            _clear,
            _open_pbr,
            by_ior,
            Basis("exact", "materialx", "dielectric_bsdf"),
            (
                "Dispersion is kept as an Abbe number where n is a formula, else lost",
                ABSORPTION,
                "Below an index of 1.5 Babylon's OpenPBRMaterial reflects less at grazing incidence",
            ),
            film=FilmMode("materialx_airy", _open_pbr_film),
        ),
    ),
    spaces={"srgb": "", "acescg": ""},
    media_type=_MEDIA,
)
