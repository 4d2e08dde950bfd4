"""Rows of questions, in columns."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.optics.parameters import (
    K_T,
    N_I,
    N_T,
    THETA_I_DEG,
    THETA_I_RAD,
    WAVELENGTH_NM,
    Array,
    Parameter,
)
from app.optics.registry import Registry

MEDIA = (N_I, N_T, K_T, THETA_I_DEG)
"""The numbers of a row that every model takes."""

ANGLES = (THETA_I_DEG.name, THETA_I_RAD.name)
"""An angle comes in one of these."""

NAMES = ("model", "quantity", "material", "incident", "layers")
"""The words of a row: `exact` and `R` where left out; presets in the place of numbers; films."""

THREE = "R, G and B are three questions here, one each; /curves takes three numbers at once"
"""What is said to those who give a triple of a parameter that other routes take three of."""

Index = NDArray[np.intp]


class Names(NamedTuple):
    """A column of names: the distinct ones, and for each row which it is, -1 where left out."""

    codes: Index
    distinct: Sequence[str]


class Fault(NamedTuple):
    """What is wrong with a row."""

    parameter: str
    value: object
    message: str

    def __str__(self) -> str:
        """In one line."""
        given = "" if self.value is None else f" = {self.value}"
        return f"{self.parameter}{given}: {self.message}"


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Questions in columns."""

    count: int
    """How many."""
    numbers: Mapping[str, Array]
    """Columns by the parameters' names, a model's own as `<model>.<parameter>`; NaN where left
    out."""
    names: Mapping[str, Names]
    """Those of `NAMES` that are there."""
    faults: Mapping[int, Fault] = field(default_factory=dict)
    """What is known to be wrong with a row before it is looked at."""

    def part(self, start: int, stop: int) -> Rows:
        """Some of the rows, in order; all of them are these."""
        if start == 0 and stop >= self.count:
            return self
        stop = min(stop, self.count)
        those = slice(start, stop)
        return Rows(
            stop - start,
            {name: column[those] for name, column in self.numbers.items()},
            {name: Names(codes[those], said) for name, (codes, said) in self.names.items()},
            {row - start: fault for row, fault in self.faults.items() if start <= row < stop},
        )


def number_columns(registry: Registry) -> dict[str, Parameter]:
    """Return the parameters that a column of numbers may hold, by the column's name."""
    own = {f"{model.id}.{p.name}": p for model in registry.values() for p in model.parameters}
    return {parameter.name: parameter for parameter in (*MEDIA, THETA_I_RAD, WAVELENGTH_NM)} | own


class Hints:
    """What wrong names may have meant, which takes long to find out, for the first few of them."""

    MOST = 10
    _LONGEST = 100

    def __init__(self) -> None:
        self._told: dict[str, str] = {}

    def of(self, name: str, look: Callable[[str], str]) -> str:
        """Say what a name may have meant, by looking for it if that has not been done."""
        name = name[: self._LONGEST]
        if name not in self._told and len(self._told) < self.MOST:
            self._told[name] = look(name)
        return self._told.get(name, f"unknown; the nearest are told of {self.MOST} names alone")


def parted(keys: Index, which: Index) -> Iterator[tuple[int, Index]]:
    """Part rows by their keys."""
    if keys.size == 0:
        return
    if np.all(keys == keys[0]):
        yield int(keys[0]), which
        return
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    starts = np.flatnonzero(np.diff(ordered, prepend=ordered[0] - 1))
    for start, stop in zip(starts, [*starts[1:], keys.size], strict=True):
        yield int(ordered[start]), which[order[start:stop]]
