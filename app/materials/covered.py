"""A material seen from another medium, from a coat on it, or through a pane in front of it.

Covers are clear, and so thick that the waves from their faces do not interfere.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from app.materials.appearance import DAYLIGHT, Appearance, Viewing, appearance
from app.materials.colored import colored
from app.materials.front import Front
from app.materials.schema import Preset
from app.optics.color import WAVELENGTH_NM, luminance, rendered_white, srgb_weights
from app.optics.films import reflectances
from app.optics.incidence import Incidence
from app.optics.parameters import Array, Parameter
from app.optics.specular import MU_BAR
from app.optics.stack import Layer, Stack

CoverKind = Literal["medium", "coat", "pane"]

COVER_N = Parameter("n", "n", 1.5, 1.0, 4.0, "", "Index of what is in front of the material, real.")

_THICK_NM = 1e6


@dataclass(frozen=True, slots=True)
class Cover:
    """What is in front of a material."""

    kind: CoverKind
    """A medium that fills the space, a coat in touch with the material and air before it, or a pane
    with air on both sides."""
    front: Front
    """Its index."""

    @property
    def index(self) -> Array | float:
        """Index over the visible."""
        return self.front.visible()[0]


def below(preset: Preset, cover: Cover, viewing: Viewing = DAYLIGHT) -> Appearance:
    """Color of the material's own surface: seen from the medium or the coat, behind a pane from air."""
    n_i = 1.0 if cover.kind == "pane" else cover.index
    return appearance(colored(preset), n_i, viewing)


def spectral(preset: Preset, cover: Cover, incidence: Incidence) -> Array:
    """Unpolarized reflectance of the whole at `WAVELENGTH_NM`, a row an angle.

    Angles of a coat and a pane are those in air, those of a medium in it.
    """
    seen = colored(preset).visible
    n = cover.index
    thick = [Layer(n, 0.0, _THICK_NM, incoherent=True)] if cover.kind != "medium" else []
    if cover.kind == "pane":
        thick.append(Layer(1.0, 0.0, _THICK_NM, incoherent=True))
    outside = n if cover.kind == "medium" else 1.0
    stack = Stack(outside, thick, seen.n, seen.k, wavelength_nm=WAVELENGTH_NM)
    column = Incidence(incidence.cos.reshape(-1, 1), incidence.sin.reshape(-1, 1))
    Rs, Rp = reflectances(stack, column)
    return np.asarray(0.5 * (Rs + Rp))


def through(
    preset: Preset, cover: Cover, incidence: Incidence, viewing: Viewing = DAYLIGHT
) -> Array:
    """Linear sRGB of the whole, not clamped, a row an angle; angles as of `spectral`."""
    return np.asarray(spectral(preset, cover, incidence) @ srgb_weights(*viewing))


def whole(preset: Preset, cover: Cover, viewing: Viewing = DAYLIGHT) -> Appearance:
    """Color of the whole at normal incidence and at cos(theta_i) = 1/7."""
    R = spectral(preset, cover, Incidence.from_cosine(np.array([1.0, MU_BAR])))
    F0, F82 = np.ascontiguousarray(R @ srgb_weights(*viewing))
    warnings = (*colored(preset).visible.warnings, *cover.front.visible()[1])
    white = rendered_white(*viewing)
    return Appearance(F0, F82, float(luminance(R[0], *viewing[:2])), warnings, white)
