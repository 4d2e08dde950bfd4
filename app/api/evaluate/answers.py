"""How the values of `/evaluate` are written, piece by piece: as JSON, CSV or an Arrow stream."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

import numpy as np
import orjson

from app.api.evaluate.pieces import Piece
from app.api.responses import CONVENTION
from app.batch.rows import Fault, Outcome
from app.optics.parameters import Array

Evaluated = Iterable[tuple[Piece, Outcome]]

_LONGEST_VALUE = 200


class Writer(NamedTuple):
    """A way to write an answer."""

    media_type: str
    write: Callable[[Evaluated], Iterator[bytes]]


def write_json(evaluated: Evaluated) -> Iterator[bytes]:
    """`{"convention", "results", "failed"}`: an item's number, its list of numbers, or its error."""
    yield b'{"convention":' + orjson.dumps(CONVENTION) + b',"results":['
    failed, separator = 0, b""
    for piece, outcome in evaluated:
        wrong = _by_item(piece, outcome)
        failed += len(wrong)
        if piece.counts.size:
            yield separator + b",".join(_json_items(piece, outcome.values, wrong))
            separator = b","
    yield b'],"failed":%d}' % failed


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


def write_csv(evaluated: Evaluated) -> Iterator[bytes]:
    """One row a value, after its item's number and before what is wrong with it."""
    yield b"item,value,error\r\n"
    for piece, outcome in evaluated:
        wrong = _by_item(piece, outcome)
        items = np.repeat(np.arange(piece.first, piece.first + piece.counts.size), piece.counts)
        numbers = _json_numbers(outcome.values)[1:-1].replace(b"null", b"").split(b",")
        if wrong:
            told = {item: _csv_field(_sentence(fault)) for item, fault in wrong.items()}
            lines = [
                b"%d,,%s" % (item, told[item - piece.first])
                if item - piece.first in told
                else b"%d,%s," % (item, number)
                for item, number in zip(items.tolist(), numbers, strict=False)
            ]
        else:
            lines = [b"%d,%s," % pair for pair in zip(items.tolist(), numbers, strict=False)]
        if lines:
            yield b"\r\n".join(lines) + b"\r\n"


def _csv_field(text: str) -> bytes:
    field = io.StringIO()
    csv.writer(field, lineterminator="").writerow([text])
    return field.getvalue().encode()


def write_arrow(evaluated: Evaluated) -> Iterator[bytes]:
    """Columns `item`, `value` and `error`, one row a value, in one record batch a piece."""
    import pyarrow as pa

    schema = pa.schema([("item", pa.int32()), ("value", pa.float64()), ("error", pa.string())])
    sink = io.BytesIO()
    with pa.ipc.new_stream(sink, schema) as stream:
        for piece, outcome in evaluated:
            wrong = _by_item(piece, outcome)
            numbers = np.arange(piece.first, piece.first + piece.counts.size, dtype=np.int32)
            items = np.repeat(numbers, piece.counts)
            errors = pa.nulls(items.size, pa.string())
            values = outcome.values
            if wrong:
                told = {piece.first + item: _sentence(fault) for item, fault in wrong.items()}
                errors = pa.array([told.get(item) for item in items.tolist()], pa.string())
                values = np.where(np.isin(items, list(told)), np.nan, values)
            columns = [pa.array(items), pa.array(values, from_pandas=True), errors]
            stream.write_batch(pa.record_batch(columns, schema=schema))
            yield sink.getvalue()
            sink.seek(0)
            sink.truncate()
    yield sink.getvalue()


def _by_item(piece: Piece, outcome: Outcome) -> dict[int, Fault]:
    """The first fault of each item that has one, by its place in the piece."""
    if not outcome.faults:
        return {}
    rows = sorted(outcome.faults)
    items = np.searchsorted(np.cumsum(piece.counts), rows, side="right").tolist()
    wrong: dict[int, Fault] = {}
    for item, row in zip(items, rows, strict=True):
        wrong.setdefault(item, outcome.faults[row])
    return wrong


def _sentence(fault: Fault) -> str:
    parameter, value, message = _clipped(fault)
    return f"{parameter}: {message}" if value is None else f"{parameter} = {value}: {message}"


def _clipped(fault: Fault) -> Fault:
    """Shorten what a client sent, so that an answer is not a multiple of a hostile request."""
    parameter, value, message = fault
    if isinstance(value, str):
        value = value[:_LONGEST_VALUE]
    elif isinstance(value, float) and not np.isfinite(value):
        value = str(value)
    return Fault(parameter[:_LONGEST_VALUE], value, message)
