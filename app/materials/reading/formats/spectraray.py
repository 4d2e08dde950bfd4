"""Materials of SpectraRay (.mat): eps1 and eps2 between `Begin of array` and `End of array`."""

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
from app.materials.reading.units import units_named

_BEGIN, _END = "Begin of array", "End of array"


def _sniff(document: Document) -> str | None:
    if any(line.strip() == _BEGIN for line in document.lines):
        return f"it has a line {_BEGIN!r}, as SpectraRay writes it"
    return None


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    stripped = [line.strip() for line in document.lines]
    if _BEGIN not in stripped:
        raise Unreadable("file", document.name, f"a line {_BEGIN!r}")
    begin = stripped.index(_BEGIN)
    end = stripped.index(_END, begin) if _END in stripped[begin:] else len(stripped)
    lines = [line if begin < i < end else "" for i, line in enumerate(document.lines)]
    layout = layout_of(lines, notes)
    blocks = blocks_of(lines, layout, notes, document.name) if layout else []
    if len(blocks) != 1 or len(blocks[0].rows[0]) < 3:
        what = f"rows of an energy, eps1 and eps2 between {_BEGIN!r} and {_END!r}"
        raise Unreadable("file", document.name, what)
    numbers = np.array(blocks[0].rows)
    told = next((x.partition("=")[2] for x in stripped[:begin] if x.startswith("Units=")), "")
    first = told.split(",")[0].strip()
    spelled = units_named(told)
    why = f"the line says Units={told[:40]}" if spelled else "SpectraRay has eV, or nm"
    named = spelled[0] if spelled else "nm" if first.casefold() == "wavelength" else "eV"
    unit = decided_unit(numbers[:, 0], notes, named=named, why=why, is_certain=True)
    columns = {"eps1": numbers[:, 1], "eps2": numbers[:, 2]}
    return Content(tables=[Table(numbers[:, 0], unit, columns, np.array(blocks[0].numbers))])


FORMAT = Format(
    id="spectraray",
    title="a material of SpectraRay",
    sniff=_sniff,
    read=_read,
)
