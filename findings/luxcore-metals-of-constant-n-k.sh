#!/usr/bin/env bash
# One would guess: LuxCore's metal2 with a fresnelconst texture, n and k of three channels, reflects what
# Fresnel's equations give for them.
# What happens: only at normal incidence. It takes the angle inside from sin(theta_i) / n as if k were
# not there. At 60 degrees n = 0.43, k = 2.4 (gold's green) reflects 0.906 where the equations give
# 0.782, n = 1.2, k = 7 (aluminium) 0.858 instead of 0.895, n = 0.2, k = 3 0.983 instead of 0.918.
# A mirror in the same scene reflects 1.
# Measured 2026-11-30 with pyluxcore 2.11.2 (PATHCPU, an even white sky, an orthographic camera).
# Touches: exports to LuxCore, whose error we state by its own formula.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check pyluxcore==2.11.2
"$folder/venv/bin/python" - <<'PYTHON'
import array
import cmath
import math
import os
import time
from importlib.metadata import version

import pyluxcore

pyluxcore.Init(lambda _: None)
print("pyluxcore", version("pyluxcore"))
N, K = (0.43, 1.2, 0.2), (2.4, 7.0, 3.0)
METAL = f"""
scene.textures.f.type = "fresnelconst"
scene.textures.f.n = {N[0]} {N[1]} {N[2]}
scene.textures.f.k = {K[0]} {K[1]} {K[2]}
scene.materials.m.type = "metal2"
scene.materials.m.fresnel = "f"
scene.materials.m.uroughness = 0.001
scene.materials.m.vroughness = 0.001
"""
MIRROR = """
scene.materials.m.type = "mirror"
scene.materials.m.kr = 1 1 1
"""


def exact(degrees, n, k):
    mu, N = math.cos(math.radians(degrees)), complex(n, k)
    inside = cmath.sqrt(1 - (1 - mu * mu) / N**2)
    s = (mu - N * inside) / (mu + N * inside)
    p = (N * mu - inside) / (N * mu + inside)
    return (abs(s) ** 2 + abs(p) ** 2) / 2


def properties(text):
    read = pyluxcore.Properties()
    read.SetFromString(text)
    return read


def rendered(material, degrees):
    sin, cos = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    scene = pyluxcore.Scene()
    for text in (
        f"""
scene.camera.type = "orthographic"
scene.camera.screenwindow = -0.01 0.01 -0.01 0.01
scene.camera.lookat.orig = {10 * sin} 0 {10 * cos}
scene.camera.lookat.target = 0 0 0
scene.camera.up = {-cos} 0 {sin}
scene.lights.sky.type = "constantinfinite"
""",
        material,
        """
scene.shapes.plane.type = "inlinedmesh"
scene.shapes.plane.vertices = -99 -99 0 99 -99 0 99 99 0 -99 99 0
scene.shapes.plane.faces = 0 1 2 0 2 3
scene.objects.plane.shape = plane
scene.objects.plane.material = m
""",
    ):
        scene.Parse(properties(text))
    session = pyluxcore.RenderSession(pyluxcore.RenderConfig(properties("""
renderengine.type = "PATHCPU"
sampler.type = "SOBOL"
film.width = 16
film.height = 16
native.threads.count = 1
batch.haltspp = 64
film.outputs.0.type = "RGB"
film.outputs.0.filename = "mirror.exr"
"""), scene))
    session.Start()
    while not session.HasDone():
        time.sleep(0.05)
        session.UpdateStats()
    session.Stop()
    pixels = array.array("f", [0.0]) * (3 * 256)
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, pixels)
    return [sum(pixels[c::3]) / 256 for c in range(3)]


same = all(abs(r - 1) < 1e-3 for r in rendered(MIRROR, 60))
for degrees, wanted in ((0, [0.780, 0.911, 0.923]), (60, [0.906, 0.858, 0.983])):
    found = rendered(METAL, degrees)
    right = [exact(degrees, n, k) for n, k in zip(N, K)]
    print(f"{degrees} degrees: " + ", ".join(f"{f:.3f} ({e:.3f})" for f, e in zip(found, right)),
          "(Fresnel's equations in brackets)")
    same &= all(abs(f - w) < 2e-3 for f, w in zip(found, wanted))
print("unchanged" if same else "CHANGED", flush=True)
os._exit(0 if same else 1)  # its threads bring the interpreter down at the end
PYTHON
