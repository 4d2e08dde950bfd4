r"""What engines make of a clear coat on a surface, from the surface's color in air.

The exact reflectance of a smooth coat, for each polarization, is the sum of what goes to and fro in it,

.. math:: R = F_c + \frac{(1-F_c)^2 R_b}{1 - F_c R_b},

with F_c the coat's reflectance from air at theta_i and R_b that of the surface below, seen from the coat
at the angle inside. `app.materials.covered` evaluates it. Engines know neither R_b nor its angle: they
take the color in air, some change its F0, and evaluate it at the angle outside.

References
----------
.. [1] KHR_materials_clearcoat, extension of glTF 2.0.
.. [2] R. Guy and M. Agopian, Physically Based Rendering in Filament, clear coat: surface modification.
.. [3] OpenPBR Surface specification 1.1.1, coat: darkening.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from app.optics.amplitudes import reflectance
from app.optics.collection import Collection
from app.optics.errors import UnknownModel
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.babylon_openpbr import babylon_openpbr
from app.optics.models.f82_tint import f82_tint
from app.optics.parameters import Array
from app.optics.specular import polynomial

COAT_F0 = 0.04
"""What a coat of glTF reflects at normal incidence: its index is 1.5."""


@dataclass(frozen=True, slots=True, eq=False)
class Base:
    """What is typed for a surface below a coat, and the coat's index."""

    F0: Array
    """Color at normal incidence in air, of three channels."""
    tint: Array
    """What the color at 82 degrees is over Schlick's."""
    n: float
    """Index of the coat."""


def kept(F0: Array, n: float) -> Array:  # noqa: ARG001
    """F0 as it is in air."""
    return F0


def cubic(F0: Array, n: float) -> Array:  # noqa: ARG001
    """Filament's fit of `from_coat` at n = 1.5 [2]_."""
    return np.clip(F0 * (F0 * (0.941892 - 0.263008 * F0) + 0.346479) - 0.0285998, 0.0, 1.0)


def quadratic(F0: Array, n: float) -> Array:  # noqa: ARG001
    """The same in fewer operations, for phones and in Unity."""
    return np.clip(F0 * (F0 * 0.526868 + 0.529324) - 0.0482256, 0.0, 1.0)


def from_coat(F0: Array, n: float) -> Array:
    """F0 seen from the coat if F0 in air were that of a real index."""
    root = np.sqrt(F0)
    t = ((1.0 - n) + (1.0 + n) * root) / ((1.0 + n) + (1.0 - n) * root)
    return np.asarray(t * t)


def _over(coat: Array, below: Array) -> Array:
    """A coat of a reflectance on what it lets through of the surface below, once."""
    return np.asarray(coat + (1.0 - coat) * below)


def _schlick_coat(base: Base, incidence: Incidence, coat_F0: Array | float) -> Array:
    mu = incidence.cos[..., np.newaxis]
    return _over(polynomial(coat_F0, mu), polynomial(base.F0, mu))


def _plain(base: Base, incidence: Incidence) -> Array:
    return _schlick_coat(base, incidence, COAT_F0)


def _of_any_index(base: Base, incidence: Incidence) -> Array:
    return _schlick_coat(base, incidence, Interface(1.0, base.n).F0)


def _exact_coat(base: Base, incidence: Incidence) -> Array:
    return reflectance(Interface(1.0, base.n), incidence)[..., np.newaxis]


def _metal(base: Base, incidence: Incidence) -> Array:
    along = Incidence(incidence.cos[..., np.newaxis], incidence.sin[..., np.newaxis])
    return f82_tint(Interface(), along, base.F0, base.tint)


def _cycles(base: Base, incidence: Incidence) -> Array:
    return _over(_exact_coat(base, incidence), _metal(base, incidence))


def _darkened(base: Base, incidence: Incidence, K: Array | float) -> Array:
    """The color below times (1 - K) / (1 - K E), E the color at normal incidence [3]_."""
    below = _metal(base, incidence) * (1.0 - K) / (1.0 - K * base.F0)
    return _over(_exact_coat(base, incidence), below)


def _openpbr(base: Base, incidence: Incidence) -> Array:
    return _darkened(base, incidence, _exact_coat(base, incidence))


def _materialx(base: Base, incidence: Incidence) -> Array:
    coat = Interface(1.0, base.n)
    return _darkened(base, incidence, 1.0 - (1.0 - float(coat.F0)) / base.n**2)


