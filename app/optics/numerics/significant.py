"""Numbers rounded to significant digits, by arithmetic where that is sure and else by formatting."""

import numpy as np

from app.optics.numerics.blocks import VALUES
from app.optics.numerics.double_double import divide, multiply
from app.optics.parameters import Array

# 10^22 is the largest power of ten that is a double.
_POWERS = np.array([float(10**power) for power in range(23)])

_LARGEST_WHOLE = 2.0**53  # up to which every whole number is a double

# Twice the digits of a double are left of a product; nearer to a half than this it is not trusted.
_CLEAR_OF_HALF = 1e-9


def round_significant(values: Array, digits: int) -> Array:
    """Round to `digits` significant digits, to the very double that those digits spell.

    As Python's formatting does: to the nearest, by all that a double holds, and between two that are
    as near to the even one. What is too large or too small for that by arithmetic, or as near to two,
    is formatted.
    """
    if digits >= 17:
        return values
    result = np.array(values, dtype=np.float64)
    flat = result.reshape(-1)
    for start in range(0, flat.size, VALUES):
        piece = flat[start : start + VALUES]
        piece[:] = _rounded(piece, digits)
    return result


def _rounded(values: Array, digits: int) -> Array:
    magnitude = np.abs(values)
    ordinary = np.isfinite(values) & (magnitude > 0.0)
    power = digits - 1 - np.floor(np.log10(magnitude, where=ordinary, out=np.zeros_like(values)))
    sure = ordinary & (np.abs(power) < len(_POWERS))
    scale = _POWERS[np.where(sure, np.abs(power), 0.0).astype(np.intp)]
    up = power >= 0.0
    numbers = np.where(sure, magnitude, 0.0)
    product = multiply((numbers, 0.0), (np.where(up, scale, 1.0), 0.0))
    high, low = np.asarray(product[0]), np.asarray(product[1])
    large = sure & ~up
    if large.any():
        high[large], low[large] = divide((numbers[large], 0.0), (scale[large], 0.0))
    # The logarithm's own error may have turned a digit too many or too few into whole ones.
    sure &= (high >= _POWERS[digits - 1]) & (high < _POWERS[digits])
    whole = np.rint(high)
    rest = (high - whole) + low
    step = np.rint(rest)
    sure &= 0.5 - np.abs(rest - step) > _CLEAR_OF_HALF
    whole = whole + step
    sure &= (whole <= _LARGEST_WHOLE) | (step == 0.0)
    nearest = np.copysign(np.where(up, whole / scale, whole * scale), values)
    result: Array = np.where(sure, nearest, values)
    spelled = ordinary & ~sure
    result[spelled] = [formatted(value, digits) for value in values[spelled].tolist()]
    return result


def formatted(value: float, digits: int) -> float:
    """Round one number by Python's formatting, which takes a hundred times as long as arithmetic."""
    return float(f"{value:.{digits}g}")
