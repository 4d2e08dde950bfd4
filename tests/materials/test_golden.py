"""Published and independently computed values: n, F0, F82, charts of engines, rivals."""

import numpy as np
import pytest

from app.materials.appearance import appearance
from app.materials.catalog import Catalog
from app.optics.color import linear_srgb
from app.optics.interface import Interface
from app.optics.knobs.dispersion import D_LINE_NM

TABLE = 2e-3
"""How far F0 and F82 may be from the table below, per channel."""
CHART = 1e-3
"""How far they may be from the charts that engines publish."""

# Linear sRGB under D65 of F0 and of F82 (cos = 1/7), from an independent integration of the pages.
METALS = {
    "Ag": "main/Ag/Johnson .989 .984 .978 .988 .986 .987 medium",
    "Al": "main/Al/Cheng .916 .923 .924 .869 .897 .919 high",
    "Au": "main/Au/Olmon-ev 1.043 .774 .335 .992 .886 .631 high",
    "Cu": "main/Cu/Johnson .932 .623 .522 .946 .755 .702 medium",
    "Fe": "main/Fe/Querry .575 .567 .563 .615 .631 .668 medium",
    "Ni": "main/Ni/Johnson .697 .640 .563 .682 .673 .666 medium",
    "Co": "main/Co/Johnson .683 .655 .616 .663 .668 .682 medium",
    "Cr": "main/Cr/Johnson .550 .556 .554 .561 .570 .619 low",
    "Ti": "main/Ti/Johnson .619 .579 .542 .611 .612 .619 low",
    "W": "main/W/Weaver .516 .496 .467 .532 .532 .531 medium",
    "Pt": "main/Pt/Rakic-BB .679 .640 .584 .655 .660 .663 medium",
    "Pd": "main/Pd/Johnson .733 .697 .652 .712 .713 .721 high",
    "Zn": "main/Zn/Werner-DFT .808 .844 .865 .684 .764 .831 low",
    "Pb": "main/Pb/Mathewson-298K .657 .661 .693 .633 .637 .679 medium",
    "Mo": "main/Mo/Kirillova .572 .585 .583 .559 .569 .596 medium",
    "V": "main/V/Johnson .519 .535 .567 .540 .526 .551 low",
    "Mg": "main/Mg/Palm .892 .882 .894 .845 .856 .895 low",
    "Ir": "main/Ir/Schmitt-MS .745 .732 .701 .652 .665 .676 high",
    "Rh": "main/Rh/Weaver .797 .765 .743 .720 .715 .721 medium",
    "Nb": "main/Nb/Weaver .500 .507 .501 .563 .565 .581 medium",
    "Be": "main/Be/Rakic-BB .539 .533 .534 .550 .553 .566 medium",
    "Hg": "main/Hg/Inagaki .781 .779 .778 .718 .751 .795 high",
    "brass": "other/Cu-Zn/Querry-Cu70Zn30 .910 .778 .423 .906 .862 .704 high",
    "stainless": "other/stainless_steel/Karlsson-austenitic .669 .639 .598 .648 .664 .682 high",
    "TiN": "main/TiN/Beliaev-sputtering .744 .428 .155 .823 .728 .556 medium",
    "Si": "main/Si/Schinke .344 .368 .425 .467 .464 .459 high",
    "Ge": "main/Ge/Nunley .500 .516 .464 .453 .483 .498 high",
    "GaAs": "main/GaAs/Papatryfonos .341 .362 .446 .468 .465 .467 high",
    "graphite": "main/C/Song-cHOPG-o .273 .265 .263 .518 .515 .513 medium",
}

# F0 that engines publish for the same pages.
CHARTS = {
    "Cr": (0.550, 0.556, 0.554),
    "Pd": (0.733, 0.697, 0.652),
    "brass": (0.910, 0.778, 0.423),
    "Hg": (0.781, 0.779, 0.778),
}

# n at the helium d line, 587.56 nm, to half a unit of the last digit.
TABLE_OF_N = (
    "fused-silica 1.4585, BK7 1.5168, SF10 1.7283, SF11 1.7847, water 1.3334, ice 1.3098, "
    "diamond 2.4175, sapphire-o 1.7682, sapphire-e 1.7601, PMMA 1.4906, polycarbonate 1.5848, "
    "cubic-zirconia 2.1588, moissanite-o 2.648, moissanite-e 2.690, NaCl 1.5442, CaF2 1.4338, "
    "MgF2-o 1.3777, MgF2-e 1.3896, rutile-o 2.614, rutile-e 2.910, quartz-o 1.5443, "
    "quartz-e 1.5534, ethanol 1.3608, glycerol 1.4713, air 1.00027717, CO2 1.000449, "
    "He 1.0000349, H2 1.0001388"
)
INDICES = {name: float(n) for name, n in map(str.split, TABLE_OF_N.split(", "))}

