"""The angles at which something happens: Brewster's, the critical and the pseudo-Brewster angle."""

from __future__ import annotations

import cmath

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
        Degrees, of the interface's shape; 0 where Rp rises from normal incidence on.

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


# cos(theta_i) of the scan that brackets the minimum, dense toward grazing, where it lies for metals.
_SCAN = [float(mu) for mu in np.concatenate([[1.0], np.geomspace(0.995, 1e-5, 60)])]


def _least_Rp_deg(eta: float, kappa: float) -> float:
    """Solve d Rp / d theta = 0.

    With x = 1/cos^2 and w = q/(N^2 cos), r_p = (1 - w)/(1 + w), and w^2 = A x + B is linear in x with
    A = (N^2 - 1)/N^4 and B = 1/N^4. Rp is least where Re w / (1 + |w|^2) is largest.
    """
    square = complex(eta, kappa) ** 2
    A, B = (square - 1.0) / square**2, 1.0 / square**2

    def merit(x: float) -> float:
        w = cmath.sqrt(A * x + B)
        return w.real / (1.0 + (w * w.conjugate()).real)

    def slope(log_x: float) -> float:
        """Sign and zero of d merit / dx, from dw/dx = A / (2 w)."""
        w = cmath.sqrt(A * np.exp(log_x) + B)
        dw = A / (2.0 * w)
        return dw.real * (1.0 + abs(w) ** 2) - 2.0 * w.real * (w.conjugate() * dw).real

    xs = [1.0 / (mu * mu) for mu in _SCAN]
    merits = [merit(x) for x in xs]
    best = merits.index(max(merits))
    low, high = xs[max(best - 1, 0)], xs[min(best + 1, len(xs) - 1)]
    if not slope(np.log(low)) > 0.0 > slope(np.log(high)):
        return float(np.degrees(np.arccos(_SCAN[best])))
    x = float(np.exp(brentq(slope, np.log(low), np.log(high), xtol=1e-15, rtol=1e-15)))
    return float(np.degrees(np.arctan(np.sqrt(x - 1.0))))
