"""Any table of numbers: with commas, semicolons, tabs or blanks, with names of columns or without."""

from collections.abc import Sequence

import numpy as np

from app.materials.reading.formats import (
    Block,
    Content,
    Document,
    Format,
    Layout,
    Notes,
    Table,
    Unreadable,
    blocks_of,
    by_hand,
    by_number,
    columns_named,
    decided_unit,
    layout_of,
    unit_in,
)


def read_lines(lines: Sequence[str], name: str, notes: Notes) -> Content:
    """Read lines as a table, or as tables of n and of k below one another.

    Raises
    ------
    Unreadable
        If there is none.
    Undecided
        If its unit or its columns are not said and cannot be told.
    """
    layout = layout_of(lines, notes)
    blocks = blocks_of(lines, layout, notes, name) if layout else []
    if layout is None or not blocks:
        what = "rows of at least two numbers: a wavelength or energy, n, and k where it is known"
        raise Unreadable("file", name, what)
    if sum(len(block.rows) for block in blocks) < 2:
        raise Unreadable("file", name, "at least two rows; give a single index as n_t and k_t")
    tables: list[Table] = []
    for block in blocks:
        tables.append(_table(block, layout, notes, tables[0].unit if tables else None))
    told = {role for table in tables for role in table.columns}
    if not told & {"n", "eps1", "delta"}:
        raise Unreadable("file", name, "a column of n, eps1 or delta; there is none")
    return Content(tables=tables)


def _table(block: Block, layout: Layout, notes: Notes, before: str | None) -> Table:
    numbers = np.array(block.rows)
    named = columns_named(block.header, layout, numbers.shape[1])
    unit = None
    if notes.choices.columns is not None:
        columns = by_hand(notes.choices.columns, numbers.shape[1])
        unit = named[1] if named else None
    elif named is not None:
        columns, unit = named
    else:
        columns = by_number(numbers, notes)
    at = next(i for i, role in enumerate(columns) if role in _ABSCISSAE)
    roles = {role: numbers[:, i] for i, role in enumerate(columns) if role in _VALUES}
    if unit is None and columns[at] in _USUAL and columns[at] != "wavelength":
        unit, why = _USUAL[columns[at]], f"the usual unit of a column of {columns[at]}"
    else:
        why = "the column is called so"
    if before is not None and unit is None:
        unit, why = before, "the table above has it"
    unit = decided_unit(
        numbers[:, at],
        notes,
        named=unit,
        why=why,
        hinted=unit_in(block.header),
        n=roles.get("n"),
        is_certain=unit is not None and unit == before,
    )
    return Table(numbers[:, at], unit, roles, np.array(block.numbers))


_ABSCISSAE = ("wavelength", "energy", "wavenumber", "frequency")
_VALUES = ("n", "k", "eps1", "eps2", "delta", "beta")
_USUAL = {"energy": "eV", "wavenumber": "cm-1", "frequency": "THz"}


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    return read_lines(documents[0].lines, documents[0].name, notes)


FORMAT = Format(
    id="table",
    title="a table",
    sniff=lambda _: "nothing else fits",
    read=_read,
    rank=9,
)
