"""A pane, by the sum over its reflections, and modifiers against pvlib."""

import numpy as np
import pytest
from pvlib import iam

from app.optics.amplitudes import power as boundary_power
from app.optics.errors import OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.pane import MODIFIERS, KnownModifier, Pane

ANGLES = np.linspace(0.0, 89.5, 180)
INCIDENCE = Incidence.from_degrees(ANGLES)
KNOWN = {each.id: each.function for each in MODIFIERS}
GIVEN = {"b": 0.05, "a_r": 0.16, "n": 1.526, "absorption_per_m": 4.0, "thickness_mm": 2.0}


def test_a_pane_is_the_sum_over_its_reflections() -> None:
    """Stokes' geometric series, with a and r of each passage and face written out."""
    pane = Pane(1.526, 3.0, 20.0)
    energy, lost = pane.parts(INCIDENCE)
    face = boundary_power(Interface(1.0, 1.526), INCIDENCE)
    cos_t = np.sqrt(1.0 - (INCIDENCE.sin / 1.526) ** 2)
    a = np.exp(-20.0 * 3e-3 / cos_t)
    for r, R, T, A in (
        (face.Rs, energy.Rs, energy.Ts, lost.As),
        (face.Rp, energy.Rp, energy.Tp, lost.Ap),
    ):
        trips = np.array([(r * a) ** (2 * m) for m in range(400)]).sum(axis=0)
        np.testing.assert_allclose(T, (1.0 - r) ** 2 * a * trips, rtol=1e-8)
        np.testing.assert_allclose(R, r + (1.0 - r) ** 2 * a**2 * r * trips, rtol=1e-8, atol=1e-12)
        np.testing.assert_allclose(R + T + A, 1.0, atol=1e-12)


def test_the_modifiers_are_those_of_pvlib() -> None:
    np.testing.assert_allclose(KNOWN["ashrae"](INCIDENCE, GIVEN), iam.ashrae(ANGLES), atol=1e-12)
    np.testing.assert_allclose(
        KNOWN["martin_ruiz"](INCIDENCE, GIVEN), iam.martin_ruiz(ANGLES), atol=1e-12
    )
    np.testing.assert_allclose(KNOWN["physical"](INCIDENCE, GIVEN), iam.physical(ANGLES), atol=1e-9)
    np.testing.assert_allclose(KNOWN["schlick"](INCIDENCE, GIVEN), iam.schlick(ANGLES), atol=1e-12)


@pytest.mark.parametrize("each", MODIFIERS, ids=lambda each: each.id)
def test_modifiers_fall_from_1_to_0(each: KnownModifier) -> None:
    ends = Incidence.from_degrees([0.0, 90.0])
    values = KNOWN[each.id](ends, GIVEN)
    np.testing.assert_allclose(values, [1.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(Pane().modifier(ends), [1.0, 0.0], atol=1e-12)


def test_on_a_cell_the_physical_modifier_is_exact() -> None:
    """Where nothing is reflected behind, one face and one passage are all there is."""
    pane = Pane(n_behind=1.526)
    np.testing.assert_allclose(
        pane.modifier(INCIDENCE), KNOWN["physical"](INCIDENCE, GIVEN), rtol=1e-8
    )


def test_what_is_no_pane_is_refused() -> None:
    with pytest.raises(OutOfRange, match="absorption_per_m = -1"):
        Pane(absorption_per_m=-1.0)


@pytest.mark.filterwarnings("error")
def test_the_ends_of_the_parameters_are_no_faults() -> None:
    ends = Incidence.from_degrees([0.0, 89.0, 90.0])
    for given in (GIVEN | {"b": 0.0}, GIVEN | {"n": 1.0}, GIVEN | {"absorption_per_m": 0.0}):
        for each in MODIFIERS:
            values = each.function(ends, given)
            assert np.isfinite(values).all()
            assert values[0] == pytest.approx(1.0)
    assert np.isfinite(Pane(1.0, 0.0, 0.0).modifier(ends)).all()
