"""`index.json`: what lists show of every material, computed by the program's own code."""

from collections.abc import Iterable

import numpy as np

from app.materials.appearance import Appearance, appearance
from app.materials.schema import (
    TRANSPARENT,
    Channels,
    Color,
    Preset,
    Row,
    SpectrumFile,
    Table,
)
from app.materials.spectrum import Spectrum
from app.optics.interface import Interface
from app.optics.specular import F82
from tools.build_materials.selection import Choice

REFERENCE_NM = 587.6
"""Where lists show n and k: the default of the API's wavelength_nm."""


def spectrum_preset(choice: Choice, file: SpectrumFile) -> Preset:
    """Summarize a spectrum at the reference wavelength and over the visible."""
    spectrum = Spectrum(file)
    k = spectrum.k(REFERENCE_NM)
    n, n_absolute = float(spectrum.n(REFERENCE_NM)), float(spectrum.n_absolute(REFERENCE_NM))
    look = appearance(spectrum)
    abbe = spectrum.abbe_number if file.category in TRANSPARENT else None
    return Preset(
        id=file.id,
        name=file.name,
        category=file.category,
        aliases=choice.aliases,
        kind="spectrum",
        rival_of=choice.rival_of,
        axis=file.axis,
        n=_digits(n),
        n_absolute=_digits(n_absolute),
        k=None if k is None else _digits(float(k)),
        wavelength_nm=REFERENCE_NM,
        relative_to=file.relative_to,
        wavelength_in=file.wavelength_in,
        n_range_nm=spectrum.n_range_nm,
        k_range_nm=spectrum.k_range_nm,
        sample=file.sample,
        confidence=file.confidence,
        source=file.provenance.reference,
        doi=file.provenance.doi,
        licence=file.provenance.licence,
        note=file.note,
        warnings=file.warnings,
        F0=_digits(float(Interface(n_t=n_absolute, k_t=0.0 if k is None else k).F0)),
        color=_color(look),
        abbe=None if abbe is None else round(abbe, 4),
    )


def row_presets(table: Table) -> Iterable[Preset]:
    """Summarize the rows of a table; without dispersion every channel has the same F0."""
    for row in table.rows:
        boundary = Interface(n_t=row.n)
        F0 = float(boundary.F0)
        grey = np.ones(3)
        look = Appearance(F0 * grey, F82(boundary) * grey, F0, (), grey)
        yield Preset(
            **row.model_dump(),
            n_absolute=row.n,
            kind="single",
            n_range_nm=None if row.wavelength_nm is None else (row.wavelength_nm,) * 2,
            k_range_nm=None,
            sample="unstated",
            confidence="low" if row.n_min is not None else table.confidence,
            licence=table.licence,
            warnings=_row_warnings(row),
            F0=_digits(F0),
            color=_color(look),
        )


def _row_warnings(row: Row) -> tuple[str, ...]:
    warnings = ["k is not known and counts as 0", "a single index: its color has no dispersion"]
    if row.wavelength_nm is None:
        warnings.append("the source names no wavelength")
    return tuple(warnings)


def _color(look: Appearance) -> Color:
    return Color(
        F0=_channels(look.F0),
        F82=_channels(look.F82),
        F82_tint=_channels(look.F82_tint),
        luminance=round(look.luminance, 6),
    )


def _channels(values: Iterable[float]) -> Channels:
    # Six decimals are far below what the measurements mean and hide the last bits, in which
    # processors may differ. Adding 0 turns -0.0 into 0.0.
    red, green, blue = (round(float(value), 6) + 0.0 for value in values)
    return red, green, blue


def _digits(value: float) -> float:
    return float(f"{value:.10g}")
