"""The Arrow body of `/evaluate`: columns of the items' names, one row a value."""

from __future__ import annotations

import importlib.util
import struct
from collections.abc import Callable, Iterator
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from app.api.evaluate.pieces import MOST_VALUES, Piece, TooManyValues
from app.batch.arrow import WrongColumn, rows_of
from app.http.problems import BadParameters
from app.optics.registry import Registry

if TYPE_CHECKING:
    import pyarrow as pa

MEDIA_TYPE = "application/vnd.apache.arrow.stream"

AVAILABLE = importlib.util.find_spec("pyarrow") is not None
"""Whether the extra `[arrow]` is installed."""


class Columns:
    """A table that has been read."""

    def __init__(self, table: pa.Table, registry: Registry) -> None:
        self._table = table
        self._registry = registry

    @property
    def values(self) -> int:
        """How many values it asks for."""
        return int(self._table.num_rows)

    def pieces(self, size: int) -> Iterator[Callable[[], Piece]]:
        """Part it into pieces of at most `size` rows."""
        first = 0
        for batch in self._table.to_batches(max_chunksize=size):
            yield partial(self._piece, first, batch)
            first += batch.num_rows

    def _piece(self, first: int, batch: pa.RecordBatch) -> Piece:
        rows, ones = rows_of(batch, self._registry), np.ones(batch.num_rows, np.intp)
        return Piece(first, rows, ones, np.zeros(batch.num_rows, np.bool_))


def read_arrow(body: bytes | bytearray, registry: Registry) -> Columns:
    """Read a stream.

    Raises
    ------
    BadParameters
        If it is none, or a column is not known or of another type.
    TooManyValues
        If it has more rows than may be asked at a time.
    """
    import pyarrow as pa

    try:
        _refuse_compressed(body)
        batches, values = [], 0
        with pa.ipc.open_stream(pa.py_buffer(body)) as stream:
            for batch in stream:
                values += batch.num_rows
                if values > MOST_VALUES:
                    raise TooManyValues
                batches.append(batch)
            table = pa.Table.from_batches(batches, stream.schema)
        table.validate(full=True)  # the offsets in a stream may point anywhere
        rows_of(pa.RecordBatch.from_pylist([], schema=table.schema), registry)
    except WrongColumn as error:
        raise BadParameters(
            {"parameter": error.column, "value": None, "message": error.message}
        ) from None
    except (pa.ArrowException, OSError, UnicodeDecodeError, struct.error) as error:
        message = f"no Arrow stream: {str(error)[:200]}"
        raise BadParameters({"parameter": "body", "value": None, "message": message}) from None
    return Columns(table, registry)


def _refuse_compressed(body: bytes | bytearray) -> None:
    """Refuse buffers that would be expanded: a small body could take all memory there is.

    Raises
    ------
    BadParameters
        If there are any.
    """
    import pyarrow as pa

    for message in pa.ipc.MessageReader.open_stream(pa.py_buffer(body)):
        if message.type in ("record batch", "dictionary"):
            head = message.metadata.to_pybytes()
            batch = _follow(head, _field(head, _follow(head, 0), _HEADER))
            if message.type == "dictionary":
                batch = _follow(head, _field(head, batch, _DATA))
            if _field(head, batch, _COMPRESSION):
                why = "a compressed stream, which is not read here; send it as it is"
                raise BadParameters({"parameter": "body", "value": None, "message": why})


# Numbers of fields in Message.fbs of Arrow's format: of a message, a dictionary, a record batch.
_HEADER, _DATA, _COMPRESSION = 2, 1, 3


def _field(data: bytes, table: int, number: int) -> int:
    """Where a field of a FlatBuffers table is, 0 if it is left out."""
    vtable = table - struct.unpack_from("<i", data, table)[0]
    entry = 4 + 2 * number
    if entry >= struct.unpack_from("<H", data, vtable)[0]:
        return 0
    offset: int = struct.unpack_from("<H", data, vtable + entry)[0]
    return table + offset if offset else 0


def _follow(data: bytes, position: int) -> int:
    target: int = position + struct.unpack_from("<I", data, position)[0]
    return target
