"""Differences that vanish at an angle, with all their digits about it.

A factor such as eta cos(theta_i) - sin(theta_i) is the difference of two rounded products, of which
no digit is left at the angle where it vanishes. It is also a sine of the difference of the two
angles, and in degrees the difference of two near angles is exact: all that is needed is the angle of
the interface in degrees to twice the precision of a double.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from app.optics.double_double import Double2
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array

# Beyond this distance the plain difference has its digits: its relative error there is about
# 1e-16 / (distance in radians), 3e-14.
_NEAR_DEG = 0.2

AngleOf = Callable[[Array, Array], Double2]


def careful_near(
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
