"""The JSON body of `/evaluate`: items of one value or many, in columns."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache, partial
from operator import attrgetter
from typing import Any, Generic, Literal, NamedTuple, TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from app.api.evaluate.pieces import MOST_TOLD, MOST_VALUES, Piece, TooManyValues
from app.batch.rows import NAMES, THREE, Fault, Hints, Index, Names, Rows, number_columns
from app.http.problems import BadParameters, unknown_parameter
from app.optics.meant import instead
from app.optics.parameters import THETA_I_DEG, Array
from app.optics.registry import Registry

_WINDOW = 250_000
"""Bytes of items that exist as Python objects at a time."""

T = TypeVar("T", bound=np.generic)

_DECODERS = 64
"""Decoders that are kept, each of items with columns of their own."""

_SAMPLE = 4_000
"""Bytes at three places that are looked at to see which columns all items of a window may have."""

_MOST_NAMES = 50_000
"""Different names in a column: each is kept as a Python object."""

_LONGEST_SHOWN = 10_000
"""Bytes of an item that is wrong and whose value is told."""

_LONGEST_ANGLE = 100
"""Bytes of an angle in a long item, blanks before it included."""

_MOST_KINDS = 2 * MOST_TOLD
_SOMETHING = Fault("items", None, "")
"""What is said of an item that is wrong in a way of its own, when many others were before it."""

_RAWS = msgspec.json.Decoder(list[msgspec.Raw])
_KEY = re.compile(rb'"([\w.]+)"\s*:')
_END_OF_ITEM = re.compile(rb"\}[ \t\r\n]*,")
_SPACE = re.compile(rb"[ \t\r\n]*")
_PARTS = msgspec.json.Decoder(dict[str, msgspec.Raw])
_COLON = ord(":")

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
    """The body, with all items as the bytes they were sent as."""

    items: msgspec.Raw


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
            start, stop = _within(body, raw)
        except _UNREADABLE as error:
            message = f'{error}; a body reads {{"items": [{{"n_t": 1.5, "theta_i_deg": 60}}]}}'
            raise BadParameters({"parameter": "items", "value": None, "message": message}) from None
        gathered = _Gathered(self._choices)
        wrong = _Wrong(self)
        while start < stop:
            at = gathered.size
            read, start = self._window(body, start, stop, partial(wrong.add, at))
            fields = gathered.add(read.items, read.columns)
            if fields != read.fields:
                for index, name in read.repeated():
                    wrong.repeated(at + index, name)
            if max(gathered.values, gathered.size) > MOST_VALUES:
                raise TooManyValues
        return gathered.items(wrong)

    def _window(
        self, body: bytes | bytearray, start: int, stop: int, refuse: _Refuse
    ) -> tuple[_Window, int]:
        """Decode as many items as a window has room for, and say where the next ones begin.

        Where it ends is a guess, for an item ends with a brace and a comma, but so may a string in it.
        If what is before it are items and nothing else, it was right; if not, more is taken.
        """
        end = _end_of_item(body, start, stop, _WINDOW)
        while True:
            if end - start > 1.2 * _WINDOW:
                _refuse_unlike_angles(body, start, end)
            text = b"".join((b"[", memoryview(body)[start:end], b"]"))
            try:
                return self._decoded(text, refuse), _after_comma(body, end, stop)
            except _UNREADABLE:
                if end == stop:
                    raise
            end = _end_of_item(body, start, stop, 2 * (end - start))

    def _decoded(self, text: bytes, refuse: _Refuse) -> _Window:
        """Decode items; those that cannot be decoded are told to `refuse`, with the reason."""
        fields = int(np.count_nonzero(np.frombuffer(text, np.uint8) == _COLON))
        for decoder in (self._decoder_of(self._columns_of_some(text)), self._all):
            with suppress(*_UNREADABLE):
                return _Window(text, decoder.many.decode(text), decoder.columns, fields)
        raws = _RAWS.decode(text)
        window = _Window(text, [], self._all.columns, -1)
        for index, one in enumerate(raws):
            try:
                window.items.append(self._all.one.decode(one))
            except _UNREADABLE as error:
                window.items.append(self._all.blank)
                refuse(index, one, str(error))
        return window

    def _columns_of_some(self, text: bytes) -> frozenset[str]:
        """The columns of a few items, most often those of all: with no more, all are read faster."""
        middle = len(text) // 2
        some = (text[:_SAMPLE], text[middle : middle + _SAMPLE], text[-_SAMPLE:])
        columns = {name.decode() for part in some for name in _KEY.findall(part)}
        return frozenset(columns.intersection(self._known))

    def fault(self, raw: msgspec.Raw, text: str, hints: Hints) -> Fault:
        """Say what is wrong with an item that could not be decoded, from what the decoder said."""
        given = None
        if memoryview(raw).nbytes <= _LONGEST_SHOWN:
            with suppress(*_UNREADABLE):
                given = msgspec.json.decode(raw)
        name, unknown = _named(text)
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


@dataclass(slots=True)
class _Window:
    """Some items, decoded."""

    text: bytes
    items: list[Any]
    columns: list[str]
    """Those that the items may hold."""
    fields: int
    """Colons in the text: that many fields were given, unless there are some in strings."""

    def repeated(self) -> Iterator[tuple[int, str]]:
        """Yield the items that give a field more than once, and the field."""
        for index, raw in enumerate(_RAWS.decode(self.text)):
            text = bytes(raw)
            if text.count(b":") < 2:
                continue
            try:
                if text.count(b":") == len(_PARTS.decode(text)):
                    continue
                pairs: list[tuple[str, Any]] = json.loads(text, object_pairs_hook=list)
            except (*_UNREADABLE, ValueError):
                continue  # it was refused for that
            seen: set[str] = set()
            for name, _ in pairs:
                if name in seen:
                    yield index, name
                    break
                seen.add(name)


_Refuse = Callable[[int, msgspec.Raw, str], None]
"""Takes the number of an item in its window, the item, and what the decoder said."""


class _Wrong:
    """Items that cannot be read: what of it of the first ones, of the others in which field."""

    def __init__(self, reader: ItemReader) -> None:
        self._reader = reader
        self._hints = Hints()
        self._kinds: dict[Fault, int] = {}
        self._items: list[int] = []
        self._codes: list[int] = []

    def add(self, start: int, index: int, raw: msgspec.Raw, text: str) -> None:
        """Take an item of a window that could not be decoded and what the decoder said."""
        if len(self._items) < MOST_TOLD:
            self._append(start + index, self._reader.fault(raw, text, self._hints))
        else:
            self._append(start + index, Fault(_named(text)[0], None, ""))

    def repeated(self, index: int, name: str) -> None:
        """Take an item that gives a field more than once."""
        self._append(index, Fault(name, None, "given more than once"))

    def _append(self, index: int, fault: Fault) -> None:
        if fault not in self._kinds and len(self._kinds) >= _MOST_KINDS:
            fault = _SOMETHING
        self._items.append(index)
        self._codes.append(self._kinds.setdefault(fault, len(self._kinds)))

    def faults(self) -> Callable[[int, int], Iterator[tuple[int, Fault]]]:
        """Return what tells of the items in a range which are wrong."""
        order = np.argsort(self._items, kind="stable")
        items = np.array(self._items, np.intp)[order]
        codes, kinds = np.array(self._codes, np.intp)[order], list(self._kinds)

        def between(start: int, stop: int) -> Iterator[tuple[int, Fault]]:
            those = slice(*np.searchsorted(items, (start, stop)).tolist())
            for item, code in zip(items[those].tolist(), codes[those].tolist(), strict=True):
                yield item, kinds[code]

        return between


@dataclass(frozen=True, slots=True, eq=False)
class Items:
    """All items of a body in columns; one element an item, the angles one after the other."""

    numbers: dict[str, Array]
    names: dict[str, Names]
    theta_i_deg: Array
    counts: Index
    listed: NDArray[np.bool_]
    wrong: Callable[[int, int], Iterator[tuple[int, Fault]]]
    """Tells of the items in a range which cannot be read, and why."""

    @property
    def size(self) -> int:
        """Bytes that they take."""
        columns = [*self.numbers.values(), self.theta_i_deg, self.counts, self.listed]
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

        rows = Rows(
            int(counts.sum()),
            {name: spread(column) for name, column in self.numbers.items()}
            | {THETA_I_DEG.name: self.theta_i_deg[before : before + int(counts.sum())]},
            {
                name: Names(spread(codes), distinct)
                for name, (codes, distinct) in self.names.items()
            },
            {int(first[item - start]): fault for item, fault in self.wrong(start, stop)},
        )
        return Piece(start, rows, counts, listed)


class _Gathered:
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
        self._theta_i_deg: list[Array] = []
        self._counts: list[Index] = []
        self._listed: list[NDArray[np.bool_]] = []
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
        theta = np.full(size, np.nan)
        counts, listed = np.ones(size, np.intp), np.zeros(size, np.bool_)
        for name in columns:
            given: Iterable[Any] = map(attrgetter(_attribute(name)), items)
            if name in NAMES:
                colons += self._name(name, list(given))
            elif name == THETA_I_DEG.name:
                theta, counts, listed = _angles(list(given))
                # A list is given even if it is empty, and a number unless it is NaN.
                colons += int(np.count_nonzero(listed)) + _given(theta[np.repeat(~listed, counts)])
            else:
                colons += self._number(name, given, size)
        self._theta_i_deg.append(theta)
        self._counts.append(counts)
        self._listed.append(listed)
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

    def items(self, wrong: _Wrong) -> Items:
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
            np.concatenate([np.zeros(0), *self._theta_i_deg]),
            np.concatenate([np.zeros(0, np.intp), *self._counts]),
            np.concatenate([np.zeros(0, np.bool_), *self._listed]),
            wrong.faults(),
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


def _angles(given: list[Any]) -> tuple[Array, Index, NDArray[np.bool_]]:
    """All angles of items one after the other, how many are whose, and who gave a list."""
    size = len(given)
    with suppress(TypeError, ValueError):  # raised for lists
        ones, zeros = np.ones(size, np.intp), np.zeros(size, np.bool_)
        return np.fromiter(given, np.float64, size), ones, zeros
    arrays = [np.atleast_1d(np.array(angle, np.float64)) for angle in given]
    listed = np.array([type(angle) is list for angle in given])
    return np.concatenate(arrays), np.array([array.size for array in arrays]), listed


def _within(body: bytes | bytearray, raw: msgspec.Raw) -> tuple[int, int]:
    """Where the items of a body are, between their brackets.

    Raises
    ------
    msgspec.MsgspecError
        If they are no list, or there twice.
    """
    here = np.frombuffer(raw, np.uint8)
    start = here.ctypes.data - np.frombuffer(body, np.uint8).ctypes.data
    if not body.startswith(b"[", start):
        raise msgspec.ValidationError("Expected `array` of items")
    if body.count(b":", 0, start) > 1:
        raise msgspec.ValidationError("`items` is given more than once")
    first = _SPACE.match(body, start + 1)
    return (first.end() if first else 0), start + here.size - 1


def _refuse_unlike_angles(body: bytes | bytearray, start: int, end: int) -> None:
    """Refuse a long item that cannot be one of many angles, before it becomes Python objects.

    Raises
    ------
    TooManyValues
        If it has more commas than there may be angles.
    BadParameters
        If it has so few that it has to hold something else.
    """
    commas = body.count(b",", start, end)
    if commas > MOST_VALUES + 100:
        raise TooManyValues
    if end - start > _LONGEST_ANGLE * (commas + 1):
        message = f"an item of {end - start} bytes, which is not one of many angles"
        raise BadParameters({"parameter": "items", "value": None, "message": message})


def _end_of_item(body: bytes | bytearray, start: int, stop: int, size: int) -> int:
    """Where an item may end that is about `size` bytes further on, or the end of all."""
    if start + size >= stop:
        return stop
    last = body.rfind(b"},", start + size // 2, start + size)
    if last >= 0:
        return last + 1
    found = _END_OF_ITEM.search(body, start + size // 2, stop)
    return found.start() + 1 if found else stop


def _after_comma(body: bytes | bytearray, end: int, stop: int) -> int:
    return stop if end == stop else body.index(b",", end) + 1


def _named(text: str) -> tuple[str, bool]:
    """The field that a decoder's message is about, and whether it is an unknown one."""
    unknown, place = _UNKNOWN.search(text), _PLACE.search(text)
    if unknown:
        return unknown[1], True
    return (place[1] if place and place[1] else "items"), False


def _attribute(name: str) -> str:
    return name.replace(".", "__")
