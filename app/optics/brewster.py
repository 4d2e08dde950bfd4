r"""eta cos(theta_i) - sin(theta_i) with all its digits, near Brewster's angle too.

The factor vanishes at Brewster's angle theta_B = arctan(eta), where Rp, its square, would be noise.
It is also sqrt(1 + eta^2) sin(theta_B - theta_i), see `app.optics.near_angle`.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from app.optics.double_double import Double2, arctan_deg
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.near_angle import careful_near
from app.optics.parameters import Array


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
    return careful_near(
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
        return _one_angle_deg(float(n_i), float(n_t))
    return arctan_deg(Double2(n_t), Double2(n_i))


@lru_cache(maxsize=1024)
def _one_angle_deg(n_i: float, n_t: float) -> Double2:
    return arctan_deg(Double2(n_t), Double2(n_i))
