"""How the values of `/evaluate` are written, piece by piece: as JSON, CSV or an Arrow stream."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache, partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import orjson
from numpy.typing import NDArray

from app.answers.films import CONVENTION_OF_ROWS
from app.api.evaluate.pieces import MOST_TOLD, Piece
from app.batch.evaluation import Outcome
from app.batch.rows import Fault
from app.optics.parameters import Array

if TYPE_CHECKING:
    import pyarrow as pa

_LONGEST_VALUE = 200
_LONGEST_MESSAGE = 1000
_MOST_BITS = 63


_ROWS = 65_536
"""Rows that are written at a time."""

_Part = Callable[[NDArray[np.int32], Array, Mapping[int, str]], bytes]
"""Writes rows: their items, their values, and what is said of those that are wrong."""


class Written(NamedTuple):
    """A piece of an answer."""

    body: bytes
    """What is sent."""
    told: int = 0
    """How many faults it tells in full."""


class Writer(NamedTuple):
    """A way to write an answer, piece by piece.

    Faults are told in full until `MOST_TOLD` have been, so that an answer is no multiple of what was
    sent; after that it is said that something is wrong, and the last piece counts.
    """

    media_type: str
    """The kind of content."""
    head: Callable[[], bytes]
    """Returns what comes first."""
    piece: Callable[[Piece, Array, Mapping[int, Fault], int], Written]
    """Returns what stands for a piece, from its values, the faults of its items and how many more may
    be told in full."""
    tail: Callable[[Counter[str]], bytes]
    """Returns what comes last, from how many items were wrong in which parameter."""


def _json_head() -> bytes:
    return b'{"convention":' + orjson.dumps(CONVENTION_OF_ROWS) + b',"results":['


def _json_piece(piece: Piece, values: Array, wrong: Mapping[int, Fault], left: int) -> Written:
    """An item's number, its list of numbers, or its error."""
    if piece.counts.size == 0:
        return Written(b"")
    items = b",".join(_json_items(piece, values, wrong, left))
    return Written(b"," + items if piece.first else items, min(left, len(wrong)))


def _json_tail(failed: Counter[str]) -> bytes:
    if failed.total() <= MOST_TOLD:
        return b'],"failed":%d}' % failed.total()
    return b'],"failed":%d,"failed_by":%s}' % (failed.total(), orjson.dumps(failed))


def _json_items(
    piece: Piece, values: Array, wrong: Mapping[int, Fault], left: int
) -> Iterator[bytes]:
    if not wrong and not piece.listed.any():
        yield _json_numbers(values)[1:-1]
        return
    stops = np.cumsum(piece.counts).tolist()
    for item, (stop, count, listed) in enumerate(
        zip(stops, piece.counts.tolist(), piece.listed.tolist(), strict=True)
    ):
        if item in wrong:
            told = _json_error(wrong[item]) if left > 0 else b""
            left -= 1
            yield b'{"index":%d,"errors":[%s]}' % (piece.first + item, told)
        else:
            numbers = _json_numbers(values[stop - count : stop])
            yield numbers if listed else numbers[1:-1]


def _json_numbers(values: Array) -> bytes:
    return orjson.dumps(values, option=orjson.OPT_SERIALIZE_NUMPY)


def _json_error(fault: Fault) -> bytes:
    return orjson.dumps(_clipped(fault)._asdict())


def _texts(items: list[int], wrong: Mapping[int, Fault], left: int) -> dict[int, str]:
    """What is said of rows that are wrong, from the item of each row."""
    told: dict[int, str] = {}
    for row, item in enumerate(items):
        if item in wrong:
            fault = wrong[item]
            short = f"{fault.parameter[:_LONGEST_VALUE]}: wrong; {MOST_TOLD} rows are told in full"
            told[row] = short if len(told) >= left else str(_clipped(fault))
    return told


