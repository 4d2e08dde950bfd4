r"""How a material reflects: R over angle and wavelength, and its linear sRGB.

The spectrum is evaluated first and integrated last: R(theta, lambda) is exact at every wavelength,
and the color is the integral of that. A material whose k is not known counts as transparent here;
every result that holds an end value or such a k says so in its warnings.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.materials.spectrum import Colored, Spectrum
from app.optics.amplitudes import reflectance
from app.optics.color import (
    Adaptation,
    Gamut,
    Illuminant,
    Observer,
    Space,
    apply_gamut,
    in_space,
    linear_srgb,
    luminance,
    rendered_white,
    srgb_weights,
)
from app.optics.errors import OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, Array
from app.optics.specular import F82, MU_BAR, polynomial, tint_at_82

ANGLES_AT_ONCE = 256
"""Angles whose 471 wavelengths are in memory together."""


class Viewing(NamedTuple):
    """Under which light, by which observer a color is seen; arguments of what integrates spectra."""

    illuminant: Illuminant = "D65"
    observer: Observer = "cie1931_2deg"
    adaptation: Adaptation = "bradford"


DAYLIGHT = Viewing()


@dataclass(frozen=True, slots=True, eq=False)
class Appearance:
    """Color of the reflected light in linear sRGB, not clamped."""

    F0: Array
    F82: Array
    """At normal incidence and at cos(theta_i) = 1/7, each the integral of the exact spectrum."""
    luminance: float
    """Luminous reflectance Y at normal incidence."""
    warnings: tuple[str, ...]
    """Where the spectrum does not cover the visible, and whether k is not known."""
    white: Array
    """The perfect reflector in the same light: ones unless that keeps its cast."""

    @property
    def F82_tint(self) -> Array:
        """F82 over Schlick's value there, per channel: what the F82-tint model takes."""
        return tint_at_82(self.F0 / self.white, self.F82 / self.white)

    def of_white(self) -> "Appearance":
        """What the surface reflects of each channel, without the cast of the light: for models."""
        white = self.white
        return replace(self, F0=self.F0 / white, F82=self.F82 / white, white=np.ones(3))

    def within(self, gamut: Gamut) -> "Appearance":
        """The same look with F0, F82 and the tint brought into 0 to 1 together.

        The tint is how much darker the edge is than Schlick's, and a policy for what a screen can
        show does not change it, but where the edge is brighter: it is cut to 1 there. F82 is what
        F0 and the tint make of it.
        """
        if gamut == "unclamped":
            return self
        F0 = apply_gamut(self.F0, gamut)
        schlick = self.white * polynomial(F0 / self.white, MU_BAR)
        F82 = np.clip(np.clip(self.F82_tint, 0.0, 1.0) * schlick, 0.0, 1.0)
        return replace(self, F0=F0, F82=F82)

    def in_space(self, space: Space, observer: Observer = "cie1931_2deg") -> "Appearance":
        """The same look in another linear space; what an observer's D65 is, decides its white."""
        F0, F82, white = (in_space(rgb, space, observer) for rgb in (self.F0, self.F82, self.white))
        return replace(self, F0=F0, F82=F82, white=white)

    @property
    def outside(self) -> tuple[str, ...]:
        """Names of what has channels outside 0 to 1, which engines cut or refuse."""
        looks = {name: getattr(self, name) for name in ("F0", "F82", "F82_tint")}
        return tuple(
            name for name, rgb in looks.items() if not bool(np.all((rgb >= 0.0) & (rgb <= 1.0)))
        )


def interface(spectrum: Spectrum, wavelength_nm: ArrayLike, n_i: ArrayLike = 1.0) -> Interface:
    """Boundary from a medium `n_i` to the material, of the wavelengths' shape.

    A k that is not known counts as 0.

    Raises
    ------
    WavelengthOutOfRange
        If n, or k where the source gives any, is not known at a wavelength.
    OutOfRange
        If n or k is beyond what the core takes, as those of metals in the far infrared.
    """
    n, k = spectrum.n_absolute(wavelength_nm), spectrum.k(wavelength_nm)
    try:
        return Interface(n_i, n, 0.0 if k is None else k)
    except OutOfRange as error:
        at = np.asarray(wavelength_nm)[(n if error.parameter == "n_t" else k) == error.value]
        raise OutOfRange(
            "wavelength_nm",
            at[0] if at.size else None,
            f"one where {error.parameter} is {error.allowed}; "
            f"of {spectrum.id} it is {error.value:.5g} here",
        ) from None


