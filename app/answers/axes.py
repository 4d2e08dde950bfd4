"""What varies in a sweep, a map or a table, and the interfaces that it makes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np

from app.answers.answer import Values, answer
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.interface import Interface
from app.optics.meant import instead
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, Array

Scale = Literal["linear", "log"]
AxisName = Literal["theta_i_deg", "n_t", "k_t", "eta", "n_i"]
SweptName = Literal["n_t", "k_t", "eta"]

MOST_STEPS = 20_001
"""Values of a sweep."""

MOST_CELLS = 250_000
"""Cells of a map or of a table."""

INDICES = ("n_i", "n_t", "k_t")

SETS: Mapping[str, str] = {"n_t": "n_t", "eta": "n_t", "k_t": "k_t", "n_i": "n_i"}
"""The index of the interface that an axis sets; angles set none."""

_DECLARED = {"theta_i_deg": THETA_I_DEG, "n_t": N_T, "k_t": K_T, "eta": N_T, "n_i": N_I}
_USUAL = {
    "theta_i_deg": (0.0, 90.0),
    "n_t": (0.1, 5.0),
    "k_t": (0.0, 5.0),
    "eta": (0.1, 5.0),
    "n_i": (1.0, 2.0),
}


@answer
class Axis:
    """One axis of a map."""

    name: str
    values: Values

    @classmethod
    def between(
        cls,
        name: AxisName,
        minimum: float | None,
        maximum: float | None,
        steps: int,
        scale: Scale = "linear",
        *,
        n_i: float = 1.0,
        prefix: str = "",
    ) -> Axis:
        """Spread an axis between two ends, the usual ones if None.

        Parameters
        ----------
        n_i
            Of the incident medium, which bounds eta.
        prefix
            Stands before `minimum` and `maximum` in what an error names.

        Raises
        ------
        OutOfRange, NotAllowed
            If an end is out of the bounds of what varies, or the ends are not in order.
        """
        unit = n_i if name == "eta" else 1.0
        low, high = _DECLARED[name].minimum / unit, _DECLARED[name].maximum / unit
        first, last = (
            usual if given is None else given
            for given, usual in zip((minimum, maximum), _USUAL[name], strict=True)
        )
        for end, value in (("minimum", first), ("maximum", last)):
            if not low <= value <= high:
                allowed = instead(name, value) or f"from {low:g} to {high:g} for {name}"
                raise OutOfRange(prefix + end, value, allowed)
        if first >= last:
            raise NotAllowed(prefix + "minimum", first, f"below {prefix}maximum, {last:g}")
        if scale == "linear":
            return cls(name=name, values=np.linspace(first, last, steps))
        if first <= 0.0:
            raise NotAllowed(prefix + "minimum", first, "above 0 where scale=log")
        return cls(name=name, values=np.geomspace(first, last, steps))


@dataclass(frozen=True)
class Grid:
    """Points of which one thing varies along a row, and maybe another from row to row."""

    fixed: Interface
    """The interface whose other indices hold."""
    x: Axis
    y: Axis | None = None
    """What varies."""

    @cached_property
    def varied(self) -> dict[str, Array]:
        """Values of each axis; they broadcast against one another."""
        if self.y is None:
            return {self.x.name: self.x.values}
        return {
            self.x.name: self.x.values[np.newaxis, :],
            self.y.name: self.y.values[:, np.newaxis],
        }

    @cached_property
    def interface(self) -> Interface:
        """The interfaces."""
        return interfaces(self.fixed, self.varied)

    def columns(self) -> dict[str, Array]:
        """Coordinates of every point, row after row."""
        spread = np.broadcast_arrays(*self.varied.values())
        return {name: values.ravel() for name, values in zip(self.varied, spread, strict=True)}


def interfaces(fixed: Interface, varied: Mapping[str, Array]) -> Interface:
    """Put values of what varies in place of an interface's own."""
    n_i, n_t = varied.get("n_i", fixed.n_i), varied.get("n_t", fixed.n_t)
    if "eta" in varied:  # eta n_i may round past a bound
        n_t = np.clip(varied["eta"] * n_i, N_T.minimum, N_T.maximum)
    return Interface(n_i, n_t, varied.get("k_t", fixed.k_t))


def held(fixed: Interface, *varying: str) -> dict[str, Any]:
    """The indices under their names; None for those that vary."""
    varied = {SETS.get(name) for name in varying}
    return {n: None if n in varied else float(getattr(fixed, n)) for n in INDICES}


def refuse_many_cells(parameter: str, **steps: int) -> None:
    """Refuse more cells than are computed at once.

    Raises
    ------
    NotAllowed
        Naming `parameter`, one of `steps`.
    """
    if math.prod(steps.values()) > MOST_CELLS:
        allowed = f"{' times '.join(steps)} at most {MOST_CELLS}"
        raise NotAllowed(parameter, steps[parameter], allowed)
