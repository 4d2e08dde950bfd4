"""The nine dispersion formulas of the refractiveindex.info database."""

from collections.abc import Callable, Sequence

import numpy as np

from app.optics.errors import NotAllowed
from app.optics.parameters import Array

HERZBERGER_POLE_UM2 = 0.028


def refractive_index(number: int, coefficients: Sequence[float], wavelength_um: Array) -> Array:
    r"""Evaluate formula `number` with coefficients c_1, c_2, ... at wavelengths in micrometers.

    1. Sellmeier, :math:`n^2 - 1 = c_1 + \sum c_i \lambda^2 / (\lambda^2 - c_{i+1}^2)`
    2. Sellmeier, :math:`n^2 - 1 = c_1 + \sum c_i \lambda^2 / (\lambda^2 - c_{i+1})`
    3. polynomial, :math:`n^2 = c_1 + \sum c_i \lambda^{c_{i+1}}`
    4. general, two terms :math:`c_i \lambda^{c_{i+1}} / (\lambda^2 - c_{i+2}^{c_{i+3}})`, then 3
    5. Cauchy, :math:`n = c_1 + \sum c_i \lambda^{c_{i+1}}`
    6. gases, :math:`n - 1 = c_1 + \sum c_i / (c_{i+1} - \lambda^{-2})`
    7. Herzberger, :math:`n = c_1 + c_2 L + c_3 L^2 + c_4 \lambda^2 + c_5 \lambda^4 + \dots`,
       :math:`L = 1 / (\lambda^2 - 0.028)`
    8. retro, :math:`(n^2 - 1)/(n^2 + 2) = c_1 + c_2 \lambda^2/(\lambda^2 - c_3) + c_4 \lambda^2`
    9. exotic, :math:`n^2 = c_1 + c_2/(\lambda^2-c_3) + c_4 (\lambda-c_5)/((\lambda-c_5)^2 + c_6)`

    Parameters
    ----------
    number
        1 to 9.
    coefficients
        As many as the source gives, in whole terms; of formula 4 both poles are given, with an
        amplitude of 0 where there is none.
    wavelength_um
        Any shape.

    Returns
    -------
    Array
        n, of the same shape. The caller keeps to the formula's range.

    Raises
    ------
    NotAllowed
        If there is no such formula, or a term lacks a coefficient.

    References
    ----------
    .. [1] M. N. Polyanskiy, Sci. Data 11, 94 (2024), and its "Dispersion formulas".
    """
    check_coefficients(number, coefficients)
    return np.asarray(_FORMULAS[number](tuple(coefficients), wavelength_um))


def check_coefficients(number: int, coefficients: Sequence[float]) -> None:
    """Refuse coefficients that are no whole terms of a formula.

    Raises
    ------
    NotAllowed
        If there is no such formula, or a term lacks a coefficient.
    """
    if number not in _FORMULAS:
        raise NotAllowed("number", number, "a dispersion formula, 1 to 9")
    counts, words = _COUNTS.get(number, _IN_PAIRS)
    if len(coefficients) not in counts:
        what = f"{words} for formula {number}, and these are {len(coefficients)}"
        raise NotAllowed("coefficients", list(coefficients), what)


def _pairs(coefficients: Sequence[float], first: int = 1) -> list[tuple[float, float]]:
    return list(zip(coefficients[first::2], coefficients[first + 1 :: 2], strict=False))


def _padded(coefficients: Sequence[float], count: int) -> list[float]:
    return [*coefficients, *[0.0] * count][:count]


def _sellmeier(c: Sequence[float], wl: Array) -> Array:
    return _sellmeier_2([c[0], *(x for a, b in _pairs(c) for x in (a, b * b))], wl)


def _sellmeier_2(c: Sequence[float], wl: Array) -> Array:
    square = wl * wl
    terms = sum((a * square / (square - b) for a, b in _pairs(c)), np.zeros_like(wl))
    return np.sqrt(1.0 + c[0] + terms)


def _powers(c: Sequence[float], wl: Array, first: int = 1) -> Array:
    return np.asarray(sum((a * wl**b for a, b in _pairs(c, first)), np.zeros_like(wl)))


def _polynomial(c: Sequence[float], wl: Array) -> Array:
    return np.sqrt(c[0] + _powers(c, wl))


def _general(c: Sequence[float], wl: Array) -> Array:
    square = wl * wl
    total = c[0] + _powers(c, wl, first=9)
    for first in (1, 5):
        amplitude, power, base, exponent = c[first : first + 4]
        if amplitude:
            total = total + amplitude * wl**power / (square - base**exponent)
    return np.sqrt(total)


def _cauchy(c: Sequence[float], wl: Array) -> Array:
    return c[0] + _powers(c, wl)


def _gases(c: Sequence[float], wl: Array) -> Array:
    inverse = 1.0 / (wl * wl)
    return 1.0 + (c[0] + sum((a / (b - inverse) for a, b in _pairs(c)), np.zeros_like(wl)))


def _herzberger(c: Sequence[float], wl: Array) -> Array:
    square = wl * wl
    pole = 1.0 / (square - HERZBERGER_POLE_UM2)
    c1, c2, c3 = _padded(c, 3)
    tail = sum((a * square ** (i + 1) for i, a in enumerate(c[3:])), np.zeros_like(wl))
    return np.asarray(c1 + c2 * pole + c3 * pole**2 + tail)


def _retro(c: Sequence[float], wl: Array) -> Array:
    square = wl * wl
    c1, c2, c3, c4 = _padded(c, 4)
    refraction = c1 + c2 * square / (square - c3) + c4 * square
    return np.sqrt((1.0 + 2.0 * refraction) / (1.0 - refraction))


def _exotic(c: Sequence[float], wl: Array) -> Array:
    c1, c2, c3, c4, c5, c6 = _padded(c, 6)
    shift = wl - c5
    return np.sqrt(c1 + c2 / (wl * wl - c3) + c4 * shift / (shift * shift + c6))


_MOST = 101
_IN_PAIRS = (range(1, _MOST, 2), "an odd number")
_COUNTS: dict[int, tuple[Sequence[int], str]] = {
    4: (range(9, _MOST, 2), "an odd number from 9"),
    7: (range(3, 7), "3 to 6"),
    8: ((4,), "4"),
    9: ((6,), "6"),
}
"""How many coefficients make whole terms; an odd number where nothing else is said."""

_FORMULAS: dict[int, Callable[[Sequence[float], Array], Array]] = {
    1: _sellmeier,
    2: _sellmeier_2,
    3: _polynomial,
    4: _general,
    5: _cauchy,
    6: _gases,
    7: _herzberger,
    8: _retro,
    9: _exotic,
}
