"""How deep light enters: evanescent waves, absorbers, and what travels on."""

from math import isclose

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp, mpc, mpf

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.snell import penetration_depth_wavelengths, refraction_angle_deg

indices = st.floats(0.5, 4.0)


@given(indices, st.floats(0.05, 0.95), st.floats(0.05, 0.95))
def test_depth_of_the_evanescent_wave(n_i: float, eta: float, share: float) -> None:
    """1 / (4 pi sqrt(n_i^2 sin^2 theta_i - n_t^2)) wavelengths beyond the critical angle."""
    critical = np.degrees(np.arcsin(eta))
    theta_i_deg = float(critical + share * (90.0 - critical))
    n_t = eta * n_i
    depth = float(
        penetration_depth_wavelengths(Interface(n_i, n_t), Incidence.from_degrees(theta_i_deg))
    )
    with mp.workdps(30):
        tangential = mpf(n_i) * mp.sin(mp.radians(mpf(theta_i_deg)))
        expected = float(1 / (4 * mp.pi * mp.sqrt(tangential**2 - mpf(n_t) ** 2)))
    assert isclose(depth, expected, rel_tol=1e-12)


@given(indices, indices, st.floats(1e-6, 20.0), st.floats(0.0, 90.0))
def test_depth_in_an_absorber(n_i: float, n_t: float, k_t: float, theta_i_deg: float) -> None:
    interface, incidence = Interface(n_i, n_t, k_t), Incidence.from_degrees(theta_i_deg)
    depth = float(penetration_depth_wavelengths(interface, incidence))
    with mp.workdps(30):
        tangential = mpf(n_i) * mp.sin(mp.radians(mpf(theta_i_deg)))
        normal = mp.sqrt(mpc(n_t, k_t) ** 2 - tangential**2)
        expected = float(1 / (4 * mp.pi * normal.imag))
    assert isclose(depth, expected, rel_tol=1e-12)


def test_depth_at_normal_incidence_is_that_of_beers_law() -> None:
    """1/e of the power after 1 / alpha, alpha = 4 pi k / wavelength, whatever n."""
    depth = penetration_depth_wavelengths(
        Interface(1.0, [0.3, 1.5, 4.0], 2.0), Incidence.from_degrees(0.0)
    )
    assert depth == pytest.approx(1.0 / (8.0 * np.pi), rel=1e-13)


def test_what_travels_on_undamped_has_no_depth() -> None:
    theta = Incidence.from_degrees([0.0, 45.0, 90.0])
    assert np.isnan(penetration_depth_wavelengths(Interface(1.0, 1.5), theta)).all()
    assert np.isnan(refraction_angle_deg(Interface(1.5, 1.0), theta)).tolist() == [0, 1, 1]
