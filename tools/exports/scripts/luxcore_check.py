"""LuxCore: each file is parsed, and a mirror of a few metals rendered below an even white sky."""

from __future__ import annotations

import array
import json
import math
import os
import sys
import time
from pathlib import Path
from typing import Any

import pyluxcore

RENDERED = ("Au", "Cu", "Cr", "Ag")
TOLERANCE = 1e-3
_SIZE = 16

_SKY = """
scene.lights.sky.type = "constantinfinite"
scene.lights.sky.gain = 1 1 1
scene.camera.type = "orthographic"
scene.camera.screenwindow = -0.01 0.01 -0.01 0.01
"""
_PLANE = """
scene.shapes.plane.type = "inlinedmesh"
scene.shapes.plane.vertices = -99 -99 0 99 -99 0 99 99 0 -99 99 0
scene.shapes.plane.faces = 0 1 2 0 2 3
scene.objects.plane.shape = plane
"""
_RENDER = f"""
renderengine.type = "PATHCPU"
sampler.type = "SOBOL"
film.width = {_SIZE}
film.height = {_SIZE}
native.threads.count = 1
batch.haltspp = 64
path.pathdepth.total = 3
film.outputs.0.type = "RGB"
film.outputs.0.filename = "mirror.exr"
"""


def properties(text: str) -> Any:
    """Read properties."""
    read = pyluxcore.Properties()
    read.SetFromString(text)
    return read


def rendered(material: str, name: str, degrees: float) -> list[float]:
    """Mean color of a mirror seen at an angle, which is its reflectance."""
    theta = math.radians(degrees)
    camera = f"""
scene.camera.lookat.orig = {10 * math.sin(theta)} 0 {10 * math.cos(theta)}
scene.camera.lookat.target = 0 0 0
scene.camera.up = {-math.cos(theta)} 0 {math.sin(theta)}
"""
    scene = pyluxcore.Scene()
    for text in (_SKY + camera, material, _PLANE + f"scene.objects.plane.material = {name}"):
        scene.Parse(properties(text))
    session = pyluxcore.RenderSession(pyluxcore.RenderConfig(properties(_RENDER), scene))
    session.Start()
    while not session.HasDone():
        time.sleep(0.05)
        session.UpdateStats()
    session.Stop()
    pixels = array.array("f", [0.0]) * (3 * _SIZE**2)
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, pixels)
    return [sum(pixels[channel::3]) / _SIZE**2 for channel in range(3)]


def main() -> None:
    """Check the files that standard input lists."""
    pyluxcore.Init(lambda _: None)
    errors, farthest, entries = [], 0.0, json.load(sys.stdin)
    for entry in entries:
        path = Path(entry["file"])
        text = path.read_text(encoding="utf-8")
        try:
            pyluxcore.Scene().Parse(properties(text))
        except Exception as error:  # whatever the library finds wrong is what is asked
            errors.append(f"{entry['material']} {entry['mode']}: {error}")
            continue
        if entry["material"] in RENDERED:
            for degrees, said in zip(entry["theta_i_deg"], entry["reflectance"], strict=True):
                found = rendered(text, path.stem, degrees)
                apart = max(abs(a - b) for a, b in zip(found, said, strict=True))
                farthest = max(farthest, apart)
                if apart > TOLERANCE:
                    errors.append(f"{entry['material']} at {degrees}: {apart:.2g} off")
    print(json.dumps({"read": len(entries), "errors": errors, "farthest": farthest}), flush=True)
    os._exit(0)  # its threads bring the interpreter down at the end


main()
