"""How the values of `/evaluate` are written, piece by piece: as JSON, CSV or an Arrow stream."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import orjson

from app.answers.interface import CONVENTION
from app.api.evaluate.pieces import Piece
from app.batch.evaluation import Outcome
from app.batch.rows import Fault
from app.optics.parameters import Array

if TYPE_CHECKING:
    import pyarrow as pa

_LONGEST_VALUE = 200


class Writer(NamedTuple):
    """A way to write an answer; pieces are written apart from one another, in any order."""

    media_type: str
    """The kind of content."""
    head: Callable[[], bytes]
    """Returns what comes first."""
    piece: Callable[[Piece, Outcome], bytes]
    """Returns what stands for a piece and its outcome."""
    tail: Callable[[int], bytes]
    """Returns what comes last, from the number of items that were wrong."""


def _json_head() -> bytes:
    return b'{"convention":' + orjson.dumps(CONVENTION) + b',"results":['


def _json_piece(piece: Piece, outcome: Outcome) -> bytes:
    """An item's number, its list of numbers, or its error."""
    if piece.counts.size == 0:
        return b""
    items = b",".join(_json_items(piece, outcome.values, by_item(piece, outcome)))
    return b"," + items if piece.first else items


def _json_tail(failed: int) -> bytes:
    return b'],"failed":%d}' % failed


def _json_items(piece: Piece, values: Array, wrong: dict[int, Fault]) -> Iterator[bytes]:
    if not wrong and not piece.listed.any():
        yield _json_numbers(values)[1:-1]
        return
    stops = np.cumsum(piece.counts).tolist()
    for item, (stop, count, listed) in enumerate(
        zip(stops, piece.counts.tolist(), piece.listed.tolist(), strict=True)
    ):
        if item in wrong:
            yield _json_fault(piece.first + item, wrong[item])
        else:
            numbers = _json_numbers(values[stop - count : stop])
            yield numbers if listed else numbers[1:-1]


def _json_numbers(values: Array) -> bytes:
    return orjson.dumps(values, option=orjson.OPT_SERIALIZE_NUMPY)


def _json_fault(index: int, fault: Fault) -> bytes:
    parameter, value, message = _clipped(fault)
    error = {"parameter": parameter, "value": value, "message": message}
    return orjson.dumps({"index": index, "errors": [error]})


def _csv_piece(piece: Piece, outcome: Outcome) -> bytes:
    """One row a value, after its item's number and before what is wrong with it."""
    if outcome.values.size == 0:
        return b""
    wrong = by_item(piece, outcome)
    items = np.repeat(np.arange(piece.first, piece.first + piece.counts.size), piece.counts)
    numbers = _json_numbers(outcome.values)[1:-1].replace(b"null", b"").split(b",")
    if not wrong:
        lines = [b"%d,%s," % pair for pair in zip(items.tolist(), numbers, strict=True)]
    else:
        told = {piece.first + i: _csv_field(str(_clipped(fault))) for i, fault in wrong.items()}
        lines = [
            b"%d,,%s" % (item, told[item]) if item in told else b"%d,%s," % (item, number)
            for item, number in zip(items.tolist(), numbers, strict=True)
        ]
    return b"\r\n".join(lines) + b"\r\n"


def _csv_field(text: str) -> bytes:
    field = io.StringIO()
    csv.writer(field, lineterminator="").writerow([text])
    return field.getvalue().encode()


def _arrow_schema() -> pa.Schema:
    import pyarrow as pa

    return pa.schema([("item", pa.int32()), ("value", pa.float64()), ("error", pa.string())])


def _arrow_head() -> bytes:
    return bytes(_arrow_schema().serialize())


def _arrow_piece(piece: Piece, outcome: Outcome) -> bytes:
    """A record batch with one row a value."""
    import pyarrow as pa

    wrong = by_item(piece, outcome)
    numbers = np.arange(piece.first, piece.first + piece.counts.size, dtype=np.int32)
    items, values = np.repeat(numbers, piece.counts), outcome.values
    errors = pa.nulls(items.size, pa.string())
    if wrong:
        told = {piece.first + item: str(_clipped(fault)) for item, fault in wrong.items()}
        errors = pa.array([told.get(item) for item in items.tolist()], pa.string())
        values = np.where(np.isin(items, list(told)), np.nan, values)
    columns = [pa.array(items), pa.array(values, from_pandas=True), errors]
    return bytes(pa.record_batch(columns, schema=_arrow_schema()).serialize())


def _arrow_tail(_: int) -> bytes:
    return b"\xff\xff\xff\xff\x00\x00\x00\x00"  # the format's mark of the end


JSON = Writer("application/json", _json_head, _json_piece, _json_tail)
CSV = Writer("text/csv; charset=utf-8", lambda: b"item,value,error\r\n", _csv_piece, lambda _: b"")
ARROW = Writer("application/vnd.apache.arrow.stream", _arrow_head, _arrow_piece, _arrow_tail)


def by_item(piece: Piece, outcome: Outcome) -> dict[int, Fault]:
    """The first fault of each item that has one, by its place in the piece."""
    if not outcome.faults:
        return {}
    rows = sorted(outcome.faults)
    items = np.searchsorted(np.cumsum(piece.counts), rows, side="right").tolist()
    wrong: dict[int, Fault] = {}
    for item, row in zip(items, rows, strict=True):
        wrong.setdefault(item, outcome.faults[row])
    return wrong


def _clipped(fault: Fault) -> Fault:
    """Shorten what a client sent, so that an answer is not a multiple of a hostile request."""
    parameter, value, message = fault
    if isinstance(value, str):
        value = value[:_LONGEST_VALUE]
    elif isinstance(value, float) and not np.isfinite(value):
        value = str(value)
    return Fault(parameter[:_LONGEST_VALUE], value, message)
