"""The JSON body of `/evaluate`: items of one value or many, in columns."""

from __future__ import annotations

import math
import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache, partial
from operator import attrgetter, itemgetter
from typing import Any, Literal, NamedTuple, TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from app.api.evaluate.pieces import MOST_VALUES, Piece, TooManyValues
from app.batch.rows import NAMES, THREE, Fault, Hints, Index, Names, Rows, number_columns
from app.http.problems import BadParameters, unknown_parameter
from app.optics.meant import instead
from app.optics.parameters import THETA_I_DEG, Array
from app.optics.registry import Registry

_AT_A_TIME = 20_000
"""Items that exist as Python objects at a time."""

T = TypeVar("T", bound=np.generic)

_DECODERS = 64
"""Decoders that are kept, each of items with columns of their own."""

_SAMPLE = 50
"""Items that are looked at to see which columns all may have."""

_PARTS = msgspec.json.Decoder(dict[str, msgspec.Raw])
_NUMBER = itemgetter(0)
_NOTHING = [msgspec.Raw()]

_PLACE = re.compile(r" - at `\$\.?([\w.]*)")
_UNKNOWN = re.compile(r"unknown field `(.*)`")

_UNREADABLE = (msgspec.MsgspecError, RecursionError, UnicodeDecodeError)


class _Decoder(NamedTuple):
    """Decoders of items that hold some columns, and an item that says nothing."""

    columns: list[str]
    one: msgspec.json.Decoder[Any]
    many: msgspec.json.Decoder[Any]
    blank: Any


class _Body(msgspec.Struct, forbid_unknown_fields=True):
    """The body, each item as the bytes it was sent as."""

    items: list[msgspec.Raw]


