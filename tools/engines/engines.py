"""The engines that can be measured: which package, at which version, and how it is run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from tools.engines import browser, package, settings
from tools.engines.results import Told


@dataclass(frozen=True, slots=True)
class Engine:
    """One version of an engine."""

    title: str
    package: str
    version: str
    how: str
    """What was drawn, and what was read of it."""
    run: Callable[[str, str], list[Told]]
    """Answers the questions, given the package and the version."""
    rounding: float = 1e-6
    """How far its pixels may be from what it computes: single precision, where not told otherwise."""


_PLANE = (
    "A large mirror-smooth plane below an orthographic camera, lit by an even white environment, or "
    "by one light in the mirror's direction"
)

ENGINES = {
    "three": Engine(
        "three.js",
        "three",
        "0.187.0",
        f"{_PLANE}; MeshPhysicalMaterial, float pixels.",
        partial(
            browser.told,
            script="three",
            modules={"three": "three/build/three.module.js"},
            settings=settings.THREE,
        ),
    ),
    "babylon": Engine(
        "Babylon.js",
        "@babylonjs/core",
        "9.35.0",
        f"{_PLANE}; PBRMaterial and OpenPBRMaterial, float pixels, its noise picture even.",
        partial(
            browser.told,
            script="babylon",
            modules={"@babylonjs/core/": "@babylonjs/core/"},
            settings=settings.BABYLON,
        ),
    ),
    "filament": Engine(
        "Filament",
        "filament",
        "1.53.4",
        f"{_PLANE}; glTF files by its own loader, half-float pixels, no post-processing.",
        partial(browser.told, script="filament", modules={}, settings=settings.FILAMENT),
        rounding=2.0**-12,
    ),
    "playcanvas": Engine(
        "PlayCanvas",
        "playcanvas",
        "2.23.3",
        f"{_PLANE}; StandardMaterial with metalness, float pixels.",
        partial(
            browser.told,
            script="playcanvas",
            modules={"playcanvas": "playcanvas/build/playcanvas.mjs"},
        ),
    ),
    "materialx": Engine(
        "MaterialX",
        "materialx",
        "1.39.5",
        "The GLSL that its generator includes, compiled as shipped: under a light the Fresnel "
        "function, in an environment the analytic albedo of the prefiltered method, both with its "
        "energy compensation.",
        partial(browser.told, script="materialx", modules={}, source="pip"),
    ),
    "usd": Engine(
        "UsdPreviewSurface",
        "usd-core",
        "26.11",
        "The lighting of the preview shader that usd-core ships, compiled as it is, under one light "
        "in the mirror's direction, at roughness 0.5, for at 0 its highlight is infinite.",
        partial(browser.told, script="usd", modules={}, source="pip"),
    ),
    "mitsuba": Engine(
        "Mitsuba",
        "mitsuba",
        "3.9.1",
        "The reflected lobe of the smooth plugins, sampled in the variant scalar_rgb.",
        partial(package.told, script="mitsuba_plugins.py", python="3.11"),
    ),
    "cycles": Engine(
        "Blender Cycles",
        "bpy",
        "5.2.3",
        "A mirror-smooth plane under a white world, orthographic camera, 64 samples, 32-bit EXR.",
        partial(
            package.told,
            script="cycles_planes.py",
            python="3.13",
            settings=settings.CYCLES,
        ),
    ),
}
