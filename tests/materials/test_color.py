"""From spectra to linear sRGB."""

import subprocess
import sys
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.optics.color import (
    ADAPTATIONS,
    ILLUMINANTS,
    OBSERVERS,
    WAVELENGTH_NM,
    acescg_from_srgb,
    apply_gamut,
    bradford,
    color_matching,
    decode_srgb,
    encode_srgb,
    illuminant_power,
    linear_srgb,
    luminance,
    srgb_from_xyz,
    srgb_hex,
    white,
    xyz,
)
from app.optics.errors import NotAllowed, OutOfRange, UnknownName

ROUNDING = 1e-12
ONES = np.ones(WAVELENGTH_NM.size)

# IEC 61966-2-1:1999, section 5.2: the standard's matrix, to its four digits.
# OpenColorIO's ACES configurations, linear Rec.709 to ACEScg by Bradford, to four digits.
OCIO_ACESCG_FROM_SRGB = [
    [0.6131, 0.3395, 0.0474],
    [0.0702, 0.9164, 0.0135],
    [0.0206, 0.1096, 0.8698],
]

IEC_SRGB_FROM_XYZ = [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.204, 1.057]]


@pytest.mark.parametrize(("illuminant", "observer"), list(product(ILLUMINANTS, OBSERVERS)))
def test_perfect_reflector_is_white(illuminant: str, observer: str) -> None:
    rgb = linear_srgb(ONES, illuminant, observer)  # type: ignore[arg-type]
    np.testing.assert_allclose(rgb, 1.0, rtol=0, atol=ROUNDING)
    assert luminance(ONES, illuminant, observer) == pytest.approx(1.0, abs=ROUNDING)  # type: ignore[arg-type]


def test_acescg_is_the_published_one() -> None:
    # Theirs starts from the four digits of D65's chromaticity, ours from the tables.
    np.testing.assert_allclose(acescg_from_srgb(), OCIO_ACESCG_FROM_SRGB, rtol=0, atol=1.5e-4)
    np.testing.assert_allclose(acescg_from_srgb().sum(axis=1), 1.0, rtol=0, atol=ROUNDING)


def test_illuminant_e_without_adaptation_is_a_fifth_off() -> None:
    assert linear_srgb(ONES, "E", adaptation="none")[0] - 1.0 == pytest.approx(0.205, abs=1e-3)


def test_illuminants_barely_differ_for_a_grey_surface_once_adapted() -> None:
    np.testing.assert_allclose(linear_srgb(0.5 * ONES, "E"), 0.5, rtol=0, atol=ROUNDING)


def test_whites_are_those_of_the_cie() -> None:
    # CIE 015:2018: XYZ of D65 for both observers. E is white by definition of the functions, whose
    # published values keep that to 3e-4.
    np.testing.assert_allclose(white("D65"), [0.95047, 1.0, 1.08883], rtol=0, atol=2e-5)
    np.testing.assert_allclose(
        white("D65", "cie1964_10deg"), [0.94811, 1.0, 1.07304], rtol=0, atol=2e-5
    )
    np.testing.assert_allclose(white("E"), 1.0, rtol=0, atol=4e-4)


def test_tabulated_values_of_the_cie() -> None:
    # CIE 015:2018: y(555 nm) = 1 (2 degrees), D65(560 nm) = 100, D65(780 nm) = 63.3828.
    assert color_matching()[555 - 360, 1] == 1.0
    assert illuminant_power()[560 - 360] == 100.0
    assert illuminant_power()[780 - 360] == 63.3828
    assert illuminant_power("E").min() == illuminant_power("E").max()


def test_matrix_is_that_of_the_standard_to_its_digits() -> None:
    np.testing.assert_allclose(srgb_from_xyz(), IEC_SRGB_FROM_XYZ, rtol=0, atol=5e-4)


def test_bradford_from_e_to_d65() -> None:
    # Computed by colour-science 0.4.7, matrix_chromatic_adaptation_VonKries, transform "Bradford".
    expected = [
        [0.9531874, -0.0265906, 0.0238731],
        [-0.0382467, 1.0288406, 0.0094060],
        [0.0026068, -0.0030332, 1.0892565],
    ]
    adapt = bradford([1.0, 1.0, 1.0], [0.95047, 1.0, 1.08883])
    np.testing.assert_allclose(adapt, expected, rtol=0, atol=1e-7)


