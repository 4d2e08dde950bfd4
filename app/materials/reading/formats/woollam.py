"""Materials of WVASE and CompleteEASE: a name, a unit, a kind or a number of points, then rows."""

import re
from collections.abc import Sequence

import numpy as np

from app.materials.reading.formats import (
    Content,
    Document,
    Format,
    Notes,
    Table,
    Unreadable,
    blocks_of,
    decided_unit,
    layout_of,
)
from app.materials.reading.units import unit_spelled

_HEADER = 3
_NK = re.compile(r"n\s*,?\s*k|nk|optical constants", re.IGNORECASE)
_EPS = re.compile(r"e1\s*,?\s*e2|eps(ilon)?|er\s*,?\s*ei|dielectric.*", re.IGNORECASE)


def _third(text: str) -> str | None:
    """What the third line says: nk, eps, or how many rows there are."""
    text = text.strip()
    if _EPS.fullmatch(text):
        return "eps"
    return "nk" if _NK.fullmatch(text) or text.isdecimal() else None


def _sniff(document: Document) -> str | None:
    lines = document.lines[:_HEADER]
    if len(lines) == _HEADER and unit_spelled(lines[1]) and _third(lines[2]):
        return "its second line is a unit and its third a kind or a count, as WVASE writes them"
    return None


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    if _sniff(document) is None:
        what = "three lines in front: a name, a unit, and nk, e1e2 or the number of rows"
        raise Unreadable("file", document.name, what)
    lines = ["", "", "", *document.lines[_HEADER:]]
    layout = layout_of(lines, notes)
    blocks = blocks_of(lines, layout, notes, document.name) if layout else []
    if len(blocks) != 1:
        raise Unreadable("file", document.name, "rows of numbers below the three lines")
    numbers = np.array(blocks[0].rows)
    third = document.lines[2].strip()
    if third.isdecimal() and int(third[:12]) != len(numbers):
        notes.warn(f"the third line announces {third[:12]} rows; there are {len(numbers)}")
    pair = ("eps1", "eps2") if _third(third) == "eps" else ("n", "k")
    columns = {role: numbers[:, i] for i, role in enumerate(pair, start=1) if i < numbers.shape[1]}
    unit = decided_unit(
        numbers[:, 0],
        notes,
        named=unit_spelled(document.lines[1]),
        why="the second line says it",
        n=columns.get("n"),
    )
    if third.isdecimal():
        why = "WVASE writes n and k where the third line is a count"
        notes.assume("columns", f"wavelength,{','.join(pair)}", why)
    table = Table(numbers[:, 0], unit, columns, np.array(blocks[0].numbers))
    return Content(tables=[table], name=document.lines[0].strip() or None)


FORMAT = Format(
    id="woollam",
    title="a material of WVASE or CompleteEASE",
    sniff=_sniff,
    read=_read,
)
