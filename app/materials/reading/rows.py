"""Lines of text as rows of numbers: separators, decimal signs, comments and what is missing."""

import csv
import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from app.materials.reading.document import MOST_ROWS
from app.materials.reading.report import Notes, Unreadable

COMMENT = re.compile(r"\s*(?:[#;%!*]|//|['\"](?!\s*[-+.\d]))")
"""How lines begin that are no data; a number may stand in quotes."""

_TAIL = re.compile(r"\s(?:[#!%]|//).*$")
"""A comment behind the numbers of a line."""

_SEPARATORS = (";", "\t", "|", ",", None)  # None: blanks
_SAMPLE = 200
_NOTHING = frozenset(
    {
        "",
        "-",
        "--",
        "---",
        "_",
        "*",
        "?",
        "na",
        "n/a",
        "n.a.",
        "n. a.",
        "n.d.",
        "nan",
        "-nan",
        "null",
    }
    | {"none", "#n/a", "#value!", "missing", "k.a.", "k. a.", "1.#qnan", "-1.#ind"}
)
_GROUPED = {
    ".": re.compile(r"[-+]?\d{1,3}(?:,\d{3})+\.\d+|[-+]?\d{1,3}(?:[ \xa0\u202f']\d{3})+(?:\.\d*)?"),
    ",": re.compile(r"[-+]?\d{1,3}(?:\.\d{3})+,\d+|[-+]?\d{1,3}(?:[ \xa0\u202f']\d{3})+(?:,\d*)?"),
}
"""Thousands set apart; 1,000 alone may be 1 or 1000, and is neither."""
_GROUP = re.compile(r"[ \xa0\u202f']|[.,](?=.*[.,])")
_DOUBTFUL = re.compile(r"[-+]?\d{1,3}(?:[.,]\d{3})+")
_FORTRAN = re.compile(r"(?<=\d)[dD](?=[-+]?\d)")
_MOST_COLUMNS = 64


@dataclass(frozen=True)
class Layout:
    """How numbers stand in lines."""

    separator: str | None
    """None for blanks."""
    decimal: str

    def cells(self, line: str) -> list[str]:
        """Part a line; separators at its end are no cells."""
        cells = self._all_cells(line)
        while cells and not cells[-1]:
            cells.pop()
        return cells

    def _all_cells(self, line: str) -> list[str]:
        if self.separator is None:
            return line.split()
        if self.separator == "|":  # as Markdown has it, at both ends too
            line = line.strip().removeprefix("|").removesuffix("|")
        if '"' in line:  # a quoted cell may hold the separator
            try:
                return [cell.strip() for cell in next(csv.reader([line], delimiter=self.separator))]
            except csv.Error:
                pass
        return [cell.strip() for cell in line.split(self.separator)]

    def number(self, cell: str) -> float | None:
        """Read a cell; NaN for what is missing, None for what is no number."""
        cell = cell.strip("\"'")
        plain = cell
        if self.decimal == ",":
            plain = "" if "." in cell else cell.replace(",", ".")
        # float() takes 1_000 and digits of other scripts, which no table has.
        if "_" not in plain and plain.isascii():
            try:
                return float(plain)
            except ValueError:
                pass
            try:
                return float(_FORTRAN.sub("e", plain))
            except ValueError:
                pass
        if cell.casefold() in _NOTHING:
            return math.nan
        if _GROUPED[self.decimal].fullmatch(cell):
            return float(_GROUP.sub("", cell).replace(",", "."))
        return None

    def row(self, line: str) -> list[float] | None:
        """Read a line of at least two numbers, None where it is none; NaN for empty cells."""
        if "#" in line or "!" in line or "%" in line or "//" in line:
            line = _TAIL.sub("", line)
        cells = self._all_cells(line)
        if not 2 <= len(cells) <= _MOST_COLUMNS or not any(cells[1:]):
            return None
        numbers = []
        for cell in cells:
            number = self.number(cell)
            if number is None:
                return None
            numbers.append(number)
        return numbers if math.isfinite(numbers[0]) else None


@dataclass
class Block:
    """Rows that belong together, with the lines above them."""

    header: list[str]
    """Lines above, comments among them."""
    rows: list[list[float]]
    numbers: list[int]
    """Of the rows' lines."""


