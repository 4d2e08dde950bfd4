"""Reads `materials/engines/`: what render engines reflect, measured by running them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, get_args

import numpy as np

from app.materials.location import data_directory
from app.optics.collection import Collection
from app.optics.errors import UnknownName
from app.optics.incidence import Incidence
from app.optics.interface import Interface, Kind
from app.optics.parameters import Array
from app.optics.quantities import QUANTITIES

Light = Literal["environment", "light"]
"""An even environment, or one light in the mirror's direction as a share of white metal."""

Channel = Literal["red", "green", "blue"]
CHANNELS: tuple[Channel, ...] = get_args(Channel)


class UnknownEngine(UnknownName):
    """An engine that was not measured."""


@dataclass(frozen=True, slots=True)
class Medium:
    """What lies below the surface: n and k of red, green and blue."""

    name: str
    n: Array
    k: Array

    @property
    def kind(self) -> Kind:
        """Whether it absorbs."""
        return "conductor" if np.any(self.k) else "dielectric"

    @property
    def interface(self) -> Interface:
        """Its boundary with vacuum, an element a channel."""
        return Interface(1.0, self.n, self.k)


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """Reflectance of a medium in one engine, by one of its materials or modes."""

    medium: Medium
    light: Light
    way: str
    typed: Mapping[str, Any]
    reflectance: Array
    """A row an angle, a column a channel."""


@dataclass(frozen=True, slots=True, eq=False)
class Setting:
    """What an engine reflects of an even environment where something is typed into its knobs."""

    way: str
    typed: Mapping[str, Any]
    reflectance: Array
    """A row an angle, a column a channel."""


@dataclass(frozen=True, slots=True, eq=False)
class Engine:
    """Everything measured of one version of an engine."""

    id: str
    title: str
    package: str
    version: str
    date: str
    how: str
    repeat: str
    noise: float
    channels_nm: tuple[float, ...]
    theta_i_deg: Array
    media: tuple[Medium, ...]
    curves: tuple[Curve, ...]
    settings: tuple[Setting, ...]

    def curve(self, medium: str, way: str, light: Light) -> Curve:
        """Return the curve of a medium by its name, entered in one way, under one light."""
        asked = (medium, way, light)
        (found,) = (c for c in self.curves if (c.medium.name, c.way, c.light) == asked)
        return found

    def exact(self, medium: Medium) -> Array:
        """Unpolarized reflectance of a medium, in rows and columns as a curve's."""
        incidence = Incidence.from_degrees(self.theta_i_deg[:, None])
        return np.broadcast_to(
            QUANTITIES["R"](medium.interface, incidence), (self.theta_i_deg.size, len(CHANNELS))
        )


def _engine(told: dict[str, Any]) -> Engine:
    media = {
        m["name"]: Medium(m["name"], np.array(m["n"]), np.array(m["k"])) for m in told["media"]
    }
    curves = tuple(
        Curve(
            media[curve["medium"]],
            curve["light"],
            curve["way"],
            curve["typed"],
            np.array(curve["reflectance"]),
        )
        for curve in told["curves"]
    )
    return Engine(
        id=told["engine"],
        theta_i_deg=np.array(told["theta_i_deg"]),
        channels_nm=tuple(told["channels_nm"]),
        media=tuple(media.values()),
        curves=curves,
        settings=tuple(
            Setting(one["way"], one["typed"], np.array(one["reflectance"]))
            for one in told.get("settings", ())
        ),
        **{
            name: told[name]
            for name in ("title", "package", "version", "date", "how", "repeat", "noise")
        },
    )


@cache
def engines() -> Collection[Engine]:
    """Every engine that was measured, loaded once a process."""
    files = sorted((data_directory() / "engines").glob("*.json"))
    return Collection((_engine(json.loads(f.read_text())) for f in files), UnknownEngine, "engine")