def test_leading_axes_are_kept() -> None:
    values = np.broadcast_to(ONES, (2, 3, ONES.size))
    assert xyz(values).shape == linear_srgb(values).shape == (2, 3, 3)
    assert luminance(values).shape == (2, 3)


@pytest.mark.parametrize("shape", [(), (470,), (471, 2)])
def test_other_shapes_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(NotAllowed, match="471"):
        linear_srgb(np.ones(shape))


def test_unknown_names_are_refused() -> None:
    with pytest.raises(UnknownName, match="illuminant"):
        linear_srgb(ONES, "D50")  # type: ignore[arg-type]
    with pytest.raises(UnknownName, match="observer"):
        linear_srgb(ONES, observer="mine")  # type: ignore[arg-type]
    with pytest.raises(UnknownName, match="adaptation"):
        linear_srgb(ONES, adaptation="cat02")  # type: ignore[arg-type]
    with pytest.raises(UnknownName, match="gamut"):
        apply_gamut([1.0, 1.0, 1.0], "clip")  # type: ignore[arg-type]


def test_adaptations_are_the_declared_ones() -> None:
    assert ADAPTATIONS == ("bradford", "none")


def test_gold_in_three_versions_is_one_spectrum() -> None:
    # The three values of gold that circulate: one integral, three gamut policies.
    raw = [1.022, 0.782, 0.344]
    np.testing.assert_allclose(apply_gamut(raw, "unclamped"), raw, rtol=0, atol=0)
    np.testing.assert_allclose(apply_gamut(raw, "clamped"), [1.0, 0.782, 0.344], rtol=0, atol=0)
    # 1e-3: the published values were scaled before they were rounded.
    np.testing.assert_allclose(apply_gamut(raw, "scaled"), [1.0, 0.766, 0.336], rtol=0, atol=1e-3)


def test_scaling_leaves_what_fits_and_cuts_what_is_negative() -> None:
    np.testing.assert_array_equal(apply_gamut([0.3, 0.2, 0.1], "scaled"), [0.3, 0.2, 0.1])
    np.testing.assert_array_equal(apply_gamut([2.0, 1.0, -0.1], "scaled"), [1.0, 0.5, 0.0])


@settings(deadline=None)
@given(
    st.lists(st.floats(-2.0, 2.0), min_size=3, max_size=3), st.sampled_from(["clamped", "scaled"])
)
def test_policies_reach_the_gamut(rgb: list[float], policy: str) -> None:
    fitted = apply_gamut(rgb, policy)  # type: ignore[arg-type]
    assert fitted.min() >= 0.0
    assert fitted.max() <= 1.0


def test_transfer_function() -> None:
    # IEC 61966-2-1: foot of slope 12.92 to 0.0031308, which is 0.04045 in sRGB.
    assert encode_srgb(0.0031308) == pytest.approx(0.04045, abs=1e-5)
    assert encode_srgb([0.0, 0.5, 1.0]) == pytest.approx([0.0, 0.7353570, 1.0], abs=1e-7)
    assert encode_srgb(-0.001) == pytest.approx(-0.01292)


@settings(deadline=None)
@given(st.floats(-0.5, 2.0))
def test_decoding_inverts_encoding(linear: float) -> None:
    # Around the joint the standard's rounded constants leave a step of 3e-8.
    assert decode_srgb(encode_srgb(linear)) == pytest.approx(linear, abs=1e-7)


def test_hex() -> None:
    assert srgb_hex([1.0, 0.0, 0.0]) == "#ff0000"
    assert srgb_hex(linear_srgb(ONES)) == "#ffffff"
    assert srgb_hex(decode_srgb([128 / 255] * 3)) == "#808080"
    with pytest.raises(OutOfRange, match="apply_gamut"):
        srgb_hex([1.043, 0.774, 0.335])


def test_needs_nothing_of_the_materials() -> None:
    code = "import sys, app.optics.color; print({'pydantic', 'fastapi', 'yaml'} & set(sys.modules))"
    answer = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert answer.stdout.strip() == "set()"
