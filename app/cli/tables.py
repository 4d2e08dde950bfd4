"""Answers of the API as tables of words and numbers, for a terminal and as CSV."""

import csv
import io
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np
import typer
from rich import box
from rich.console import Console
from rich.table import Table

from app.answers.conversions import Conversions
from app.answers.curves import Curves
from app.answers.film_spectrum import FilmSpectrum


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


def print_tables(sheets: Sequence[Sheet]) -> None:
    """Print tables as wide as the terminal, or as they are where nobody looks at them."""
    console = Console(highlight=False)
    if console.is_terminal:
        console.print(*map(_drawn, sheets))
        return
    text = io.StringIO()
    Console(file=text, highlight=False, width=100_000).print(*map(_drawn, sheets))
    lines = [line.rstrip() for line in text.getvalue().splitlines()]
    typer.echo("\n".join(lines).strip("\n"))


def _drawn(sheet: Sheet) -> Table:
    table = Table(box=box.SIMPLE_HEAD, title=sheet.title or None, title_justify="left")
    for at, name in enumerate(sheet.header):
        numbers = all(isinstance(row[at], int | float | None) for row in sheet.rows)
        table.add_column(name, justify="right" if numbers else "left", overflow="fold")
    for row in sheet.rows:
        table.add_row(*map(cell, row))
    return table