class ItemReader:
    """Reads bodies whose items ask for the models of a registry.

    The type of an item is made from the registry, and numbers that are left out become NaN, which
    JSON cannot spell.
    """

    def __init__(self, registry: Registry) -> None:
        self._columns = number_columns(registry)
        self._choices = {name: dict(p.choices) for name, p in self._columns.items() if p.choices}
        self._known = [*NAMES, *self._columns]
        self._decoder_of = lru_cache(_DECODERS)(self._made)
        self._all = self._decoder_of(frozenset(self._known))

    def _made(self, columns: frozenset[str]) -> _Decoder:
        """Make a decoder of items that hold no other columns."""
        item = msgspec.defstruct(
            "Item",
            [self._field(name) for name in self._known if name in columns],
            rename=lambda attribute: attribute.replace("__", "."),
            forbid_unknown_fields=True,
            gc=False,
        )
        many: Any = list[item]  # type: ignore[valid-type]
        decoders = msgspec.json.Decoder(item), msgspec.json.Decoder(many)
        return _Decoder([name for name in self._known if name in columns], *decoders, item())

    def _field(self, name: str) -> tuple[str, Any, Any]:
        """A field of an item: its name, what it may be, and what it is where it is left out."""
        if name in NAMES:
            return name, str, None
        kind: Any = float
        if name == THETA_I_DEG.name:
            kind = float | list[float]
        if self._columns[name].choices:
            kind = float | Literal[tuple(choice for choice, _ in self._columns[name].choices)]
        return _attribute(name), kind, math.nan

    def read(self, body: bytes | bytearray) -> Items:
        """Take a body apart.

        Raises
        ------
        BadParameters
            If it is no JSON, or no object with a list of items.
        TooManyValues
            If the items ask for more than may be asked at a time.
        """
        try:
            raw = msgspec.json.decode(body, type=_Body).items
        except _UNREADABLE as error:
            message = f'{error}; a body reads {{"items": [{{"n_t": 1.5, "theta_i_deg": 60}}]}}'
            raise BadParameters({"parameter": "items", "value": None, "message": message}) from None
        if len(raw) > MOST_VALUES:
            raise TooManyValues(len(raw))
        gathered = _Gathered(len(raw), self._choices)
        for start in range(0, len(raw), _AT_A_TIME):
            part = raw[start : start + _AT_A_TIME]
            items, columns, wrong = self._decoded(part)
            gathered.add(start, items, columns, [(start + index, part[index]) for index in wrong])
            raw[start : start + len(part)] = _NOTHING * len(part)  # makes room for the columns
            if gathered.values > MOST_VALUES:
                raise TooManyValues(gathered.values)
        return gathered.items(self)

    def _decoded(self, raw: list[msgspec.Raw]) -> tuple[list[Any], list[str], list[int]]:
        """Decode items, the columns they may hold, and which of them cannot be decoded."""
        body = b"[" + b",".join(raw) + b"]"
        for decoder in (self._decoder_of(self._columns_of_some(raw)), self._all):
            with suppress(*_UNREADABLE):
                return decoder.many.decode(body), decoder.columns, []
        items, wrong = [], []
        for index, one in enumerate(raw):
            try:
                items.append(self._all.one.decode(one))
            except _UNREADABLE:
                items.append(self._all.blank)
                wrong.append(index)
        return items, self._all.columns, wrong

    def _columns_of_some(self, raw: list[msgspec.Raw]) -> frozenset[str]:
        """The columns of a few items, most often those of all: with no more, all are read faster."""
        columns: set[str] = set()
        for one in raw[:: len(raw) // _SAMPLE + 1]:
            with suppress(*_UNREADABLE):
                columns.update(_PARTS.decode(one))
        return frozenset(columns.intersection(self._known))

    def fault(self, raw: msgspec.Raw, hints: Hints) -> Fault:
        """Say what is wrong with an item that could not be decoded."""
        try:
            self._all.one.decode(raw)
        except _UNREADABLE as error:
            text = str(error)
        try:
            given = msgspec.json.decode(raw)
        except _UNREADABLE:
            given = None
        unknown, place = _UNKNOWN.search(text), _PLACE.search(text)
        name = unknown[1] if unknown else place[1] if place and place[1] else "items"
        value = given.get(name) if isinstance(given, dict) else given
        message = instead(name, value) or text.partition(" - at ")[0]
        if isinstance(value, dict | list):
            if name in self._columns and self._columns[name].triple:
                message += f"; {THREE}"
            value = None  # too much to repeat
        if unknown:
            message = hints.of(name, self._nearest)
        return Fault(name, value, message)

    def _nearest(self, name: str) -> str:
        return unknown_parameter(name, None, self._known)["message"]


@dataclass(frozen=True, slots=True, eq=False)
class Items:
    """All items of a body in columns; one element an item, the angles one after the other."""

    numbers: dict[str, Array]
    names: dict[str, Names]
    theta_i_deg: Array
    counts: Index
    listed: NDArray[np.bool_]
    malformed: list[tuple[int, msgspec.Raw]]
    reader: ItemReader

    @property
    def values(self) -> int:
        """How many values they ask for."""
        return int(self.theta_i_deg.size)

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
        hints = Hints()
        listed = self.listed[start:stop]

        def spread(column: NDArray[T]) -> NDArray[T]:
            """One element a value; without lists that is the column itself, and needs no memory."""
            part = column[start:stop]
            return np.repeat(part, counts) if listed.any() else part

        rows = Rows(
            int(counts.sum()),
            {name: spread(column) for name, column in self.numbers.items()}
            | {THETA_I_DEG.name: self.theta_i_deg[before : before + int(counts.sum())]},
            {
                name: Names(spread(codes), distinct)
                for name, (codes, distinct) in self.names.items()
            },
            {
                int(first[item - start]): self.reader.fault(raw, hints)
                for item, raw in self.malformed[
                    bisect_left(self.malformed, start, key=_NUMBER) : bisect_left(
                        self.malformed, stop, key=_NUMBER
                    )
                ]
            },
        )
        return Piece(start, rows, counts, listed)


class _Gathered:
    """Columns on their way to `Items`, made as long as there are items when they are first needed.

    Parameters
    ----------
    size
        How many items there are.
    choices
        Numbers by their names, of the columns that may be given by name.
    """

    def __init__(self, size: int, choices: dict[str, dict[str, float]]) -> None:
        self._size = size
        self._choices = choices
        self._numbers: dict[str, Array] = {}
        self._codes: dict[str, Index] = {}
        self._distinct: dict[str, dict[str | None, int]] = {name: {None: -1} for name in NAMES}
        self._theta_i_deg: list[Array] = []
        self._counts = np.ones(size, np.intp)
        self._listed = np.zeros(size, np.bool_)
        self._malformed: list[tuple[int, msgspec.Raw]] = []
        self.values = 0

    def add(
        self,
        start: int,
        items: list[Any],
        columns: list[str],
        malformed: list[tuple[int, msgspec.Raw]],
    ) -> None:
        """Take decoded items, of which the first is number `start`."""
        here, size = slice(start, start + len(items)), len(items)
        theta = np.full(size, np.nan)
        for name in columns:
            given: Iterable[Any] = map(attrgetter(_attribute(name)), items)
            if name in NAMES:
                self._name(name, list(given), here)
            elif name == THETA_I_DEG.name:
                theta = self._angles(list(given), here)
            else:
                self._number(name, given, here)
        self._theta_i_deg.append(theta)
        self._malformed += malformed
        self.values += theta.size

    def _number(self, name: str, given: Iterable[Any], here: slice) -> None:
        choices = self._choices.get(name)
        if choices:
            given = (choices.get(value, value) for value in given)
        column = np.fromiter(given, np.float64, here.stop - here.start)
        if name not in self._numbers and not np.isnan(column).all():
            self._numbers[name] = np.full(self._size, np.nan)
        if name in self._numbers:
            self._numbers[name][here] = column

    def _angles(self, given: list[Any], here: slice) -> Array:
        """All angles of items one after the other, and how many are whose."""
        with suppress(TypeError, ValueError):  # raised for lists
            return np.fromiter(given, np.float64, len(given))
        arrays = [np.atleast_1d(np.array(angle, np.float64)) for angle in given]
        self._listed[here] = [type(angle) is list for angle in given]
        self._counts[here] = [array.size for array in arrays]
        return np.concatenate(arrays)

    def _name(self, name: str, said: list[str | None], here: slice) -> None:
        distinct = self._distinct[name]
        for text in dict.fromkeys(said):
            distinct.setdefault(text, len(distinct) - 1)
        if len(distinct) == 1:
            return  # all leave it out
        if name not in self._codes:
            self._codes[name] = np.full(self._size, -1)
        self._codes[name][here] = np.fromiter(map(distinct.__getitem__, said), np.intp, len(said))

    def items(self, reader: ItemReader) -> Items:
        """All that was added; columns that nobody gave are left out."""
        return Items(
            self._numbers,
            {
                name: Names(codes, [text for text in self._distinct[name] if text is not None])
                for name, codes in self._codes.items()
            },
            np.concatenate([np.zeros(0), *self._theta_i_deg]),
            self._counts,
            self._listed,
            self._malformed,
            reader,
        )


def _attribute(name: str) -> str:
    return name.replace(".", "__")
