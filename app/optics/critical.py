r"""eta^2 - sin^2(theta_i) with all its digits, near the critical angle too.

Its root is the normal component of the refracted wave, and a thin second medium (eta = 0.01) passes
from Rp = 0 to Rp = 1 within a few millionths of a radian of the critical angle
theta_c = arcsin(eta), where the difference of eta and a rounded sine has lost the digits that Rp
needs. The difference is also 2 cos((theta_c + theta_i)/2) sin((theta_c - theta_i)/2), with theta_c
in degrees to twice the precision of a double as in `app.optics.brewster`.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from app.optics.double_double import (
    Double2,
    Number,
    arctan_deg,
    multiply,
    square_root,
    two_sum,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array

# Beyond this distance from the critical angle the plain difference has its digits.
_NEAR_DEG = 0.2


def normal_square(interface: Interface, incidence: Incidence) -> Array:
    """Evaluate eta^2 - sin^2(theta_i), negative beyond the critical angle.

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
    eta, s, c = interface.eta, incidence.sin, incidence.cos
    # Near grazing incidence s is rounded while c is not, near normal incidence the other way round.
    plain = np.where(
        s * s < 0.5, (eta - s) * (eta + s), interface.eta_minus_1 * (eta + 1.0) + c * c
    )
    degrees = incidence.exact_degrees
    dense = eta < 1.0
    if degrees is None or not dense.any():
        return plain
    critical_deg = np.degrees(np.arcsin(np.where(dense, eta, 0.0)))
    near = dense & (np.abs(critical_deg - degrees) < _NEAR_DEG)
    if not near.any():
        return plain
    theta = np.broadcast_to(degrees, plain.shape)[near]
    n_i, n_t = interface.n_i, interface.n_t
    if n_i.ndim or n_t.ndim:
        n_i, n_t = (np.broadcast_to(array, plain.shape)[near] for array in (n_i, n_t))
    critical = critical_angle_deg(n_i, n_t)
    distance = (critical.high - theta) + critical.low
    # The cosine of the mean is the sine of its complement, which keeps its digits near 90 degrees.
    complement = 0.5 * (((90.0 - critical.high) - critical.low) + (90.0 - theta))
    difference = 2.0 * np.sin(np.radians(complement)) * np.sin(0.5 * np.radians(distance))
    result = plain.copy()
    result[near] = difference * np.broadcast_to(eta + s, plain.shape)[near]
    return result


def critical_angle_deg(n_i: Array, n_t: Array) -> Double2:
    """arcsin(n_t / n_i) in degrees, to about 30 digits; of two arrays or of two single numbers.

    All n_t must be less than n_i.
    """
    if n_i.ndim == n_t.ndim == 0:
        return _one_angle_deg(float(n_i), float(n_t))
    return _angle_deg(n_i, n_t)


@lru_cache(maxsize=1024)
def _one_angle_deg(n_i: float, n_t: float) -> Double2:
    return _angle_deg(n_i, n_t)


def _angle_deg(n_i: Number, n_t: Number) -> Double2:
    # By way of the arctangent of n_t / sqrt(n_i^2 - n_t^2).
    adjacent = square_root(multiply(two_sum(n_i, -n_t), two_sum(n_i, n_t)))
    return arctan_deg(Double2(n_t), adjacent)
