"""Tables of Henke and the CXRO: delta and beta over energy or wavelength, n = 1 - delta, k = beta."""

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
from app.materials.reading.units import units_named

_NAMES = re.compile(r"\b(energy|wavelength).*\bdelta\b.*\bbeta\b", re.IGNORECASE)
_FACTORS = re.compile(r"\bE\s*\(eV\).*\bf1\b.*\bf2\b", re.IGNORECASE)
_HEADER = 12


def _line(document: Document, pattern: re.Pattern[str]) -> str | None:
    return next((line for line in document.lines[:_HEADER] if pattern.search(line[:200])), None)


def _sniff(document: Document) -> str | None:
    if _line(document, _NAMES):
        return "it has columns delta and beta, as the CXRO writes them"
    if _line(document, _FACTORS) or document.suffix == ".nff":
        return "it has columns f1 and f2"
    return None


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    names = _line(document, _NAMES)
    if names is None:
        what = (
            "delta and beta; scattering factors f1 and f2 give them with a density: take "
            "'index of refraction' of the CXRO"
        )
        raise Unreadable("file", document.name, what)
    lines = [
        "" if i < _HEADER and (_NAMES.search(x[:200]) or "density" in x.lower()) else x
        for i, x in enumerate(document.lines)
    ]
    layout = layout_of(lines, notes)
    blocks = blocks_of(lines, layout, notes, document.name) if layout else []
    if len(blocks) != 1 or len(blocks[0].rows[0]) < 3:
        raise Unreadable("file", document.name, "rows of an energy, delta and beta")
    numbers = np.array(blocks[0].rows)
    named = (units_named(names) or ["eV" if "energy" in names.lower() else "nm"])[0]
    unit = decided_unit(
        numbers[:, 0], notes, named=named, why="the column is called so", is_certain=True
    )
    columns = {"delta": numbers[:, 1], "beta": numbers[:, 2]}
    first = document.lines[0].split("Density")[0].strip()
    table = Table(numbers[:, 0], unit, columns, np.array(blocks[0].numbers))
    return Content(tables=[table], name=first if 0 < len(first) < 40 else None)


FORMAT = Format(
    id="henke",
    title="delta and beta of the CXRO",
    sniff=_sniff,
    read=_read,
)
