"""Files of rows, CSV and Parquet, read and written a batch at a time."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet

from app.batch.arrow import WrongColumn, rows_of
from app.batch.evaluation import evaluate
from app.batch.rows import NAMES, number_columns
from app.optics.parameters import N_T, WAVELENGTH_NM
from app.optics.registry import default_registry

if TYPE_CHECKING:
    from typing import Protocol

    class BatchWriter(AbstractContextManager[Any], Protocol):
        """What batches are written to."""

        def write_batch(self, batch: pa.RecordBatch) -> None:
            """Append a batch."""


SUFFIXES = (".csv", ".parquet")

_ROWS = 65_536
_BLOCK_BYTES = 4_000_000
_ADDED = (("value", pa.float64()), ("error", pa.string()))


class RowsFile:
    """A file of rows.

    Parameters
    ----------
    path
        A CSV file with a header row or a Parquet file, by its suffix.
    keep
        Columns that mean nothing here and are copied.

    Raises
    ------
    WrongColumn
        If there is a column that is neither known nor to be kept, or one to be kept is not there.
    pyarrow.ArrowException
        If the file is none of its kind.
    """

    def __init__(self, path: Path, keep: Sequence[str] = ()) -> None:
        self._path = path
        self._keep = tuple(keep)
        self._known = set(number_columns(default_registry())) | set(NAMES)
        if path.suffix == ".parquet":
            with pa.parquet.ParquetFile(path) as file:
                self.schema = file.schema_arrow
                self.total = int(file.metadata.num_rows)
        else:
            self.schema = self._csv_schema()
            self.total = path.stat().st_size
        for name in self._keep:
            if name not in self.schema.names:
                raise WrongColumn(name, "to be kept, but not there")
        for name, _ in _ADDED:
            if name in self.schema.names:
                raise WrongColumn(name, "there already; it is what will be added")
        evaluated(pa.RecordBatch.from_pylist([], schema=self.schema), self._keep)

    def batches(self) -> Iterator[tuple[pa.RecordBatch, int]]:
        """Yield batches in order, each with how much of `total` has been read with it."""
        if self._path.suffix == ".parquet":
            with pa.parquet.ParquetFile(self._path, pre_buffer=False) as file:
                done = 0
                for batch in file.iter_batches(_ROWS, use_threads=False):
                    done += batch.num_rows
                    yield batch, done
            return
        with self._path.open("rb") as file, self._csv(file) as reader:
            for batch in reader:
                yield batch, file.tell()

    def _csv_schema(self) -> pa.Schema:
        with self._path.open("rb") as file, self._csv(file) as reader:
            return reader.schema

    def _csv(self, file: Any) -> Any:
        numbers = number_columns(default_registry())
        types = {name: pa.float64() for name, p in numbers.items() if not p.choices}
        types |= {name: pa.string() for name, p in numbers.items() if p.choices}
        types |= dict.fromkeys((*NAMES, *self._keep), pa.string())
        return pa.csv.open_csv(
            file,
            pa.csv.ReadOptions(use_threads=False, block_size=_BLOCK_BYTES),
            convert_options=pa.csv.ConvertOptions(
                column_types=types, null_values=[""], strings_can_be_null=True
            ),
        )


def evaluated(batch: pa.RecordBatch, keep: Sequence[str] = ()) -> pa.RecordBatch:
    """Add the columns `value` and `error` to a batch.

    Raises
    ------
    WrongColumn
        If it has a column that is neither known nor to be kept.
    """
    asked = [name for name in batch.schema.names if name not in keep]
    if N_T.name in asked and not {"material", "incident"}.intersection(asked):
        # A table of n and k over the wavelength: nothing in it is looked up there.
        asked = [name for name in asked if name != WAVELENGTH_NM.name]
    outcome = evaluate(rows_of(batch.select(asked), default_registry()), default_registry())
    errors = pa.nulls(batch.num_rows, pa.string())
    if outcome.faults:
        told = np.full(batch.num_rows, None, dtype=object)
        for row, fault in outcome.faults.items():
            told[row] = str(fault)
        errors = pa.array(told, pa.string())
    values = pa.array(outcome.values, from_pandas=True)
    schema = added(batch.schema)
    return pa.record_batch([*batch.columns, values, errors], schema=schema)


def added(schema: pa.Schema) -> pa.Schema:
    """The schema of what `evaluated` returns."""
    for name, kind in _ADDED:
        schema = schema.append(pa.field(name, kind))
    return schema


@contextmanager
def writing(path: Path, schema: pa.Schema) -> Iterator[BatchWriter]:
    """Write batches to a file, which is there when all have been written and not before."""
    part = path.with_name(f"{path.name}.part")
    kind = pa.parquet.ParquetWriter if path.suffix == ".parquet" else pa.csv.CSVWriter
    try:
        with kind(str(part), schema) as writer:
            yield writer
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def in_order(batches: Iterable[pa.RecordBatch], keep: Sequence[str]) -> Iterator[pa.RecordBatch]:
    """Evaluate batches here, one after the other."""
    for batch in batches:
        yield evaluated(batch, keep)
