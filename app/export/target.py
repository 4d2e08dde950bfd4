"""A target of export: its modes, its writer, and the curve that it will show."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from app.export.surface import Spectral, Surface, Typed, incidence
from app.materials.appearance import DAYLIGHT, color_curve
from app.materials.colored import Constant
from app.materials.rgb_index import ANGLES_DEG
from app.materials.spectrum import Visible
from app.optics.amplitudes import reflectance
from app.optics.color import WAVELENGTH_NM, Space
from app.optics.incidence import Incidence
from app.optics.interface import Interface, Kind
from app.optics.models.f82_tint import f82_tint
from app.optics.parameters import Array
from app.optics.specular import polynomial

TargetId = Literal["materialx", "openpbr", "gltf", "usd", "blender", "mitsuba", "pbrt", "luxcore"]
ModeId = Literal["nk", "f82", "principled", "spectral", "schlick", "ior"]

Curve = Callable[[Surface], Array]
"""Reflectance of three channels at `ANGLES_DEG`, an angle a row."""


@dataclass(frozen=True, slots=True)
class File:
    """A text file."""

    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Basis:
    """What a target's curve is computed with: a model, and the engine in which it was measured."""

    model: str
    """Id of a model; empty for a formula of the target alone."""
    engine: str | None = None
    """Id of the engine among the measured ones."""
    way: str | None = None
    note: str = ""


@dataclass(frozen=True, slots=True)
class FilmMode:
    """How a mode says that there is a film with interference on the surface."""

    model: str
    """Id of the shortcut among `app.optics.film_models` that stands for the engine."""
    parameters: Callable[[float, float], dict[str, Typed]]
    """What is typed besides, of the film's index and its thickness in nm."""


@dataclass(frozen=True, slots=True)
class Mode:
    """One way to write a kind of material for a target."""

    id: ModeId
    kind: Kind
    title: str
    parameters: Callable[[Surface], dict[str, Typed]]
    """What is typed, by the target's own names."""
    write: Callable[[Surface, dict[str, Typed]], File]
    """Writes what is typed."""
    curve: Curve
    basis: Basis
    lost: tuple[str, ...] = ()
    """Sentences on what the target does not know of the material."""
    takes_above_1: bool = True
    """Whether colors above 1 are legal there."""
    film: FilmMode | None = None
    """None where the target has no film, or where none stands for what it does."""

    def file(self, surface: Surface) -> File:
        """Write a material."""
        return self.write(surface, self.parameters(surface))


@dataclass(frozen=True, slots=True)
class Target:
    """An engine or a format."""

    id: TargetId
    title: str
    modes: tuple[Mode, ...]
    """The first of a kind is what is written unless another is asked for."""
    spaces: Mapping[Space, str]
    """Spaces that its numbers may be in, each with what has to be set for it, if anything."""
    media_type: str = "text/plain"
    """Of its files."""
    least_ior: float = 0.0
    """What an index of a clear medium, or of a film, may be."""

    def of(self, kind: Kind) -> tuple[Mode, ...]:
        """Return the modes for a kind of material."""
        return tuple(mode for mode in self.modes if mode.kind == kind)


def by_pairs(surface: Surface) -> Array:
    """Fresnel's equations with a pair of n and k a channel."""
    return np.asarray(reflectance(Interface(1.0, surface.n, surface.k), incidence()))


def by_ior(surface: Surface) -> Array:
    """Fresnel's equations with one index."""
    return _gray(reflectance(Interface(1.0, surface.ior), incidence()))


def by_f82(surface: Surface) -> Array:
    """F82-tint."""
    colors = np.array(surface.F0), np.array(surface.F82_tint)
    return f82_tint(Interface(), incidence(), *colors)


def by_schlick(surface: Surface) -> Array:
    """Schlick's curve from a color."""
    return polynomial(np.array(surface.F0), incidence().cos)


def by_schlick_ior(surface: Surface) -> Array:
    """Schlick's curve from an index."""
    return _gray(polynomial(Interface(1.0, surface.ior).F0, incidence().cos))


def by_spectrum(surface: Surface) -> Array:
    """Integrate what the samples that are written reflect, interpolated linearly."""
    return spectral_curve(surface.spectrum)


def spectral_curve(samples: Spectral) -> Array:
    """Linear sRGB at `ANGLES_DEG` of n and k that are interpolated linearly."""
    n, k = (
        np.interp(WAVELENGTH_NM, samples.wavelength_nm, [value for _, value in samples.rows(name)])
        for name in ("n", "k")
    )
    medium = Constant(Visible(n, k, ()))
    return color_curve(medium, Incidence.from_degrees(ANGLES_DEG), 1.0, DAYLIGHT)


def _gray(R: Array) -> Array:
    return np.broadcast_to(R, (ANGLES_DEG.size, 3))


PAIRS = "The spectrum becomes three fitted pairs of n and k"
TINT = "The color at 0 and 82 degrees is kept, and what lies between is a fit"
DISPERSION = "One index stands for all wavelengths: dispersion is lost"
ABSORPTION = "What the medium absorbs on the way through is not exported"
"""Sentences that several targets share."""
