"""The angle of incidence keeps its digits from 0 to 90 degrees, whatever it is made from."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpf

from app.optics.errors import OutOfRange
from app.optics.incidence import Incidence

# Three roundings: to radians, of the function, of the number.
RELATIVE = 4.5e-16

angles = st.just(0.0) | st.floats(1e-290, 90.0)  # radians of less are no normal doubles


@given(angles | st.floats(90.0 - 1e-9, 90.0) | st.floats(1e-290, 1e-9))
def test_cosine_and_sine_are_right_to_the_last_digits(theta_i_deg: float) -> None:
    incidence = Incidence.from_degrees(theta_i_deg)
    with mp.workdps(40):
        # A double near 90 times pi / 180 needs all 40 digits for its cosine.
        cos = mp.sin(mp.radians(90 - mpf(theta_i_deg)))
        sin = mp.sin(mp.radians(mpf(theta_i_deg)))
        assert abs(mpf(float(incidence.cos)) - cos) <= RELATIVE * cos
        assert abs(mpf(float(incidence.sin)) - sin) <= RELATIVE * sin


@pytest.mark.parametrize(
    ("incidence", "cos", "sin"),
    [
        (Incidence.from_degrees(0.0), 1.0, 0.0),
        (Incidence.from_degrees(90.0), 0.0, 1.0),
        (Incidence.from_radians(0.0), 1.0, 0.0),
        (Incidence.from_radians(np.pi / 2), 0.0, 1.0),
        (Incidence.from_cosine(1.0), 1.0, 0.0),
        (Incidence.from_cosine(0.0), 0.0, 1.0),
    ],
)
def test_both_ends_are_exact(incidence: Incidence, cos: float, sin: float) -> None:
    assert (float(incidence.cos), float(incidence.sin)) == (cos, sin)


@given(angles)
def test_the_degrees_given_come_back(theta_i_deg: float) -> None:
    incidence = Incidence.from_degrees(theta_i_deg)
    assert float(incidence.theta_i_deg) == theta_i_deg
    assert float(incidence.theta_i) == pytest.approx(np.radians(theta_i_deg), abs=1e-15)


@given(st.floats(0.0, 1.0))
def test_cosines_come_back(mu: float) -> None:
    incidence = Incidence.from_cosine(mu)
    assert float(incidence.cos) == mu
    assert float(incidence.sin**2 + incidence.cos**2) == pytest.approx(1.0, abs=1e-15)
    assert np.cos(float(incidence.theta_i)) == pytest.approx(mu, abs=1e-15)


@given(st.floats(0.0, np.pi / 2))
def test_radians_come_back(theta_i: float) -> None:
    incidence = Incidence.from_radians(theta_i)
    assert float(incidence.theta_i) == pytest.approx(theta_i, abs=1e-15)
    assert float(incidence.theta_i_deg) == pytest.approx(np.degrees(theta_i), abs=1e-13)


@pytest.mark.parametrize("shape", [(), (0,), (5,), (2, 1, 3)])
def test_shapes_are_kept(shape: tuple[int, ...]) -> None:
    for incidence in (
        Incidence.from_degrees(np.full(shape, 30.0)),
        Incidence.from_radians(np.full(shape, 0.5)),
        Incidence.from_cosine(np.full(shape, 0.5)),
    ):
        assert incidence.cos.shape == incidence.sin.shape == shape
        assert incidence.theta_i.shape == incidence.theta_i_deg.shape == shape


@pytest.mark.parametrize("value", [-1e-9, 90.0 + 1e-9, np.nan, np.inf, -np.inf])
def test_angles_out_of_range_are_refused(value: float) -> None:
    with pytest.raises(OutOfRange, match="theta_i_deg"):
        Incidence.from_degrees(value)
    with pytest.raises(OutOfRange, match="theta_i"):
        Incidence.from_radians(np.radians(value))
    with pytest.raises(OutOfRange, match="mu"):
        Incidence.from_cosine(1.0 + abs(value))
