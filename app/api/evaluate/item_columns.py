"""Items of `/evaluate` as columns, gathered part by part."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from operator import attrgetter
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.api.evaluate.pieces import Piece
from app.batch.rows import ANGLES, NAMES, Fault, Index, Names, Rows
from app.http.problems import BadParameters
from app.optics.parameters import THETA_I_DEG, THETA_I_RAD, Array

T = TypeVar("T", bound=np.generic)

_MOST_NAMES = 50_000
"""Different names in a column: each is kept as a Python object."""


Faults = Callable[[int, int], Iterator[tuple[int, Fault]]]
"""Yields the items in a range that cannot be read, and why."""


@dataclass(frozen=True, slots=True, eq=False)
class Items:
    """All items of a body in columns; one element an item, the angles one after the other."""

    numbers: dict[str, Array]
    names: dict[str, Names]
    angles: Array
    counts: Index
    listed: NDArray[np.bool_]
    in_radians: NDArray[np.bool_]
    """Whether the angles of an item are in radians."""
    wrong: Faults

    @property
    def size(self) -> int:
        """Bytes that they take."""
        columns = [*self.numbers.values(), self.angles, self.counts, self.listed, self.in_radians]
        return sum(column.nbytes for column in columns) + sum(
            codes.nbytes for codes, _ in self.names.values()
        )

    def pieces(self, size: int) -> Iterator[Callable[[], Piece]]:
        """Part the items into pieces of about `size` values, each item whole."""
        ends = np.cumsum(self.counts)
        start = 0
        while start < self.counts.size:
            before = int(ends[start - 1]) if start else 0
            stop = max(start + 1, int(np.searchsorted(ends, before + size, side="right")))
            yield partial(self._piece, start, min(stop, self.counts.size), before)
            start = stop

    def _piece(self, start: int, stop: int, before: int) -> Piece:
        counts = self.counts[start:stop]
        first = np.cumsum(counts) - counts
        listed = self.listed[start:stop]

        def spread(column: NDArray[T]) -> NDArray[T]:
            """One element a value; without lists that is the column itself, and needs no memory."""
            part = column[start:stop]
            return np.repeat(part, counts) if listed.any() else part

        given = self.angles[before : before + int(counts.sum())]
        angles = {THETA_I_DEG.name: given}
        if self.in_radians[start:stop].any():
            in_radians = spread(self.in_radians)
            angles = {
                THETA_I_DEG.name: np.where(in_radians, np.nan, given),
                THETA_I_RAD.name: np.where(in_radians, given, np.nan),
            }
        rows = Rows(
            int(counts.sum()),
            {name: spread(column) for name, column in self.numbers.items()} | angles,
            {
                name: Names(spread(codes), distinct)
                for name, (codes, distinct) in self.names.items()
            },
            {int(first[item - start]): fault for item, fault in self.wrong(start, stop)},
        )
        return Piece(start, rows, counts, listed)


class Gathered:
    """Columns on their way to `Items`; a column is made when somebody gives it.

    Parameters
    ----------
    choices
        Numbers by their names, of the columns that may be given by name.
    """

    def __init__(self, choices: dict[str, dict[str, float]]) -> None:
        self._choices = choices
        self._numbers: dict[str, _Column[np.float64]] = {}
        self._codes: dict[str, _Column[np.intp]] = {}
        self._distinct: dict[str, dict[str | None, int]] = {name: {None: -1} for name in NAMES}
        self._angles: list[Array] = []
        self._counts: list[Index] = []
        self._listed: list[NDArray[np.bool_]] = []
        self._in_radians: list[NDArray[np.bool_]] = []
        self.twice: list[int] = []
        """Items among those last taken that give their angle twice, in degrees and in radians."""
        self.size = 0
        self.values = 0

    def add(self, items: list[Any], columns: list[str]) -> int:
        """Take decoded items, and count the colons that their fields were given with.

        Raises
        ------
        BadParameters
            If there are too many different names.
        """
        size, colons = len(items), 0
        angles: dict[str, list[Any]] = {}
        for name in columns:
            given: Iterable[Any] = map(attrgetter(attribute_of(name)), items)
            if name in NAMES:
                colons += self._name(name, list(given))
            elif name in ANGLES:
                angles[name] = list(given)
            else:
                colons += self._number(name, given, size)
        in_radians, self.twice = np.zeros(size, np.bool_), []
        one = angles.get(THETA_I_DEG.name, [math.nan] * size)
        if THETA_I_RAD.name in angles:
            radians = angles[THETA_I_RAD.name]
            in_radians = np.array([_is_given(angle) for angle in radians], np.bool_)
            self.twice = [i for i in np.flatnonzero(in_radians).tolist() if _is_given(one[i])]
            one = [
                r if is_rad else d for r, d, is_rad in zip(radians, one, in_radians, strict=True)
            ]
        theta, counts, listed = _angles(one)
        # A list is given even if it is empty, and a number unless it is NaN.
        colons += int(np.count_nonzero(listed)) + _given(theta[np.repeat(~listed, counts)])
        colons += len(self.twice)
        self._angles.append(theta)
        self._counts.append(counts)
        self._listed.append(listed)
        self._in_radians.append(in_radians)
        self.size += size
        self.values += theta.size
        return colons

    def _number(self, name: str, given: Iterable[Any], size: int) -> int:
        choices = self._choices.get(name)
        if choices:
            given = (choices.get(value, value) for value in given)
        part = np.fromiter(given, np.float64, size)
        count = _given(part)
        if count:
            column = self._numbers.setdefault(name, _Column(np.float64(np.nan)))
            column.append(self.size, part)
        return count

    def _name(self, name: str, said: list[str | None]) -> int:
        distinct = self._distinct[name]
        seen = dict.fromkeys(said)
        for text in seen:
            distinct.setdefault(text, len(distinct) - 1)
        if len(distinct) > _MOST_NAMES:
            message = f"more than {_MOST_NAMES} different ones; send them in several calls"
            raise BadParameters({"parameter": name, "value": None, "message": message})
        if len(seen) == 1 and None in seen:
            return 0  # all leave it out
        part = np.fromiter(map(distinct.__getitem__, said), np.intp, len(said))
        self._codes.setdefault(name, _Column(np.intp(-1))).append(self.size, part)
        colons = int(np.count_nonzero(part >= 0))
        if any(text is not None and ":" in text for text in seen):
            colons += sum(text.count(":") for text in said if text is not None)
        return colons

    def items(self, wrong: Faults) -> Items:
        """All that was added; columns that nobody gave are left out."""
        return Items(
            {name: column.whole(self.size) for name, column in self._numbers.items()},
            {
                name: Names(
                    column.whole(self.size),
                    [text for text in self._distinct[name] if text is not None],
                )
                for name, column in self._codes.items()
            },
            np.concatenate([np.zeros(0), *self._angles]),
            np.concatenate([np.zeros(0, np.intp), *self._counts]),
            np.concatenate([np.zeros(0, np.bool_), *self._listed]),
            np.concatenate([np.zeros(0, np.bool_), *self._in_radians]),
            wrong,
        )


class _Column(Generic[T]):
    """A column in parts, each from an item on; in between it is left out."""

    def __init__(self, left_out: T) -> None:
        self._left_out = left_out
        self._parts: list[tuple[int, NDArray[T]]] = []

    def append(self, start: int, part: NDArray[T]) -> None:
        """Take the part that begins with an item."""
        self._parts.append((start, part))

    def whole(self, size: int) -> NDArray[T]:
        """The column of all items."""
        column = np.full(size, self._left_out)
        for start, part in self._parts:
            column[start : start + part.size] = part
        self._parts.clear()
        return column


def _given(column: Array) -> int:
    return int(column.size - np.count_nonzero(np.isnan(column)))


def _is_given(angle: Any) -> bool:
    """Whether an angle is a list, or a number and not the NaN of what is left out."""
    return isinstance(angle, list) or not math.isnan(angle)


def _angles(given: list[Any]) -> tuple[Array, Index, NDArray[np.bool_]]:
    """All angles of items one after the other, how many are whose, and who gave a list."""
    size = len(given)
    with suppress(TypeError, ValueError):  # raised for lists
        ones, zeros = np.ones(size, np.intp), np.zeros(size, np.bool_)
        return np.fromiter(given, np.float64, size), ones, zeros
    arrays = [np.atleast_1d(np.array(angle, np.float64)) for angle in given]
    listed = np.array([type(angle) is list for angle in given])
    return np.concatenate(arrays), np.array([array.size for array in arrays]), listed


def attribute_of(name: str) -> str:
    """The attribute of a decoded item that holds a column, whose name may have a dot."""
    return name.replace(".", "__")
