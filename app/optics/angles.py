"""The angles at which something happens: Brewster's, the critical and the pseudo-Brewster angle."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from app.optics.brewster import brewster_angle_deg
from app.optics.critical import critical_angle_deg
from app.optics.formula import ETA, Axis, Curve, Formula, Series, Symbol, rounding
from app.optics.interface import Interface
from app.optics.parameters import K_T, Array

Curves = Callable[[Interface, int], Curve]


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


_ANGLE = Axis("angle_deg", r"\theta_i", "angle of incidence", "deg")


def _over_eta(low: float, high: float, angle: Callable[[Interface], Array], title: str) -> Curves:
    """Plot an angle over the relative index."""

    def curve(interface: Interface, samples: int) -> Curve:
        eta = np.linspace(low, high, samples)
        values = angle(Interface(1.0, eta, interface.kappa))
        return Curve(ETA, eta, _ANGLE, (Series("angle_deg", title, values),))

    return curve


FORMULAS = (
    Formula(
        id="angle.brewster",
        title="Brewster's angle",
        latex=r"\theta_B=\arctan\eta,\quad R_p(\theta_B)=0,\quad \theta_B+\theta_t=90^\circ",
        reference="D. Brewster, On the laws which regulate the polarisation of light by reflexion, "
        "Phil. Trans. R. Soc. 105, 125 (1815), doi:10.1098/rstl.1815.0010",
        validity="Dielectrics, from either side; what is reflected there is s-polarized. Without "
        "absorption alone: see the pseudo-Brewster angle.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.001 to 100"),),
        at=Interface(n_t=1.5),
        curve=_over_eta(0.2, 4.0, brewster_deg, "Brewster's angle"),
    ),
    Formula(
        id="angle.critical",
        title="Critical angle",
        latex=r"\theta_c=\arcsin\eta,\quad R(\theta_i)=1\ \text{for}\ \theta_i\ge\theta_c",
        reference="J. Kepler, Dioptrice (1611); M. Born and E. Wolf, Principles of Optics, 7th edition, "
        "1.5.4, doi:10.1017/CBO9781139644181",
        validity="From the denser side, eta < 1, into a medium that does not absorb; elsewhere there is "
        "none. The light that seems to be lost runs along the surface as an evanescent wave.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.001 to 1 - 1e-9"),),
        at=Interface(1.5, 1.0),
        curve=_over_eta(0.2, 1.2, critical_deg, "critical angle"),
    ),
    Formula(
        id="angle.pseudo_brewster",
        title="Pseudo-Brewster angle",
        latex=r"\frac{\mathrm{d}R_p}{\mathrm{d}\theta_i}(\theta_{pB})=0,\quad "
        r"\theta_{pB}=\theta_B\ \text{for}\ \kappa=0",
        symbols=(
            Symbol(r"\theta_{pB}", "pseudo-Brewster angle, where R_p is least", "rad"),
            Symbol(r"\theta_B", "Brewster's angle", "rad"),
        ),
        reference="S. Y. Kim and K. Vedam, Analytic solution of the pseudo-Brewster angle, J. Opt. Soc. "
        "Am. A 3, 1772 (1986), doi:10.1364/JOSAA.3.001772",
        validity="Every interface: the angle of least R_p, which is 0 without absorption alone. It is "
        "solved numerically, since the closed form loses its digits.",
        accuracy=(rounding(1e-14, "angle", "eta from 0.2 to 4, kappa from 0.1 to 8"),),
        at=Interface(1.0, 1.5, 3.0),
        takes=(K_T,),
        curve=_over_eta(0.2, 4.0, pseudo_brewster_deg, "pseudo-Brewster angle"),
    ),
)
