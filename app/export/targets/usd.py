"""USD: a UsdPreviewSurface, as text."""

from __future__ import annotations

from app.export.surface import Surface, Typed
from app.export.target import (
    ABSORPTION,
    DISPERSION,
    Basis,
    File,
    Mode,
    Target,
    by_schlick,
    by_schlick_ior,
)

_BLACK = [0.0, 0.0, 0.0]


def _metal(surface: Surface) -> dict[str, Typed]:
    return {
        "useSpecularWorkflow": 1,
        "specularColor": surface.F0,
        "diffuseColor": _BLACK,
        "roughness": 0.0,
    }


def _clear(surface: Surface) -> dict[str, Typed]:
    return {"ior": surface.ior, "diffuseColor": _BLACK, "roughness": 0.0, "opacity": 0.0}


def _write(surface: Surface, typed: dict[str, Typed]) -> File:
    inputs = []
    for name, value in typed.items():
        if isinstance(value, list):
            inputs.append(f"color3f inputs:{name} = ({', '.join(map(repr, value))})")
        else:
            inputs.append(f"{'int' if isinstance(value, int) else 'float'} inputs:{name} = {value}")
    lines = "\n        ".join(inputs)
    text = f"""#usda 1.0
(
    defaultPrim = "{surface.name}"
    metersPerUnit = 1
    upAxis = "Y"
)

def Material "{surface.name}"
{{
    token outputs:surface.connect = </{surface.name}/Surface.outputs:surface>

    def Shader "Surface"
    {{
        uniform token info:id = "UsdPreviewSurface"
        {lines}
        token outputs:surface
    }}
}}
"""
    return File(f"{surface.name}.usda", text)


USD = Target(
    id="usd",
    title="UsdPreviewSurface",
    modes=(
        Mode(
            "schlick",
            "conductor",
            "Specular workflow",
            _metal,
            _write,
            by_schlick,
            Basis("schlick", "usd", "specular workflow"),
            (
                "A metal is Schlick's curve from its color at normal incidence; its metallic workflow "
                "would reflect the same at every angle",
            ),
        ),
        Mode(
            "ior",
            "dielectric",
            "ior",
            _clear,
            _write,
            by_schlick_ior,
            Basis("schlick", "usd", "ior"),
            (
                "Its shader shows Schlick's curve of the index, and does not refract",
                DISPERSION,
                ABSORPTION,
            ),
        ),
    ),
    spaces={"srgb": ""},
    media_type="model/vnd.usda",
)
