"""The arctangent that Brewster's and the critical angle are taken from, beside 50 digits."""

import numpy as np
import pytest
from mpmath import atan, degrees, mp, mpf

from app.optics.amplitudes import power
from app.optics.angles import brewster_deg
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.double_double import arctan_deg

RELATIVE = 1e-31

# The quotients whose angles lie half way between two whole degrees need the whole series.
QUOTIENTS = [1e-5, 1e-3, 0.00873, 0.0087, 0.2, 0.577, 0.99, 1.0, 1.0 + 1e-9, 1.5, 2.42, 114.0, 1e5]


@pytest.mark.parametrize("y", QUOTIENTS)
def test_arctangent_to_31_digits(y: float) -> None:
    single = arctan_deg((y, 0.0), (1.0, 0.0))
    several = arctan_deg((np.array([y]), 0.0), (np.array([1.0]), 0.0))
    with mp.workdps(50):
        exact = degrees(atan(mpf(y)))
        for angle in (single, several):
            high, low = (float(np.squeeze(part)) for part in angle)
            assert abs(mpf(high) + mpf(low) - exact) <= RELATIVE * exact


@pytest.mark.parametrize(
    ("n_i", "n_t"), [(1.3960030903904168, 0.009614993102274672), (1.0, 0.008918042133484788)]
)
def test_Rp_at_the_double_nearest_to_brewsters_angle(n_i: float, n_t: float) -> None:
    """What remains of Rp there is the square of the rounding of that double, which is known."""
    interface = Interface(n_i, n_t)
    angle = float(brewster_deg(interface))
    Rp = float(power(interface, Incidence.from_degrees(angle)).Rp)
    with mp.workdps(60):
        eta, theta = mpf(n_t) / mpf(n_i), mpf(angle) * mp.pi / 180
        q = mp.sqrt(eta**2 - mp.sin(theta) ** 2)
        exact = ((eta**2 * mp.cos(theta) - q) / (eta**2 * mp.cos(theta) + q)) ** 2
        assert abs(mpf(Rp) - exact) <= 1e-12 * exact
