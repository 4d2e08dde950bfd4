r"""eta cos(theta_i) - sin(theta_i) with all its digits, near Brewster's angle too.

The factor vanishes at Brewster's angle theta_B = arctan(eta), where the difference of the rounded
products keeps no digit and Rp, its square, would be noise. But the same factor is
sqrt(1 + eta^2) sin(theta_B - theta_i), and in degrees the difference of two near angles is exact:
all that is needed is theta_B in degrees to twice the precision of a double. It comes from the
nearest whole degree d, whose sine and cosine are tabulated to 32 digits, as

.. math::
    \theta_B = d + \arctan\frac{n_t \cos d - n_i \sin d}{n_i \cos d + n_t \sin d}

in double-double arithmetic (pairs of doubles whose unevaluated sum is the number).

References
----------
.. [1] T. J. Dekker, A floating-point technique for extending the available precision, Numerische
   Mathematik 18, 224 (1971).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array

# Beyond this distance from Brewster's angle the plain difference has its digits: the relative error
# there is about 1e-16 / (distance in radians), 3e-14.
_NEAR_DEG = 0.2

_SPLITTER = 134217729.0  # 2^27 + 1
_DIGITS = 10**50
_PI = 314159265358979323846264338327950288419716939937510


Number = float | Array
"""One number, with which Python is faster, or many, with which NumPy is."""


class Double2(NamedTuple):
    """A number as the unevaluated sum of two doubles."""

    high: Number
    low: Number


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
    eta = interface.eta
    plain = np.asarray(eta * incidence.cos - incidence.sin)
    degrees = incidence.exact_degrees
    if degrees is None:
        return plain
    near = np.abs(np.degrees(np.arctan(eta)) - degrees) < _NEAR_DEG
    if not near.any():
        return plain
    if interface.n_i.ndim == interface.n_t.ndim == 0:
        brewster = _one_brewster_deg(float(interface.n_i), float(interface.n_t))
        slope = np.asarray(np.hypot(1.0, eta))
        theta = np.broadcast_to(degrees, plain.shape)[near]
    else:
        n_i, n_t, theta = (
            np.broadcast_to(array, plain.shape)[near]
            for array in (interface.n_i, interface.n_t, degrees)
        )
        whole = np.rint(np.degrees(np.arctan2(n_t, n_i))).astype(np.intp)
        brewster = _brewster_deg(n_i, n_t, whole.astype(np.float64), _table()[:, whole])
        slope = np.hypot(n_i, n_t) / n_i
    distance = (brewster.high - theta) + brewster.low
    result = plain.copy()
    result[near] = slope * np.sin(np.radians(distance))
    return result


@lru_cache(maxsize=1024)
def _one_brewster_deg(n_i: float, n_t: float) -> Double2:
    whole = round(math.degrees(math.atan2(n_t, n_i)))
    return _brewster_deg(n_i, n_t, float(whole), _table()[:, whole].tolist())


def _brewster_deg(
    n_i: Number, n_t: Number, whole: Number, table: Sequence[Number] | Array
) -> Double2:
    """arctan(n_t / n_i) in degrees, to about 30 digits.

    `whole` is the nearest whole degree and `table` the columns of `_table` that belong to it.
    """
    cos_high, cos_low, sin_high, sin_low = table
    cosine, sine = Double2(cos_high, cos_low), Double2(sin_high, sin_low)
    numerator = _add(_scale(cosine, n_t), _scale(sine, -n_i))
    z = _divide(numerator, _add(_scale(cosine, n_i), _scale(sine, n_t)))
    # |z| < tan(0.5 deg): the series converges by 1e-4 a term, and from z^7 on doubles suffice.
    square = _multiply(z, z)
    s = square.high
    tail = s**3 * (-1.0 / 7.0 + s * (1.0 / 9.0 - s * (1.0 / 11.0 - s / 13.0)))
    fifth = _multiply(_multiply(square, square), _FIFTH)
    series = _add(_add(_multiply(square, _THIRD), fifth), _plain(tail))
    angle = _add(z, _multiply(z, series))
    return _add(_plain(whole), _multiply(angle, _DEGREES))


def _plain(value: Number) -> Double2:
    return Double2(value, 0.0)


def _constant(value: Fraction) -> Double2:
    high = float(value)
    return Double2(high, float(value - Fraction(high)))


_THIRD, _FIFTH = _constant(Fraction(-1, 3)), _constant(Fraction(1, 5))
_DEGREES = _constant(Fraction(180 * _DIGITS, _PI))


def _two_sum(a: Number, b: Number) -> Double2:
    """a + b and its rounding error (Knuth)."""
    total = a + b
    rest = total - a
    return Double2(total, (a - (total - rest)) + (b - rest))


def _two_product(a: Number, b: Number) -> Double2:
    """a * b and its rounding error (Dekker)."""
    product = a * b
    a_high = _SPLITTER * a - (_SPLITTER * a - a)
    b_high = _SPLITTER * b - (_SPLITTER * b - b)
    a_low, b_low = a - a_high, b - b_high
    error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
    return Double2(product, error)


def _add(a: Double2, b: Double2) -> Double2:
    high, error = _two_sum(a.high, b.high)
    tail, tail_error = _two_sum(a.low, b.low)
    high, error = _two_sum(high, error + tail)
    return _two_sum(high, error + tail_error)


def _multiply(a: Double2, b: Double2) -> Double2:
    high, error = _two_product(a.high, b.high)
    return _two_sum(high, error + (a.high * b.low + a.low * b.high))


def _scale(a: Double2, factor: Number) -> Double2:
    return _multiply(a, _plain(factor))


def _divide(a: Double2, b: Double2) -> Double2:
    first = a.high / b.high
    remainder = _add(a, _scale(b, -first))
    second = remainder.high / b.high
    remainder = _add(remainder, _scale(b, -second))
    return _add(_two_sum(first, second), _plain(remainder.high / b.high))


@cache
def _table() -> Array:
    """Cosine and sine of 0 to 90 whole degrees, each as high and low part: shape (4, 91)."""
    sines = []
    for degree in range(91):
        x = Fraction(_PI * degree, 180 * _DIGITS)
        term, total, order = x, x, 1
        while abs(term) > Fraction(1, _DIGITS):
            order += 2
            term = -term * x * x / ((order - 1) * order)
            term = Fraction(int(term * _DIGITS * 1000), _DIGITS * 1000)
            total += term
        sines.append(total)
    columns = [[(high := float(value)), float(value - Fraction(high))] for value in sines]
    high, low = np.array(columns).T
    return np.array([high[::-1], low[::-1], high, low])
