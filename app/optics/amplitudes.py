r"""Exact Fresnel amplitudes and powers, for dielectrics and conductors in one code path.

With c = cos(theta_i), s = sin(theta_i), N = eta + i kappa and q = sqrt(N^2 - s^2) (Im q >= 0, all
relative to n_i), the textbook quotients are rewritten so that nothing cancels as N -> 1:

.. math::
    r_s = \frac{1 - N^2}{(c + q)^2}, \qquad
    r_p = \frac{(N^2 - 1)(N^2 c^2 - s^2)}{(N^2 c + q)^2}

Convention: time factor exp(-i w t), k_t >= 0, r_p = -r_s at normal incidence.

References
----------
.. [1] M. Born and E. Wolf, Principles of Optics, 7th ed., sections 1.5 and 14.2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.optics.brewster import brewster_factor
from app.optics.critical import normal_square
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array

Complex = NDArray[np.complex128]


@dataclass(frozen=True, slots=True, eq=False)
class Wave:
    """Normal component q = a + i b of the second medium's wave vector, in units of n_i k_0.

    Attributes
    ----------
    a, b
        Real and imaginary part; b > 0 in absorbers and beyond the critical angle, where a is 0
        without absorption.
    """

    a: Array
    b: Array


@dataclass(frozen=True, slots=True, eq=False)
class Amplitudes:
    """Complex amplitude coefficients of reflection and transmission."""

    r_s: Complex
    r_p: Complex
    t_s: Complex
    t_p: Complex


@dataclass(frozen=True, slots=True, eq=False)
class Power:
    """Power coefficients, all within 0 and 1; R and T are those of unpolarized light."""

    Rs: Array
    Rp: Array
    Ts: Array
    Tp: Array

    @property
    def R(self) -> Array:
        """Reflectance of unpolarized light, (Rs + Rp) / 2."""
        return np.asarray(0.5 * (self.Rs + self.Rp))

    @property
    def T(self) -> Array:
        """Power entering the second medium, (Ts + Tp) / 2 = 1 - R."""
        return np.asarray(0.5 * (self.Ts + self.Tp))


def wave(interface: Interface, incidence: Incidence) -> Wave:
    """Solve the complex Snell law for q = sqrt(N^2 - sin^2 theta_i).

    Returns
    -------
    Wave
        Of the broadcast shape, with a >= 0 and b >= 0.
    """
    eta, kappa = interface.eta, interface.kappa
    real = normal_square(interface, incidence) - kappa * kappa
    product = eta * kappa
    # The larger of a and b by a sum of positive terms, the smaller from a b = eta kappa.
    larger = np.sqrt(0.5 * (np.hypot(real, 2.0 * product) + np.abs(real)))
    smaller = np.divide(product, larger, out=np.zeros_like(larger), where=larger > 0.0)
    forward = real >= 0.0
    return Wave(np.where(forward, larger, smaller), np.where(forward, smaller, larger))


def amplitudes(interface: Interface, incidence: Incidence) -> Amplitudes:
    """Complex amplitude coefficients r_s, r_p, t_s, t_p.

    Parameters
    ----------
    interface, incidence
        The boundary and the directions; they broadcast against each other.

    Returns
    -------
    Amplitudes
        Complex arrays of the broadcast shape. t refers to the electric field, so t_p carries the
        ratio of the indices: t_s = 1 + r_s, t_p = (1 + r_p) / N.

    Examples
    --------
    >>> normal = amplitudes(Interface(n_t=1.5), Incidence.from_degrees(0.0))
    >>> bool(normal.r_p == -normal.r_s)
    True
    """
    q = wave(interface, incidence)
    c, eta, kappa = incidence.cos, interface.eta, interface.kappa
    qz = q.a + 1j * q.b
    index = eta + 1j * kappa
    square = index * index
    contrast = interface.eta_minus_1 * (eta + 1.0) - kappa * kappa + 2j * eta * kappa
    den_s, den_p = c + qz, square * c + qz
    null = _brewster_null(interface, incidence)
    with np.errstate(invalid="ignore", divide="ignore"):
        r_s = -contrast / (den_s * den_s)
        r_p = contrast * (null[0] + 1j * null[1]) / (den_p * den_p)
        t_s, t_p = 2.0 * c / den_s, 2.0 * index * c / den_p
    # Without a boundary (N = 1) a grazing ray still meets none: 0/0 above is r = 0, t = 1.
    matched = (contrast == 0.0) & (den_s == 0.0)
    return Amplitudes(
        np.where(matched, 0.0, r_s),
        np.where(matched, 0.0, r_p),
        np.where(matched, 1.0, t_s),
        np.where(matched, 1.0, t_p),
    )


def power(interface: Interface, incidence: Incidence) -> Power:
    """Reflected and transmitted power for s and p polarization, in real arithmetic.

    Relative accuracy is 1e-12 at every angle given in degrees, Brewster's and the critical angle
    included, about which the plain forms lose their digits.

    Parameters
    ----------
    interface, incidence
        The boundary and the directions; they broadcast against each other.

    Returns
    -------
    Power
        Arrays of the broadcast shape within 0 and 1, with R + T = 1. In an absorber T is what
        passes the boundary, before it decays.

    Examples
    --------
    Nothing of the p-polarized light returns at Brewster's angle:

    >>> import numpy as np
    >>> bool(power(Interface(n_t=1.5), Incidence.from_radians(np.arctan(1.5))).Rp < 1e-30)
    True
    """
    q = wave(interface, incidence)
    c, s, eta, kappa = incidence.cos, incidence.sin, interface.eta, interface.kappa
    square_re, square_im = (eta - kappa) * (eta + kappa), 2.0 * eta * kappa
    contrast = (interface.eta_minus_1**2 + kappa**2) * ((eta + 1.0) ** 2 + kappa**2)
    den_s = (c + q.a) ** 2 + q.b**2
    den_p = (square_re * c + q.a) ** 2 + (square_im * c + q.b) ** 2
    null_re, null_im = _brewster_null(interface, incidence)
    with np.errstate(invalid="ignore", divide="ignore"):
        Rs = contrast / (den_s * den_s)
        Rp = contrast * (null_re**2 + null_im**2) / (den_p * den_p)
        Ts = 4.0 * c * q.a / den_s
        Tp = 4.0 * c * q.a * (q.a**2 + q.b**2 + s * s) / den_p
    # At 90 degrees and beyond the critical angle all is reflected, to the last bit; without a
    # boundary (N = 1) nothing is, not even there, where the quotients above are 0/0.
    total = (c == 0.0) | ((q.a == 0.0) & (q.b > 0.0))
    none = contrast == 0.0
    return Power(
        _between(none, total, Rs),
        _between(none, total, Rp),
        *(_between(total & ~none, none, T) for T in (Ts, Tp)),
    )


def _between(zero: NDArray[np.bool_], one: NDArray[np.bool_], values: Array) -> Array:
    """Set the known ends, and take off the last bit by which a power may round above 1."""
    return np.where(zero, 0.0, np.where(one, 1.0, np.minimum(values, 1.0)))


def _brewster_null(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """N^2 c^2 - s^2 as real and imaginary part: the factor that vanishes at Brewster's angle."""
    c, eta, kappa = incidence.cos, interface.eta, interface.kappa
    absorbed = kappa * c
    real = brewster_factor(interface, incidence) * (eta * c + incidence.sin) - absorbed * absorbed
    return np.asarray(real), np.asarray(2.0 * eta * c * absorbed)
