"""An own material as a preset with a spectrum, so that everything that takes those takes it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256

import numpy as np

from app.materials.appearance import appearance
from app.materials.own.token import BrokenToken, OwnData, read
from app.materials.schema import Channels, Color, Preset, Provenance, SpectrumFile, called
from app.materials.spectrum import Spectrum
from app.optics.errors import OutOfRange
from app.optics.interface import Interface
from app.optics.parameters import Array

REFERENCE_NM = 587.6
"""Where n and k are told unless a wavelength is given, or the nearest end of what is known."""

SOURCE = "data of your own, carried by the id"

LICENCE = "as you say"

_KEPT = 64
"""Materials that stay read while they are asked for."""


@dataclass(frozen=True, slots=True)
class Own:
    """An own material."""

    preset: Preset
    spectrum: Spectrum


@lru_cache(maxsize=_KEPT)
def own(token: str) -> Own:
    """Read the material that a token carries.

    Raises
    ------
    BrokenToken
        If it carries none.
    """
    data = read(token)
    spectrum = Spectrum(_file(token, data))
    try:
        return Own(_preset(token.strip(), data, spectrum), spectrum)
    except OutOfRange as error:  # n = 100 in air is more against vacuum
        raise BrokenToken(token, f"{error.parameter} is to be {error.allowed}") from None


def _file(token: str, data: OwnData) -> SpectrumFile:
    return SpectrumFile(
        id=called(token, data.name),
        name=data.name,
        category="generic",
        axis="isotropic",
        sample="unstated",
        confidence="unstated",
        conditions={},
        relative_to=data.relative_to,
        wavelength_in=None,
        note=None,
        warnings=(),
        provenance=Provenance(
            database="none",
            tag="none",
            page="none",
            file=data.name,
            sha256=sha256(token.encode()).hexdigest(),
            reference=SOURCE,
            doi=(),
            links=(),
            licence=LICENCE,
            comments=None,
        ),
        n=data.n,
        k=data.k,
    )


def _preset(token: str, data: OwnData, spectrum: Spectrum) -> Preset:
    low, high = spectrum.range_nm
    at = min(max(REFERENCE_NM, low), high)
    absorbs = spectrum.k(at)
    k = None if absorbs is None else float(absorbs)
    n_absolute = float(spectrum.n_absolute(at))
    look = appearance(spectrum)
    return Preset(
        id=token,
        name=data.name,
        category="generic",
        kind="spectrum",
        n=float(spectrum.n(at)),
        n_absolute=n_absolute,
        k=k,
        wavelength_nm=at,
        relative_to=data.relative_to,
        n_range_nm=spectrum.n_range_nm,
        k_range_nm=spectrum.k_range_nm,
        sample="unstated",
        confidence="unstated",
        source=SOURCE,
        licence=LICENCE,
        warnings=look.warnings,
        F0=float(Interface(n_t=n_absolute, k_t=k or 0.0).F0),
        color=Color(
            F0=_channels(look.F0),
            F82=_channels(look.F82),
            F82_tint=_channels(look.F82_tint),
            luminance=look.luminance,
        ),
    )


def _channels(values: Array) -> Channels:
    red, green, blue = np.round(values, 6).tolist()
    return red, green, blue
