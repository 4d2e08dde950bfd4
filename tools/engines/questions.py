"""What every engine is asked: clear media and metals, at angles from 0 to 89 degrees.

A metal has one n and k for each of red, green and blue, those of its spectrum at three wavelengths,
so that its exact curves are three calls of the formula and owe nothing to a color space.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from app.materials.media import default_catalog
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.quantities import QUANTITIES

THETA_I_DEG = np.array([*range(0, 60, 5), *range(60, 80, 2), *range(80, 90)], float)
"""Where reflectance is measured, closer where it rises."""

CHANNELS_NM = (650.0, 550.0, 450.0)
"""The wavelengths at which a metal's red, green and blue are read."""

Settings = Sequence[tuple[str, dict[str, Any]]]
"""Ways of an engine, each with what is typed."""

CLEAR = {"n = 1": 1.0, "water": 1.33, "glass": 1.5, "diamond": 2.42}
METALS = {"gold": "Au", "copper": "Cu", "aluminium": "Al", "chromium": "Cr"}


@dataclass(frozen=True, slots=True)
class Medium:
    """What is measured: one index, or one for each channel."""

    name: str
    n: list[float]
    k: list[float]

    @property
    def is_metal(self) -> bool:
        """Whether it absorbs."""
        return any(self.k)

    @property
    def interface(self) -> Interface:
        """The surface of the medium in vacuum; the last axis is the channel."""
        return Interface(1.0, np.array(self.n), np.array(self.k))

    def exact(self, theta_i_deg: Array = THETA_I_DEG) -> Array:
        """Unpolarized reflectance, a row an angle, a column a channel."""
        return QUANTITIES["R"](self.interface, Incidence.from_degrees(theta_i_deg[:, None]))

    @property
    def F0(self) -> list[float]:
        """Reflectance at normal incidence, by channel."""
        return [round(float(x), 6) for x in self.exact(np.zeros(1))[0]]

    @property
    def tint(self) -> list[float]:
        """F82 over Schlick's value there, by channel: what F82-tint models are given."""
        mu = 1 / 7
        at = np.degrees(np.arccos(np.array([mu])))
        schlick = 1 - (1 - self.exact(np.zeros(1))[0]) * (1 - (1 - mu) ** 5)
        return [round(float(x), 6) for x in self.exact(at)[0] / schlick]


WHITE = Medium("white metal", [1e-3] * 3, [100.0] * 3)
"""What reflects everything: how far an engine's white is from 1 is the noise of its measurement."""


def media() -> list[Medium]:
    """Return the clear media, then the metals."""
    catalog = default_catalog()
    clear = [Medium(name, [n, n, n], [0.0, 0.0, 0.0]) for name, n in CLEAR.items()]
    metals = []
    for name, preset in METALS.items():
        read = [catalog.constants(preset, nm) for nm in CHANNELS_NM]
        metals.append(Medium(name, [c.n for c in read], [c.k or 0.0 for c in read]))
    return [*clear, *metals]


def asked(settings: Settings = ()) -> dict[str, Any]:
    """Return the questions as JSON has them, with what the engines are given for a metal.

    Parameters
    ----------
    settings
        What is typed besides the media, by the way of the engine that it belongs to.
    """
    told = [
        {
            "name": medium.name,
            "metal": medium.is_metal,
            "n": medium.n,
            "k": medium.k,
            "F0": medium.F0,
            "tint": medium.tint,
        }
        for medium in (WHITE, *media())
    ]
    return {"media": told, "theta_i_deg": THETA_I_DEG.tolist(), "settings": list(settings)}
