"""At which wavelengths the atlas looks at a material."""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np

from app.materials.spectrum import Spectrum
from app.optics.parameters import K_T, N_T, Array

Band = Literal["visible", "elsewhere"]
BANDS: tuple[Band, ...] = get_args(Band)

VISIBLE_NM: Array = np.arange(400.0, 701.0, 50.0)
"""Where the light is from which red, green and blue are made; a material's are those it is known at."""
VISIBLE_NM.flags.writeable = False

SHARES = (0.25, 0.5, 0.75)
"""How far into its range, in equal ratios, a material is looked at that is known at none of those."""

GRID = (
    "400 to 700 nm by 50 nm, as far as n, and k where the source has any, are known there; "
    "materials known at none of these are looked at after a quarter, a half and three quarters of "
    "their range, in equal ratios"
)
"""The grid in words."""


def wavelengths(spectrum: Spectrum) -> tuple[Band, Array]:
    """Choose the wavelengths in nanometers, rising, at which a material is looked at.

    Returns
    -------
    tuple
        The band, and the wavelengths of it at which n and k are known and within the core's bounds;
        none if n and k are nowhere known together.
    """
    visible = _computed(spectrum, VISIBLE_NM)
    if visible.size:
        return "visible", visible
    low, high = spectrum.range_nm
    if low > high:
        return "elsewhere", np.empty(0)
    # Within the ends, which rounding must not leave.
    own = np.clip(low * (high / low) ** np.array(SHARES), low, high)
    return "elsewhere", _computed(spectrum, np.unique(own))


def _computed(spectrum: Spectrum, wavelength_nm: Array) -> Array:
    n, k = spectrum.n_absolute_or_nan(wavelength_nm), spectrum.k_or_nan(wavelength_nm)
    known = N_T.admits(n)  # NaN is not admitted
    return wavelength_nm[known if k is None else known & K_T.admits(k)]
