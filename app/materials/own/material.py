"""An own material as a preset with a spectrum, so that everything that takes those takes it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256

from app.materials.own.token import BrokenToken, OwnData, read
from app.materials.schema import Preset, Provenance, SpectrumFile, called
from app.materials.spectrum import Spectrum
from app.materials.summary import summary
from app.optics.errors import OutOfRange

SOURCE = "data of your own, carried by the id"

LICENCE = "as you say"

_KEPT = 64
"""Materials that stay read while they are asked for."""


@dataclass(frozen=True, slots=True)
class Own:
    """An own material."""

    preset: Preset
    spectrum: Spectrum


def own(token: str) -> Own:
    """Read the material that a token carries.

    Raises
    ------
    BrokenToken
        If it carries none.
    """
    return _own(token.strip())


@lru_cache(maxsize=_KEPT)
def _own(token: str) -> Own:
    data = read(token)
    spectrum = Spectrum(_file(token, data))
    try:
        return Own(_preset(token, data, spectrum), spectrum)
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
    return Preset(
        id=token,
        name=data.name,
        category="generic",
        kind="spectrum",
        relative_to=data.relative_to,
        sample="unstated",
        confidence="unstated",
        source=SOURCE,
        licence=LICENCE,
        **summary(spectrum),
    )
