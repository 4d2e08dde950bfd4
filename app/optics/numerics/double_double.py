r"""Twice the digits of a double, where two nearly equal angles are subtracted.

A number is the unevaluated sum of two doubles. The arctangent is taken in degrees, because there
the difference from an angle given in degrees is exact. It starts from the nearest whole degree d,
whose sine and cosine are tabulated to 32 digits:

.. math::
    \arctan\frac{y}{x} = d + \arctan\frac{y \cos d - x \sin d}{x \cos d + y \sin d}

References
----------
.. [1] T. J. Dekker, A floating-point technique for extending the available precision, Numerische
   Mathematik 18, 224 (1971).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from typing import NamedTuple

import numpy as np

from app.optics.parameters import Array, Number

_SPLITTER = 134217729.0  # 2^27 + 1
_DIGITS = 10**50
_PI = 314159265358979323846264338327950288419716939937510


class Double2(NamedTuple):
    """A number as the unevaluated sum of two doubles."""

    high: Number
    low: Number = 0.0


def _constant(value: Fraction) -> Double2:
    high = float(value)
    return Double2(high, float(value - Fraction(high)))


_THIRD, _FIFTH, _SEVENTH = (_constant(Fraction(*f)) for f in ((-1, 3), (1, 5), (-1, 7)))
_DEGREES = _constant(Fraction(180 * _DIGITS, _PI))


def two_sum(a: Number, b: Number) -> Double2:
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


def add(a: Double2, b: Double2) -> Double2:
    """a + b."""
    high, error = two_sum(a.high, b.high)
    tail, tail_error = two_sum(a.low, b.low)
    high, error = two_sum(high, error + tail)
    return two_sum(high, error + tail_error)


def multiply(a: Double2, b: Double2) -> Double2:
    """a * b."""
    high, error = _two_product(a.high, b.high)
    return two_sum(high, error + (a.high * b.low + a.low * b.high))


def negative(a: Double2) -> Double2:
    """-a."""
    return Double2(-a.high, -a.low)


def divide(a: Double2, b: Double2) -> Double2:
    """a / b, by long division."""
    first = a.high / b.high
    remainder = add(a, multiply(b, Double2(-first)))
    second = remainder.high / b.high
    remainder = add(remainder, multiply(b, Double2(-second)))
    return add(two_sum(first, second), Double2(remainder.high / b.high))


def square_root(a: Double2) -> Double2:
    """Root of a > 0, by one step of Newton's from the double's."""
    root = np.sqrt(a.high) if isinstance(a.high, np.ndarray) else math.sqrt(a.high)
    remainder = add(a, negative(_two_product(root, root)))
    return two_sum(root, remainder.high / (2.0 * root))


def arctan_deg(y: Double2, x: Double2) -> Double2:
    """arctan(y / x) in degrees, 0 to 90, to 31 digits, for y >= 0 and x >= 0."""
    whole: Number
    table: Sequence[Number] | Array
    if isinstance(y.high, np.ndarray):
        nearest = np.rint(np.degrees(np.arctan2(y.high, x.high)))
        whole, table = nearest, _whole_degrees()[:, nearest.astype(np.intp)]
    else:
        degree = round(math.degrees(math.atan2(y.high, x.high)))
        whole, table = float(degree), _whole_degrees()[:, degree].tolist()
    cos_high, cos_low, sin_high, sin_low = table
    cosine, sine = Double2(cos_high, cos_low), Double2(sin_high, sin_low)
    numerator = add(multiply(cosine, y), negative(multiply(sine, x)))
    z = divide(numerator, add(multiply(cosine, x), multiply(sine, y)))
    # |z| < tan(0.5 deg): the series converges by 1e-4 a term, and from z^9 on a double suffices.
    square = multiply(z, z)
    s = square.high
    series = Double2(s * (1.0 / 9.0 - s * (1.0 / 11.0 - s * (1.0 / 13.0 - s / 15.0))))
    for coefficient in (_SEVENTH, _FIFTH, _THIRD):
        series = multiply(square, add(coefficient, series))
    angle = add(z, multiply(z, series))
    return add(Double2(whole), multiply(angle, _DEGREES))


@cache
def _whole_degrees() -> Array:
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
