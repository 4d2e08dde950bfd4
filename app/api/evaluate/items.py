"""The JSON body of `/evaluate`: items of one value or many, in columns."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import Any, Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from app.api.evaluate.pieces import MOST_VALUES, Piece, TooManyValues
from app.api.problems import BadParameters, unknown_parameter
from app.batch.rows import Fault, Index, Names, Rows, number_columns
from app.optics.parameters import THETA_I_DEG, Array
from app.optics.registry import Registry

_AT_A_TIME = 20_000
"""Items that exist as Python objects at a time."""

_PLACE = re.compile(r" - at `\$\.?([\w.]*)")
_UNKNOWN = re.compile(r"unknown field `(.*)`")


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
        fields: list[tuple[str, Any, Any]] = [("model", str, "exact"), ("quantity", str, "R")]
        for name, parameter in self._columns.items():
            kind: Any = float
            if name == THETA_I_DEG.name:
                kind = float | list[float]
            if parameter.choices:
                kind = float | Literal[tuple(choice for choice, _ in parameter.choices)]
            fields.append((_attribute(name), kind, math.nan))
        item = msgspec.defstruct(
            "Item",
            fields,
            rename=lambda attribute: attribute.replace("__", "."),
            forbid_unknown_fields=True,
            gc=False,
        )
        self._known = ["model", "quantity", *self._columns]
        self._one: msgspec.json.Decoder[Any] = msgspec.json.Decoder(item)
        self._many: msgspec.json.Decoder[Any] = msgspec.json.Decoder(list[item])  # type: ignore[valid-type]
        self._blank = item()

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
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
            message = f'{error}; a body reads {{"items": [{{"n_t": 1.5, "theta_i_deg": 60}}]}}'
            raise BadParameters({"parameter": "items", "value": None, "message": message}) from None
        if len(raw) > MOST_VALUES:
            raise TooManyValues(len(raw))
        gathered = _Gathered(list(self._columns), self._choices)
        for start in range(0, len(raw), _AT_A_TIME):
            part = raw[start : start + _AT_A_TIME]
            gathered.add(start, *self._decoded(part))
            if gathered.values > MOST_VALUES:
                raise TooManyValues(gathered.values)
        return gathered.items(raw, self)

    def _decoded(self, raw: list[msgspec.Raw]) -> tuple[list[Any], list[int]]:
        """Decode items, all at once where all can be, and say which cannot."""
        try:
            return self._many.decode(b"[" + b",".join(raw) + b"]"), []
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError):
            pass
        items, wrong = [], []
        for index, one in enumerate(raw):
            try:
                items.append(self._one.decode(one))
            except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError):
                items.append(self._blank)
                wrong.append(index)
        return items, wrong

    def fault(self, raw: msgspec.Raw) -> Fault:
        """Say what is wrong with an item that could not be decoded."""
        try:
            self._one.decode(raw)
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
            text = str(error)
        try:
            given = msgspec.json.decode(raw)
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError):
            given = None
        unknown, place = _UNKNOWN.search(text), _PLACE.search(text)
        name = unknown[1] if unknown else place[1] if place and place[1] else "items"
        value = given.get(name) if isinstance(given, dict) else given
        if isinstance(value, dict | list):
            value = None  # too much to repeat
        message = text.partition(" - at ")[0]
        if unknown:
            message = unknown_parameter(name, value, self._known)["message"]
        return Fault(name, value, message)


@dataclass(frozen=True, slots=True, eq=False)
class Items:
    """All items of a body in columns; one element an item, the angles one after the other."""

    numbers: dict[str, Array]
    names: dict[str, Names]
    theta_i_deg: Array
    counts: Index
    listed: NDArray[np.bool_]
    malformed: dict[int, msgspec.Raw]
    reader: ItemReader

    @property
    def values(self) -> int:
        """How many values they ask for."""
        return int(self.theta_i_deg.size)

    def pieces(self, size: int) -> Iterator[Piece]:
        """Part the items into pieces of about `size` values, each item whole."""
        ends = np.cumsum(self.counts)
        start = 0
        while start < self.counts.size:
            before = int(ends[start - 1]) if start else 0
            stop = max(start + 1, int(np.searchsorted(ends, before + size, side="right")))
            yield self._piece(start, min(stop, self.counts.size), before)
            start = stop

    def _piece(self, start: int, stop: int, before: int) -> Piece:
        counts = self.counts[start:stop]
        first = np.cumsum(counts) - counts
        rows = Rows(
            int(counts.sum()),
            {name: np.repeat(column[start:stop], counts) for name, column in self.numbers.items()}
            | {THETA_I_DEG.name: self.theta_i_deg[before : before + int(counts.sum())]},
            {
                name: Names(np.repeat(codes[start:stop], counts), distinct)
                for name, (codes, distinct) in self.names.items()
            },
            {
                int(first[item - start]): self.reader.fault(raw)
                for item, raw in self.malformed.items()
                if start <= item < stop
            },
        )
        return Piece(start, rows, counts, self.listed[start:stop])


class _Gathered:
    """Columns on their way to `Items`."""

    def __init__(self, columns: Sequence[str], choices: dict[str, dict[str, float]]) -> None:
        self._numbers: dict[str, list[Array]] = {
            name: [] for name in columns if name != THETA_I_DEG.name
        }
        self._choices = choices
        self._codes: dict[str, list[Index]] = {"model": [], "quantity": []}
        self._distinct: dict[str, dict[str, int]] = {"model": {}, "quantity": {}}
        self._theta: list[Array] = []
        self._counts: list[Index] = []
        self._listed: list[NDArray[np.bool_]] = []
        self._malformed: list[int] = []
        self.values = 0

    def add(self, start: int, items: list[Any], wrong: list[int]) -> None:
        """Append decoded items."""
        size = len(items)
        for name, parts in self._numbers.items():
            given: Iterable[Any] = map(attrgetter(_attribute(name)), items)
            choices = self._choices.get(name)
            if choices:
                given = (choices.get(value, value) for value in given)
            parts.append(np.fromiter(given, np.float64, size))
        for name, codes in self._codes.items():
            distinct = self._distinct[name]
            found = (distinct.setdefault(v, len(distinct)) for v in map(attrgetter(name), items))
            codes.append(np.fromiter(found, np.intp, size))
        angles = [item.theta_i_deg for item in items]
        listed = np.fromiter((type(angle) is list for angle in angles), np.bool_, size)
        self._listed.append(listed)
        if listed.any():
            arrays = [np.atleast_1d(np.array(angle, np.float64)) for angle in angles]
            self._counts.append(np.fromiter(map(len, arrays), np.intp, size))
            self._theta.append(np.concatenate(arrays))
        else:
            self._counts.append(np.ones(size, np.intp))
            self._theta.append(np.fromiter(angles, np.float64, size))
        self._malformed += [start + index for index in wrong]
        self.values += self._theta[-1].size

    def items(self, raw: list[msgspec.Raw], reader: ItemReader) -> Items:
        """All that was added; columns that nobody gave are left out."""
        empty = np.zeros(0)
        numbers = {name: np.concatenate(parts or [empty]) for name, parts in self._numbers.items()}
        return Items(
            {name: column for name, column in numbers.items() if not np.isnan(column).all()},
            {
                name: Names(
                    np.concatenate([*codes, np.zeros(0, np.intp)]), list(self._distinct[name])
                )
                for name, codes in self._codes.items()
            },
            np.concatenate(self._theta or [empty]),
            np.concatenate([*self._counts, np.zeros(0, np.intp)]),
            np.concatenate([*self._listed, np.zeros(0, np.bool_)]),
            {index: raw[index] for index in self._malformed},
            reader,
        )


def _attribute(name: str) -> str:
    return name.replace(".", "__")
