r"""Factors of Fresnel's equations that vanish at an angle, with all their digits about it.

A factor such as eta cos(theta_i) - sin(theta_i) is the difference of two rounded products, of which
no digit is left at the angle where it vanishes. It is also a sine of the difference of the two
angles, and in degrees the difference of two near angles is exact: all that is needed is the angle of
the interface in degrees to twice the precision of a double.

The factor of Brewster's angle theta_B = arctan(eta) is sqrt(1 + eta^2) sin(theta_B - theta_i); its
square is Rp. That of the critical angle theta_c = arcsin(eta), eta^2 - sin^2(theta_i), is
2 cos((theta_c + theta_i)/2) sin((theta_c - theta_i)/2) times eta + sin(theta_i). Its root is the normal
component of the refracted wave, and a thin second medium (eta = 0.01) passes from Rp = 0 to Rp = 1
within a few millionths of a radian of that angle.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.choice import choose
from app.optics.numerics.double_double import (
    Double2,
    arctan_deg,
    multiply,
    square_root,
    two_sum,
)
from app.optics.parameters import Array, Number

# Beyond this distance the plain difference has its digits: its relative error there is about
# 1e-16 / (distance in radians), 3e-14.
_NEAR_DEG = 0.2

AngleOf = Callable[[Array, Array], Double2]


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
    return _careful_near(
        brewster_angle_deg,
        lambda eta: np.asarray(np.degrees(np.arctan(eta))),
        plain,
        interface,
        incidence,
        _about_brewster,
    )


def _about_brewster(n_i: Array, n_t: Array, theta_deg: Array, brewster: Double2) -> Array:
    distance = (brewster.high - theta_deg) + brewster.low
    return np.asarray(np.hypot(n_i, n_t) / n_i * np.sin(np.radians(distance)))


def brewster_angle_deg(n_i: Array, n_t: Array) -> Double2:
    """arctan(n_t / n_i) in degrees, to about 30 digits; of two arrays or of two single numbers."""
    if n_i.ndim == n_t.ndim == 0:
        return _one_brewster_deg(float(n_i), float(n_t))
    return arctan_deg(Double2(n_t), Double2(n_i))


@lru_cache(maxsize=1024)
def _one_brewster_deg(n_i: float, n_t: float) -> Double2:
    return arctan_deg(Double2(n_t), Double2(n_i))


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
    return _careful_near(
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
        return _one_critical_deg(float(n_i), float(n_t))
    return _angle_deg(n_i, n_t)


@lru_cache(maxsize=1024)
def _one_critical_deg(n_i: float, n_t: float) -> Double2:
    return _angle_deg(n_i, n_t)


def _angle_deg(n_i: Number, n_t: Number) -> Double2:
    # By way of the arctangent of n_t / sqrt(n_i^2 - n_t^2).
    adjacent = square_root(multiply(two_sum(n_i, -n_t), two_sum(n_i, n_t)))
    return arctan_deg(Double2(n_t), adjacent)


def _careful_near(
    angle_deg: AngleOf,
    roughly_deg: Callable[[Array], Array],
    plain: Array,
    interface: Interface,
    incidence: Incidence,
    careful: Callable[[Array, Array, Array, Double2], Array],
) -> Array:
    """Replace what is near an angle of the interface.

    Parameters
    ----------
    angle_deg
        The angle in degrees from n_i and n_t, to about 30 digits.
    roughly_deg
        The same from eta in plain arithmetic, NaN where there is none.
    plain
        The values, of the shape that interface and incidence broadcast to.
    interface, incidence
        The boundary and the directions.
    careful
        The values near the angle, from n_i, n_t and theta_i in degrees, and the angle.

    Returns
    -------
    Array
        `plain`, or a copy where anything was near; the very `plain` for directions that were not
        made from degrees, since those are rounded already.
    """
    degrees = incidence.exact_degrees
    if degrees is None:
        return plain
    near = np.abs(roughly_deg(interface.eta) - degrees) < _NEAR_DEG
    if not near.any():
        return plain
    theta = np.broadcast_to(degrees, plain.shape)[near]
    n_i, n_t = interface.n_i, interface.n_t
    if interface.shape:
        n_i, n_t = (np.broadcast_to(array, plain.shape)[near] for array in (n_i, n_t))
    result = plain.copy()
    result[near] = careful(n_i, n_t, theta, angle_deg(n_i, n_t))
    return result
