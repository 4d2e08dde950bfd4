"""The JSON body of `/evaluate`: items of one value or many, in columns."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any, Literal, NamedTuple

import msgspec
import numpy as np

from app.api.evaluate.item_bounds import after_comma, end_of_item, refuse_unlike_angles, within
from app.api.evaluate.item_columns import Faults, Gathered, Items, attribute_of
from app.api.evaluate.pieces import MOST_TOLD, MOST_VALUES, TooManyValues
from app.batch.rows import ANGLES, NAMES, THREE, Fault, Hints, number_columns
from app.http.problems import BadParameters, unknown_parameter
from app.optics.meant import instead
from app.optics.parameters import THETA_I_DEG, THETA_I_RAD
from app.optics.registry import Registry

_WINDOW = 250_000
"""Bytes of items that exist as Python objects at a time."""

_DECODERS = 64
"""Decoders that are kept, each of items with columns of their own."""

_SAMPLE = 4_000
"""Bytes at three places that are looked at to see which columns all items of a window may have."""

_LONGEST_SHOWN = 10_000
"""Bytes of an item that is wrong and whose value is told."""

_MOST_KINDS = 2 * MOST_TOLD
_SOMETHING = Fault("items", None, "")
"""What is said of an item that is wrong in a way of its own, when many others were before it."""

_RAWS = msgspec.json.Decoder(list[msgspec.Raw])
_KEY = re.compile(rb'"([\w.]+)"\s*:')
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
        if name in ANGLES:
            kind = float | list[float]
        if self._columns[name].choices:
            kind = float | Literal[tuple(choice for choice, _ in self._columns[name].choices)]
        return attribute_of(name), kind, math.nan

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
            start, stop = within(body, raw)
        except _UNREADABLE as error:
            message = f'{error}; a body reads {{"items": [{{"n_t": 1.5, "theta_i_deg": 60}}]}}'
            raise BadParameters({"parameter": "items", "value": None, "message": message}) from None
        gathered = Gathered(self._choices)
        wrong = _Wrong(self)
        while start < stop:
            at = gathered.size
            read, start = self._window(body, start, stop, partial(wrong.add, at))
            fields = gathered.add(read.items, read.columns)
            for index in gathered.twice:
                wrong.two_angles(at + index)
            if fields != read.fields:
                for index, name in read.repeated():
                    wrong.repeated(at + index, name)
            if max(gathered.values, gathered.size) > MOST_VALUES:
                raise TooManyValues
        return gathered.items(wrong.faults())

    def _window(
        self, body: bytes | bytearray, start: int, stop: int, refuse: _Refuse
    ) -> tuple[_Window, int]:
        """Decode as many items as a window has room for, and say where the next ones begin.

        Where it ends is a guess, for an item ends with a brace and a comma, but so may a string in it.
        If what is before it are items and nothing else, it was right; if not, more is taken.
        """
        end = end_of_item(body, start, stop, _WINDOW)
        while True:
            if end - start > 1.2 * _WINDOW:
                refuse_unlike_angles(body, start, end)
            text = b"".join((b"[", memoryview(body)[start:end], b"]"))
            try:
                return self._decoded(text, refuse), after_comma(body, end, stop)
            except _UNREADABLE:
                if end == stop:
                    raise
            end = end_of_item(body, start, stop, 2 * (end - start))

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

    def two_angles(self, index: int) -> None:
        """Take an item that gives its angle in degrees and in radians."""
        message = f"given beside {THETA_I_RAD.name}, which takes its place; leave one out"
        self._append(index, Fault(THETA_I_DEG.name, None, message))

    def _append(self, index: int, fault: Fault) -> None:
        if fault not in self._kinds and len(self._kinds) >= _MOST_KINDS:
            fault = _SOMETHING
        self._items.append(index)
        self._codes.append(self._kinds.setdefault(fault, len(self._kinds)))

    def faults(self) -> Faults:
        """Return what tells of the items in a range which are wrong."""
        order = np.argsort(self._items, kind="stable")
        items = np.array(self._items, np.intp)[order]
        codes, kinds = np.array(self._codes, np.intp)[order], list(self._kinds)

        def between(start: int, stop: int) -> Iterator[tuple[int, Fault]]:
            those = slice(*np.searchsorted(items, (start, stop)).tolist())
            for item, code in zip(items[those].tolist(), codes[those].tolist(), strict=True):
                yield item, kinds[code]

        return between


def _named(text: str) -> tuple[str, bool]:
    """The field that a decoder's message is about, and whether it is an unknown one."""
    unknown, place = _UNKNOWN.search(text), _PLACE.search(text)
    if unknown:
        return unknown[1], True
    return (place[1] if place and place[1] else "items"), False