def layout_of(lines: Sequence[str], notes: Notes) -> Layout | None:
    """Find out how numbers stand in lines; None where none are."""
    sample = [line for line in lines if any(c.isdigit() for c in line) and not COMMENT.match(line)]
    middle = max(0, len(sample) // 2 - _SAMPLE // 2)
    sample = sample[:_SAMPLE] + sample[max(_SAMPLE, middle) :][:_SAMPLE]
    best: tuple[float, Layout] | None = None
    for separator in _SEPARATORS:
        for decimal in (".", ","):
            if decimal == separator or notes.choices.decimal not in (None, decimal):
                continue
            layout = Layout(separator, decimal)
            widths = Counter(len(row) for line in sample if (row := layout.row(line)))
            if not widths:
                continue
            score = widths.most_common(1)[0][1] / len(sample)
            if best is None or score > best[0]:
                best = score, layout
    if best is None:
        return None
    layout = best[1]
    if layout.decimal == ",":
        notes.assume("decimal", ",", "the rows are numbers with this decimal sign alone", ["."])
    return layout


def blocks_of(lines: Sequence[str], layout: Layout, notes: Notes, name: str) -> list[Block]:
    """Part lines into blocks of rows; a line of words below rows begins another block.

    Rows of another length than most of their block are left out.

    Raises
    ------
    Unreadable
        If there are too many rows.
    """
    blocks = [Block([], [], [])]
    row_of = layout.row
    count = 0
    for number, line in enumerate(lines, start=1):
        row = row_of(line)
        if row is not None:
            blocks[-1].rows.append(row)
            blocks[-1].numbers.append(number)
            count += 1
            if count > MOST_ROWS:
                raise Unreadable("file", name, f"a table of at most {MOST_ROWS:,} rows")
        elif line.strip():
            if blocks[-1].rows and _heads(line, layout):
                blocks.append(Block([], [], []))
            is_first = not blocks[-1].rows
            if is_first:
                blocks[-1].header.append(line)
            if not COMMENT.match(line) and (not is_first or _is_broken(line, layout)):
                notes.leave_out(number, _broken(line, layout))
    return [_even(block, notes) for block in blocks if block.rows]


def _heads(line: str, layout: Layout) -> bool:
    """Whether a line below rows heads other rows: words alone, not a comment or a broken row."""
    if COMMENT.match(line):
        return False
    cells = layout.cells(line)
    return len(cells) > 1 and all(layout.number(cell) is None for cell in cells)


def _is_broken(line: str, layout: Layout) -> bool:
    """Whether a line above rows is one with a cell that is no number, and not what heads them."""
    cells = layout.cells(line)
    numbers = [number for cell in cells if (number := layout.number(cell)) is not None]
    return (
        2 < len(cells) < 2 * len(numbers)
        and layout.number(cells[0]) is not None
        and math.isfinite(numbers[0])
    )


def _broken(line: str, layout: Layout) -> str:
    """Say why a line is no row."""
    why = f"no row of numbers: {line.strip()[:60]}"
    for cell in layout.cells(line):
        cell = cell.strip("\"'")
        if _DOUBTFUL.fullmatch(cell) and layout.number(cell) is None:
            plain = re.sub("[.,]", "", cell)
            return f"{why}; write {plain} for {cell[:20]} if it is that"
    return why


def _even(block: Block, notes: Notes) -> Block:
    """Leave out rows that are shorter or longer than most; empty cells at their ends may be many."""
    spans = [(_filled(row), len(row)) for row in block.rows]
    fitting = {
        width: sum(
            count for (least, most), count in Counter(spans).items() if least <= width <= most
        )
        for width in sorted({max(2, least) for least, _ in spans}, reverse=True)
    }
    usual = max(fitting, key=lambda width: fitting[width])
    rows, numbers = [], []
    for row, number, (least, most) in zip(block.rows, block.numbers, spans, strict=True):
        if least <= usual <= most:
            rows.append(row[:usual])
            numbers.append(number)
        else:
            notes.leave_out(number, f"{least} numbers where most rows have {usual}")
    return Block(block.header, rows, numbers)


def _filled(row: list[float]) -> int:
    """How many numbers a row has, without those at its end that are missing."""
    count = len(row)
    while count and math.isnan(row[count - 1]):
        count -= 1
    return count
