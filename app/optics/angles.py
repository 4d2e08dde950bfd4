"""Angles at which something happens: Brewster's, critical, pseudo-Brewster and principal angle."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.optimize import brentq

from app.optics.factors import brewster_angle_deg, critical_angle_deg
from app.optics.interface import Interface, worked_out_once
from app.optics.numerics.choice import anywhere, everywhere, select
from app.optics.parameters import Array


@dataclass(frozen=True, slots=True)
class Zero:
    """An angle without a closed form: where a function of one unknown, eta and kappa crosses 0.

    All four are closed formulas of real numbers, so that other languages can solve them too.
    """

    function: Callable[[float, float, float], float]
    """Of eta, kappa and the unknown; at most 0 at the low end, at least 0 at the high one."""
    low: Callable[[float, float], float]
    high: Callable[[float, float], float]
    """The ends, of eta and kappa, with no other zero between them."""
    tangent2: Callable[[float, float, float], float]
    """tan^2(theta_i), of the same."""

    def angle_deg(self, eta: float, kappa: float) -> float:
        """Solve for the angle in degrees."""
        low, high = self.low(eta, kappa), self.high(eta, kappa)
        function = partial(self.function, eta, kappa)
        x = brentq(function, low, high, xtol=1e-300, rtol=_LEAST_RTOL, maxiter=_MOST_STEPS)
        return math.degrees(math.atan(math.sqrt(self.tangent2(eta, kappa, x))))


_LEAST_RTOL = 4.0 * float(np.finfo(float).eps)
_MOST_STEPS = 2000  # a zero near 1e-300, where hardly anything absorbs, is halved down to


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

    There is no closed form that keeps its digits; `LEAST_RP` is solved one interface at a time.

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
    return _brewster_or(interface, LEAST_RP)


def _brewster_or(interface: Interface, zero: Zero) -> Array:
    """Brewster's angle without absorption, elsewhere the angle of a zero, one at a time."""
    if not interface.is_conductor:
        return brewster_deg(interface)
    eta, kappa, _ = interface.relative
    if isinstance(eta, float) and isinstance(kappa, float):
        return np.asarray(zero.angle_deg(eta, kappa))
    lossless = brewster_deg(interface)
    solved = np.vectorize(zero.angle_deg, otypes=[np.float64])(eta, kappa)
    return np.where(np.isnan(lossless), solved, lossless)


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
    return _brewster_or(interface, QUADRATURE)


def _slope_of_Rp(eta: float, kappa: float, x: float) -> float:
    """What d Rp / d theta has the sign of, of x = 1 - tan^2(theta_i)/|N|^2.

    With t = tan^2(theta_i) and w = q/(N^2 cos), r_p = (1 - w)/(1 + w), where w^2 = A t + 1/N^2 with
    A = (N^2 - 1)/N^4, and 1 - w^2 = A (N^2 - t). So d(log Rp)/dt = -2 Re 1/(w (N^2 - t)), and where it
    is 0 the square of w (N^2 - t) is real. That is a cubic of t, here divided by Im N^2, of which only
    one zero lies within 1/2 and 1 of |N|^2: 1 without absorption, 1/2 for small and imaginary N.
    """
    size, faint = eta * eta + kappa * kappa, 2.0 * kappa * kappa / (eta * eta + kappa * kappa)
    square, cubic = 3.0 - 6.0 * faint - 3.0 * size, 2.0 - 2.0 * faint - size
    return ((square - cubic * x) * x + 2.0 * size + 6.0 * faint) * x - 2.0 * faint


def _end_of_slope(eta: float, kappa: float) -> float:  # noqa: ARG001
    return 0.5


def _start_of_slope(eta: float, kappa: float) -> float:  # noqa: ARG001
    return 0.0


def _of_slope(eta: float, kappa: float, x: float) -> float:
    return (1.0 - x) * (eta * eta + kappa * kappa)


def _lacks_quadrature(eta: float, kappa: float, t: float) -> float:
    """t^2 - |N^2 + (N^2 - 1) t|, of t = tan^2(theta_i)."""
    re = (eta - kappa) * (eta + kappa) * (1.0 + t) - t
    im = 2.0 * eta * kappa * (1.0 + t)
    return t * t - math.sqrt(re * re + im * im)


def _reach(eta: float, kappa: float) -> float:
    """|N^2 - 1|."""
    re, im = (eta - kappa) * (eta + kappa) - 1.0, 2.0 * eta * kappa
    return math.sqrt(re * re + im * im)


def _most(eta: float, kappa: float) -> float:
    """By the triangle inequality every zero is within |N^2| over this and this.

    Without absorption each of both is the zero itself, above and below eta = 1; rounding must not leave
    it outside.
    """
    half = 0.5 * _reach(eta, kappa)
    return (half + math.sqrt(half * half + eta * eta + kappa * kappa)) * (1.0 + 1e-9)


def _least(eta: float, kappa: float) -> float:
    return (eta * eta + kappa * kappa) / _most(eta, kappa)


def _until_turn(eta: float, kappa: float) -> float:
    """The upper end, before a maximum beyond which further zeros may lie.

    Half the slope of t^4 - |N^2 + (N^2 - 1) t|^2 is 2 t^3 - a t + b with a = |N^2 - 1|^2 and
    b = Re N^2 - |N^2|^2, which falls below 0 between two positive roots only if b is positive, |N| < 1
    that is, and small enough.
    """
    reach, size = _reach(eta, kappa), eta * eta + kappa * kappa
    a, b = reach * reach, (eta - kappa) * (eta + kappa) - size * size
    scale = math.sqrt(a / 6.0)
    share = np.minimum(np.maximum(b, 0.0) / np.maximum(4.0 * scale * scale * scale, 1e-300), 1.0)
    turn = 2.0 * scale * np.sin(np.arcsin(share) / 3.0)
    turns = (b > 0.0) & (27.0 * b * b <= 2.0 * a * a * a)
    within = turns & (turn > _least(eta, kappa)) & (turn < _most(eta, kappa))
    past = within & (_lacks_quadrature(eta, kappa, turn) > 0.0)
    return float(np.where(past, turn, _most(eta, kappa)))


def _itself(eta: float, kappa: float, t: float) -> float:  # noqa: ARG001
    return t


LEAST_RP = Zero(_slope_of_Rp, _start_of_slope, _end_of_slope, _of_slope)
"""The pseudo-Brewster angle."""
QUADRATURE = Zero(_lacks_quadrature, _least, _until_turn, _itself)
"""The principal angle."""

LANDMARKS: Mapping[str, Callable[[Interface], Array]] = {
    "brewster_deg": brewster_deg,
    "critical_deg": critical_deg,
    "pseudo_brewster_deg": pseudo_brewster_deg,
    "principal_deg": principal_deg,
}
"""The angles by their names in the API; each is NaN where there is none."""
