"""Answers of the API as tables of words and numbers, for a terminal and as CSV."""

import csv
import io
import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np
import orjson
import typer
from rich import box
from rich.console import Console
from rich.table import Table
from starlette.responses import Response

from app.answers.conversions import Conversions
from app.answers.curves import Curves
from app.answers.film_spectrum import FilmSpectrum
from app.answers.interface import InterfaceFacts, ResolvedPreset
from app.answers.lookup import (
    CoatedLookupTable,
    FilmLookupTable,
    InterpolationError,
    LookupTable,
    TableAxis,
)
from app.answers.materials.curves import MaterialCurves
from app.answers.materials.rgb import ChannelError


@dataclass(frozen=True, slots=True)
class Sheet:
    """A table: its header, and a row each."""

    header: Sequence[str]
    rows: Sequence[Sequence[Any]]
    title: str = ""


_PROSE = {"convention", "measure"}

Sheets = Callable[[Any], list[Sheet]]


def pairs(answer: Any) -> list[Sheet]:
    """Every number and name of an answer by its path; lists of objects and prose are left out."""
    return [Sheet(("name", "value"), list(_flat(answer)))]


def _entries(value: Any) -> Mapping[str, Any] | None:
    """Fields by name, of what has some."""
    if isinstance(value, Mapping):
        return value
    return {f.name: getattr(value, f.name) for f in fields(value)} if is_dataclass(value) else None


