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

_LONGEST_NAME = 20_000


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
    is_encoded = pa.types.is_dictionary(column.type)
    if not is_encoded:
        column = _clipped(column).dictionary_encode()
    codes = column.indices.cast(pa.int64()).fill_null(-1).to_numpy(zero_copy_only=False)
    dictionary = column.dictionary
    if len(dictionary) > codes.size:  # it holds much that no row says
        said, codes = np.unique(codes, return_inverse=True)
        dictionary = dictionary.take(pa.array(said, mask=said < 0))
    if is_encoded:
        dictionary = _clipped(dictionary)
    # One of its own may hold null, and the same twice.
    distinct: dict[str, int] = {}
    places = [
        -1 if text is None else distinct.setdefault(text, len(distinct))
        for text in dictionary.to_pylist()
    ]
    # The last stands for rows that say nothing: their code is -1.
    return Names(np.array([*places, -1], np.intp)[codes], list(distinct))


def _clipped(texts: pa.Array) -> pa.Array:
    """Shorten what is too long to be a name, and is none when it is shorter either."""
    import pyarrow.compute as pc

    longest = pc.max(pc.binary_length(texts)).as_py() or 0
    return texts if longest <= _LONGEST_NAME else pc.utf8_slice_codeunits(texts, 0, _LONGEST_NAME)


def _is_text(kind: pa.DataType) -> bool:
    import pyarrow as pa

    if pa.types.is_dictionary(kind):
        kind = kind.value_type
    return bool(pa.types.is_string(kind) or pa.types.is_large_string(kind))
