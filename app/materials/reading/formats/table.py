"""Any table of numbers: with commas, semicolons, tabs, bars or blanks, with or without names."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

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
from app.materials.reading.instead import instead
from app.optics.parameters import Array


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
        raise Unreadable("file", name, instead(lines))
    if sum(len(block.rows) for block in blocks) < 2:
        what = f"at least two rows; give a single index as n_t and k_t{notes.first_left_out}"
        raise Unreadable("file", name, what)
    tables: list[Table] = []
    for block in blocks:
        tables += _tables(block, layout, notes, tables[0].unit if tables else None)
    told = {role for table in tables for role in table.columns}
    if not told & {"n", "eps1", "delta"}:
        raise Unreadable("file", name, "a column of n, eps1 or delta; there is none")
    return Content(tables=tables)


def _tables(block: Block, layout: Layout, notes: Notes, before: str | None) -> list[Table]:
    """Columns with their abscissa, which n and k may each have of their own, beside one another."""
    numbers = np.array(block.rows)
    width = numbers.shape[1]
    named = columns_named(block.header, layout, width, notes)
    units = named[1] if named is not None else (None,) * width
    if notes.choices.columns is not None:
        columns = by_hand(notes.choices.columns, width)
    elif named is not None:
        columns = named[0]
    else:
        columns = by_number(numbers, notes)
    edges = [i for i, role in enumerate(columns) if role in _ABSCISSAE]
    parts = [range(at, end) for at, end in pairwise([*edges, width])]
    if sum(any(columns[i] in _VALUES for i in part) for part in parts) > 1:
        return [
            _table(block, numbers, {i: columns[i] for i in part}, units[part[0]], notes, before)
            for part in parts
            if any(columns[i] in _VALUES for i in part)
        ]
    roles = {i: role for i, role in enumerate(columns) if role in _VALUES}
    at = edges[0]
    return [_table(block, numbers, {at: columns[at]} | roles, units[at], notes, before)]


def _table(
    block: Block,
    numbers: Array,
    columns: Mapping[int, str],
    unit: str | None,
    notes: Notes,
    before: str | None,
) -> Table:
    """The first of the columns is the abscissa of the others."""
    at = next(iter(columns))
    there = np.isfinite(numbers[:, at])
    x = numbers[there, at]
    roles = {role: numbers[there, i] for i, role in columns.items() if role in _VALUES}
    if unit is None and columns[at] in _USUAL and columns[at] != "wavelength":
        unit, why = _USUAL[columns[at]], f"the usual unit of a column of {columns[at]}"
    else:
        why = "the column is called so"
    if before is not None and unit is None:
        unit, why = before, "the table above has it"
    unit = decided_unit(
        x,
        notes,
        named=unit,
        why=why,
        hinted=unit_in(block.header),
        n=roles.get("n"),
        is_certain=unit is not None and unit == before,
    )
    return Table(x, unit, roles, np.array(block.numbers)[there])


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
