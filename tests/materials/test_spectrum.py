"""n and k of single materials: native points, formulas, ranges, what is not known."""

import json
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from app.materials.catalog import Catalog
from app.materials.dispersion import refractive_index
from app.materials.errors import WavelengthOutOfRange
from app.materials.location import data_directory
from app.materials.schema import Formula, SpectrumFile
from app.materials.spectrum import Spectrum
from app.optics.color import WAVELENGTH_NM
from app.optics.errors import NotAllowed


def _made(n: dict[str, Any], k: dict[str, Any] | None) -> Spectrum:
    """A spectrum of these quantities, dressed as copper."""
    fields = json.loads((data_directory() / "spectra" / "Cu.json").read_text(encoding="utf-8"))
    return Spectrum(SpectrumFile.model_validate_json(json.dumps({**fields, "n": n, "k": k})))


POINTS = {"kind": "points", "wavelength_nm": [400.0, 500.0, 700.0], "values": [2.0, 1.0, 3.0]}
SHORTER = {"kind": "points", "wavelength_nm": [450.0, 650.0], "values": [0.0, 4.0]}


def test_native_points_come_back_and_between_them_lies_a_line() -> None:
    spectrum = _made(POINTS, SHORTER)
    np.testing.assert_array_equal(spectrum.n([400.0, 500.0, 700.0]), [2.0, 1.0, 3.0])
    assert spectrum.n(450.0) == 1.5
    assert spectrum.n(600.0) == 2.0
    assert spectrum.k(550.0) == 2.0


def test_n_and_k_keep_their_own_ranges() -> None:
    spectrum = _made(POINTS, SHORTER)
    assert spectrum.n_range_nm == (400.0, 700.0)
    assert spectrum.k_range_nm == (450.0, 650.0)
    assert spectrum.range_nm == (450.0, 650.0)
    assert spectrum.n(420.0) == 1.8
    with pytest.raises(WavelengthOutOfRange) as caught:
        spectrum.k(420.0)
    error = caught.value
    assert (error.parameter, error.material, error.quantity) == ("wavelength_nm", "Cu", "k")
    assert (error.minimum, error.maximum) == (450.0, 650.0)
    assert str(error) == (
        "wavelength_nm = 420.0 is not allowed: 450 to 650 nm, where k of Cu is known"
    )


@pytest.mark.parametrize("wavelength", [399.999, 700.001, -1.0, 0.0, np.nan, np.inf])
def test_nothing_is_extrapolated(wavelength: float) -> None:
    with pytest.raises(WavelengthOutOfRange):
        _made(POINTS, None).n([500.0, wavelength])


def test_unknown_k_is_not_zero() -> None:
    spectrum = _made(POINTS, None)
    assert spectrum.k(500.0) is None
    assert spectrum.k_range_nm is None
    assert spectrum.range_nm == spectrum.n_range_nm
    assert "k is not known and counts as 0" in spectrum.visible.warnings


def test_color_alone_holds_the_ends_and_says_so() -> None:
    seen = _made(POINTS, SHORTER).visible
    assert seen.n[WAVELENGTH_NM < 400].tolist() == [2.0] * 40
    assert seen.k[-1] == 4.0
    assert len(seen.warnings) == 4
    assert seen.warnings[0] == "n not known below 400 nm: the color holds the value there"
    assert _made(POINTS, POINTS).visible.warnings == (
        "n and k not known below 400 nm: the color holds the value there",
        "n and k not known above 700 nm: the color holds the value there",
    )


@settings(deadline=None)
@given(st.lists(st.floats(400.0, 700.0), max_size=8))
def test_shapes_are_kept_and_values_stay_within_the_points(wavelengths: list[float]) -> None:
    n = _made(POINTS, None).n(wavelengths)
    assert n.shape == (len(wavelengths),)
    assert np.all((n >= 1.0) & (n <= 3.0))


def test_scalars_and_grids() -> None:
    spectrum = _made(POINTS, SHORTER)
    assert spectrum.n(500.0).shape == ()
    assert spectrum.n(np.full((2, 3), 500.0)).shape == (2, 3)


def test_abbe_number_needs_a_formula_over_all_three_lines(catalog: Catalog) -> None:
    assert _made(POINTS, None).abbe_number is None
    assert catalog.spectrum("diamond").abbe_number == pytest.approx(55.3, abs=0.05)
    formula = {"kind": "formula", "number": 5, "coefficients": [1.5], "range_nm": [400.0, 600.0]}
    assert _made(formula, None).abbe_number is None
    formula["range_nm"] = [400.0, 700.0]
    assert _made(formula, None).abbe_number is None  # no dispersion at all


# One example a formula, worked out by hand at 1 um or, where that is a pole of none, at 2 um.
BY_HAND = [
    (1, [0.0, 3.0, 0.5], 1.0, np.sqrt(1.0 + 3.0 / 0.75)),
    (2, [0.0, 3.0, 0.25], 1.0, np.sqrt(1.0 + 3.0 / 0.75)),
    (3, [2.0, 1.0, 2.0, 8.0, -3.0], 2.0, np.sqrt(2.0 + 4.0 + 1.0)),
    (4, [2.0, 1.0, 0.0, 1.0, 2.0, 2.0, 0.0, 1.0, 2.0, 5.0, 1.0], 2.0, np.sqrt(13.0)),
    (5, [1.5, 0.04, -2.0], 2.0, 1.51),
    (6, [0.0, 0.5, 1.25], 2.0, 1.5),
    (7, [1.5, 0.972, 0.0, 0.1], 1.0, 2.6),
    (8, [0.1, 0.1, 0.0, 0.05], 1.0, np.sqrt(1.5 / 0.75)),
    (9, [2.0, 1.0, 0.5, 1.0, 0.5, 0.25], 1.0, np.sqrt(2.0 + 2.0 + 1.0)),
]


@pytest.mark.parametrize(("number", "coefficients", "wavelength", "expected"), BY_HAND)
def test_formulas_by_hand(
    number: int, coefficients: list[float], wavelength: float, expected: float
) -> None:
    n = refractive_index(number, coefficients, np.array([wavelength]))
    assert n == pytest.approx(expected, rel=1e-14)


TOO_FEW = [(number, count) for number in (1, 2, 3, 5, 6) for count in (0, 2, 4, 16)]
TOO_FEW += [(4, count) for count in (0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12)]
TOO_FEW += [(7, 2), (7, 7), (8, 3), (8, 5), (9, 5), (9, 7)]


@pytest.mark.parametrize(("number", "count"), TOO_FEW)
def test_a_term_without_all_its_coefficients_is_refused(number: int, count: int) -> None:
    with pytest.raises(NotAllowed, match=f"these are {count}"):
        refractive_index(number, [1.0] * count, np.array([1.0]))
    with pytest.raises(ValidationError, match="coefficients"):
        Formula(kind="formula", number=number, coefficients=(1.0,) * count, range_nm=(1.0, 2.0))


def test_the_last_coefficient_of_a_glass_counts(catalog: Catalog) -> None:
    formula, at = catalog.spectrum("BK7").file.n, np.array([0.5876])
    assert isinstance(formula, Formula)
    n = refractive_index(formula.number, formula.coefficients, at)
    assert n == pytest.approx(1.51680, abs=5e-6)
    with pytest.raises(NotAllowed, match="odd number"):
        refractive_index(formula.number, formula.coefficients[:-1], at)


def test_there_is_no_tenth_formula() -> None:
    with pytest.raises(NotAllowed, match="1 to 9"):
        refractive_index(10, [1.0], np.array([1.0]))
