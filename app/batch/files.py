"""Files of rows, CSV and Parquet, read and written a batch at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet

from app.batch.arrow import WrongColumn, rows_of
from app.batch.csv_blocks import Block, CsvBlocks
from app.batch.evaluation import evaluate
from app.batch.meant_columns import READ_AS_WELL, meant, renamed
from app.batch.rows import NAMES, Fault, number_columns
from app.optics.numerics.significant import round_significant
from app.optics.parameters import N_T, WAVELENGTH_NM
from app.optics.registry import default_registry

if TYPE_CHECKING:
    from typing import Protocol

    class BatchWriter(Protocol):
        """What batches are written to."""

        def write_batch(self, batch: pa.RecordBatch) -> None:
            """Append a batch."""


SUFFIXES = (".csv", ".parquet")

_ROWS = 65_536
_ADDED = (("value", pa.float64()), ("error", pa.string()))


class FileFault(Exception):
    """A file that cannot be read or written, and why."""

    def __init__(self, path: Path, error: Exception) -> None:
        super().__init__(f"{path}: {error}")


class RowsFile:
    """A file of rows.

    Parameters
    ----------
    path
        A CSV file with a header row or a Parquet file, by its suffix.
    keep
        Columns that mean nothing here and are copied.

    Attributes
    ----------
    assumed
        What the file does not say of itself: separators, decimal signs, columns called otherwise.

    Raises
    ------
    WrongColumn
        If there is a column that is neither known nor to be kept, one to be kept is not there, or
        one is there twice.
    FileFault
        If the file cannot be read or is none of its kind.
    """

    def __init__(self, path: Path, keep: Sequence[str] = ()) -> None:
        self._path = path
        self._keep = tuple(keep)
        self._known = set(_types()) | set(self._keep)
        self.assumed: tuple[str, ...] = ()
        try:
            if path.suffix == ".parquet":
                with pa.parquet.ParquetFile(path) as file:
                    self.schema = file.schema_arrow
                    self.total = int(file.metadata.num_rows)
            else:
                self._csv = CsvBlocks(path, self._type, self._known)
                self.schema = self._csv.schema
                self.assumed = self._csv.assumed
                self.total = path.stat().st_size
        except (pa.ArrowException, OSError) as error:
            raise FileFault(path, error) from None
        for name in self.schema.names:
            if self.schema.names.count(name) > 1:
                raise WrongColumn(name, "there twice")
        for name in self._keep:
            if name not in self.schema.names:
                raise WrongColumn(name, "to be kept, but not there")
        for name, _ in _ADDED:
            if name in self.schema.names:
                raise WrongColumn(name, "there already; it is what will be added")
        columns = meant(self.schema.names, self._known)
        self.assumed += tuple(one.said(name) for name, one in columns.items())
        try:
            evaluated(pa.RecordBatch.from_pylist([], schema=self.schema), self._keep)
        except WrongColumn as error:
            if error.column in self._known or error.column in columns:
                raise
            raise WrongColumn(error.column, f"{error.message}; {READ_AS_WELL}") from None

    def _type(self, name: str) -> pa.DataType:
        if name in meant([name], self._known):
            return pa.float64()
        return pa.string() if name in self._keep else _types().get(name, pa.string())

    def blocks(self) -> Iterator[Block]:
        """Yield all rows in order.

        Raises
        ------
        FileFault
            If the file cannot be read any further.
        """
        try:
            yield from self._parquet() if self._path.suffix == ".parquet" else self._csv.blocks()
        except (pa.ArrowException, OSError) as error:
            raise FileFault(self._path, error) from None

    def _parquet(self) -> Iterator[Block]:
        with pa.parquet.ParquetFile(self._path, pre_buffer=False) as file:
            done = 0
            for batch in file.iter_batches(_ROWS, use_threads=False):
                places = np.arange(done + 1, done + 1 + batch.num_rows)
                done += batch.num_rows
                yield Block(batch, {}, places, done)


@cache
def _types() -> Mapping[str, pa.DataType]:
    """How the columns are read that are known; numbers that have names may come by them."""
    numbers = number_columns(default_registry()).items()
    types = {name: pa.string() if p.choices else pa.float64() for name, p in numbers}
    return types | dict.fromkeys(NAMES, pa.string())


def evaluated(
    batch: pa.RecordBatch,
    keep: Sequence[str] = (),
    faults: Mapping[int, Fault] | None = None,
    digits: int = 17,
) -> pa.RecordBatch:
    """Add the columns `value` and `error` to a batch.

    Parameters
    ----------
    batch
        The rows.
    keep
        Columns that are copied.
    faults
        What is known to be wrong with a row already.
    digits
        How many significant ones the values have.

    Raises
    ------
    WrongColumn
        If it has a column that is neither known nor to be kept.
    """
    given = [name for name in batch.schema.names if name not in keep]
    batch_asked = renamed(batch.select(given), meant(given, set(_types())))
    asked = batch_asked.schema.names
    if N_T.name in asked and not {"material", "incident"}.intersection(asked):
        # A table of n and k over the wavelength: nothing in it is looked up there.
        asked = [name for name in asked if name != WAVELENGTH_NM.name]
    rows = rows_of(batch_asked.select(asked), default_registry())
    rows = replace(rows, faults={**rows.faults, **(faults or {})})
    outcome = evaluate(rows, default_registry())
    errors = pa.nulls(batch.num_rows, pa.string())
    if outcome.faults:
        told = np.full(batch.num_rows, None, dtype=object)
        for row, fault in outcome.faults.items():
            told[row] = str(fault)
        errors = pa.array(told, pa.string())
    values = pa.array(round_significant(outcome.values, digits), from_pandas=True)
    schema = added(batch.schema)
    return pa.record_batch([*batch.columns, values, errors], schema=schema)


def added(schema: pa.Schema) -> pa.Schema:
    """The schema of what `evaluated` returns."""
    for name, kind in _ADDED:
        schema = schema.append(pa.field(name, kind))
    return schema


@contextmanager
def writing(path: Path, schema: pa.Schema) -> Iterator[BatchWriter]:
    """Write batches to a file, which is there when all have been written and not before.

    Raises
    ------
    FileFault
        If the file cannot be written; what else goes wrong meanwhile is not blamed on it.
    """
    part = path.with_name(f"{path.name}.part")
    kind = pa.parquet.ParquetWriter if path.suffix == ".parquet" else pa.csv.CSVWriter
    try:
        with _blamed_on(path):
            writer = kind(str(part), schema)
        try:
            yield _Writer(writer, path)
        except BaseException:
            with suppress(OSError, pa.ArrowException):
                writer.close()
            raise
        with _blamed_on(path):
            writer.close()
            part.replace(path)
    finally:
        part.unlink(missing_ok=True)


class _Writer:
    """A writer whose faults are those of the file that is written."""

    def __init__(self, writer: BatchWriter, path: Path) -> None:
        self._writer = writer
        self._path = path

    def write_batch(self, batch: pa.RecordBatch) -> None:
        """Append a batch."""
        with _blamed_on(self._path):
            self._writer.write_batch(batch)


@contextmanager
def _blamed_on(path: Path) -> Iterator[None]:
    try:
        yield
    except (pa.ArrowException, OSError) as error:
        raise FileFault(path, error) from None


def in_order(
    blocks: Iterable[Block], keep: Sequence[str], digits: int = 17
) -> Iterator[tuple[Block, pa.RecordBatch]]:
    """Evaluate blocks here, one after the other."""
    for block in blocks:
        yield block, evaluated(block.batch, keep, block.faults, digits)
