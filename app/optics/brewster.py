r"""eta cos(theta_i) - sin(theta_i) with all its digits, near Brewster's angle too.

The factor vanishes at Brewster's angle theta_B = arctan(eta), where the difference of the rounded
products keeps no digit and Rp, its square, would be noise. But the same factor is
sqrt(1 + eta^2) sin(theta_B - theta_i), and in degrees the difference of two near angles is exact:
all that is needed is theta_B in degrees to twice the precision of a double.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from app.optics.double_double import Double2, arctan_deg
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array, Number

# Beyond this distance from Brewster's angle the plain difference has its digits: the relative error
# there is about 1e-16 / (distance in radians), 3e-14.
_NEAR_DEG = 0.2


def brewster_factor(interface: Interface, incidence: Incidence) -> Array:
    """Evaluate eta cos(theta_i) - sin(theta_i).

    Parameters
    ----------
    interface, incidence
        The boundary and the directions; they broadcast against each other.

    Returns
    -------
    Array
        Of the broadcast shape. Relative accuracy is a few units in the last place where the
        directions were made from degrees; from radians or cosines the absolute one is.
    """
    eta, _, _ = interface.relative
    plain = np.asarray(eta * incidence.cos - incidence.sin)
    degrees = incidence.exact_degrees
    if degrees is None:
        return plain
    near = np.abs(_nearly_brewster_deg(interface) - degrees) < _NEAR_DEG
    if not near.any():
        return plain
    theta = np.broadcast_to(degrees, plain.shape)[near]
    n_i, n_t = interface.n_i, interface.n_t
    if interface.shape:
        n_i, n_t = (np.broadcast_to(array, plain.shape)[near] for array in (n_i, n_t))
    brewster = brewster_angle_deg(n_i, n_t)
    distance = (brewster.high - theta) + brewster.low
    result = plain.copy()
    result[near] = np.hypot(n_i, n_t) / n_i * np.sin(np.radians(distance))
    return result


def _nearly_brewster_deg(interface: Interface) -> Number:
    """Brewster's angle in plain arithmetic."""
    if not interface.shape:
        return brewster_angle_deg(interface.n_i, interface.n_t).high
    return np.degrees(np.arctan(interface.eta))


def brewster_angle_deg(n_i: Array, n_t: Array) -> Double2:
    """arctan(n_t / n_i) in degrees, to about 30 digits; of two arrays or of two single numbers."""
    if n_i.ndim == n_t.ndim == 0:
        return _one_angle_deg(float(n_i), float(n_t))
    return arctan_deg(Double2(n_t), Double2(n_i))


@lru_cache(maxsize=1024)
def _one_angle_deg(n_i: float, n_t: float) -> Double2:
    return arctan_deg(Double2(n_t), Double2(n_i))
