#!/usr/bin/env bash
# One would guess: a named conductor ("AlSb", "Se", "Li") rendered in a spectral variant
# keeps its last measured index, or is refused, at visible wavelengths past the end of its table.
# What happens: the reflectance is nan at normal incidence and exactly 1 at 60 degrees, as if n and
# k were 0 there: a perfect mirror, in the visible. AlSb is so at 600 nm (at 580 nm not yet), Se at
# 700 nm (600 not yet), Li at 760 nm (700 not yet). Gold, whose table goes on, is fine. No warning.
# Measured 2026-11-29 with mitsuba 3.9.1 (variant scalar_spectral).
# Touches: engine comparisons of metals over the visible; check the table's end first.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"${PYTHON:-python3}" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --quiet --disable-pip-version-check mitsuba==3.9.1 numpy==2.2.6
"$folder/venv/bin/python" - <<'PYTHON'
import math
from importlib.metadata import version

import mitsuba as mi

mi.set_variant("scalar_spectral")
print("mitsuba", version("mitsuba"))


def reflectance(material, nm, cosine):
    bsdf = mi.load_dict({"type": "conductor", "material": material})
    point = mi.SurfaceInteraction3f()
    point.wavelengths = [nm] * 4
    point.wi = [math.sqrt(1 - cosine * cosine), 0, cosine]
    return float(bsdf.sample(mi.BSDFContext(), point, 0.5, [0.5, 0.5])[1][0])


found = {}
for material, inside, outside in (("AlSb", 580, 600), ("Se", 600, 700), ("Li", 700, 760),
                                  ("Au", 600, 760)):
    for nm in (inside, outside):
        found[material, nm == outside] = pair = [reflectance(material, nm, c) for c in (1.0, 0.5)]
        print(f"{material} at {nm} nm: R {pair[0]:.4f} at 0 degrees, {pair[1]:.4f} at 60 degrees")
same = (
    all(math.isnan(found[m, True][0]) and found[m, True][1] == 1 for m in ("AlSb", "Se", "Li"))
    and all(0 < r < 0.99 for key, pair in found.items() if key[0] == "Au" or not key[1]
            for r in pair)
)
print("unchanged" if same else "CHANGED")
raise SystemExit(0 if same else 1)
PYTHON
