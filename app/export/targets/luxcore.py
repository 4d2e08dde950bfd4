"""LuxCore: properties of a scene, as text."""

from __future__ import annotations

import numpy as np

from app.export.surface import Surface, Typed, incidence
from app.export.target import ABSORPTION, DISPERSION, PAIRS, Basis, File, Mode, Target, by_ior
from app.optics.parameters import Array


def _fresnel(surface: Surface) -> dict[str, Typed]:
    return {"n": surface.n, "k": surface.k}


def _write_metal(surface: Surface, typed: dict[str, Typed]) -> File:
    name = surface.name
    numbers = (
        f"scene.textures.{name}_fresnel.{key} = {' '.join(map(repr, values))}"
        for key, values in typed.items()
        if isinstance(values, list)
    )
    return _file(
        surface,
        f'scene.textures.{name}_fresnel.type = "fresnelconst"',
        *numbers,
        f'scene.materials.{name}.type = "metal2"',
        f'scene.materials.{name}.fresnel = "{name}_fresnel"',
        f"scene.materials.{name}.uroughness = 0.001",
        f"scene.materials.{name}.vroughness = 0.001",
    )


def _clear(surface: Surface) -> dict[str, Typed]:
    return {"interiorior": surface.ior, "exteriorior": 1.0}


def _write_clear(surface: Surface, typed: dict[str, Typed]) -> File:
    name = surface.name
    return _file(
        surface,
        f'scene.materials.{name}.type = "glass"',
        *(f"scene.materials.{name}.{key} = {value}" for key, value in typed.items()),
    )


def _file(surface: Surface, *lines: str) -> File:
    return File(f"{surface.name}.scn", "\n".join(lines) + "\n")


def _curve(surface: Surface) -> Array:
    """What LuxCore's source has for constant n and k.

    It takes the cosine inside from sin(theta_t) = sin(theta_i) / n as if k were not there, and corrects
    its square for k, which is not the complex index's.
    """
    n, k, at = np.array(surface.n), np.array(surface.k), incidence()
    sin2 = at.sin**2 / n**2
    cos2 = 1.0 - sin2
    inside = np.sqrt(0.5 * (cos2 + np.hypot(cos2, 2.0 * k**2 * sin2)))
    size2 = n**2 + k**2
    both = 2.0 * n * at.cos * inside
    parallel, perpendicular = size2 * at.cos**2 + inside**2, size2 * inside**2 + at.cos**2
    R = 0.5 * (
        (parallel - both) / (parallel + both) + (perpendicular - both) / (perpendicular + both)
    )
    return np.asarray(np.clip(R, 0.0, 1.0))


LUXCORE = Target(
    id="luxcore",
    title="LuxCore",
    modes=(
        Mode(
            "nk",
            "conductor",
            "metal2, fresnelconst",
            _fresnel,
            _write_metal,
            _curve,
            Basis(
                "", note="the formula of LuxCore's source, which LuxCore 2.11.2 follows to 0.001"
            ),
            (
                PAIRS,
                "LuxCore's formula for constant n and k is an approximation, right at normal incidence",
            ),
        ),
        Mode(
            "ior",
            "dielectric",
            "glass",
            _clear,
            _write_clear,
            by_ior,
            Basis(
                "exact",
                note="LuxCore evaluates Fresnel's equations for glass by its source; not run",
            ),
            (DISPERSION, ABSORPTION),
        ),
    ),
    spaces={"srgb": "", "acescg": "The scene's color space has to be ACEScg"},
)
