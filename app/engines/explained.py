"""Which registered model each engine evaluates, and where it departs from the boundary."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from app.engines.measured import CHANNELS, Curve, Engine, Light
from app.optics.interface import Kind


@dataclass(frozen=True, slots=True)
class Explanation:
    """A model that stands for some of an engine's curves; what is None is any."""

    model: str
    light: Light | None = None
    way: str | None = None
    kind: Kind | None = None

    def fits(self, curve: Curve) -> bool:
        """Whether it speaks of a curve."""
        return (
            self.light in (None, curve.light)
            and self.way in (None, curve.way)
            and self.kind in (None, curve.medium.kind)
        )


EXPLAINED: Mapping[str, tuple[Explanation, ...]] = {
    "babylon": (
        Explanation("babylon_openpbr", way="OpenPBRMaterial", kind="dielectric"),
        Explanation("f82_tint", way="OpenPBRMaterial"),
        Explanation("f82_tint", way="PBRMaterial, F82"),
        Explanation("schlick"),
    ),
    "cycles": (
        Explanation("exact", kind="dielectric"),
        Explanation("exact", way="Metallic BSDF, Physical Conductor"),
        Explanation("f82_tint"),
    ),
    "filament": (
        Explanation("schlick", way="glTF, ior and specular"),
        Explanation("schlick", way="glTF, base color"),
    ),
    "materialx": (
        Explanation("schlick", light="environment"),
        Explanation("f82_tint", way="generalized_schlick_bsdf"),
        Explanation("exact"),
    ),
    "mitsuba": (Explanation("exact"),),
    "playcanvas": (Explanation("constant_f0", kind="dielectric"),),
    "three": (Explanation("schlick", light="environment"), Explanation("spherical_gaussian")),
    "usd": (
        Explanation("constant_f0", way="metallic"),
        Explanation("schlick"),
    ),
}
"""By engine, the first that fits a curve counts; a curve that none fits is explained by no model."""


def explained(engine: Engine, curve: Curve) -> str | None:
    """Return the id of the model that an engine evaluates for a curve, or None."""
    found = (e.model for e in EXPLAINED.get(engine.id, ()) if e.fits(curve))
    return next(found, None)


@dataclass(frozen=True, slots=True)
class Departure:
    """A sentence on one engine, with the figure that shows it."""

    text: str
    """Of `{measured}` and `{exact}`, the red channel at the angle."""
    medium: str
    way: str
    light: Light
    at_deg: float

    def told(self, engine: Engine) -> str:
        """Fill in what was measured."""
        curve = engine.curve(self.medium, self.way, self.light)
        row = int(np.flatnonzero(engine.theta_i_deg == self.at_deg)[0])
        red = CHANNELS.index("red")
        return self.text.format(
            measured=f"{curve.reflectance[row, red]:.3f}",
            exact=f"{engine.exact(curve.medium)[row, red]:.3f}",
            at=f"{self.at_deg:g} degrees",
        )


@dataclass(frozen=True, slots=True)
class SettingDeparture:
    """A sentence on what is typed into an engine, with the figure that shows it at normal incidence."""

    text: str
    """Of `{measured}`, the red channel."""
    way: str
    typed: Mapping[str, Any]
    """What of it has to be typed, of extensions and nested parts as well."""

    def told(self, engine: Engine) -> str:
        """Fill in what was measured."""
        return self.text.format(measured=f"{self.measured(engine):.4f}")

    def measured(self, engine: Engine) -> float:
        """Reflectance of red at normal incidence."""
        (found,) = (
            setting
            for setting in engine.settings
            if setting.way == self.way and self.typed.items() <= _flat(setting.typed).items()
        )
        return float(found.reflectance[0, CHANNELS.index("red")])


def _flat(typed: Mapping[str, Any]) -> dict[str, Any]:
    """Numbers and texts of all levels."""
    found: dict[str, Any] = {}
    for name, value in typed.items():
        if isinstance(value, Mapping):
            found |= _flat(value)
        elif not isinstance(value, list):
            found[name] = value
    return found


DEPARTURES: Mapping[str, tuple[Departure | SettingDeparture, ...]] = {
    "babylon": (
        Departure(
            "OpenPBRMaterial cuts clear media off at grazing incidence, for its F90 is twice the "
            "difference of the indices: water reflects {measured} at {at}, the boundary {exact}.",
            "water",
            "OpenPBRMaterial",
            "light",
            85.0,
        ),
        Departure(
            "Metals are Schlick's unless conductorSpecularModel is set: chromium reflects {measured} "
            "at {at} where the boundary has its dip, {exact}.",
            "chromium",
            "PBRMaterial",
            "light",
            85.0,
        ),
        SettingDeparture(
            "OpenPBRMaterial darkens what is below a clear coat by half in an even environment, "
            "whatever its color: gold, whose red is 0.958 without one, reflects {measured} with a coat "
            "of index 1.5, where all that goes to and fro makes 0.942.",
            "OpenPBRMaterial",
            {"coatWeight": 1, "coatIor": 1.5},
        ),
    ),
    "filament": (
        Departure(
            "A glTF material with KHR_materials_ior but without KHR_materials_specular reflects no "
            "environment: glass {measured} at {at}, the boundary {exact}.",
            "glass",
            "glTF, ior",
            "environment",
            0.0,
        ),
        SettingDeparture(
            "specularFactor enters F0 twice: 0.5 of it, which glTF means to halve the 0.04 of glass, "
            "leaves {measured}.",
            "glTF",
            {"specularFactor": 0.5},
        ),
    ),
    "materialx": (
        Departure(
            "The prefiltered environment, its generator's default, fits one Schlick curve to all "
            "Fresnel models: chromium by n and k reflects {measured} at {at}, the boundary {exact}.",
            "chromium",
            "conductor_bsdf",
            "environment",
            85.0,
        ),
        Departure(
            "In it an index of 1, which is no boundary, reflects {measured} at {at}.",
            "n = 1",
            "dielectric_bsdf",
            "environment",
            80.0,
        ),
        Departure(
            "The energy compensation, made for rough surfaces, makes a mirror brighter than its light "
            "at grazing incidence: gold by n and k reflects {measured} at {at}, the boundary {exact}.",
            "gold",
            "conductor_bsdf",
            "light",
            85.0,
        ),
    ),
    "playcanvas": (
        Departure(
            "Clear media have no Fresnel effect at all: glass reflects {measured} at {at}, the "
            "boundary {exact}.",
            "glass",
            "refractionIndex",
            "environment",
            85.0,
        ),
        Departure(
            "Metals rise toward their largest channel alone, which itself stays: the red of "
            "chromium is {measured} at {at}, that of the boundary {exact}.",
            "chromium",
            "diffuse",
            "environment",
            89.0,
        ),
    ),
    "three": (
        Departure(
            "An ior of 1, which is no boundary, reflects {measured} at {at}: F90 stays 1.",
            "n = 1",
            "ior",
            "environment",
            80.0,
        ),
        Departure(
            "Metals are Schlick's from their color: chromium reflects {measured} at {at} where the "
            "boundary has its dip, {exact}.",
            "chromium",
            "color",
            "environment",
            85.0,
        ),
    ),
    "usd": (
        Departure(
            "Metals reflect the same at every angle: chromium {measured} at {at}, the boundary "
            "{exact}.",
            "chromium",
            "metallic",
            "light",
            89.0,
        ),
    ),
}
"""By engine, what its curves show; engines that have none follow the boundary within their noise."""
