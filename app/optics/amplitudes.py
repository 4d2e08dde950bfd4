r"""Exact Fresnel amplitudes and powers, for dielectrics and conductors in one code path.

With c = cos(theta_i), s = sin(theta_i), N = eta + i kappa and q = sqrt(N^2 - s^2) (Im q >= 0, all
relative to n_i), the textbook quotients are rewritten so that nothing cancels as N -> 1:

.. math::
    r_s = \frac{1 - N^2}{(c + q)^2}, \qquad
    r_p = \frac{(N^2 - 1)(N^2 c^2 - s^2)}{(N^2 c + q)^2} = -r_s \frac{c q - s^2}{c q + s^2}

The last form has the fewest operations, and the squares of its factors are real,

.. math::
    |c + q|^2 = c^2 + 2 c\,\mathrm{Re}\,q + |q|^2, \qquad
    |c q \pm s^2|^2 = c^2 |q|^2 + s^4 \pm 2 c s^2\,\mathrm{Re}\,q,

of which only the difference can cancel: where absorption is weak, it is taken from the product
:math:`(c q - s^2)(c q + s^2) = N^2 c^2 - s^2` instead. Unpolarized light needs but their sum,

.. math::
    R = \frac{R_s + R_p}{2} = \frac{|N^2 - 1|^2}{|c + q|^4}\,
        \frac{c^2 |q|^2 + s^4}{|c q + s^2|^2}.

Convention: time factor exp(-i w t), k_t >= 0, r_p = -r_s at normal incidence.

References
----------
.. [1] M. Born and E. Wolf, Principles of Optics, 7th ed., sections 1.5 and 14.2.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.optics.factors import brewster_factor, normal_square
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.blocks import in_blocks
from app.optics.numerics.choice import (
    absolute,
    anywhere,
    choose,
    everywhere,
    maximum,
    sqrt,
)
from app.optics.parameters import Array, Condition, Number

Complex = NDArray[np.complex128]

# In place of 0 below fractions whose numerator is 0 too; the square of the second is no 0 either.
_SMALLEST, _SMALLEST_DEN = 1e-300, 1e-150


class Wave(NamedTuple):
    """Normal component q = a + i b of the second medium's wave vector, in units of n_i k_0."""

    a: Number
    b: Number
    """Real and imaginary part; b > 0 in absorbers and beyond the critical angle, where a is 0
    without absorption."""
    abs2: Number
    """a^2 + b^2."""
    stands: Condition
    """Where a is 0 and b is not, so that nothing travels on."""


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

    R: Array
    Rs: Array
    Rp: Array
    Ts: Array
    Tp: Array

    @property
    def T(self) -> Array:
        """Power entering the second medium, (Ts + Tp) / 2 = 1 - R."""
        return np.asarray(0.5 * (self.Ts + self.Tp))


