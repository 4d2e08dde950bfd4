"""Shortcuts for a coat: their formulas, and where they are exact."""

import numpy as np
import pytest

from app.optics.amplitudes import power
from app.optics.coats import (
    Base,
    coat_shortcuts,
    cubic,
    from_coat,
    quadratic,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface, normal_reflectance

GRAZING = Incidence.from_degrees(np.array([0.0, 30.0, 60.0, 85.0]))
NORMAL = Incidence.from_degrees(np.zeros(1))


@pytest.mark.parametrize("n", [1.33, 1.5, 1.8])
def test_a_real_index_seen_from_the_coat(n: float) -> None:
    """Of dielectrics the conversion is no shortcut."""
    bases = np.array([1.0, 1.4, 1.5, 2.0, 2.42, 40.0])
    in_air, below = (np.asarray(normal_reflectance(front, bases, 0.0)) for front in (1.0, n))
    np.testing.assert_allclose(from_coat(in_air, n)[1:], below[1:], atol=1e-14)


def test_the_fits_are_of_that_at_1_5() -> None:
    """How far each is from what it fits, where dielectrics and metals are."""
    F0 = np.linspace(0.02, 0.999, 2000)
    for fit, at_most in ((cubic, 0.006), (quadratic, 0.018)):
        off = np.abs(fit(F0, 1.5) - from_coat(F0, 1.5)).max()
        assert 0.5 * at_most < off < at_most, off


@pytest.mark.parametrize("n", [1.33, 1.6])
@pytest.mark.parametrize("F0", [0.1, 0.5, 0.95])
def test_openpbr_counts_all_that_goes_to_and_fro(n: float, F0: float) -> None:
    """At normal incidence on a gray base its series is whole; written out as one."""
    gray = np.full(3, F0)
    F = ((n - 1.0) / (n + 1.0)) ** 2
    series = F + sum((1.0 - F) ** 2 * F0 * (F * F0) ** m for m in range(60))
    found = coat_shortcuts()["openpbr_coat"].color(Base(gray, np.ones(3), n), NORMAL)
    np.testing.assert_allclose(found, [[series] * 3], rtol=1e-12)


def test_a_mirror_stays_one_but_where_the_coat_darkens_it_for_good() -> None:
    white = Base(np.ones(3), np.ones(3), 1.5)
    for shortcut in coat_shortcuts().values():
        found = shortcut.color(white, GRAZING)
        if shortcut.id == "babylon_openpbr_coat":
            # 0.04 + 0.96 (1 - 0.28)^2, of the mean of 0.04 and 0.52
            np.testing.assert_allclose(found[0], 0.537664, rtol=1e-12)
            continue
        assert found.shape == (4, 3)
        # The fits of F0 end a little off 1.
        np.testing.assert_allclose(found, 1.0, atol=0.005, err_msg=shortcut.id)


def test_nothing_below_is_the_coat_alone() -> None:
    black = Base(np.zeros(3), np.zeros(3), 1.5)
    coat = power(Interface(1.0, 1.5), GRAZING).R
    for name in ("cycles_coat", "openpbr_coat", "materialx_openpbr_coat"):
        F82_of_black = coat_shortcuts()[name].color(black, Incidence.from_degrees(np.array([0.0])))
        np.testing.assert_allclose(F82_of_black[0], coat[0], rtol=1e-12)
