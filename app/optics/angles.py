"""The angles at which something happens: Brewster's, the critical and the pseudo-Brewster angle."""

from __future__ import annotations

import cmath
import math

import numpy as np
from scipy.optimize import brentq

from app.optics.brewster import brewster_angle_deg
from app.optics.critical import critical_angle_deg
from app.optics.interface import Interface
from app.optics.parameters import Array


def brewster_deg(interface: Interface) -> Array:
    """Brewster's angle arctan(eta), where Rp = 0.

    Returns
    -------
    Array
        Degrees, of the interface's shape; NaN where the second medium absorbs.
    """
    angle = brewster_angle_deg(interface.n_i, interface.n_t).high
    return np.where(interface.k_t > 0.0, np.nan, angle)


def critical_deg(interface: Interface) -> Array:
    """Critical angle arcsin(eta), beyond which all light is reflected.

    Returns
    -------
    Array
        Degrees, of the interface's shape; NaN where eta >= 1 or the second medium absorbs.
    """
    n_i, n_t = interface.n_i, interface.n_t
    exists = (n_t < n_i) & (interface.k_t == 0.0)
    if not exists.any():
        return np.full(exists.shape, np.nan)
    # Where there is none, a stand-in keeps the root real.
    angle = critical_angle_deg(n_i, np.where(exists, n_t, 0.5 * n_i)).high
    return np.where(exists, angle, np.nan)


def pseudo_brewster_deg(interface: Interface) -> Array:
    """Angle of least Rp, which is Brewster's angle without absorption.

    There is no closed form that keeps its digits; the angle is solved one interface at a time.

    Returns
    -------
    Array
        Degrees above 0 and below 90, of the interface's shape: Rp falls from normal incidence on
        at every interface.

    References
    ----------
    .. [1] S. Y. Kim and K. Vedam, Analytic solution of the pseudo-Brewster angle, J. Opt. Soc.
       Am. A 3, 1772 (1986).
    """
    lossless = brewster_deg(interface)
    if not interface.is_conductor:
        return lossless
    solved = np.vectorize(_least_Rp_deg, otypes=[np.float64])(interface.eta, interface.kappa)
    return np.where(np.isnan(lossless), solved, lossless)


# tan^2 of the pseudo-Brewster angle over |N|^2: 1 without absorption, 1/2 for small and purely
# imaginary N. Nothing else is a zero of the slope, so that a wider bracket holds just the minimum.
_BRACKET = (0.25, 2.0)


def _least_Rp_deg(eta: float, kappa: float) -> float:
    """Solve d Rp / d theta = 0.

    With t = tan^2(theta_i) and w = q/(N^2 cos), r_p = (1 - w)/(1 + w), where w^2 = A t + 1/N^2 with
    A = (N^2 - 1)/N^4, and 1 - w^2 = A (N^2 - t). So d(log Rp)/dt = -2 Re 1/(w (N^2 - t)), which
    has the sign of -Re w (N^2 - t): negative at normal, positive toward grazing incidence.
    """
    square = complex(eta, kappa) ** 2
    size, slant = abs(square), (square - 1.0) / square**2

    def slope(relative: float) -> float:
        t = relative * size
        w = cmath.sqrt(slant * t + 1.0 / square)
        return -(w * (square - t)).real

    t = size * brentq(slope, *_BRACKET, xtol=1e-15, rtol=1e-15)
    return math.degrees(math.atan(math.sqrt(t)))
