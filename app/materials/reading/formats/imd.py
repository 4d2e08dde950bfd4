"""IMD's .nk: comments after a semicolon, then wavelength in Angstrom, n and k."""

from collections.abc import Sequence

import numpy as np

from app.materials.reading.formats import (
    Block,
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

_COLUMNS = 3


def _sniff(document: Document) -> str | None:
    first = next((line for line in document.lines if line.strip()), "")
    if document.suffix == ".nk" and first.lstrip().startswith(";"):
        return "it ends in .nk and begins with a comment after a semicolon, as IMD's files do"
    return None


def _rows(document: Document, notes: Notes) -> Block:
    lines = [line.split(";", 1)[0] for line in document.lines]
    layout = layout_of(lines, notes)
    blocks = blocks_of(lines, layout, notes, document.name) if layout else []
    if len(blocks) != 1 or len(blocks[0].rows[0]) < _COLUMNS:
        raise Unreadable("file", document.name, "rows of a wavelength, n and k below the comments")
    return blocks[0]


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    block = _rows(documents[0], notes)
    numbers = np.array(block.rows)
    unit = decided_unit(
        numbers[:, 0],
        notes,
        named="A",
        why="IMD's files have Angstrom",
        n=numbers[:, 1],
        is_certain=True,
    )
    columns = {"n": numbers[:, 1], "k": numbers[:, 2]}
    return Content(tables=[Table(numbers[:, 0], unit, columns, np.array(block.numbers))])


FORMAT = Format(
    id="imd",
    title="IMD's .nk in Angstrom",
    sniff=_sniff,
    read=_read,
)
