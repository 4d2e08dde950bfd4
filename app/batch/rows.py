"""Rows of questions, evaluated by groups that one call of a model answers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import repeat
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.optics.errors import UnknownName
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, Array, Parameter
from app.optics.quantities import QUANTITIES
from app.optics.registry import Model, Registry

MEDIA = (N_I, N_T, K_T, THETA_I_DEG)
"""The numbers of a row that every model takes."""

T = TypeVar("T")
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
    """Questions in columns.

    Attributes
    ----------
    count
        How many.
    numbers
        Columns by the parameters' names, a model's own as `<model>.<parameter>`; NaN where left out.
    names
        The columns `model` and `quantity`, `exact` and `R` where left out.
    faults
        What is known to be wrong with a row before it is looked at.
    """

    count: int
    numbers: Mapping[str, Array]
    names: Mapping[str, Names]
    faults: Mapping[int, Fault] = field(default_factory=dict)


@dataclass(slots=True)
class Outcome:
    """One value a row, NaN where it is undefined or the row is wrong; and what is wrong."""

    values: Array
    faults: dict[int, Fault] = field(default_factory=dict)


def number_columns(registry: Registry) -> dict[str, Parameter]:
    """Return the parameters that a column of numbers may hold, by the column's name."""
    own = {f"{model.id}.{p.name}": p for model in registry.values() for p in model.parameters}
    return {parameter.name: parameter for parameter in MEDIA} | own


def evaluate(rows: Rows, registry: Registry) -> Outcome:
    """Answer every row; one that is wrong does not keep the others from their answers."""
    task = _Task(rows, registry)
    for model, which in task.by_name("model", "exact", lambda name: registry.find(name, "model")):
        for quantity, asked in task.by_name("quantity", "R", _quantity, which):
            if model.id != "exact" and quantity != "R":
                message = f"{model.id} has R alone; the other quantities are those of exact"
                task.refuse(asked, "quantity", repeat(quantity), message)
            else:
                task.answer(model, quantity, asked)
    return task.outcome


def _quantity(name: str) -> str:
    if name not in QUANTITIES:
        raise UnknownName("quantity", name, QUANTITIES)
    return name


class _Task:
    """Rows on their way to becoming an outcome."""

    def __init__(self, rows: Rows, registry: Registry) -> None:
        self.rows = rows
        self.registry = registry
        self.outcome = Outcome(np.full(rows.count, np.nan), dict(rows.faults))

    def refuse(self, which: Index, parameter: str, values: Iterable[object], message: str) -> None:
        """Say what is wrong with some rows, each with the value that it gave."""
        for row, value in zip(which.tolist(), values, strict=False):
            self.outcome.faults[row] = Fault(parameter, value, message)

    def by_name(
        self, column: str, default: str, find: Callable[[str], T], which: Index | None = None
    ) -> Iterator[tuple[T, Index]]:
        """Part rows by what a column of names calls for, and refuse those that name nothing."""
        if which is None:
            which = np.arange(self.rows.count)
            if self.rows.faults:
                which = np.delete(which, list(self.rows.faults))
        if column not in self.rows.names:
            yield find(default), which
            return
        codes, distinct = self.rows.names[column]
        for code, asked in _parted(codes[which], which):
            name = default if code < 0 else distinct[code]
            try:
                found = find(name)
            except UnknownName as error:
                self.refuse(asked, column, repeat(name), error.allowed)
            else:
                yield found, asked

    def answer(self, model: Model, quantity: str, which: Index) -> None:
        """Evaluate rows of one model and quantity."""
        own = {f"{model.id}.{p.name}": p for p in model.parameters}
        which = self._without_foreign(model, own, which)
        for parameter in MEDIA:
            which = self._within_bounds(parameter.name, parameter, which)
        for name, parameter in own.items():
            which = self._within_bounds(name, parameter, which)
        # Parameters that are left out may have to be solved, those that are given must not be.
        present = [name for name in own if name in self.rows.numbers]
        pattern = np.zeros(which.size, dtype=np.intp)
        for bit, name in enumerate(present):
            pattern |= (~np.isnan(self._at(name, which))).astype(np.intp) << bit
        for bits, asked in _parted(pattern, which):
            given = [name for bit, name in enumerate(present) if bits >> bit & 1]
            self._evaluate(model, quantity, given, asked)

    def _evaluate(self, model: Model, quantity: str, given: list[str], which: Index) -> None:
        if which.size == 0:
            return
        n_i, n_t, k_t, theta_i_deg = (self._numbers(p.name, p, which) for p in MEDIA)
        interface, incidence = Interface(n_i, n_t, k_t), Incidence.from_degrees(theta_i_deg)
        if model.id == "exact":
            values = QUANTITIES[quantity](interface, incidence)
        else:
            own = {name.partition(".")[2]: _one_if_equal(self._at(name, which)) for name in given}
            values = model(interface, incidence, **own)
        self.outcome.values[which] = values

    def _at(self, name: str, which: Index) -> Array:
        """A column at some rows, which are distinct and in order: all of them are the column."""
        column = self.rows.numbers[name]
        return column if which.size == self.rows.count else column[which]

    def _without_foreign(self, model: Model, own: Mapping[str, Parameter], which: Index) -> Index:
        """Refuse rows that give a parameter of another model, which would otherwise be lost."""
        for name in self.rows.numbers:
            if "." in name and name not in own:
                column = self._at(name, which)
                given = ~np.isnan(column)
                if given.any():
                    message = f"given although the model is {model.id}"
                    self.refuse(which[given], name, column[given].tolist(), message)
                    which = which[~given]
        return which

    def _within_bounds(self, name: str, parameter: Parameter, which: Index) -> Index:
        """Refuse rows whose number is not allowed."""
        if name not in self.rows.numbers:
            return which
        values = self._at(name, which)
        fine = parameter.admits(values) | np.isnan(values)
        if fine.all():
            return which
        self.refuse(which[~fine], name, values[~fine].tolist(), parameter.allowed)
        return which[fine]

    def _numbers(self, name: str, parameter: Parameter, which: Index) -> Array | float:
        default = parameter.default or 0.0
        if name not in self.rows.numbers:
            return default
        values = self._at(name, which)
        left_out = np.isnan(values)
        return _one_if_equal(np.where(left_out, default, values) if left_out.any() else values)


def _one_if_equal(values: Array) -> Array | float:
    """A single number where all are the same, with which the models are fastest."""
    first = values[0]
    return float(first) if values[-1] == first and np.all(values == first) else values


def _parted(keys: Index, which: Index) -> Iterator[tuple[int, Index]]:
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
