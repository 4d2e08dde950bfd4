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

_FEW_BATCHES = 16
_SMALL_BATCH = 16_384
"""Rows. Many batches that are smaller are put together first: each would be a piece of its own."""

AVAILABLE = importlib.util.find_spec("pyarrow") is not None
"""Whether the extra `[arrow]` is installed."""


class Columns:
    """A table that has been read."""

    def __init__(self, table: pa.Table, registry: Registry) -> None:
        self._table = table
        self._registry = registry

    @property
    def size(self) -> int:
        """Bytes that it takes, those of the body among them."""
        return int(self._table.get_total_buffer_size())

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
            rows_of(pa.RecordBatch.from_pylist([], schema=stream.schema), registry)
            for batch in stream:
                values += batch.num_rows
                if values > MOST_VALUES:
                    raise TooManyValues
                batches.append(batch)
            table = pa.Table.from_batches(batches, stream.schema)
        _validate(table)
        if (
            table.num_columns
            and len(batches) > _FEW_BATCHES
            and values < _SMALL_BATCH * len(batches)
        ):
            table = _put_together(table)
    except WrongColumn as error:
        raise BadParameters(
            {"parameter": error.column, "value": None, "message": error.message}
        ) from None
    except (pa.ArrowException, OSError, UnicodeDecodeError, struct.error) as error:
        message = f"no Arrow stream: {str(error)[:200]}"
        raise BadParameters({"parameter": "body", "value": None, "message": message}) from None
    return Columns(table, registry)


def _validate(table: pa.Table) -> None:
    """Check what is read, for the offsets in a stream may point anywhere; a dictionary once.

    Raises
    ------
    pyarrow.ArrowException
        If it is not what it says.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    known: set[tuple[int, ...]] = set()
    for chunk in (chunk for column in table.columns for chunk in column.chunks):
        if not isinstance(chunk, pa.DictionaryArray):
            chunk.validate(full=True)
            continue
        chunk.validate()
        chunk.indices.validate(full=True)
        reached = pc.min_max(chunk.indices)
        if chunk.null_count < len(chunk) and not (
            reached["min"].as_py() >= 0 and reached["max"].as_py() < len(chunk.dictionary)
        ):
            raise pa.ArrowInvalid("an index beyond its dictionary")
        if (where := _address(chunk.dictionary)) not in known:
            chunk.dictionary.validate(full=True)
            known.add(where)


def _put_together(table: pa.Table) -> pa.Table:
    """Make one batch of many.

    Batches often share a dictionary, each of which is taken once and as it is: to compare what is in
    them would take as long as a hundred batches have entries together.
    """
    import pyarrow as pa

    columns = []
    for column in table.columns:
        if not pa.types.is_dictionary(column.type):
            columns.append(column.combine_chunks())
            continue
        starts: dict[tuple[int, ...], int] = {}
        dictionaries, indices, size = [], [], 0
        for chunk in column.chunks:
            where = _address(chunk.dictionary)
            if where not in starts:
                starts[where] = size
                dictionaries.append(chunk.dictionary)
                size += len(chunk.dictionary)
            part = chunk.indices.cast(pa.int64()).fill_null(-1).to_numpy(zero_copy_only=False)
            indices.append(np.where(part < 0, -1, part + starts[where]))
        codes = np.concatenate(indices)
        columns.append(
            pa.DictionaryArray.from_arrays(
                pa.array(codes, mask=codes < 0), pa.concat_arrays(dictionaries)
            )
        )
    return pa.table(columns, names=table.schema.names)


def _address(dictionary: pa.Array) -> tuple[int, ...]:
    buffers = [buffer for buffer in dictionary.buffers() if buffer is not None]
    place = dictionary.offset, len(dictionary)
    return *place, *(number for buffer in buffers for number in (buffer.address, buffer.size))


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
