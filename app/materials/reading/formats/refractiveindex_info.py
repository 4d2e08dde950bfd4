"""Pages of refractiveindex.info: YAML with tables and dispersion formulas."""

from collections.abc import Iterator, Sequence
from decimal import Decimal, InvalidOperation
from math import isfinite
from typing import Any

import numpy as np
import yaml

from app.materials.dispersion import check_coefficients
from app.materials.reading.formats import (
    Content,
    Document,
    Format,
    Notes,
    Table,
    Unreadable,
    decided_unit,
)
from app.materials.schema import Formula
from app.optics.errors import NotAllowed

_DEEPEST = 12
"""Levels of nesting; libyaml's own loader ends the process at some ten thousand."""
_KEYS = ("DATA:", "REFERENCES:", "COMMENTS:", "CONDITIONS:", "SPECS:")


def _sniff(document: Document) -> str | None:
    lines = document.lines
    if any(line.startswith("DATA:") for line in lines) and "type:" in document.text:
        return "it has the keys DATA and type of a page of refractiveindex.info"
    return None


def page(text: str, name: str) -> dict[str, Any]:
    """Read YAML into strings, lists and mappings.

    Raises
    ------
    Unreadable
        If it is none, is nested deeply or refers to itself.
    """
    try:
        depth = 0
        for event in yaml.parse(text, Loader=yaml.CSafeLoader):
            if isinstance(event, yaml.CollectionStartEvent):
                depth += 1
            elif isinstance(event, yaml.CollectionEndEvent):
                depth -= 1
            if depth > _DEEPEST or isinstance(event, yaml.AliasEvent):
                raise Unreadable("file", name, "YAML without anchors, at most a few levels deep")
        loaded = yaml.load(text, Loader=yaml.CBaseLoader)  # noqa: S506 (strings alone)
    except (yaml.YAMLError, ValueError, TypeError) as error:
        if isinstance(error, NotAllowed):
            raise
        where = getattr(error, "problem_mark", None)
        line = f", line {where.line + 1}" if where is not None else ""
        raise Unreadable("file", name, f"YAML; this is none{line}") from None
    if not isinstance(loaded, dict) or not isinstance(loaded.get("DATA"), list):
        raise Unreadable("file", name, "a page with a list DATA")
    return loaded


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    return content(document, page(document.text, document.name), notes)


def content(document: Document, loaded: dict[str, Any], notes: Notes) -> Content:
    """Find n and k in a page that was read.

    Raises
    ------
    Unreadable
        If there is no n, or something that is neither a table nor a formula.
    """
    starts = _data_lines(document.lines)
    tables: list[Table] = []
    formula: Formula | None = None
    for block in loaded["DATA"]:
        kind, what = _kind(block, document.name)
        start = next(starts, 0)
        if kind == "formula":
            if formula is not None:
                raise Unreadable("file", document.name, "one formula; this page has several")
            formula = _formula(block, what, document.name)
        else:
            tables.append(_table(block, what, start, document.name, notes))
    tabulated = any("n" in table.columns for table in tables)
    if formula is None and not tabulated:
        raise Unreadable("file", document.name, "n; this page has k alone")
    if formula is not None and tabulated:
        formula, tables = _one_of_both(formula, tables, notes)
    return Content(tables=tables, formula=formula, relative_to=_relative_to(loaded))


def _one_of_both(
    formula: Formula, tables: list[Table], notes: Notes
) -> tuple[Formula | None, list[Table]]:
    """Choose between a formula and a table of n, as a page may have both."""
    chosen = notes.choices.n_from or "table"
    why = "the page has a formula of n and a table of it; the points are what was measured"
    notes.assume("n_from", chosen, why, ["formula"])
    if chosen == "table":
        return None, tables
    return formula, [
        Table(t.x, t.unit, {c: v for c, v in t.columns.items() if c != "n"}, t.lines)
        for t in tables
    ]


def _kind(block: Any, name: str) -> tuple[str, str]:
    words = block.get("type", "") if isinstance(block, dict) else ""
    parts = words.split() if isinstance(words, str) else []
    if len(parts) == 2 and parts[0] == "formula" and parts[1].isdigit():
        return "formula", parts[1]
    if len(parts) == 2 and parts[0] == "tabulated" and parts[1] in ("n", "k", "nk"):
        return "tabulated", parts[1]
    if parts and parts[-1] == "n2":
        raise Unreadable("file", name, "n and k; this page has the nonlinear index n2")
    raise Unreadable(
        "file", name, f"DATA of type formula or tabulated; this is {str(words)[:40]!r}"
    )


def _formula(block: dict[str, Any], number: str, name: str) -> Formula:
    written = block.get(
        "wavelength_range", block.get("range")
    )  # as pages of older releases have it
    try:
        low, high = (float(Decimal(text) * 1000) for text in str(written).split())
        coefficients = tuple(float(text) for text in str(block.get("coefficients")).split())
        if not np.isfinite([low, high, *coefficients]).all():
            raise ValueError
    except (ValueError, InvalidOperation, OverflowError):
        what = "a formula with coefficients and a wavelength_range of two numbers"
        raise Unreadable("file", name, what) from None
    try:
        check_coefficients(int(number), coefficients)
    except NotAllowed as error:
        what = f"a formula {number} whose coefficients are whole: {error.allowed}"
        raise Unreadable("file", name, what) from None
    return Formula(
        kind="formula", number=int(number), coefficients=coefficients, range_nm=(low, high)
    )


def _table(block: dict[str, Any], what: str, start: int, name: str, notes: Notes) -> Table:
    data = block.get("data")
    if not isinstance(data, str):
        raise Unreadable("file", name, "tables with data")
    rows, lines = [], []
    for number, line in enumerate(data.split("\n"), start=start + 1):
        cells = line.split()
        if not cells:
            continue
        try:
            row = [float(cell) if "_" not in cell else np.nan for cell in cells]
        except ValueError:
            row = []
        if len(row) == 1 + len(what) and all(map(isfinite, row)):
            rows.append(row)
            lines.append(number)
        else:
            notes.leave_out(number, f"no row of {1 + len(what)} numbers: {line.strip()[:60]}")
    if not rows:
        raise Unreadable("file", name, "tables with rows of numbers")
    numbers = np.array(rows)
    unit = decided_unit(
        numbers[:, 0],
        notes,
        named="um",
        why="refractiveindex.info has micrometers",
        is_certain=True,
    )
    columns = {role: numbers[:, i] for i, role in enumerate(what, start=1)}
    return Table(numbers[:, 0], unit, columns, np.array(lines))


def _data_lines(lines: Sequence[str]) -> Iterator[int]:
    """Numbers of the lines with `type`, from which those of rows are counted: the text is after."""
    for number, line in enumerate(lines, start=1):
        if line.strip().startswith("data:"):
            yield number
        elif line.strip().startswith("coefficients:"):
            yield 0


def _relative_to(loaded: dict[str, Any]) -> Any:
    """What n is relative to, where the page says it, under the keys of new releases or old ones."""
    for key, name in (("PROPERTIES", "n_absolute"), ("SPECS", "n_is_absolute")):
        section = loaded.get(key)
        if isinstance(section, dict) and name in section:
            return "vacuum" if str(section[name]).lower() == "true" else "air"
    return None


FORMAT = Format(
    id="refractiveindex_info",
    title="a page of refractiveindex.info",
    sniff=_sniff,
    read=_read,
)
