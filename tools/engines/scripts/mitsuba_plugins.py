"""Mitsuba: the reflected lobe of its smooth plugins, sampled; run by `tools.engines.package`."""

from __future__ import annotations

import json
import math
import sys
from typing import Any

import mitsuba as mi


def ways(medium: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return plugins for a medium, by the way in which it is entered."""
    if not medium["metal"]:
        return {"dielectric": {"type": "dielectric", "int_ior": medium["n"][0], "ext_ior": 1.0}}
    eta, k = ({"type": "rgb", "value": medium[name]} for name in ("n", "k"))
    return {"conductor": {"type": "conductor", "eta": eta, "k": k}}


def reflectance(plugin: dict[str, Any], degrees: float) -> list[float]:
    """Return the weight of a ray that is reflected, by channel."""
    bsdf = mi.load_dict(plugin)
    at = mi.SurfaceInteraction3f()
    theta = math.radians(degrees)
    at.wi = [math.sin(theta), 0, math.cos(theta)]
    context = mi.BSDFContext()
    context.type_mask = mi.BSDFFlags.DeltaReflection
    _, weight = bsdf.sample(context, at, 0.5, [0.5, 0.5])
    return [float(x) for x in weight]


def main() -> None:
    """Answer the questions on standard input."""
    mi.set_variant("scalar_rgb")
    asked = json.load(sys.stdin)
    curves = [
        {
            "medium": medium["name"],
            "light": "environment",
            "way": way,
            "typed": {k: v["value"] if isinstance(v, dict) else v for k, v in plugin.items()},
            "reflectance": [reflectance(plugin, degrees) for degrees in asked["theta_i_deg"]],
        }
        for medium in asked["media"]
        for way, plugin in ways(medium).items()
    ]
    print(json.dumps(curves))


main()
