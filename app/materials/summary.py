"""What lists show of a spectrum that is no preset of the catalog: constants, ranges and color."""

from typing import Any

import numpy as np

from app.materials.appearance import appearance
from app.materials.schema import Channels, Color
from app.materials.spectrum import Spectrum
from app.optics.interface import Interface
from app.optics.parameters import Array

REFERENCE_NM = 587.6
"""Where n and k are told unless a wavelength is given, or the nearest end of what is known."""


def summary(spectrum: Spectrum) -> dict[str, Any]:
    """Fields of a preset that follow from n and k; its warnings are those of the color.

    Raises
    ------
    OutOfRange
        If n against vacuum is beyond the core's bounds.
    """
    low, high = spectrum.range_nm
    at = min(max(REFERENCE_NM, low), high)
    absorbs = spectrum.k(at)
    k = None if absorbs is None else float(absorbs)
    n_absolute = float(spectrum.n_absolute(at))
    look = appearance(spectrum)
    return {
        "n": float(spectrum.n(at)),
        "n_absolute": n_absolute,
        "k": k,
        "wavelength_nm": at,
        "n_range_nm": spectrum.n_range_nm,
        "k_range_nm": spectrum.k_range_nm,
        "warnings": look.warnings,
        "F0": float(Interface(n_t=n_absolute, k_t=k or 0.0).F0),
        "color": Color(
            F0=_channels(look.F0),
            F82=_channels(look.F82),
            F82_tint=_channels(look.F82_tint),
            luminance=look.luminance,
        ),
    }


def _channels(values: Array) -> Channels:
    red, green, blue = np.round(values, 6).tolist()
    return red, green, blue
