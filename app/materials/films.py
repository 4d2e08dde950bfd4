"""Layers as they are written: `MgF2:99.6,0.055+3.32i:30,BK7:2000000:incoherent`, and what they are of.

A medium is the id or alias of a preset, or a number: an index, real or complex. Here k counts however
small it is, since a layer may be thick: 1e-7 in 3 mm of glass absorbs half a percent.
"""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

from app.materials.errors import NoSpectrum
from app.materials.media import (
    Resolved,
    constants_at,
    default_catalog,
    resolve_layer,
)
from app.materials.spectrum import UNKNOWN_K
from app.optics.errors import NotAllowed, OpticsError, OutOfRange
from app.optics.parameters import K_T, LAYER_K, LAYER_N, N_T, THICKNESS_NM, Array
from app.optics.stack import MOST_LAYERS, Layer

SPELLING = (
    "MEDIUM:NM, or MEDIUM:NM:incoherent, from the incident side and separated by commas; MEDIUM is a "
    "material or an index such as 1.38 or 0.055+3.32i, NM the thickness in nanometers"
)
INCOHERENT = "incoherent"

_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
# A + that an address spells as it is arrives as a blank.
_INDEX = re.compile(rf"\s*({_NUMBER})(?:\s*([+ -])\s*({_NUMBER})?\s*[ij])?\s*")
_LONGEST = 50_000


@dataclass(frozen=True, slots=True)
class Film:
    """One layer as it was written."""

    medium: str
    thickness_nm: float | None
    """None where it was left out, as where it is to be found."""
    incoherent: bool
    index: complex | None
    """Where the medium is a number."""

    @property
    def spelled(self) -> str:
        """The layer as it may be written again."""
        thickness = "" if self.thickness_nm is None else f":{self.thickness_nm:.12g}"
        return f"{self.medium}{thickness}{':' + INCOHERENT if self.incoherent else ''}"


@dataclass(frozen=True, slots=True)
class Constants:
    """n, against vacuum, and k of a medium over wavelengths, and what has to be said of them."""

    n: Array
    k: Array
    warnings: tuple[str, ...]


def read_layers(text: str, *, without_thickness: bool = False) -> tuple[Film, ...]:
    """Read layers from the incident side on.

    Parameters
    ----------
    text
        As `SPELLING` says.
    without_thickness
        Whether thicknesses may be left out.

    Raises
    ------
    NotAllowed
        If it says something else, or names more than 1000 layers.
    """
    if len(text) > _LONGEST:
        raise NotAllowed("layers", f"{len(text)} characters", f"at most {_LONGEST}")
    films = tuple(_film(part, without_thickness) for part in text.split(","))
    if len(films) > MOST_LAYERS:
        raise NotAllowed("layers", f"{len(films)} layers", f"at most {MOST_LAYERS}")
    return films


def _film(part: str, without_thickness: bool) -> Film:
    medium, thickness, incoherent = part.strip(), None, False
    head, _, tail = medium.rpartition(":")
    if head and tail.strip() == INCOHERENT:
        medium, incoherent = head, True
        head, _, tail = medium.rpartition(":")
    if head and re.fullmatch(rf"\s*{_NUMBER}\s*", tail):
        medium, thickness = head.strip(), float(tail)
        if not THICKNESS_NM.admits(np.asarray(thickness)):
            raise NotAllowed("layers", part, f"a thickness that is {THICKNESS_NM.allowed}")
    elif not without_thickness:
        raise NotAllowed("layers", part, SPELLING)
    if not medium:
        raise NotAllowed("layers", part, SPELLING)
    index = _index(part, medium)
    if index is not None:
        medium = f"{index.real:.15g}" + (f"+{index.imag:.15g}i" if index.imag else "")
    return Film(medium, thickness, incoherent, index)


def _index(part: str, medium: str) -> complex | None:
    found = _INDEX.fullmatch(medium)
    if found is None:
        return None
    n, k = float(found[1]), 0.0
    if found[2]:
        k = float(found[3]) if found[3] else 1.0
        k = -k if found[2] == "-" else k
    if k < 0.0:
        raise NotAllowed("layers", part, f"n + ki with k >= 0; for n - i k give {n:g}+{-k:g}i")
    for value, bounds in ((n, LAYER_N), (k, LAYER_K)):
        if not bounds.admits(np.asarray(value)):
            raise NotAllowed("layers", part, f"an index whose {bounds.name} is {bounds.allowed}")
    return complex(n, k)


