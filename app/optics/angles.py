"""Angles at which something happens: Brewster's, critical, pseudo-Brewster and principal angle."""

import cmath
import math
from collections.abc import Callable, Mapping

import numpy as np
from scipy.optimize import brentq

from app.optics.factors import brewster_angle_deg, critical_angle_deg
from app.optics.interface import Interface, worked_out_once
from app.optics.numerics.choice import anywhere, everywhere, select
from app.optics.parameters import Array


@worked_out_once
def brewster_deg(interface: Interface) -> Array:
    """Brewster's angle arctan(eta), where Rp = 0.

    Returns
    -------
    Array
        Degrees, of the interface's shape; NaN where the second medium absorbs.
    """
    n_i, n_t, k_t = interface.indices
    absorbs = k_t > 0.0
    angle = np.nan if everywhere(absorbs) else brewster_angle_deg(n_i, n_t)[0]
    return np.asarray(select(absorbs, np.nan, angle))


@worked_out_once
def critical_deg(interface: Interface) -> Array:
    """Critical angle arcsin(eta), beyond which all light is reflected.

    Returns
    -------
    Array
        Degrees, of the interface's shape; NaN where eta >= 1 or the second medium absorbs.
    """
    n_i, n_t, k_t = interface.indices
    exists = (n_t < n_i) & (k_t == 0.0)
    if not anywhere(exists):
        return np.full(interface.shape, np.nan)
    # Where there is none, a stand-in keeps the root real.
    angle = critical_angle_deg(n_i, select(exists, n_t, 0.5 * n_i))[0]
    return np.asarray(select(exists, angle, np.nan))


@worked_out_once
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
    .. [1] R. M. A. Azzam, Complex reflection coefficients of p- and s-polarized light at the
       pseudo-Brewster angle of a dielectric-conductor interface, J. Opt. Soc. Am. A 30, 1975 (2013).
    """
    return _brewster_or(interface, _least_Rp_deg)


def _brewster_or(interface: Interface, solve: Callable[[float, float], float]) -> Array:
    """Brewster's angle without absorption, elsewhere `solve(eta, kappa)`, one at a time."""
    if not interface.is_conductor:
        return brewster_deg(interface)
    eta, kappa, _ = interface.relative
    if isinstance(eta, float) and isinstance(kappa, float):
        return np.asarray(solve(eta, kappa))
    lossless = brewster_deg(interface)
    solved = np.vectorize(solve, otypes=[np.float64])(eta, kappa)
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


@worked_out_once
def principal_deg(interface: Interface) -> Array:
    r"""Principal angle, where the phases of r_p and r_s are 90 degrees apart.

    Linearly polarized light of both components in the right proportion comes back circularly polarized
    there. The angle obeys

    .. math:: |N^2 - \sin^2\theta_i| = \sin^2\theta_i \tan^2\theta_i

    with N = eta + i kappa, since with q = sqrt(N^2 - sin^2) the ratio r_p/r_s is
    (sin tan - q)/(sin tan + q), of which the real part vanishes. In the plane of complex N^2 this is a
    circle about sin^2 theta_i [1]_. It is solved one interface at a time.

    Returns
    -------
    Array
        Degrees above 0 and below 90, of the interface's shape. Without absorption it is Brewster's
        angle, where the phase of r_p jumps. Where three angles obey, which takes |N| < 1, it is the
        smallest.

    References
    ----------
    .. [1] R. M. A. Azzam, Contours of constant principal angle and constant principal azimuth in the
       complex epsilon plane, J. Opt. Soc. Am. 71, 1523 (1981).

    Examples
    --------
    >>> from app.optics.amplitudes import amplitudes, phase_deg
    >>> from app.optics.incidence import Incidence
    >>> gold = Interface(n_t=0.27, k_t=2.9)
    >>> at = amplitudes(gold, Incidence.from_degrees(principal_deg(gold)))
    >>> round(float(phase_deg(at.r_p) - phase_deg(at.r_s)) % 180, 9)
    90.0
    """
    return _brewster_or(interface, _quadrature_deg)


def _quadrature_deg(eta: float, kappa: float) -> float:
    """Solve t^2 = |N^2 + (N^2 - 1) t| for the least t = tan^2(theta_i).

    By the triangle inequality every root is within |N^2|/high and high, each of which is the root
    itself without absorption, above and below eta = 1.
    """
    square = complex(eta, kappa) ** 2
    size, reach = abs(square), abs(square - 1.0)
    high = 0.5 * reach + math.hypot(0.5 * reach, math.sqrt(size))

    def excess(t: float) -> float:
        return t * t - abs(square + (square - 1.0) * t)

    # Rounding must not leave the root outside.
    low, high = size / high * (1.0 - 1e-9), high * (1.0 + 1e-9)
    turn = _first_maximum(square)
    if turn is not None and low < turn < high and excess(turn) > 0.0:
        high = turn
    t = brentq(excess, low, high, xtol=1e-300, rtol=4.0 * np.finfo(float).eps)
    return math.degrees(math.atan(math.sqrt(t)))


def _first_maximum(square: complex) -> float | None:
    """Where t^4 - |N^2 + (N^2 - 1) t|^2 has a maximum, beyond which further roots may lie.

    Half its slope is 2 t^3 - a t + b with a = |N^2 - 1|^2 and b = Re N^2 - |N^2|^2, which falls below 0
    between two positive roots only if b is positive, |N| < 1 that is, and small enough.
    """
    a, b = abs(square - 1.0) ** 2, square.real - abs(square) ** 2
    if b <= 0.0 or 27.0 * b * b > 2.0 * a**3:
        return None
    scale = math.sqrt(a / 6.0)
    return 2.0 * scale * math.sin(math.asin(min(b / (4.0 * scale**3), 1.0)) / 3.0)


LANDMARKS: Mapping[str, Callable[[Interface], Array]] = {
    "brewster_deg": brewster_deg,
    "critical_deg": critical_deg,
    "pseudo_brewster_deg": pseudo_brewster_deg,
    "principal_deg": principal_deg,
}
"""The angles by their names in the API; each is NaN where there is none."""