def normal_reflectance(n: Array, k: Array | None) -> tuple[Array, list[str]]:
    """F0 from vacuum where n and k are known and within the core's bounds, else NaN.

    Returns
    -------
    tuple
        F0, and what has to be said of it.
    """
    absorbing = np.zeros_like(n) if k is None else k
    known = np.isfinite(n) & np.isfinite(absorbing)
    computed = known & (n >= N_T.minimum) & (n <= N_T.maximum) & (absorbing <= K_T.maximum)
    F0 = np.full(n.shape, np.nan)
    F0[computed] = Interface(1.0, n[computed], absorbing[computed]).F0
    beyond = f"F0 is not computed where n is not {N_T.allowed} or k above {K_T.maximum:g}"
    return F0, [] if np.array_equal(known, computed) else [beyond]


def color_curve(
    spectrum: Colored,
    incidence: Incidence,
    n_i: ArrayLike = 1.0,
    viewing: Viewing = DAYLIGHT,
) -> Array:
    """Linear sRGB of the light reflected at each angle, not clamped.

    Parameters
    ----------
    spectrum
        The second medium; `spectrum.visible.warnings` tells what was held.
    incidence
        Directions, any shape.
    n_i
        Real index of the incident medium: one number, or one for each of the 471 wavelengths.
    viewing
        How the channels are made.

    Returns
    -------
    Array
        The angles' shape followed by 3.
    """
    seen = spectrum.visible
    boundary = Interface(n_i, seen.n, seen.k)
    weights = srgb_weights(*viewing)
    cos, sin = incidence.cos.reshape(-1, 1), incidence.sin.reshape(-1, 1)
    rows = [
        reflectance(boundary, Incidence(cos[at], sin[at])) @ weights
        for at in (
            slice(first, first + ANGLES_AT_ONCE) for first in range(0, len(cos), ANGLES_AT_ONCE)
        )
    ]
    stacked = np.concatenate(rows) if rows else np.empty((0, 3))
    return stacked.reshape(*incidence.cos.shape, 3)


def appearance(
    spectrum: Colored,
    n_i: ArrayLike = 1.0,
    viewing: Viewing = DAYLIGHT,
) -> Appearance:
    """Colors that material models ask for; parameters as in `color_curve`."""
    seen = spectrum.visible
    boundary = Interface(n_i, seen.n, seen.k)
    F0 = linear_srgb(boundary.F0, *viewing)
    at_82 = linear_srgb(F82(boundary), *viewing)
    return Appearance(
        F0=F0,
        F82=at_82,
        luminance=float(luminance(boundary.F0, *viewing[:2])),
        warnings=seen.warnings,
        white=rendered_white(*viewing),
    )


def averaged_interface(
    spectrum: Colored, n_i: ArrayLike = 1.0, viewing: Viewing = DAYLIGHT
) -> Interface:
    """Boundary of constants averaged to three channels, as renderers do that have no spectra.

    Each curve is weighted by the channel's share of the light, so constant curves keep their value,
    in light whose white is not adapted too. An
    average of constants is not the constant of an average: compare with `color_curve`, which is
    right. Channels that no index can be, as those below 0, are cut to the core's bounds.

    Returns
    -------
    Interface
        Of shape (3, 1).
    """
    seen = spectrum.visible
    white = rendered_white(*viewing)

    def mean(values: ArrayLike) -> Array:
        return linear_srgb(values, *viewing) / white

    media = ((n_i, N_I), (seen.n, N_T), (seen.k, K_T))
    averaged = (
        (np.full(3, values) if np.ndim(values) == 0 else mean(values), bounds)
        for values, bounds in media
    )
    return Interface(
        *(np.clip(c, bounds.minimum, bounds.maximum)[:, np.newaxis] for c, bounds in averaged)
    )