# Luminance of F0 over the measurements of one material.
SPREADS = {
    "Ti": (0.406, 0.585),
    "Cr": (0.555, 0.679),
    "V": (0.414, 0.534),
    "Ag": (0.930, 0.992),
    "Au": (0.682, 0.809),
    "Cu": (0.675, 0.755),
    "Fe": (0.515, 0.568),
}


def _half_a_digit(value: float) -> float:
    return 0.5 * float(10 ** -len(str(value).split(".")[1])) * 1.01


@pytest.mark.parametrize("id", METALS)
def test_metals_match_the_table(catalog: Catalog, id: str) -> None:  # noqa: A002
    page, *values, confidence = METALS[id].split()
    F0, F82 = np.array(values, dtype=float).reshape(2, 3)
    preset, spectrum = catalog.get(id), catalog.spectrum(id)
    assert spectrum.file.provenance.page == page
    assert preset.confidence == confidence
    look = appearance(spectrum)
    np.testing.assert_allclose(look.F0, F0, rtol=0, atol=TABLE)
    np.testing.assert_allclose(look.F82, F82, rtol=0, atol=TABLE)


@pytest.mark.parametrize("id", CHARTS)
def test_charts_of_engines_are_reproduced(catalog: Catalog, id: str) -> None:  # noqa: A002
    look = appearance(catalog.spectrum(id))
    np.testing.assert_allclose(look.F0, CHARTS[id], rtol=0, atol=CHART)


def test_gold_of_babar(catalog: Catalog) -> None:
    look = appearance(catalog.spectrum("Au-Babar"))
    np.testing.assert_allclose(look.F0, [1.0588, 0.7733, 0.3073], rtol=0, atol=1e-4)
    np.testing.assert_allclose(look.F82_tint, [0.9713, 1.018, 0.9936], rtol=0, atol=1e-4)


@pytest.mark.parametrize("id", INDICES)
def test_indices(catalog: Catalog, id: str) -> None:  # noqa: A002
    constants = catalog.constants(id, D_LINE_NM)
    assert constants.n == pytest.approx(INDICES[id], abs=_half_a_digit(INDICES[id]))


def test_abbe_number_of_bk7(catalog: Catalog) -> None:
    # Schott's data sheet: 64.17.
    assert catalog.spectrum("BK7").abbe_number == pytest.approx(64.17, abs=0.005)


@pytest.mark.parametrize("id", SPREADS)
def test_rivals_spread(catalog: Catalog, id: str) -> None:  # noqa: A002
    spread = catalog.spread(id)
    assert (spread.minimum, spread.maximum) == pytest.approx(SPREADS[id], abs=1e-3)


def test_copper_reddens_as_in_the_figure_of_shirley(catalog: Catalog) -> None:
    # Bottom to top at normal incidence: 400, 500, 600, 700, 800 nm, from half to nearly all.
    spectrum = catalog.spectrum("Cu")
    wavelengths = [400.0, 500.0, 600.0, 700.0, 800.0]
    F0 = Interface(n_t=spectrum.n(wavelengths), k_t=spectrum.k(wavelengths)).F0  # type: ignore[arg-type]
    assert np.all(np.diff(F0) > 0.0)
    assert F0[0] == pytest.approx(0.5, abs=0.05)
    assert F0[-1] > 0.95


def test_illuminant_e_unadapted_gives_the_wrong_gold(catalog: Catalog) -> None:
    # A trap: reflectances integrated under E and taken for sRGB without adaptation.
    seen = catalog.spectrum("Au").visible
    spectrum = Interface(n_t=seen.n, k_t=seen.k).F0
    right = linear_srgb(spectrum)
    assert linear_srgb(spectrum, "E", adaptation="none")[0] - right[0] > 0.15
    np.testing.assert_allclose(linear_srgb(spectrum, "E"), right, rtol=0, atol=0.03)


def test_sources_that_differ_both_stay(catalog: Catalog) -> None:
    assert catalog.get("fused-silica-shirley").n == 1.46
    assert catalog.get("quartz-wloka").n == 1.54
    assert catalog.get("water-shirley").n == 1.333
    assert catalog.get("water-wloka").n == 1.333333
    garnet, zirconia = catalog.get("garnet-wloka"), catalog.get("cubic-zirconia-wloka")
    assert (garnet.n_min, garnet.n_max) == (1.73, 1.89)
    assert (zirconia.n_min, zirconia.n_max) == (2.14, 2.20)
