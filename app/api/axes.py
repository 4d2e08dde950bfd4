"""Axes of a sweep, a map or a table that a query asks for."""

from typing import Any

from pydantic import Field

from app.answers.axes import SETS, Axis, AxisName, Scale
from app.api.params import InterfaceQuery
from app.optics.errors import NotAllowed

_PRESET = {"n_t": "material", "k_t": "material", "n_i": "incident"}


def end(description: str) -> Any:
    """Pydantic field of the first or the last value, the usual one unless given."""
    return Field(None, allow_inf_nan=False, description=description)


def swept(
    query: InterfaceQuery, name: AxisName, prefix: str, steps: int, scale: Scale = "linear"
) -> Axis:
    """Spread an axis between the ends that the query gives, named with `prefix`.

    Raises
    ------
    OutOfRange
        If an end is out of the bounds of what varies.
    NotAllowed
        If the ends are not in order, or what varies is given too.
    """
    index = SETS.get(name)
    for given in () if index is None else (index, _PRESET[index]):
        value = getattr(query, given)
        if value is not None and given in query.model_fields_set:
            raise NotAllowed(given, value, f"not beside {name} as what varies, which sets it")
    first, last = (getattr(query, prefix + end) for end in ("minimum", "maximum"))
    return Axis.between(name, first, last, steps, scale, n_i=query.n_i, prefix=prefix)
