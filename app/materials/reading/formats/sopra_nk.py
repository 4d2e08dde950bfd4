"""SOPRA's .nk: a header with a unit code, start, end and intervals; then pairs n k, no abscissa."""

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


def _header(document: Document) -> tuple[int, float, float, int, int] | None:
    """Unit, start, end, intervals and the number of the line; None where the first line is none."""
    for number, line in enumerate(document.lines, start=1):
        if not line.strip():
            continue
        words = line.replace(",", " ").split()
        try:
            code, start, end, intervals = (float(word) for word in words[:_HEADER])
        except ValueError:
            return None
        whole = code in _UNITS and intervals == int(intervals) if np.isfinite(intervals) else False
        if len(words) != _HEADER or not whole or not 1 <= intervals <= MOST_ROWS:
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
    if len(beside.split()) != 2:
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
        words = line.replace(",", " ").split()
        if not words:
            continue
        try:
            n, k = (float(word) for word in words)
        except ValueError:
            # A pair that is left out silently would move all that follow.
            what = f"a pair n k on each line; line {number} is {line.strip()[:40]!r}"
            raise Unreadable("file", document.name, what) from None
        pairs.append((n, k))
        lines.append(number)
    if len(pairs) != intervals + 1:
        what = f"{intervals + 1} pairs for {intervals} intervals; there are {len(pairs)}"
        raise Unreadable("file", document.name, what)
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
