"""CSV files read a block at a time; a row that cannot be read is a row that is wrong."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from itertools import repeat
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.csv

from app.batch.rows import Fault, Index
from app.optics.meant import instead

_BLOCK = 4_000_000
"""Characters of a block."""

_LONGEST_ROW = 1_000_000
"""Characters of a row; a row in quotes that has more is a quote that nobody closed."""

_SURROGATES = re.compile("[\udc80-\udcff]")
"""What Python reads bytes as that are no UTF-8."""

_SEPARATORS = ",;\t"
_SAMPLE = 20_000
_DECIMAL_COMMA = re.compile(r"\s*[-+]?\d*,\d+(?:[eE][-+]?\d+)?\s*")
_DECIMAL_POINT = re.compile(r"\s*[-+]?\d*\.\d+(?:[eE][-+]?\d+)?\s*")

_ENCODING = "utf-8-sig"
_LONGEST_VALUE = 200


class Block(NamedTuple):
    """Some of a file's rows, in order."""

    batch: pa.RecordBatch
    """What they hold; null in the place of what cannot be read."""
    faults: Mapping[int, Fault]
    """What cannot be read, by its row in the block."""
    places: Index
    """Where each row is: the number of its line or, in Parquet, of the row, from 1."""
    done: int
    """How much of the file has been read with it."""


class CsvBlocks:
    """A CSV file with a header row.

    Parameters
    ----------
    path
        The file, in UTF-8.
    type_of
        How a column is read, by its name.
    known
        Names of columns, by which the header is parted.

    Attributes
    ----------
    assumed
        How it is parted, and the decimal sign, where those are not commas and points.

    Raises
    ------
    pyarrow.ArrowException
        If there is no header, or it is no UTF-8.
    """

    def __init__(
        self, path: Path, type_of: Callable[[str], pa.DataType], known: Collection[str] = ()
    ) -> None:
        self._path = path
        with self._opened() as (_, text):
            head = _whole_row(text, text.readline(_LONGEST_ROW))
            sample = text.read(_SAMPLE).split("\n")
        if not head.strip():
            raise pa.ArrowInvalid("no header row")
        if _SURROGATES.search(head):
            raise pa.ArrowInvalid("the header is no UTF-8; save the file as CSV in UTF-8")
        self._separator = _separator(head, known)
        names = next(csv.reader([head], delimiter=self._separator))
        self._decimal = _decimal(sample, self._separator)
        self.assumed = _said(self._separator, self._decimal)
        self._header_lines = head.count("\n")
        self.schema = pa.schema([(name, type_of(name)) for name in names])

    def _opened(self) -> _Opened:
        return _Opened(self._path)

    def blocks(self) -> Iterator[Block]:
        """Yield all rows in order."""
        with self._opened() as (file, text):
            _whole_row(text, text.readline(_LONGEST_ROW))
            line = self._header_lines + 1
            while block := text.read(_BLOCK):
                if not block.endswith("\n"):
                    block += text.readline(_LONGEST_ROW)
                block = _whole_row(text, block)
                yield self._read(block, line, file.tell())
                line += block.count("\n")

    def _read(self, block: str, line: int, done: int) -> Block:
        """Read rows at once where all are as they should be, else one by one."""
        lines = block.count("\n") + (not block.endswith("\n"))
        try:
            table = pa.csv.read_csv(
                pa.BufferReader(block.encode("utf-8", "surrogateescape")),
                pa.csv.ReadOptions(
                    use_threads=False, block_size=4 * len(block), column_names=self.schema.names
                ),
                parse_options=pa.csv.ParseOptions(delimiter=self._separator),
                convert_options=pa.csv.ConvertOptions(
                    column_types=self.schema,
                    null_values=[""],
                    strings_can_be_null=True,
                    decimal_point=self._decimal,
                ),
            )
        except pa.ArrowException:
            return self._read_singly(block, line, done)
        if table.num_rows != lines:  # rows of several lines, or none: which is where, is not told
            return self._read_singly(block, line, done)
        (batch,) = table.combine_chunks().to_batches()
        return Block(batch, {}, np.arange(line, line + lines), done)

    def _read_singly(self, block: str, line: int, done: int) -> Block:
        rows: list[list[Any]] = []
        faults: dict[int, Fault] = {}
        places: list[int] = []
        for place, text, cells in _rows(block, line, self._separator):
            row, fault = self._row(text, cells)
            if fault is not None:
                faults[len(rows)] = fault
            rows.append(row)
            places.append(place)
        columns: Iterable[Sequence[Any]] = zip(*rows, strict=True) if rows else repeat(())
        arrays = [
            pa.array(column, kind.type) for column, kind in zip(columns, self.schema, strict=False)
        ]
        batch = pa.record_batch(arrays, schema=self.schema)
        return Block(batch, faults, np.array(places, np.intp), done)

    def _row(self, text: str, cells: list[str] | csv.Error) -> tuple[list[Any], Fault | None]:
        """Read a row, and say what of it cannot be read."""
        row: list[Any] = [None] * len(self.schema)
        why = None
        if isinstance(cells, csv.Error):
            why = str(cells)
        elif any(_SURROGATES.search(cell) for cell in cells):
            why = "no UTF-8"
        elif len(cells) != len(row):
            why = f"{len(cells)} cells where the header has {len(row)}"
        if why is not None or isinstance(cells, csv.Error):
            shown = _SURROGATES.sub("\N{REPLACEMENT CHARACTER}", text[:_LONGEST_VALUE])
            return row, Fault("row", shown, why or "")
        first = None
        for index, (cell, kind) in enumerate(zip(cells, self.schema, strict=True)):
            if kind.type != pa.float64():
                row[index] = cell or None
            elif cell:
                try:
                    row[index] = _number(cell, self._decimal)
                except ValueError:
                    message = instead(kind.name, cell) or "no number"
                    first = first or Fault(kind.name, cell[:_LONGEST_VALUE], message)
        return row, first


