"""What is typed besides the media, by engine and way: knobs of clear media, and coats on gold.

`app/optics/knobs` and `app/optics/coats.py` tell what each stands for; tests compare them.
"""

from __future__ import annotations

from typing import Any

from tools.engines.questions import media

Typed = list[tuple[str, dict[str, Any]]]

_BLACK = [0, 0, 0]
_GOLD = next(medium for medium in media() if medium.name == "gold")


def _three(**numbers: Any) -> dict[str, Any]:
    return {"color": _BLACK, "roughness": 0, **numbers}


THREE: Typed = [
    *[("ior", _three(ior=n)) for n in (2.42, 3.0)],
    *[("reflectivity", _three(reflectivity=r)) for r in (0.25, 0.5, 1.0, 2.0)],
    *[("ior, saved", _three(ior=n)) for n in (2.0, 3.0)],
    *[("specularIntensity", _three(ior=1.5, specularIntensity=f)) for f in (0.0, 0.25, 0.5)],
    *[
        ("specularColor", _three(ior=n, specularColor=color))
        for n, color in ((1.5, [1.0, 0.5, 0.25]), (1.5, [2.0, 4.0, 50.0]), (2.42, [0.5, 0.5, 0.5]))
    ],
    ("clearcoat", {"color": _GOLD.F0, "metalness": 1, "roughness": 0, "clearcoat": 1}),
]


def _open_pbr(ior: float, weight: float) -> dict[str, Any]:
    return {
        "specularIor": ior,
        "specularWeight": weight,
        "baseColor": _BLACK,
        "baseMetalness": 0,
        "specularRoughness": 0,
    }


BABYLON: Typed = [
    ("OpenPBRMaterial", _open_pbr(n, w))
    for n, w in ((1.5, 0.25), (1.5, 0.5), (1.5, 1.0), (2.42, 0.5), (1.5, 2.0))
]
BABYLON += [
    (
        "OpenPBRMaterial",
        {
            "baseColor": _GOLD.F0,
            "baseMetalness": 1,
            "specularRoughness": 0,
            "specularColor": _GOLD.tint,
            "coatWeight": 1,
            "coatIor": n,
            "coatRoughness": 0,
        },
    )
    for n in (1.5, 1.8)
]
BABYLON += [
    (
        "PBRMaterial, clearCoat",
        {
            "albedoColor": _GOLD.F0,
            "metallic": 1,
            "roughness": 0,
            "clearCoat": {"indexOfRefraction": n},
        },
    )
    for n in (1.5, 1.8)
]


def _gltf(ior: float, **specular: Any) -> dict[str, Any]:
    return {
        "pbrMetallicRoughness": {
            "metallicFactor": 0,
            "roughnessFactor": 0,
            "baseColorFactor": [*_BLACK, 1],
        },
        "extensions": {
            "KHR_materials_ior": {"ior": ior},
            "KHR_materials_specular": specular,
        },
    }


FILAMENT: Typed = [
    *[("glTF", _gltf(1.5, specularFactor=f)) for f in (0.25, 0.5, 0.75, 1.0)],
    ("glTF", _gltf(2.42, specularFactor=1.0)),
    *[
        ("glTF", _gltf(1.5, specularFactor=1.0, specularColorFactor=color))
        for color in ([1.0, 0.5, 0.25], [2.0, 4.0, 50.0])
    ],
    (
        "glTF, clearcoat",
        {
            "pbrMetallicRoughness": {
                "metallicFactor": 1,
                "roughnessFactor": 0,
                "baseColorFactor": [*_GOLD.F0, 1],
            },
            "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 1.0}},
        },
    ),
]

CYCLES: Typed = [
    (
        "Principled BSDF",
        {"Base Color": _BLACK, "IOR": n, "Specular IOR Level": level, "Roughness": 0},
    )
    for n, level in (
        (1.5, 0.0),
        (1.5, 0.25),
        (1.5, 0.5),
        (1.5, 1.0),
        (1.5, 2.0),
        (2.42, 0.25),
        (0.5, 0.5),
        (0.8, 1.0),
        (10.0, 1.0),
        (0.0, 0.5),
    )
]
CYCLES += [
    (
        "Principled BSDF, coat",
        {
            "Base Color": _GOLD.F0,
            "Metallic": 1,
            "Specular Tint": _GOLD.tint,
            "Roughness": 0,
            "Coat Weight": 1,
            "Coat IOR": n,
            "Coat Roughness": 0,
        },
    )
    for n in (1.5, 1.8)
]
