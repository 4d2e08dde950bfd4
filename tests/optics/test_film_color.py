"""Colors of films: the fast way against the plain one; CIELAB and CIEDE2000 against published data."""

from collections.abc import Callable

import numpy as np
import pytest

from app.optics.color import WAVELENGTH_NM, delta_e_2000, lab, linear_srgb, srgb_weights
from app.optics.film_color import is_resolved, sampled_nm, step_nm, swept_colors
from app.optics.films import power
from app.optics.incidence import Incidence
from app.optics.parameters import Array
from app.optics.stack import Layer, Stack

WEIGHTS = srgb_weights()
INCIDENCE = Incidence.from_degrees([0.0, 30.0, 60.0, 85.0, 90.0])

Make = Callable[[Array, float], Stack]

# G. Sharma, W. Wu and E. N. Dalal, The CIEDE2000 color-difference formula (2005), table 1.
PUBLISHED = [
    (50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425),
    (50, 3.1571, -77.2803, 50, 0, -82.7485, 2.8615),
    (50, 2.8361, -74.0200, 50, 0, -82.7485, 3.4412),
    (50, -1.3802, -84.2814, 50, 0, -82.7485, 1.0),
    (50, 0, 0, 50, -1, 2, 2.3669),
    (50, 2.49, -0.001, 50, -2.49, 0.0009, 7.1792),
    (50, 2.49, -0.001, 50, -2.49, 0.0011, 7.2195),
    (50, -0.001, 2.49, 50, 0.0009, -2.49, 4.8045),
    (50, -0.001, 2.49, 50, 0.0011, -2.49, 4.7461),
    (50, 2.5, 0, 50, 0, -2.5, 4.3065),
    (50, 2.5, 0, 73, 25, -18, 27.1492),
    (50, 2.5, 0, 61, -5, 29, 22.8977),
    (50, 2.5, 0, 56, -27, -3, 31.9030),
    (50, 2.5, 0, 58, 24, 15, 19.4535),
    (60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644),
    (63.0109, -31.0961, -5.8663, 62.8187, -29.7946, -4.0864, 1.2630),
    (22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373),
    (90.8027, -2.0831, 1.4410, 91.1528, -1.6435, 0.0447, 1.4441),
    (6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377),
    (2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514, 0.9082),
]


def soap(at: Array, thickness_nm: float = 0.0) -> Stack:
    return Stack(1.0, [Layer(1.33 + 3000.0 / at**2, 0.0, thickness_nm)], 1.0, wavelength_nm=at)


def oxide(at: Array, thickness_nm: float = 0.0) -> Stack:
    layers = [
        Layer(1.46, 0.0, 50.0),
        Layer(2.4 + 20000.0 / at**2, 0.0, thickness_nm),
        Layer(0.2, 3.0, 12.0),
    ]
    return Stack(1.0, layers, 2.0 + at / 1000.0, 2.5, wavelength_nm=at)


def gold_leaf(at: Array, thickness_nm: float = 0.0) -> Stack:
    layers = [Layer(1.5, 0.0, 80.0), Layer(0.3 + 100.0 / at, at / 200.0, thickness_nm)]
    return Stack(1.0, layers, 1.5, wavelength_nm=at)


def gap(at: Array, thickness_nm: float = 0.0) -> Stack:
    return Stack(1.5, [Layer(1.0, 0.0, thickness_nm)], 1.5, wavelength_nm=at)


def pane(at: Array, thickness_nm: float = 0.0) -> Stack:
    layers = [Layer(1.38, 0.0, thickness_nm), Layer(1.52, 0.0, 3e6, incoherent=True)]
    return Stack(1.0, layers, 1.0, wavelength_nm=at)


STACKS: list[tuple[Make, int]] = [(soap, 0), (oxide, 1), (gold_leaf, 1), (gap, 0), (pane, 0)]


@pytest.mark.parametrize(("make", "place"), STACKS)
def test_a_sweep_gives_the_colors_of_each_stack(make: Make, place: int) -> None:
    thickness_nm = np.array([0.0, 1.0, 47.3, 300.0, 777.0])
    colors = swept_colors(make(WAVELENGTH_NM, 0.0), place, thickness_nm, INCIDENCE, WEIGHTS)
    for row, thickness in zip(colors, thickness_nm.tolist(), strict=True):
        for i, color in enumerate(row):
            one = Incidence.from_degrees(INCIDENCE.theta_i_deg[i])
            plain = linear_srgb(power(make(WAVELENGTH_NM, thickness), one).R)
            np.testing.assert_allclose(color, plain, atol=1e-7 if make is gap else 1e-12)


@pytest.mark.parametrize(("make", "place", "index"), [(soap, 0, 1.35), (oxide, 1, 2.5)])
def test_fewer_wavelengths_change_no_color_that_one_sees(
    make: Make, place: int, index: float
) -> None:
    for thickest in (300.0, 1000.0, 3000.0):
        step = step_nm(index * thickest)
        thickness_nm = np.linspace(0.0, thickest, 60)
        whole, fewer = (
            swept_colors(make(sampled_nm(s), 0.0), place, thickness_nm, INCIDENCE, WEIGHTS, s)
            for s in (1, step)
        )
        assert np.max(delta_e_2000(lab(whole), lab(fewer))) < 0.1
    assert step_nm(100.0) == 5
    assert step_nm(1e5) == 1
    assert is_resolved(1e4)
    assert not is_resolved(1e5)


def test_black_films_are_black_and_white_is_white() -> None:
    black = swept_colors(soap(WAVELENGTH_NM), 0, np.array([0.0]), INCIDENCE, WEIGHTS)
    np.testing.assert_allclose(black, 0.0, atol=1e-14)
    np.testing.assert_allclose(lab([1.0, 1.0, 1.0]), [100.0, 0.0, 0.0], atol=1e-10)
    np.testing.assert_allclose(lab([0.0, 0.0, 0.0]), 0.0, atol=1e-12)


def test_lab_of_the_primaries() -> None:
    """B. Lindbloom's values of sRGB under D65, to the digits that the tables of D65 leave."""
    np.testing.assert_allclose(lab([1.0, 0.0, 0.0]), [53.24, 80.09, 67.20], atol=0.05)
    np.testing.assert_allclose(lab([0.0, 0.0, 1.0]), [32.30, 79.19, -107.86], atol=0.05)


def test_ciede2000_of_the_published_pairs() -> None:
    table = np.array(PUBLISHED)
    for first, second in ((table[:, :3], table[:, 3:6]), (table[:, 3:6], table[:, :3])):
        np.testing.assert_allclose(delta_e_2000(first, second), table[:, 6], atol=5e-5)