def _flat(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    for name, entry in (_entries(value) or {}).items():
        if _entries(entry) is not None:
            yield from _flat(entry, f"{path}{name}.")
        elif name not in _PROSE and not (
            isinstance(entry, list | tuple) and entry and _entries(entry[0]) is not None
        ):
            yield path + name, entry


def _inside(row: Any, column: str) -> Any:
    """Follow a column's name, whose dots lead inside; None where there is nothing."""
    for name in column.split("."):
        row = row.get(name) if isinstance(row, Mapping) else getattr(row, name, None)
    return row


def listed(key: str, *columns: str, title: str = "") -> Sheets:
    """One row for each object of a list; a dot in a column's name leads inside."""

    def sheets(answer: Any) -> list[Sheet]:
        rows = [[_inside(row, column) for column in columns] for row in getattr(answer, key)]
        header = [column.rpartition(".")[2] for column in columns]
        return [Sheet(header, rows, title)] if rows else []

    return sheets


def several(*parts: Sheets) -> Sheets:
    """One table after the other."""
    return lambda answer: [sheet for part in parts for sheet in part(answer)]


def curves(answer: Curves | FilmSpectrum) -> list[Sheet]:
    """An angle or a wavelength a row, a curve a column."""
    columns = answer.table().columns
    return [Sheet(list(columns), list(zip(*columns.values(), strict=True)))]


def conversions(answer: Conversions) -> list[Sheet]:
    """A value a row, with how much is lost on the way to it."""
    rows = [
        (result.form, name, value, result.status, result.why)
        for result in answer["results"]
        for name, value in result.values.items()
    ]
    return [Sheet(("form", "name", "value", "status", "why"), rows)]


def color_errors(answer: MaterialCurves) -> list[Sheet]:
    """A model and channel a row, with its errors against the spectrum."""
    header = [f.name for f in fields(ChannelError) if f.name != "error_at_max"]
    rows = [
        (curve.model, channel.name, *(getattr(error, name) for name in header))
        for curve in (answer.rgb.curves if answer.rgb else ())
        if curve.errors is not None
        for channel in fields(curve.errors)
        for error in [getattr(curve.errors, channel.name)]
    ]
    return [Sheet(("model", "channel", *header), rows)]


def lookup_in(sent: Response) -> LookupTable:
    """Read the answer of /lut, which the route writes itself, from its JSON."""
    told = orjson.loads(bytes(sent.body))
    # What has fields that no plain table has is told apart by them.
    kinds: dict[str, type[LookupTable]] = {"layers": CoatedLookupTable, "media": FilmLookupTable}
    kind = next((kinds[name] for name in kinds if name in told), LookupTable)
    facts = told["interface"]
    for side in ("incident", "material") if facts else ():
        facts[side] = facts[side] and ResolvedPreset(**facts[side])
    told |= {
        "interface": facts and InterfaceFacts(**facts),
        "axes": [TableAxis(**axis) for axis in told["axes"]],
        "error": InterpolationError(**told["error"]),
        "texels": np.array(told["texels"]),
    }
    return kind(**told)


def lookup(answer: LookupTable) -> list[Sheet]:
    """A texel a row."""
    columns = answer.table().columns
    return [Sheet(list(columns), list(zip(*columns.values(), strict=True)))]


def heading(answer: Any) -> str:
    """The two media that an answer is about and the wavelength, where it knows them."""
    if isinstance(answer, MaterialCurves):
        seen = answer.rgb
        light = f" in linear sRGB under {seen.illuminant}, {seen.observer} observer" if seen else ""
        incident = answer.front.incident
        before = f"n_i = {cell(answer.front.n_i)}" if incident is None else _named(incident)
        return f"{before}; {_named(answer.material)}, its spectrum{light}"
    if isinstance(answer, LookupTable):
        off = f"; largest error of reading between texels {answer.error.max_abs:.3g}"
        return f"{answer.title()}{off}" if answer.interface is None else f"{_media(answer)}{off}"
    return _media(answer)


def _media(answer: Any) -> str:
    facts = getattr(answer, "interface", None)
    if not isinstance(facts, InterfaceFacts):
        return ""
    front = f"n_i = {cell(facts.n_i)}{_preset(facts.incident)}"
    return f"{front}; n_t = {cell(facts.n_t)}, k_t = {cell(facts.k_t)}{_preset(facts.material)}"


def _named(material: Any) -> str:
    return f"{material.name} ({material.id})"


def _preset(resolved: ResolvedPreset | None) -> str:
    if resolved is None:
        return ""
    nm = resolved.wavelength_nm
    at = "" if nm is None else f", at {cell(nm)} nm"
    return f" ({resolved.name}, {resolved.id}{at})"


def cell(value: Any) -> str:
    """Write a value: numbers as short as they are, nothing for what is not known."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        written = f"{value:.12g}" if float(f"{value:.12g}") == value else f"{value:.17g}"
        return written if math.isfinite(value) else ""
    if isinstance(value, list | tuple | np.ndarray):
        return ", ".join(map(cell, value))
    return str(value)


def write_csv(sheets: Sequence[Sheet]) -> str:
    """Write the first table as CSV with a header row."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(sheets[0].header)
    rows.writerows([cell(value) for value in row] for row in sheets[0].rows)
    return text.getvalue()


def print_tables(sheets: Sequence[Sheet], said: str = "") -> None:
    """Print tables below what they are about, no wider than the terminal where there is one."""
    console = Console(highlight=False)
    if console.is_terminal:
        if said:
            console.print(said, markup=False)
        for sheet in sheets:
            console.print(*map(_drawn, within(sheet, console.width)))
        return
    text = io.StringIO()
    Console(file=text, highlight=False, width=100_000).print(*map(_drawn, sheets))
    lines = [line.rstrip() for line in text.getvalue().splitlines()]
    typer.echo("\n".join([*([said, ""] if said else []), "\n".join(lines).strip("\n")]))


_PROSE_WIDTH = 24
"""Columns that sentences are broken to, where they must be."""


def within(sheet: Sheet, width: int) -> list[Sheet]:
    """Break a table that is wider than the terminal into several, each with the first column.

    Before that columns without any value are left out and headers are broken at their underscores.
    """
    columns = [[cell(row[at]) for row in sheet.rows] for at in range(len(sheet.header))]
    if _width(map(_widest, sheet.header, columns)) <= width:
        return [sheet]
    kept = [at for at, column in enumerate(columns) if any(column)]
    header = {at: _broken(sheet.header[at], max(map(len, columns[at]))) for at in kept}
    least = {
        at: _PROSE_WIDTH if _is_prose(columns[at]) else _widest(header[at], columns[at])
        for at in kept
    }
    parts: list[list[int]] = []
    for at in kept:
        if not parts or _width(least[i] for i in [*parts[-1], at]) > width:
            parts.append([] if not parts else [kept[0]])
        parts[-1].append(at)
    return [
        Sheet(
            [header[at] for at in part],
            [[row[at] for at in part] for row in sheet.rows],
            "" if number else sheet.title,
        )
        for number, part in enumerate(parts)
    ]


def _width(columns: Iterable[int]) -> int:
    """Of a table: a blank on each side of a column, one between them and one at each end."""
    return sum(column + 3 for column in columns) + 1


def _widest(header: str, column: Sequence[str]) -> int:
    return max(map(len, [*header.split("\n"), *column]))


def _is_prose(column: Sequence[str]) -> bool:
    return max(map(len, column)) > _PROSE_WIDTH and any(" " in text for text in column)


def _broken(name: str, width: int) -> str:
    """Break a header at its underscores and dots into lines no longer than the column, if it can be."""
    lines = [""]
    for part in re.findall(r"[^_.]+[_.]*", name):
        if lines[-1] and len(lines[-1] + part) > width:
            lines.append("")
        lines[-1] += part
    return "\n".join(lines)


def _drawn(sheet: Sheet) -> Table:
    table = Table(box=box.SIMPLE_HEAD, title=sheet.title or None, title_justify="left")
    for at, name in enumerate(sheet.header):
        numbers = all(isinstance(row[at], int | float | None) for row in sheet.rows)
        table.add_column(name, justify="right" if numbers else "left", overflow="fold")
    for row in sheet.rows:
        table.add_row(*map(cell, row))
    return table
