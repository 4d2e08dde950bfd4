"""Blender: a Python script that makes the material."""

from __future__ import annotations

from functools import partial

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

_METALLIC = "ShaderNodeBsdfMetallic"
_PRINCIPLED = "ShaderNodeBsdfPrincipled"


def _conductor(surface: Surface) -> dict[str, Typed]:
    return {"IOR": surface.n, "Extinction": surface.k, "Roughness": 0.0}


def _f82(surface: Surface) -> dict[str, Typed]:
    return {
        "Base Color": [*surface.F0, 1.0],
        "Edge Tint": [*surface.F82_tint, 1.0],
        "Roughness": 0.0,
    }


def _metal(surface: Surface) -> dict[str, Typed]:
    return {
        "Base Color": [*surface.F0, 1.0],
        "Metallic": 1.0,
        "Specular Tint": [*surface.F82_tint, 1.0],
        "Roughness": 0.0,
    }


def _clear(surface: Surface) -> dict[str, Typed]:
    return {
        "Base Color": [1.0, 1.0, 1.0, 1.0],
        "IOR": surface.ior,
        "Transmission Weight": 1.0,
        "Roughness": 0.0,
    }


def _film(n: float, nm: float) -> dict[str, Typed]:
    return {"Thin Film Thickness": digits(nm), "Thin Film IOR": digits(n)}


_FILM = FilmMode("cycles_film", _film)


def _write(
    node: str, surface: Surface, typed: dict[str, Typed], *, fresnel: str | None = None
) -> File:
    # The inputs of Metallic BSDF are found by name only after its mode is set.
    mode = "" if fresnel is None else f'shader.fresnel_type = "{fresnel}"\n'
    inputs = "\n".join(
        f'shader.inputs["{name}"].default_value = {tuple(v) if isinstance(v, list) else v}'
        for name, v in typed.items()
    )
    text = f"""# {" ".join(surface.preset.source.split())}
import bpy

material = bpy.data.materials.new("{surface.name}")
material.use_nodes = True
nodes = material.node_tree.nodes
nodes.clear()
shader = nodes.new("{node}")
{mode}{inputs}
output = nodes.new("ShaderNodeOutputMaterial")
output.location.x = 300
material.node_tree.links.new(shader.outputs["BSDF"], output.inputs["Surface"])
"""
    return File(f"{surface.name}_blender.py", text)


BLENDER = Target(
    id="blender",
    title="Blender, Cycles",
    modes=(
        Mode(
            "nk",
            "conductor",
            "Metallic BSDF, Physical Conductor",
            _conductor,
            partial(_write, _METALLIC, fresnel="PHYSICAL_CONDUCTOR"),
            by_pairs,
            Basis("exact", "cycles", "Metallic BSDF, Physical Conductor"),
            (PAIRS,),
            film=_FILM,
        ),
        Mode(
            "f82",
            "conductor",
            "Metallic BSDF, F82 Tint",
            _f82,
            partial(_write, _METALLIC, fresnel="F82"),
            by_f82,
            Basis("f82_tint", "cycles", "Metallic BSDF, F82 Tint"),
            (TINT,),
        ),
        Mode(
            "principled",
            "conductor",
            "Principled BSDF, metallic",
            _metal,
            partial(_write, _PRINCIPLED),
            by_f82,
            Basis("f82_tint", "cycles", "Metallic BSDF, F82 Tint"),
            (TINT,),
        ),
        Mode(
            "ior",
            "dielectric",
            "Principled BSDF, transmission",
            _clear,
            partial(_write, _PRINCIPLED),
            by_ior,
            Basis("exact", "cycles", "Principled BSDF"),
            (DISPERSION, ABSORPTION),
            film=_FILM,
        ),
    ),
    spaces={"srgb": "", "acescg": "The scene's working space has to be ACEScg"},
    media_type="text/x-python",
)
