"""glTF 2.0: a square with the material on it, in one file."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np

from app.export.surface import Surface, Typed, digits
from app.export.target import (
    ABSORPTION,
    Basis,
    File,
    FilmMode,
    Mode,
    Target,
    by_schlick,
    by_schlick_ior,
)

_POSITIONS = np.array([[-1, 0, 1], [1, 0, 1], [1, 0, -1], [-1, 0, -1]], np.float32)
_NORMALS = np.array([[0, 1, 0]] * 4, np.float32)
_TRIANGLES = np.array([0, 1, 2, 0, 2, 3], np.uint16)

_FLOAT, _UNSIGNED_SHORT = 5126, 5123
_ARRAY_BUFFER, _ELEMENT_ARRAY_BUFFER = 34962, 34963


def _square() -> dict[str, Any]:
    parts = (_POSITIONS, _NORMALS, _TRIANGLES)
    data = b"".join(part.tobytes() for part in parts)
    views, start = [], 0
    for part in parts:
        target = _ELEMENT_ARRAY_BUFFER if part is _TRIANGLES else _ARRAY_BUFFER
        views.append(
            {"buffer": 0, "byteOffset": start, "byteLength": part.nbytes, "target": target}
        )
        start += part.nbytes
    corner = {"min": _POSITIONS.min(axis=0).tolist(), "max": _POSITIONS.max(axis=0).tolist()}
    vector = {"componentType": _FLOAT, "count": 4, "type": "VEC3"}
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode("ascii")
    return {
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [
            {
                "primitives": [
                    {"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0}
                ]
            }
        ],
        "accessors": [
            {"bufferView": 0, **vector, **corner},
            {"bufferView": 1, **vector},
            {"bufferView": 2, "componentType": _UNSIGNED_SHORT, "count": 6, "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": uri}],
    }


def _file(surface: Surface, base: dict[str, Any], extensions: dict[str, Any]) -> File:
    material: dict[str, Any] = {"name": surface.name, "pbrMetallicRoughness": base}
    document: dict[str, Any] = {"asset": {"version": "2.0", "generator": "Fresnel Explorer"}}
    if extensions:
        material["extensions"] = extensions
        document["extensionsUsed"] = list(extensions)
    document |= {"materials": [material], **_square()}
    return File(f"{surface.name}.gltf", json.dumps(document, indent=1))


def _metal(surface: Surface) -> dict[str, Typed]:
    return {"baseColorFactor": [*surface.F0, 1.0], "metallicFactor": 1.0, "roughnessFactor": 0.0}


def _clear(surface: Surface) -> dict[str, Typed]:
    typed: dict[str, Typed] = {
        "baseColorFactor": [1.0, 1.0, 1.0, 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": 0.0,
        "KHR_materials_ior.ior": surface.ior,
        "KHR_materials_specular.specularFactor": 1.0,
        "KHR_materials_transmission.transmissionFactor": 1.0,
    }
    if surface.preset.abbe:
        typed["KHR_materials_volume.thicknessFactor"] = 1.0
        typed["KHR_materials_dispersion.dispersion"] = digits(20.0 / surface.preset.abbe)
    return typed


def _iridescence(n: float, nm: float) -> dict[str, Typed]:
    """Without a texture the maximum is the thickness everywhere."""
    extension = "KHR_materials_iridescence"
    return {
        f"{extension}.iridescenceFactor": 1.0,
        f"{extension}.iridescenceIor": digits(n),
        f"{extension}.iridescenceThicknessMaximum": digits(nm),
    }


_FILM = FilmMode("gltf_iridescence", _iridescence)


def _write(surface: Surface, typed: dict[str, Typed]) -> File:
    base: dict[str, Any] = {}
    extensions: dict[str, dict[str, Typed]] = {}
    for name, value in typed.items():
        extension, dot, key = name.partition(".")
        if dot:
            extensions.setdefault(extension, {})[key] = value
        else:
            base[name] = value
    return _file(surface, base, extensions)


GLTF = Target(
    id="gltf",
    title="glTF 2.0",
    modes=(
        Mode(
            "schlick",
            "conductor",
            "Metallic, base color",
            _metal,
            _write,
            by_schlick,
            Basis("schlick", "three", "color"),
            (
                "A metal is Schlick's curve from its color at normal incidence: the dip before grazing "
                "incidence is lost, and no extension has it",
            ),
            takes_above_1=False,
            film=_FILM,
        ),
        Mode(
            "ior",
            "dielectric",
            "KHR_materials_ior, transmission",
            _clear,
            _write,
            by_schlick_ior,
            Basis("schlick", "three", "ior"),
            (
                "Viewers show Schlick's curve of the index",
                "Dispersion is kept as 20 over the Abbe number where n is a formula, else lost; its "
                "thickness of 1 stands for that of your model",
                ABSORPTION,
                "KHR_materials_specular stands there because Filament shows no reflection without it",
            ),
            film=_FILM,
        ),
    ),
    spaces={"srgb": ""},
    least_ior=1.0,
    media_type="model/gltf+json",
)
