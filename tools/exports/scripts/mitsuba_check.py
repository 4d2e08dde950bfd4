"""Mitsuba: each dictionary is loaded, and what it reflects compared with what we say."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import mitsuba as mi

TOLERANCE = 1e-3


def rows(entry: dict[str, Any]) -> list[list[float]]:
    """Weight of a reflected ray, an angle a row, a channel or a wavelength a column."""
    spectral = entry["mode"] == "spectral"
    mi.set_variant("scalar_spectral" if spectral else "scalar_rgb")
    bsdf = mi.load_dict(json.loads(Path(entry["file"]).read_text(encoding="utf-8")))
    context = mi.BSDFContext()
    context.type_mask = mi.BSDFFlags.DeltaReflection
    found = []
    for degrees in entry["theta_i_deg"]:
        at = mi.SurfaceInteraction3f()
        theta = math.radians(degrees)
        at.wi = [math.sin(theta), 0, math.cos(theta)]
        row: list[float] = []
        wavelengths = entry.get("wavelength_nm", [None])
        for first in range(0, len(wavelengths), 4):
            four = wavelengths[first : first + 4]
            if spectral:
                at.wavelengths = [*four, *[four[-1]] * (4 - len(four))]
            _, weight = bsdf.sample(context, at, 0.5, [0.5, 0.5])
            row += [float(x) for x in weight][: len(four) if spectral else 3]
        found.append(row)
    return found


def main() -> None:
    """Check the files that standard input lists."""
    errors, farthest, entries = [], 0.0, json.load(sys.stdin)
    for entry in entries:
        try:
            pairs = zip(rows(entry), entry["reflectance"], strict=True)
            apart = max(abs(a - b) for row in pairs for a, b in zip(*row, strict=True))
        except Exception as error:  # whatever the library finds wrong is what is asked
            errors.append(f"{entry['material']} {entry['mode']}: {error}")
            continue
        farthest = max(farthest, apart)
        if not apart <= TOLERANCE:
            errors.append(f"{entry['material']} {entry['mode']}: {apart:.2g} off")
    print(json.dumps({"read": len(entries), "errors": errors, "farthest": farthest}))


main()