def _in_parts(
    write: _Part, piece: Piece, values: Array, wrong: Mapping[int, Fault], left: int
) -> Written:
    """Write the rows of a piece, not too many of them at a time."""
    items = np.repeat(np.arange(piece.counts.size, dtype=np.int32), piece.counts)
    parts, told = [], 0
    for start in range(0, items.size, _ROWS):
        those = slice(start, start + _ROWS)
        texts = _texts(items[those].tolist(), wrong, left - told) if wrong else {}
        told += min(left - told, len(texts))
        parts.append(write(items[those] + np.int32(piece.first), values[those], texts))
    return Written(b"".join(parts), told)


def _csv_rows(items: NDArray[np.int32], values: Array, told: Mapping[int, str]) -> bytes:
    """One row a value, after its item's number and before what is wrong with it."""
    numbers = _json_numbers(values)[1:-1].replace(b"null", b"").split(b",")
    if not told:
        lines = [b"%d,%s," % pair for pair in zip(items.tolist(), numbers, strict=True)]
    else:
        lines = [
            b"%d,,%s" % (item, _csv_field(told[row])) if row in told else b"%d,%s," % (item, number)
            for row, (item, number) in enumerate(zip(items.tolist(), numbers, strict=True))
        ]
    return b"\r\n".join(lines) + b"\r\n"


@lru_cache(256)
def _csv_field(text: str) -> bytes:
    field = io.StringIO()
    csv.writer(field, lineterminator="").writerow([text])
    return field.getvalue().encode()


def _arrow_schema() -> pa.Schema:
    import pyarrow as pa

    return pa.schema([("item", pa.int32()), ("value", pa.float64()), ("error", pa.string())])


def _arrow_head() -> bytes:
    return bytes(_arrow_schema().serialize())


def _arrow_rows(items: NDArray[np.int32], values: Array, told: Mapping[int, str]) -> bytes:
    """A record batch with one row a value."""
    import pyarrow as pa

    errors = pa.nulls(items.size, pa.string())
    if told:
        errors = pa.array(map(told.get, range(items.size)), pa.string())
        values = values.copy()
        values[list(told)] = np.nan
    columns = [pa.array(items), pa.array(values, from_pandas=True), errors]
    return bytes(pa.record_batch(columns, schema=_arrow_schema()).serialize())


def _arrow_tail(_: Counter[str]) -> bytes:
    return b"\xff\xff\xff\xff\x00\x00\x00\x00"  # the format's mark of the end


JSON = Writer("application/json", _json_head, _json_piece, _json_tail)
CSV = Writer(
    "text/csv; charset=utf-8",
    lambda: b"item,value,error\r\n",
    partial(_in_parts, _csv_rows),
    lambda _: b"",
)
ARROW = Writer(
    "application/vnd.apache.arrow.stream", _arrow_head, partial(_in_parts, _arrow_rows), _arrow_tail
)


def by_item(piece: Piece, outcome: Outcome, start: int = 0) -> dict[int, Fault]:
    """The first fault of each item that has one, by its place in the piece.

    The outcome is that of the piece's rows from number `start` on.
    """
    if not outcome.faults:
        return {}
    rows = np.array(sorted(outcome.faults), np.intp)
    items = np.searchsorted(np.cumsum(piece.counts), rows + start, side="right").tolist()
    wrong: dict[int, Fault] = {}
    for item, row in zip(items, rows.tolist(), strict=True):
        wrong.setdefault(item, outcome.faults[row])
    return wrong


def _clipped(fault: Fault) -> Fault:
    """Shorten what a client sent, so that an answer is not a multiple of a hostile request."""
    parameter, value, message = fault
    if isinstance(value, str):
        value = value[:_LONGEST_VALUE]
    elif isinstance(value, float) and not np.isfinite(value):
        value = str(value)
    elif isinstance(value, int) and value.bit_length() > _MOST_BITS:  # JSON here has no longer ones
        value = str(value)[:_LONGEST_VALUE] if value.bit_length() < 10_000 else None
    return Fault(parameter[:_LONGEST_VALUE], value, message[:_LONGEST_MESSAGE])