@contextmanager
def reported_as_layers(film: Film) -> Iterator[None]:
    """Let what is refused of a layer's material name the parameter `layers`."""
    try:
        yield
    except OpticsError as error:
        if error.parameter == "material":
            error.parameter, error.value = "layers", film.spelled
            error.args = (f"layers = {film.spelled!r} is not allowed: {error.allowed}",)
        raise


def layer_of(film: Film, n: float | Array, k: float | Array, thickness_nm: float | Array) -> Layer:
    """Make a layer of the core; what it refuses is the layer as it was written."""
    try:
        return Layer(n, k, thickness_nm, incoherent=film.incoherent)
    except OutOfRange as error:
        told = f"one whose {error.parameter} is {error.allowed}"
        raise NotAllowed("layers", film.spelled, told) from None


def resolve_film(film: Film, wavelength_nm: float | None) -> tuple[complex, Resolved | None]:
    """Index of a layer at a wavelength, and the preset that it comes from.

    Raises
    ------
    UnknownMaterial, WavelengthOutOfRange, NotAllowed
        As `resolve_layer` does, naming `layers` in place of `material`.
    """
    if film.index is not None:
        return film.index, None
    with reported_as_layers(film):
        resolved = resolve_layer(film.medium, wavelength_nm)
    return complex(resolved.constants.n_absolute, resolved.constants.k or 0.0), resolved


def film_rows(film: Film, wavelength_nm: Array) -> tuple[Array, Array]:
    """n and k of a layer at many wavelengths, as `resolve_film` has them at one.

    Parameters
    ----------
    film
        The layer.
    wavelength_nm
        Wavelengths in nm; NaN for the material's own.

    Returns
    -------
    tuple
        n, NaN where the material is not known, and k.

    Raises
    ------
    UnknownMaterial
        If there is no such material.
    """
    if film.index is not None:
        shape = wavelength_nm.shape
        return np.full(shape, film.index.real), np.full(shape, film.index.imag)
    with reported_as_layers(film):
        preset = default_catalog().get(film.medium)
    n, k = constants_at(preset, wavelength_nm)
    return n, np.where(np.isnan(k), 0.0, k)


def film_constants(film: Film, wavelength_nm: Array | None) -> Constants:
    """n and k of a layer over wavelengths; parameters as of `material_constants`."""
    if film.index is not None:
        shape = () if wavelength_nm is None else wavelength_nm.shape
        n, k = (np.full(shape, part) for part in (film.index.real, film.index.imag))
        return Constants(n, k, ())
    with reported_as_layers(film):
        return material_constants(film.medium, wavelength_nm)


def material_constants(name: str, wavelength_nm: Array | None) -> Constants:
    """n and k of a material over wavelengths.

    Parameters
    ----------
    name
        Id or alias.
    wavelength_nm
        Wavelengths in nm, or None for those of colors, where end values are held; what is held is
        among the warnings.

    Raises
    ------
    UnknownMaterial, NoSpectrum, WavelengthOutOfRange, NotAllowed
        If it is not known there, or beyond the bounds of the core.
    """
    preset = default_catalog().get(name)
    if preset.category == "vacuum":
        shape = () if wavelength_nm is None else wavelength_nm.shape
        return Constants(np.ones(shape), np.zeros(shape), ())
    if preset.kind == "single":
        raise NoSpectrum(preset.id)
    spectrum = default_catalog().spectrum(preset.id)
    if wavelength_nm is None:
        seen = spectrum.visible
        return Constants(
            seen.n, seen.k, tuple(f"{preset.called}: {told}" for told in seen.warnings)
        )
    n, k = spectrum.n_absolute(wavelength_nm), spectrum.k(wavelength_nm)
    warnings = () if k is not None else (f"{preset.called}: {UNKNOWN_K}",)
    k = np.zeros_like(n) if k is None else k
    for quantity, values, bounds in (("n", n, N_T), ("k", k, K_T)):
        fine = bounds.admits(values)
        if not fine.all():
            at, value = (float(np.asarray(a)[~fine].flat[0]) for a in (wavelength_nm, values))
            where = f"one where {quantity} of {preset.called} is {bounds.allowed}"
            raise NotAllowed("wavelength_nm", at, f"{where}; here it is {value:.5g}")
    return Constants(n, np.maximum(k, 0.0), warnings)
