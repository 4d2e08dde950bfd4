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

import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache

import numpy as np

from app.optics.numerics.choice import sqrt
from app.optics.parameters import Array, Number

_SPLITTER = 134217729.0  # 2^27 + 1
_DIGITS = 10**50
_PI = 314159265358979323846264338327950288419716939937510


Double2 = tuple[Number, Number]
"""A number as the unevaluated sum of two doubles, high and low."""


def _constant(numerator: int, denominator: int) -> tuple[float, float]:
    value = Fraction(numerator, denominator)
    high = float(value)
    return high, float(value - Fraction(high))


_THIRD, _FIFTH, _SEVENTH = _constant(-1, 3), _constant(1, 5), _constant(-1, 7)
_DEGREES = _constant(180 * _DIGITS, _PI)


def two_sum(a: Number, b: Number) -> Double2:
    """a + b and its rounding error (Knuth)."""
    total = a + b
    rest = total - a
    return total, (a - (total - rest)) + (b - rest)


def add(a: Double2, b: Double2) -> Double2:
    """a + b."""
    high, error = two_sum(a[0], b[0])
    tail, tail_error = two_sum(a[1], b[1])
    high, error = two_sum(high, error + tail)
    return two_sum(high, error + tail_error)


def multiply(a: Double2, b: Double2) -> Double2:
    """a * b, the product of the high parts with its rounding error (Dekker)."""
    (x, x_rest), (y, y_rest) = a, b
    product, x_cut, y_cut = x * y, _SPLITTER * x, _SPLITTER * y
    x_high, y_high = x_cut - (x_cut - x), y_cut - (y_cut - y)
    x_low, y_low = x - x_high, y - y_high
    error = ((x_high * y_high - product) + x_high * y_low + x_low * y_high) + x_low * y_low
    return two_sum(product, error + (x * y_rest + x_rest * y))


def negative(a: Double2) -> Double2:
    """-a."""
    return -a[0], -a[1]


def divide(a: Double2, b: Double2) -> Double2:
    """a / b, by long division."""
    first = a[0] / b[0]
    remainder = add(a, multiply(b, (-first, 0.0)))
    second = remainder[0] / b[0]
    remainder = add(remainder, multiply(b, (-second, 0.0)))
    high, low = two_sum(first, second)
    return add((high, low), (remainder[0] / b[0], 0.0))


def square_root(a: Double2) -> Double2:
    """Root of a > 0, by one step of Newton's from the double's."""
    root = sqrt(a[0])
    remainder = add(a, negative(multiply((root, 0.0), (root, 0.0))))
    return two_sum(root, remainder[0] / (2.0 * root))


def arctan_deg(y: Double2, x: Double2) -> Double2:
    """arctan(y / x) in degrees, 0 to 90, to 31 digits, for y >= 0 and x >= 0."""
    whole: Number
    table: Sequence[Number] | Array
    if isinstance(y[0], np.ndarray):
        nearest = np.rint(np.degrees(np.arctan2(y[0], x[0])))
        whole, table = nearest, _whole_degrees()[:, nearest.astype(np.intp)]
    else:
        degree = round(math.degrees(math.atan2(y[0], x[0])))
        whole, table = float(degree), _whole_degrees()[:, degree].tolist()
    cosine, sine = (table[0], table[1]), (table[2], table[3])
    numerator = add(multiply(cosine, y), negative(multiply(sine, x)))
    z = divide(numerator, add(multiply(cosine, x), multiply(sine, y)))
    # |z| < tan(0.5 deg): the series converges by 1e-4 a term, and from z^9 on a double suffices.
    square = multiply(z, z)
    s = square[0]
    series: Double2 = s * (1.0 / 9.0 - s * (1.0 / 11.0 - s * (1.0 / 13.0 - s / 15.0))), 0.0
    for coefficient in (_SEVENTH, _FIFTH, _THIRD):
        series = multiply(square, add(coefficient, series))
    angle = add(z, multiply(z, series))
    return add((whole, 0.0), multiply(angle, _DEGREES))


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
