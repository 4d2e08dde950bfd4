"""Either of two forms, value by value."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from app.optics.parameters import Number

Condition = bool | NDArray[np.bool_]


def choose(condition: Condition, yes: Callable[[], Number], no: Callable[[], Number]) -> Number:
    """Evaluate `yes()` where `condition` holds and `no()` elsewhere, and neither without need.

    What a value becomes does not depend on the values beside it.
    """
    if everywhere(condition):
        return yes()
    if not anywhere(condition):
        return no()
    return np.where(condition, yes(), no())


def everywhere(condition: Condition) -> bool:
    """Whether it holds for all values."""
    return condition if isinstance(condition, bool) else bool(condition.all())


def anywhere(condition: Condition) -> bool:
    """Whether it holds for any value."""
    return condition if isinstance(condition, bool) else bool(condition.any())
