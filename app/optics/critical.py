r"""eta^2 - sin^2(theta_i) with all its digits, near the critical angle too.

Its root is the normal component of the refracted wave, and a thin second medium (eta = 0.01) passes
from Rp = 0 to Rp = 1 within a few millionths of a radian of the critical angle
theta_c = arcsin(eta), where the difference of eta and a rounded sine has lost the digits that Rp
needs. The difference is also 2 cos((theta_c + theta_i)/2) sin((theta_c - theta_i)/2) times
eta + sin(theta_i), see `app.optics.near_angle`.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from app.optics.choice import choose
from app.optics.double_double import (
    Double2,
    arctan_deg,
    multiply,
    square_root,
    two_sum,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.near_angle import careful_near
from app.optics.parameters import Array, Number


def normal_square(interface: Interface, incidence: Incidence) -> Array:
    """Evaluate Re q^2 = eta^2 - kappa^2 - sin^2(theta_i).

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
    eta, kappa, eta_minus_1 = interface.relative
    kappa2 = kappa * kappa

    def by_cosine() -> Array:
        return np.asarray((eta_minus_1 * (eta + 1.0) - kappa2) + incidence.cos * incidence.cos)

    # Without absorption a sum of positive terms for eta >= 1, and wherever there is absorption it is
    # seen beside 2 eta kappa. For eta < 1 the cosine is rounded too coarsely near normal incidence.
    robust = (eta >= 1.0) | interface.absorbs_strongly
    return np.asarray(
        choose(robust, by_cosine, lambda: _denser_side(interface, incidence) - kappa2)
    )


def _denser_side(interface: Interface, incidence: Incidence) -> Array:
    """eta^2 - sin^2(theta_i) for eta < 1."""
    eta, _, eta_minus_1 = interface.relative
    s, c = incidence.sin, incidence.cos
    # Near grazing incidence s is rounded while c is not, near normal incidence the other way round.
    plain = np.where(s * s < 0.5, (eta - s) * (eta + s), eta_minus_1 * (eta + 1.0) + c * c)
    return careful_near(
        critical_angle_deg, _roughly_critical_deg, plain, interface, incidence, _about_critical
    )


def _about_critical(n_i: Array, n_t: Array, theta_deg: Array, critical: Double2) -> Array:
    distance = (critical.high - theta_deg) + critical.low
    # The cosine of the mean is the sine of its complement, which keeps its digits near 90 degrees.
    complement = 0.5 * (((90.0 - critical.high) - critical.low) + (90.0 - theta_deg))
    difference = 2.0 * np.sin(np.radians(complement)) * np.sin(0.5 * np.radians(distance))
    return np.asarray(difference * (n_t / n_i + np.sin(np.radians(theta_deg))))


def _roughly_critical_deg(eta: Array) -> Array:
    with np.errstate(invalid="ignore"):
        return np.where(eta < 1.0, np.degrees(np.arcsin(eta)), np.nan)


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
