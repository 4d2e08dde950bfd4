"""SOPRA's .nk: a header with a unit code, start, end and intervals; then pairs n k, no abscissa."""

import re
from collections.abc import Sequence

import numpy as np

from app.materials.reading.document import MOST_ROWS
from app.materials.reading.formats import (
    Content,
    Document,
    Format,
    Notes,
    Table,
    Unreadable,
    decided_unit,
)

_UNITS = {1: "eV", 2: "um", 3: "cm-1", 4: "nm"}
_HEADER = 4
_POINT = re.compile(r"\S*\d,\d\S*\s+\S+|\S+\s+\S*\d,\d\S*")
"""A pair with a comma inside a number."""


def _numbers(line: str, count: int) -> list[float] | None:
    """Read so many numbers between blanks, with points or commas for decimals, or between commas."""
    for words in (line.split(), line.replace(",", " ").split()):
        try:
            if len(words) == count:
                return [float(word.replace(",", ".")) for word in words]
        except ValueError:
            continue
    return None


def _header(document: Document) -> tuple[int, float, float, int, int] | None:
    """Unit, start, end, intervals and the number of the line; None where the first line is none."""
    for number, line in enumerate(document.lines, start=1):
        if not line.strip():
            continue
        numbers = _numbers(line, _HEADER)
        if numbers is None:
            return None
        code, start, end, intervals = numbers
        whole = code in _UNITS and intervals == int(intervals) if np.isfinite(intervals) else False
        if not whole or not 1 <= intervals <= MOST_ROWS:
            return None
        if not (0.0 < start < np.inf and 0.0 < end < np.inf and start != end):
            return None
        return int(code), start, end, int(intervals), number
    return None


def _sniff(document: Document) -> str | None:
    header = _header(document)
    if header is None:
        return None
    beside = next((x for x in document.lines[header[-1] :] if x.strip()), "")
    if _numbers(beside, 2) is None:
        return None
    return "its first line is a unit code, a start, an end and a number of intervals; pairs follow"


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    header = _header(document)
    if header is None:
        what = "a first line with a unit code 1 to 4, start, end and intervals"
        raise Unreadable("file", document.name, what)
    code, start, end, intervals, first = header
    pairs, lines = [], []
    for number, line in enumerate(document.lines[first:], start=first + 1):
        if not line.strip():
            continue
        pair = _numbers(line, 2)
        if pair is not None:
            pairs.append(pair)
            lines.append(number)
        elif len(pairs) > intervals:
            notes.leave_out(number, f"below the last pair: {line.strip()[:60]}")
        else:
            # A pair that is left out silently would move all that follow.
            what = f"a pair n k on each line; line {number} is {line.strip()[:40]!r}"
            raise Unreadable("file", document.name, what)
    if len(pairs) != intervals + 1:
        what = f"{intervals + 1} pairs for {intervals} intervals; there are {len(pairs)}"
        raise Unreadable("file", document.name, what)
    if any(_POINT.fullmatch(document.lines[number - 1].strip()) for number in lines):
        notes.assume("decimal", ",", "numbers have commas inside, and blanks between them")
    x = np.linspace(start, end, intervals + 1)
    numbers = np.array(pairs)
    named = _UNITS[code]
    why = (
        f"the first line has the code {code}; some read 3 as mm"
        if code == 3
        else (f"the first line has the code {code}")
    )
    unit = decided_unit(x, notes, named=named, why=why, n=numbers[:, 0], is_certain=True)
    notes.warn(f"the file has no abscissa: {intervals + 1} equal steps from {start:g} to {end:g}")
    return Content(
        tables=[Table(x, unit, {"n": numbers[:, 0], "k": numbers[:, 1]}, np.array(lines))]
    )


FORMAT = Format(
    id="sopra_nk",
    title="SOPRA's .nk without an abscissa",
    sniff=_sniff,
    read=_read,
)