def _babylon(base: Base, incidence: Incidence) -> Array:
    """The color below times (1 - a)^2, a the mean of the coat's reflectance and of (1 + its F0) / 2."""
    coat = Interface(1.0, base.n)
    over = babylon_openpbr(coat, incidence, coat.F0)[..., np.newaxis]
    a = 0.5 * (over + 0.5 * (1.0 + float(coat.F0)))
    return _over(over, _metal(base, incidence) * (1.0 - a) ** 2)


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatShortcut:
    """One engine's way to coat a surface."""

    id: str
    title: str
    reference: str
    validity: str
    """What it leaves out, in words."""
    F0_below: Callable[[Array, float], Array]
    """F0 that it takes for the surface below, of that in air and the coat's index."""
    function: Callable[[Base, Incidence], Array]
    """Three channels of the whole, of a base with that F0."""
    engines: tuple[str, ...] = ()
    """Ids of the engines in which coated gold was measured to follow it."""

    def color(self, base: Base, incidence: Incidence) -> Array:
        """Three channels of the whole, the angles' shape followed by 3."""
        return self.function(replace(base, F0=self.F0_below(base.F0, base.n)), incidence)


_FIXED = "Its coat has the index 1.5, whatever yours has"
_OUTSIDE = "evaluates the metal at the angle outside, and does not count what goes to and fro"

_SHORTCUTS = (
    CoatShortcut(
        id="gltf_clearcoat",
        title="glTF clearcoat",
        reference="KHR_materials_clearcoat; three.js 0.187.0, Filament 1.53.4 by its glTF loader",
        validity=f"{_FIXED}. It keeps F0 of the metal in air, {_OUTSIDE}.",
        F0_below=kept,
        function=_plain,
        engines=("three", "filament"),
    ),
    CoatShortcut(
        id="filament_clearcoat",
        title="Filament's own clear coat, Babylon's of 1.5",
        reference="R. Guy and M. Agopian, Physically Based Rendering in Filament; Babylon.js 9.35.0, "
        "PBRMaterial",
        validity=f"{_FIXED}. It darkens F0 by a cubic of that index's dielectrics, {_OUTSIDE}.",
        F0_below=cubic,
        function=_plain,
        engines=("babylon",),
    ),
    CoatShortcut(
        id="babylon_clearcoat",
        title="Babylon's clear coat",
        reference="Babylon.js 9.35.0, PBRMaterial, indexOfRefraction of clearCoat other than 1.5",
        validity=f"It takes F0 for that of a real index, {_OUTSIDE}.",
        F0_below=from_coat,
        function=_of_any_index,
        engines=("babylon",),
    ),
    CoatShortcut(
        id="mobile_clearcoat",
        title="Filament on phones, Unity",
        reference="f0ClearCoatToSurface of Filament's shaders, ConvertF0ForAirInterfaceToF0ForClearCoat"
        "15Fast of Unity's",
        validity=f"{_FIXED}. It darkens F0 by a square of that index's dielectrics, {_OUTSIDE}.",
        F0_below=quadratic,
        function=_plain,
    ),
    CoatShortcut(
        id="cycles_coat",
        title="Cycles, Principled coat",
        reference="Blender 5.2.3, Cycles",
        validity=f"It keeps F0 and tint of the metal in air, {_OUTSIDE}.",
        F0_below=kept,
        function=_cycles,
        engines=("cycles",),
    ),
    CoatShortcut(
        id="openpbr_coat",
        title="OpenPBR, its specification",
        reference="OpenPBR Surface specification 1.1.1, coat, equations general_darkening_formula and "
        "internal_diffuse_reflection_coefficient_for_smooth_base",
        validity="It keeps F0 and tint of the metal in air and darkens it by what goes to and fro in a "
        "coat on a smooth base; it evaluates the metal at the angle outside.",
        F0_below=kept,
        function=_openpbr,
    ),
    CoatShortcut(
        id="materialx_openpbr_coat",
        title="OpenPBR in MaterialX",
        reference="MaterialX 1.39.5, open_pbr_surface, base_darkening",
        validity="As the specification, but it darkens a smooth metal as much as a matte base, by "
        "K = 1 - (1 - F0) / n^2 of the coat.",
        F0_below=kept,
        function=_materialx,
    ),
    CoatShortcut(
        id="babylon_openpbr_coat",
        title="OpenPBR in Babylon, even environment",
        reference="Babylon.js 9.35.0, OpenPBRMaterial, image-based light with its coatDarkening of 1",
        validity="It darkens what is below by half, whatever its color: a mirror below a coat reflects "
        "0.54. Under single lights it darkens less.",
        F0_below=kept,
        function=_babylon,
        engines=("babylon",),
    ),
)


class CoatShortcuts(Collection[CoatShortcut]):
    """All shortcuts, by their ids."""

    def __init__(self, items: Iterable[CoatShortcut]) -> None:
        super().__init__(items, UnknownModel, "models")


@cache
def coat_shortcuts() -> CoatShortcuts:
    """Every shortcut."""
    return CoatShortcuts(_SHORTCUTS)
