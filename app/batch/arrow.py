"""Rows from Arrow record batches: what the API receives and files are read as."""

from __future__ import annotations

from difflib import get_close_matches
from typing import TYPE_CHECKING

import numpy as np

from app.batch.rows import NAMES, THREE, Fault, Names, Rows, number_columns
from app.optics.meant import in_our_unit
from app.optics.parameters import Array
from app.optics.registry import Registry

if TYPE_CHECKING:
    import pyarrow as pa


class WrongColumn(Exception):
    """A column that is not known or cannot be read."""

    def __init__(self, column: str, message: str) -> None:
        super().__init__(f"{column}: {message}")
        self.column = column
        self.message = message


def rows_of(batch: pa.RecordBatch, registry: Registry) -> Rows:
    """Read a record batch; null stands for what is left out.

    Raises
    ------
    WrongColumn
        If a column has a name that is not known or twice, or a type that is none of its own.
    """
    import pyarrow as pa
    import pyarrow.compute as pc

    known = number_columns(registry)
    every = [*known, *NAMES]
    numbers: dict[str, Array] = {}
    names: dict[str, Names] = {}
    faults: dict[int, Fault] = {}
    for name in batch.schema.names:
        if name not in known and name not in NAMES:
            nearest = get_close_matches(name, every, n=3)
            hint = f"nearest: {', '.join(nearest)}; " if nearest else ""
            hint += f"known: {', '.join(every)}"
            raise WrongColumn(name, f"unknown column; {in_our_unit(name, known) or hint}")
        if batch.schema.names.count(name) > 1:
            raise WrongColumn(name, "there twice")
        column = batch.column(name)
        if name in NAMES:
            names[name] = _names(name, column)
            continue
        choices = dict(known[name].choices)
        if choices and _is_text(column.type):
            codes, distinct = _names(name, column)
            worth = np.array([choices.get(choice, -1.0) for choice in distinct] + [np.nan])
            numbers[name] = worth[codes]
            continue
        kind = column.type
        if not (pa.types.is_integer(kind) or pa.types.is_floating(kind) or pa.types.is_null(kind)):
            hint = f"; {THREE}" if known[name].triple and pa.types.is_nested(kind) else ""
            raise WrongColumn(name, f"of type {kind}; numbers are wanted{hint}")
        column = pc.cast(column, pa.float64(), safe=False)
        if column.null_count < len(column) and pc.any(pc.is_nan(column)).as_py():
            fault = Fault(name, "nan", known[name].allowed)
            which = np.flatnonzero(
                pc.is_nan(column).fill_null(False).to_numpy(zero_copy_only=False)
            )
            faults |= dict.fromkeys(which.tolist(), fault)
        numbers[name] = column.to_numpy(zero_copy_only=False)
    return Rows(batch.num_rows, numbers, names, faults)


def _names(name: str, column: pa.Array) -> Names:
    """Turn a column of text into codes."""
    import pyarrow as pa

    if not _is_text(column.type):
        raise WrongColumn(name, f"of type {column.type}; text is wanted")
    if not pa.types.is_dictionary(column.type):
        column = column.dictionary_encode()
    codes = column.indices.cast(pa.int64()).fill_null(-1).to_numpy(zero_copy_only=False)
    distinct = column.dictionary.to_pylist()
    # A dictionary of its own may hold null, or what no row says.
    if None in distinct:
        codes = np.where(codes == distinct.index(None), -1, codes)
    return Names(codes.astype(np.intp), [text or "" for text in distinct])


def _is_text(kind: pa.DataType) -> bool:
    import pyarrow as pa

    if pa.types.is_dictionary(kind):
        kind = kind.value_type
    return bool(pa.types.is_string(kind) or pa.types.is_large_string(kind))
