"""What n was measured against: glass in air is glass in air, whatever air's own index."""

from collections import Counter
from math import asin, degrees, sqrt
from typing import Any

import numpy as np
import pytest

from app.materials.air import air_index
from app.materials.appearance import appearance
from app.materials.catalog import Catalog
from app.materials.front import Front
from app.materials.media import constants_at
from app.materials.spectrum import Spectrum
from app.optics.color import WAVELENGTH_NM, linear_srgb

# Relative to air: what the makers' catalogs and the named papers have.
IN_AIR = {
    *("BK7", "BK7-OHARA", "SF10", "SF11", "BAF10", "FK51A", "LASF9"),
    *("fused-silica", "fused-silica-Arosa", "polycarbonate", "polystyrene"),
    *("benzene", "toluene", "CS2", "sapphire-o", "sapphire-e", "CaF2", "MgF2-o", "MgF2-e"),
}

# Dry air at 15 °C and 101.325 kPa. Below 1.7 µm by Peck and Reeder (1972), whose own formula is
# n - 1 = 1e-8 (8060.51 + 2480990 / (132.274 - s) + 17455.7 / (39.32957 - s)), s = 1 / wavelength^2
# in micrometers; above by Mathar (2007), values that refractiveindex.info tabulates.
MATHAR = {
    2024.0: 1.000273034297,
    3081.0: 1.000272822653,
    5033.0: 1.000272757645,
    12807.0: 1.000272680710,
}
AIR_KNOWN = 2e-6


def peck(wavelength_nm: Any) -> Any:
    s = (np.asarray(wavelength_nm) / 1000.0) ** -2
    return 1.0 + 1e-8 * (8060.51 + 2480990.0 / (132.274 - s) + 17455.7 / (39.32957 - s))


def schott(wavelength_nm: float) -> float:
    """N-BK7 by the maker's data sheet."""
    square = (wavelength_nm / 1000.0) ** 2
    terms = (
        (1.03961212, 0.00600069867),
        (0.231792344, 0.0200179144),
        (1.01046945, 103.560653),
    )
    return sqrt(1.0 + sum(b * square / (square - c) for b, c in terms))


def normal(eta: Any) -> Any:
    return ((eta - 1.0) / (eta + 1.0)) ** 2


def test_which_spectra_are_relative_to_air(catalog: Catalog) -> None:
    spectra = [catalog.spectrum(p.id) for p in catalog.presets if p.kind == "spectrum"]
    assert {s.id for s in spectra if s.file.relative_to == "air"} == IN_AIR
    count = Counter(s.file.relative_to for s in spectra)
    assert count == {"air": 19, "vacuum": 38, None: 93}  # as materials/README.md says
    for spectrum in spectra:
        preset = catalog.get(spectrum.id)
        file = spectrum.file
        told = (preset.relative_to, preset.wavelength_in)
        assert told == (file.relative_to, file.wavelength_in), spectrum.id
        if file.provenance.file.startswith("data/specs/"):  # what makers of glass publish
            assert told == ("air", "air"), spectrum.id
        if file.category == "gas":  # air itself among them
            assert file.relative_to == "vacuum", spectrum.id


def test_only_what_is_relative_to_air_is_multiplied(catalog: Catalog) -> None:
    for preset in catalog.presets:
        if preset.kind == "single":
            assert preset.n_absolute == preset.n, preset.id
            continue
        spectrum = catalog.spectrum(preset.id)
        at = np.geomspace(*spectrum.n_range_nm, 50).clip(*spectrum.n_range_nm)
        wanted = spectrum.n(at) * (peck(at) if preset.id in IN_AIR else 1.0)
        np.testing.assert_allclose(spectrum.n_absolute(at), wanted, rtol=AIR_KNOWN)
        if preset.id not in IN_AIR:
            np.testing.assert_array_equal(spectrum.n_absolute(at), spectrum.n(at))


def test_air_is_the_preset_air_and_that_of_others(catalog: Catalog) -> None:
    air = catalog.spectrum("air")
    at = np.linspace(*air.n_range_nm, 500)
    np.testing.assert_array_equal(air_index(at), air.n(at))
    beyond = np.linspace(200.0, 1700.0, 500)
    np.testing.assert_allclose(air_index(beyond), peck(beyond), rtol=0, atol=AIR_KNOWN)
    np.testing.assert_allclose(
        air_index(list(MATHAR)), list(MATHAR.values()), rtol=0, atol=AIR_KNOWN
    )
    assert air_index(130.0) == air_index(185.0)  # Nobody measures in air where it is opaque.


@pytest.mark.parametrize("wavelength_nm", [320.0, 435.8343, 587.5618, 1013.98, 1600.0])
def test_behind_air_glass_has_the_index_of_its_data_sheet(
    catalog: Catalog, wavelength_nm: float
) -> None:
    glass, at = catalog.spectrum("BK7"), np.array([wavelength_nm])
    in_front, _ = Front.named("air").at(at)
    assert glass.n_absolute(at) / in_front == pytest.approx(schott(wavelength_nm), rel=1e-12)
    behind, _ = Front.named("BK7").at(at)
    assert behind == glass.n_absolute(at)
    n, _ = constants_at(catalog.get("BK7"), at)
    assert n == glass.n_absolute(at)


def test_colors_are_made_from_the_absolute_index(catalog: Catalog) -> None:
    glass = catalog.spectrum("BK7")
    n = np.array([schott(at) for at in WAVELENGTH_NM])
    in_air = appearance(glass, Front.named("air").visible()[0])
    np.testing.assert_allclose(in_air.F0, linear_srgb(normal(n)), rtol=1e-12)
    in_vacuum = linear_srgb(normal(n * peck(WAVELENGTH_NM)))
    np.testing.assert_allclose(appearance(glass).F0, in_vacuum, rtol=0, atol=1e-8)


def test_an_end_that_is_held_is_held_absolute(catalog: Catalog) -> None:
    glass: Spectrum = catalog.spectrum("SF10")
    first = glass.n_absolute(glass.n_range_nm[0])
    assert glass.visible.n[0] == first


def test_the_abbe_number_is_that_of_the_data_sheet(catalog: Catalog) -> None:
    assert catalog.get("BK7").abbe == pytest.approx(64.17, abs=0.005)


def test_the_critical_angle_of_the_data_sheet() -> None:
    assert degrees(asin(1.0 / schott(587.5618))) == pytest.approx(41.2452, abs=5e-5)