def wave(interface: Interface, incidence: Incidence) -> Wave:
    """Solve the complex Snell law for q = sqrt(N^2 - sin^2 theta_i).

    Returns
    -------
    Wave
        Numbers that broadcast to the shape of both, with a >= 0 and b >= 0.
    """
    real = normal_square(interface, incidence)
    eta, kappa, _ = interface.relative
    if interface.is_lossless and everywhere(eta >= 1.0):
        return Wave(sqrt(real), 0.0, real, False)
    forward = real >= 0.0
    if interface.is_lossless:
        if everywhere(forward):
            return Wave(sqrt(real), 0.0, real, False)
        a, b = sqrt(maximum(real, 0.0)), sqrt(maximum(-real, 0.0))
        return Wave(a, b, absolute(real), real < 0.0)
    product = 2.0 * eta * kappa
    abs2 = sqrt(real * real + product * product)
    # The larger of a and b by a sum of positive terms, the smaller from 2 a b = product.
    larger = sqrt(0.5 * (abs2 + absolute(real)))
    faint = not everywhere(interface.absorbs_strongly)
    smaller = 0.5 * product / (maximum(larger, _SMALLEST) if faint else larger)
    a = choose(forward, lambda: larger, lambda: smaller)
    b = choose(forward, lambda: smaller, lambda: larger)
    return Wave(a, b, abs2, (a == 0.0) & (b > 0.0) if faint else False)


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
        ratio of the indices: t_s = 1 + r_s, t_p = (1 + r_p) / N. At 90 degrees both r are -1, and
        the sign of their imaginary zero is that of the limit, see `phase_deg`.

    Examples
    --------
    >>> normal = amplitudes(Interface(n_t=1.5), Incidence.from_degrees(0.0))
    >>> bool(normal.r_p == -normal.r_s)
    True
    """
    return Amplitudes(*in_blocks(_amplitudes, interface, incidence))


def _amplitudes(interface: Interface, incidence: Incidence) -> tuple[Complex, ...]:
    q = wave(interface, incidence)
    c, eta, kappa = incidence.cos, interface.eta, interface.kappa
    qz = q.a + 1j * q.b
    index = eta + 1j * kappa
    square = index * index
    contrast = interface.eta_minus_1 * (eta + 1.0) - kappa * kappa + 2j * eta * kappa
    den_s, den_p = c + qz, square * c + qz
    null = brewster_null(interface, incidence)
    with np.errstate(invalid="ignore", divide="ignore"):
        r_s = -contrast / (den_s * den_s)
        r_p = contrast * (null[0] + 1j * null[1]) / (den_p * den_p)
        t_s, t_p = 2.0 * c / den_s, 2.0 * index * c / den_p
    # Without a boundary (N = 1) a grazing ray still meets none: 0/0 above is r = 0, t = 1.
    matched = (contrast == 0.0) & (den_s == 0.0)
    # Towards 90 degrees r_s = -1 + 2 c/q and r_p = -1 + 2 c N^2/q, from below the axis or above it.
    grazing = (c == 0.0) & ~matched
    return (
        _at_grazing(grazing, np.asarray(q.b > 0.0), np.where(matched, 0.0, r_s)),
        _at_grazing(grazing, square.imag * q.a < square.real * q.b, np.where(matched, 0.0, r_p)),
        np.where(matched, 1.0, t_s + 0.0),
        np.where(matched, 1.0, t_p + 0.0),
    )


def _at_grazing(grazing: NDArray[np.bool_], below: NDArray[np.bool_], r: Complex) -> Complex:
    """Set -1 at 90 degrees with the imaginary zero of its limit; all other zeros are positive."""
    kept = np.where(grazing, -1.0, r + 0.0)
    kept.imag = np.where(grazing & below, -0.0, kept.imag)
    return np.asarray(kept)


def phase_deg(amplitude: Complex) -> Array:
    """Phase of an amplitude in degrees, -180 to 180.

    Without absorption a negative amplitude has the phase 180. At 90 degrees the phase is the limit
    from smaller angles, -180 where the second medium absorbs or reflects totally (Born and Wolf,
    1.5.4: delta = -2 atan(b/c) falls from 0 at the critical angle to -180), so that no curve jumps.

    Parameters
    ----------
    amplitude
        r_s or r_p of `amplitudes`, or any complex numbers.
    """
    return np.asarray(np.degrees(np.angle(amplitude)))


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
    return Power(*in_blocks(_powers, interface, incidence))


def reflectance(interface: Interface, incidence: Incidence) -> Array:
    """Reflectance R of unpolarized light, the very R of `power`, without the work for the rest."""
    (R,) = in_blocks(_reflectance, interface, incidence)
    return R


class _Terms(NamedTuple):
    """What the powers have in common."""

    q: Wave
    """Normal component in the second medium."""
    contrast: Number
    """|N^2 - 1|^2."""
    none: Condition
    """Where it is 0: without a boundary."""
    den_s: Number
    """|c + q|^2, multiplied out into a sum in which nothing cancels."""
    even: Number
    odd: Number
    """|c q|^2 + s^4 and 2 c s^2 Re q, whose difference is |c q - s^2|^2."""
    den_p: Number
    """Their sum, |c q + s^2|^2."""
    total: Condition
    """Where all is reflected, to the last bit: at 90 degrees and beyond the critical angle, but not
    without a boundary."""


def _terms(interface: Interface, incidence: Incidence) -> _Terms:
    q, (c, s) = wave(interface, incidence), incidence.numbers
    eta, kappa, eta_minus_1 = interface.relative
    eta_plus_1, kappa2 = eta + 1.0, kappa * kappa
    contrast = (eta_minus_1 * eta_minus_1 + kappa2) * (eta_plus_1 * eta_plus_1 + kappa2)
    c2, s2, double = c * c, s * s, 2.0 * c * q.a
    even, odd, den_s = q.abs2 * c2, double * s2, c2 + double
    even += s2 * s2
    den_s += q.abs2
    none, total = contrast == 0.0, (c == 0.0) | q.stands
    if anywhere(none):
        # A grazing ray would be 0/0 without a boundary: nothing of it is reflected.
        den_s, total = maximum(den_s, _SMALLEST_DEN), total & (contrast > 0.0)
    if not anywhere(total):
        total = False
    return _Terms(q, contrast, none, den_s, even, odd, even + odd, total)


def _reflectance(interface: Interface, incidence: Incidence) -> tuple[Array]:
    return (np.asarray(_unpolarized(_terms(interface, incidence))),)


def _unpolarized(terms: _Terms) -> Number:
    """R = (Rs + Rp) / 2, where the two squares of Rp add up to 2 `even`: nothing cancels."""
    R = terms.contrast * terms.even / (terms.den_s * terms.den_s * terms.den_p)
    return _with_end(R, terms.total)


def _powers(interface: Interface, incidence: Incidence) -> tuple[Array, ...]:
    terms, (c, s) = _terms(interface, incidence), incidence.numbers
    q, contrast, none, den_s, even, odd, den_p, total = terms

    def careful() -> Number:
        # (c q - s^2) (c q + s^2) = N^2 c^2 - s^2
        real, imag = brewster_null(interface, incidence)
        return (real * real + imag * imag) / den_p

    null = choose(interface.absorbs_strongly, lambda: even - odd, careful)
    Rs = contrast / (den_s * den_s)
    Rp = Rs * null / den_p
    Ts = 4.0 * c * q.a / den_s
    Tp = Ts * (q.abs2 + s * s) / den_p
    powers = (
        _unpolarized(terms),
        _with_end(Rs, total),
        _with_end(Rp, total),
        _with_end(Ts, none),
        _with_end(Tp, none),
    )
    return tuple(np.asarray(values) for values in powers)


def _with_end(values: Number, one: Condition) -> Number:
    """Set 1 where it is known, and take off the last bit by which a power may round above it."""
    if isinstance(values, float):
        return 1.0 if one else min(values, 1.0)
    np.minimum(values, 1.0, out=values)
    if one is not False:
        np.copyto(values, 1.0, where=one)
    return values


def brewster_null(interface: Interface, incidence: Incidence) -> tuple[Number, Number]:
    """N^2 c^2 - s^2 as real and imaginary part: the factor that vanishes at Brewster's angle."""
    (c, s), (eta, kappa, _) = incidence.numbers, interface.relative
    real = brewster_factor(interface, incidence) * (eta * c + s)
    if interface.is_lossless:
        return real, 0.0
    absorbed = kappa * c
    return real - absorbed * absorbed, 2.0 * eta * c * absorbed
