"""What to do with a file in which no rows of numbers are found, by what stands there instead."""

import re
from collections import Counter
from collections.abc import Sequence

from app.materials.reading.columns import ABSCISSAE, role_of
from app.materials.reading.rows import COMMENT, Layout
from app.materials.reading.units import unit_spelled

ROWS = "rows of at least two numbers: a wavelength or energy, n, and k where it is known"

_SAMPLE = 200
_LAYOUTS = [Layout(s, d) for s in (";", "\t", "|", ",", None) for d in ".," if s != d]
_NUMBER = r"(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?"
_COMPLEX = re.compile(
    rf"\(?[-+]?{_NUMBER}\s*[-+]\s*(?:[ij]\s*\*?\s*{_NUMBER}|{_NUMBER}\s*\*?\s*[ij])\)?"
)
_WITH_UNIT = re.compile(rf"{_NUMBER}\s*(\S+)")


def instead(lines: Sequence[str]) -> str:
    """Say what a file takes that has no rows of numbers."""
    first = next((line.strip() for line in lines if line.strip()), " ")
    if first[0] in "{[":
        return f"{ROWS}; this is JSON: write it as a table with a line a wavelength"
    if first[0] == "<":
        return f"{ROWS}; this is HTML or XML: save the table in it as CSV"
    if first.startswith("%PDF"):
        return f"{ROWS}; this is PDF: copy the table in it"
    sample = [line for line in lines if any(c.isdigit() for c in line) and not COMMENT.match(line)]
    found = [one for layout in _LAYOUTS if (one := _in_the_way(sample[:_SAMPLE], layout))]
    return f"{ROWS}; {max(found, key=lambda one: one[0])[1]}" if found else ROWS


def _in_the_way(lines: Sequence[str], layout: Layout) -> tuple[int, str] | None:
    """How many columns can be read if lines are parted so, and what keeps the others from it."""
    table = [cells for line in lines if len(cells := layout.cells(line)) > 1]
    if not table:
        return None
    width = Counter(map(len, table)).most_common(1)[0][0]
    rows = [cells for cells in table if len(cells) == width]
    said = [_wrong(column, layout) for column in zip(*rows, strict=True)]
    told = [f"column {place} holds {why}" for place, why in enumerate(said, start=1) if why]
    usable = sum(why is None or not why.startswith("words") for why in said)
    if not told or usable < 2:
        return None
    first = rows[0][0][:200]
    if not any(c.isdigit() for c in first) and role_of(first)[0] in ABSCISSAE:
        return usable, "here a wavelength has a column: turn the table so that it has a row"
    return usable, told[0]


def _wrong(column: Sequence[str], layout: Layout) -> str | None:
    """Say what most cells are that are no numbers, and what to do; None where they are."""
    words = [cell.strip("\"'") for cell in column if layout.number(cell) is None]
    if 2 * len(words) <= len(column):
        return None
    shown = words[0][:40]
    if _COMPLEX.fullmatch(shown):
        return f"n and k in one, as {shown}: give each a column of its own"
    unit = _WITH_UNIT.fullmatch(shown)
    if unit is not None and unit_spelled(unit[1]):
        return f"units, as {shown}: leave them to the name of the column"
    return (
        f"words, as {shown}: leave it out, and where it tells materials apart, keep the rows of one"
    )
