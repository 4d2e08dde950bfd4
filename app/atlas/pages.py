"""The materials of the atlas: presets and pages of refractiveindex.info, each at its wavelengths."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Literal, get_args

import numpy as np

from app.atlas.grid import VISIBLE_NM, Band, wavelengths
from app.materials.media import NEGLIGIBLE_K, default_catalog
from app.materials.published.index import default_pages
from app.materials.schema import Preset
from app.optics.parameters import Array

Kind = Literal["clear", "absorbing", "metal"]
KINDS: tuple[Kind, ...] = get_args(Kind)

FAINT = 1e-3
"""Share of n - 1 below which a k counts as 0: it changes what is reflected by less than 1e-6 of that."""

METALLIC = 0.5
"""Share of n that the k of a metal exceeds at every wavelength; semiconductors do at some."""

CURATED = "curated"
"""Shelf of the presets, which stand for the pages of the database that they were taken from."""

MIDDLE_NM = 550.0
"""Next to which a material's n, k and F0 are told; outside the visible in the middle of its own."""


@dataclass(frozen=True, eq=False)
class Page:
    """A material at the wavelengths of the grid."""

    preset: Preset
    of_database: str
    """Id of the page that has these n and k, `rii:SHELF/BOOK/PAGE`; empty for a single index."""
    shelf: str
    """Of the database, or `CURATED` for a preset."""
    band: Band
    wavelength_nm: Array
    """NaN for a single index whose source names none."""
    n: Array
    """Against vacuum."""
    k: Array
    """NaN where the source gives none."""
    spans_the_visible: bool
    """Whether it is known from 400 to 700 nm, so that it has a color."""

    @property
    def k_counted(self) -> Array:
        """What k counts as."""
        return faint_as_zero(self.n, self.k)

    @property
    def kind(self) -> Kind:
        """What it counts as over its wavelengths."""
        if not self.k_counted.any():
            return "clear"
        return "metal" if bool(np.all(self.k_counted > METALLIC * self.n)) else "absorbing"

    @property
    def middle(self) -> int:
        """Place of the wavelength that stands for all."""
        if self.band == "elsewhere" or np.isnan(self.wavelength_nm).any():
            return int(self.wavelength_nm.size // 2)
        return int(np.argmin(np.abs(self.wavelength_nm - MIDDLE_NM)))


def faint_as_zero(n: Array, k: Array) -> Array:
    """What k counts as: 0 where it is not known, NaN that is, or too faint for what is reflected."""
    faint = np.maximum(NEGLIGIBLE_K, FAINT * (n - 1.0))
    return np.where(k >= faint, k, 0.0)  # NaN compares false


@cache
def _taken_from() -> Mapping[str, str]:
    """Ids of the pages that presets were taken from, by those of the presets."""
    catalog = default_catalog()
    ids = {listed.file: listed.id for listed in default_pages().all}
    spectra = [catalog.spectrum(p.id) for p in catalog.presets if p.kind == "spectrum"]
    files = {one.id: one.file.provenance.file.removeprefix("data/") for one in spectra}
    return {name: ids[file] for name, file in files.items() if file in ids}


def page_ids() -> tuple[str, ...]:
    """Ids of all materials: presets, then the pages that none of these was taken from.

    Vacuum, which reflects nothing, and pages that are refused are none.
    """
    presets = tuple(p.id for p in default_catalog().presets if p.category != "vacuum")
    taken = set(_taken_from().values())
    return presets + tuple(
        listed.id
        for listed in default_pages().all
        if listed.refused is None and listed.id not in taken
    )


def refused_pages() -> tuple[str, ...]:
    """Ids of the pages of the database that nothing is computed of."""
    return tuple(listed.id for listed in default_pages().all if listed.refused is not None)


def page(material: str) -> Page | None:
    """Look at a material; None where n and k are known together nowhere that can be computed."""
    catalog = default_catalog()
    preset = catalog.get(material)
    if preset.kind == "single":
        return _single(preset)
    spectrum = catalog.spectrum(preset.id)
    band, at = wavelengths(spectrum)
    if not at.size:
        return None
    k = spectrum.k(at)
    low, high = spectrum.range_nm
    return Page(
        preset=preset,
        of_database=_taken_from().get(preset.id, "") if preset.page is None else preset.id,
        shelf=CURATED if preset.page is None else preset.page.shelf,
        band=band,
        wavelength_nm=at,
        n=spectrum.n_absolute(at),
        k=np.full(at.shape, np.nan) if k is None else k,
        spans_the_visible=bool(low <= VISIBLE_NM[0] and high >= VISIBLE_NM[-1]),
    )


def _single(preset: Preset) -> Page:
    """A single index stands for all wavelengths, as it does in colors."""
    known = (preset.wavelength_nm, preset.n_absolute, preset.k)
    at, n, k = (np.array([np.nan if value is None else value]) for value in known)
    return Page(preset, "", CURATED, "visible", at, n, k, spans_the_visible=True)
