"""Numbers with fewer digits."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from app.optics.parameters import Array

# 10^22 is the largest power of ten that is a double.
_LARGEST_EXACT_POWER = 22

# Beyond so many, the error of a product or of a logarithm is no longer small beside the last digit.
_MOST_DIGITS_SCALED = 13


def round_significant(values: Array, digits: int) -> Array:
    """Round to `digits` significant digits, to the very double that those digits spell.

    As Python's formatting does: to the nearest, by all that a double holds, and between two that are
    as near to the even one.
    """
    if digits >= 17:
        return values
    magnitude = np.abs(values)
    ordinary = np.isfinite(values) & (magnitude > 0.0)
    power = digits - 1 - np.floor(np.log10(magnitude, where=ordinary, out=np.zeros_like(values)))
    scalable = ordinary & (np.abs(power) <= _LARGEST_EXACT_POWER) & (digits <= _MOST_DIGITS_SCALED)
    scale = 10.0 ** np.where(scalable, np.abs(power), 0.0)
    up = power >= 0.0
    numbers = np.where(scalable, values, 0.0)
    scaled = np.where(up, numbers * scale, numbers / scale)
    whole = np.round(scaled)
    # Where the product's own error could turn it the other way, it is not trusted.
    scalable &= 0.5 - np.abs(scaled - whole) > np.finfo(np.float64).eps * np.abs(scaled)
    result = np.asarray(np.where(scalable, np.where(up, whole / scale, whole * scale), values))
    spelled = ordinary & ~scalable
    result[spelled] = [float(f"{value:.{digits}g}") for value in values[spelled].tolist()]
    return result


def rounded(payload: Any, digits: int) -> Any:
    """Round every float and every float array inside `payload`."""
    if digits >= 17:
        return payload
    if isinstance(payload, Mapping):
        return {key: rounded(value, digits) for key, value in payload.items()}
    if is_dataclass(payload) and not isinstance(payload, type):
        return replace(
            payload, **{f.name: rounded(getattr(payload, f.name), digits) for f in fields(payload)}
        )
    if isinstance(payload, list | tuple):
        return [rounded(value, digits) for value in payload]
    if isinstance(payload, np.ndarray) and payload.dtype.kind == "f":
        return round_significant(payload, digits)
    if isinstance(payload, float):
        return float(f"{payload:.{digits}g}")
    return payload
