"""Answers with fewer digits."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from app.optics.numerics.significant import formatted, round_significant


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
        return formatted(payload, digits)
    return payload