class _Opened:
    """A file as bytes, which tell how far it was read, and as text."""

    def __init__(self, path: Path) -> None:
        self._file = path.open("rb")
        self._text = io.TextIOWrapper(self._file, _ENCODING, errors="surrogateescape")

    def __enter__(self) -> tuple[io.BufferedReader, io.TextIOWrapper]:
        return self._file, self._text

    def __exit__(self, *_: object) -> None:
        self._text.close()


def _whole_row(text: io.TextIOWrapper, block: str) -> str:
    """Read on to the end of a row, where a block ends between quotes."""
    if block.count('"') % 2 == 0:
        return block
    more = ""
    while len(more) < _LONGEST_ROW and (line := text.readline(_LONGEST_ROW)):
        more += line
        if line.count('"') % 2:
            break
    return block + more


def _rows(
    block: str, line: int, separator: str
) -> Iterator[tuple[int, str, list[str] | csv.Error]]:
    """Part a block into rows: the number of its first line, that line, and its cells or why none.

    Empty lines are no rows. A quote that nobody closes costs its own line and no more.
    """
    lines = block.removesuffix("\n").split("\n")
    at = 0
    while at < len(lines):
        start = at
        rest = (lines[i] + "\n" for i in range(start, len(lines)))
        reader = csv.reader(rest, delimiter=separator, strict=True)
        try:
            for cells in reader:
                if cells:
                    yield line + at, lines[at], cells
                at = start + reader.line_num
        except csv.Error as error:
            yield line + at, lines[at], error
            at += 1


def _separator(head: str, known: Collection[str]) -> str:
    """What parts a header into most names that are known; a comma unless another does better."""

    def names(separator: str) -> int:
        return sum(name in known for name in next(csv.reader([head], delimiter=separator)))

    best = max(_SEPARATORS, key=names)
    if names(best) > names(","):
        return best
    return next((s for s in ";\t" if s in head), ",") if "," not in head else ","


def _decimal(lines: Sequence[str], separator: str) -> str:
    """A comma where cells are numbers with one, and none with a point."""
    if separator == ",":
        return "."
    cells = [cell for line in lines for cell in line.split(separator)]
    has_commas = any(_DECIMAL_COMMA.fullmatch(cell) for cell in cells)
    return "," if has_commas and not any(_DECIMAL_POINT.fullmatch(c) for c in cells) else "."


def _said(separator: str, decimal: str) -> tuple[str, ...]:
    names = {";": "columns are parted by semicolons", "\t": "columns are parted by tabs"}
    said = (names[separator],) if separator in names else ()
    return (*said, "the decimal sign is a comma") if decimal == "," else said


def _number(cell: str, decimal: str) -> float:
    """Read a number as Arrow does, which knows no 1_5.

    Raises
    ------
    ValueError
        If it is none.
    """
    if "_" in cell or (decimal == "," and "." in cell):
        raise ValueError(cell)
    return float(cell.replace(decimal, "."))
