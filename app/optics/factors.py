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

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.choice import choose, select
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

AngleOf = Callable[[Number, Number], Double2]


def brewster_factor(interface: Interface, incidence: Incidence) -> Number:
    """Evaluate eta cos(theta_i) - sin(theta_i), of the broadcast shape.

    Relative accuracy is a few units in the last place where the directions were made from degrees;
    from radians or cosines the absolute one is.
    """
    (eta, _, _), (c, s) = interface.relative, incidence.numbers
    angle = np.degrees(np.arctan(eta))
    plain = eta * c - s
    return _careful_near(angle, brewster_angle_deg, plain, interface, incidence, _about_brewster)


def _about_brewster(n_i: Number, n_t: Number, theta_deg: Array, brewster: Double2) -> Array:
    distance = (brewster[0] - theta_deg) + brewster[1]
    return np.asarray(np.hypot(n_i, n_t) / n_i * np.sin(np.radians(distance)))


def brewster_angle_deg(n_i: Number, n_t: Number) -> Double2:
    """arctan(n_t / n_i) in degrees, to about 30 digits."""
    return _angle_deg(_arctan_deg, n_i, n_t)


def _arctan_deg(n_i: Number, n_t: Number) -> Double2:
    return arctan_deg((n_t, 0.0), (n_i, 0.0))


def normal_square(interface: Interface, incidence: Incidence) -> Number:
    """Evaluate Re q^2 = eta^2 - kappa^2 - sin^2(theta_i), as accurate as `brewster_factor`."""
    eta, kappa, eta_minus_1 = interface.relative
    c, s = incidence.numbers
    kappa2, contrast = kappa * kappa, eta_minus_1 * (eta + 1.0)

    def denser_side() -> Number:
        # Near grazing incidence s is rounded while c is not, near normal incidence the other way.
        plain = select(s * s < 0.5, (eta - s) * (eta + s), contrast + c * c)
        angle = np.degrees(np.arcsin(select(eta < 1.0, eta, np.nan)))
        return (
            _careful_near(angle, critical_angle_deg, plain, interface, incidence, _about_critical)
            - kappa2
        )

    # Without absorption a sum of positive terms for eta >= 1, and wherever there is absorption it is
    # seen beside 2 eta kappa. For eta < 1 the cosine is rounded too coarsely near normal incidence.
    robust = (eta >= 1.0) | interface.absorbs_strongly
    return choose(robust, lambda: (contrast - kappa2) + c * c, denser_side)


def _about_critical(n_i: Number, n_t: Number, theta_deg: Array, critical: Double2) -> Array:
    distance = (critical[0] - theta_deg) + critical[1]
    # The cosine of the mean is the sine of its complement, which keeps its digits near 90 degrees.
    complement = 0.5 * (((90.0 - critical[0]) - critical[1]) + (90.0 - theta_deg))
    difference = 2.0 * np.sin(np.radians(complement)) * np.sin(0.5 * np.radians(distance))
    return np.asarray(difference * (n_t / n_i + np.sin(np.radians(theta_deg))))


def critical_angle_deg(n_i: Number, n_t: Number) -> Double2:
    """arcsin(n_t / n_i) in degrees, to about 30 digits; all n_t must be less than n_i."""
    return _angle_deg(_arcsin_deg, n_i, n_t)


def _arcsin_deg(n_i: Number, n_t: Number) -> Double2:
    # By way of the arctangent of n_t / sqrt(n_i^2 - n_t^2).
    adjacent = square_root(multiply(two_sum(n_i, -n_t), two_sum(n_i, n_t)))
    return arctan_deg((n_t, 0.0), adjacent)


def _angle_deg(angle_of: AngleOf, n_i: Number, n_t: Number) -> Double2:
    if isinstance(n_i, float) and isinstance(n_t, float):
        return _one_angle_deg(angle_of, n_i, n_t)
    return angle_of(n_i, n_t)


@lru_cache(maxsize=1024)
def _one_angle_deg(angle_of: AngleOf, n_i: float, n_t: float) -> Double2:
    return angle_of(n_i, n_t)


def _careful_near(
    roughly_deg: Number,
    angle_deg: AngleOf,
    plain: Number,
    interface: Interface,
    incidence: Incidence,
    careful: Callable[[Number, Number, Array, Double2], Array],
) -> Number:
    """Replace what is near an angle of the interface.

    Parameters
    ----------
    roughly_deg
        The angle in degrees in plain arithmetic, NaN where there is none.
    angle_deg
        The same from n_i and n_t, to about 30 digits.
    plain
        The values, of the shape that interface and incidence broadcast to.
    interface, incidence
        The boundary and the directions.
    careful
        The values near the angle, from n_i, n_t and theta_i in degrees, and the angle.

    Returns
    -------
    Number
        `plain`, changed where anything was near; untouched for directions that were not made from
        degrees, since those are rounded already.
    """
    degrees = incidence.exact_degrees
    if degrees is None:
        return plain
    near = np.abs(roughly_deg - degrees) < _NEAR_DEG
    if not near.any():
        return plain
    n_i, n_t, _ = interface.indices
    if isinstance(plain, float):
        return float(careful(n_i, n_t, degrees, angle_deg(n_i, n_t)))
    if degrees.shape != plain.shape:
        degrees = np.broadcast_to(degrees, plain.shape)
    if interface.shape:
        n_i, n_t = (np.broadcast_to(index, plain.shape)[near] for index in (n_i, n_t))
    plain[near] = careful(n_i, n_t, degrees[near], angle_deg(n_i, n_t))
    return plain
