"""What a target is told of a material: an index, colors, pairs of n and k, and spectra."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from app.materials.appearance import DAYLIGHT, Appearance, appearance
from app.materials.colored import colored
from app.materials.rgb_index import ANGLES_DEG, fitted_interface, reflected_at_angles
from app.materials.schema import Preset
from app.materials.spectrum import Visible
from app.optics.color import WAVELENGTH_NM, Gamut, Space
from app.optics.incidence import Incidence
from app.optics.interface import Interface, Kind
from app.optics.knobs.dispersion import D_LINE_NM
from app.optics.parameters import Array

OPAQUE_K = 1e-3
"""Largest k over the visible from which a material is exported as one that is opaque.

Green light falls to 1/e within 44 µm there, and the reflectance is that of k = 0 to 1e-6.
"""

STEP_NM = 5
"""Distance of the wavelengths that spectral targets are given."""

Typed = str | float | list[float]


@dataclass(frozen=True)
class Surface:
    """A smooth, thick piece of a material in air, in channels of one space and by one gamut policy."""

    preset: Preset
    policy: Gamut
    space: Space

    @property
    def name(self) -> str:
        """An identifier in every format."""
        name = re.sub(r"[^A-Za-z0-9]+", "_", self.preset.called).strip("_")
        return name if name[0].isalpha() else f"material_{name}"

    @cached_property
    def visible(self) -> Visible:
        """Return n and k over the visible."""
        return colored(self.preset).visible

    @cached_property
    def kind(self) -> Kind:
        """Whether it is exported as opaque or as clear."""
        return "conductor" if self.visible.k.max() >= OPAQUE_K else "dielectric"

    @cached_property
    def ior(self) -> float:
        """Return n against vacuum at the d line, 587.56 nm."""
        return digits(np.interp(D_LINE_NM, WAVELENGTH_NM, self.visible.n))

    @cached_property
    def _look(self) -> Appearance:
        look = appearance(colored(self.preset), 1.0, DAYLIGHT).in_space(self.space)
        return look.within(self.policy)

    @property
    def F0(self) -> list[float]:
        """Color at normal incidence."""
        return triple(self._look.F0)

    @property
    def F82_tint(self) -> list[float]:
        """What the color at 82 degrees is over Schlick's."""
        return triple(self._look.F82_tint)

    @property
    def outside(self) -> tuple[str, ...]:
        """Names of colors that leave 0 to 1 by this policy."""
        return self._look.outside

    @cached_property
    def pairs(self) -> Interface:
        """Fitted n and k of three channels, of shape (3, 1)."""
        return fitted_interface(self.preset.id, DAYLIGHT, self.policy, self.space)

    @property
    def n(self) -> list[float]:
        """Fitted n of three channels."""
        return triple(self.pairs.n_t)

    @property
    def k(self) -> list[float]:
        """Fitted k of three channels."""
        return triple(self.pairs.k_t)

    @cached_property
    def spectrum(self) -> Spectral:
        """Return n and k at every fifth nanometer, 360 to 830."""
        at = slice(None, None, STEP_NM)
        return Spectral(WAVELENGTH_NM[at], self.visible.n[at], self.visible.k[at])

    @property
    def truth(self) -> Array:
        """What its spectrum reflects of each channel at `ANGLES_DEG`, not clamped."""
        return reflected_at_angles(self.preset.id, DAYLIGHT, self.space)


@dataclass(frozen=True, slots=True, eq=False)
class Spectral:
    """n and k at wavelengths, between which a renderer interpolates linearly."""

    wavelength_nm: Array
    n: Array
    k: Array

    def rows(self, name: str) -> list[tuple[float, float]]:
        """Pairs of wavelength and `n` or `k`, as they are written."""
        values = getattr(self, name)
        return [(float(at), digits(v)) for at, v in zip(self.wavelength_nm, values, strict=True)]


def digits(value: float | Array) -> float:
    """Six significant digits, as files have them."""
    return float(f"{float(value):.6g}")


def triple(values: Array) -> list[float]:
    """Write three channels."""
    return [digits(value) for value in values.ravel()]


def incidence() -> Incidence:
    """Directions of `ANGLES_DEG`, an angle a row."""
    return Incidence.from_degrees(ANGLES_DEG[:, np.newaxis])
