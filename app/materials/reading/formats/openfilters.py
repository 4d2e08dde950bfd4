"""Materials of OpenFilters: a table of wavelengths in nanometers and numbers n-kj."""

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
    decided_unit,
)

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_ROW = re.compile(
    rf"\s*(?P<x>{_NUMBER})\s+(?P<n>{_NUMBER})(?:(?P<sign>[-+])(?P<k>{_NUMBER})[jJ])?\s*"
)
_KEY = re.compile(r"\s*(Description|Kind|Model|Properties)\s*:\s*(.*)", re.IGNORECASE)


def _keys(document: Document) -> dict[str, tuple[int, str]]:
    keys: dict[str, tuple[int, str]] = {}
    for number, line in enumerate(document.lines[:200], start=1):
        found = _KEY.match(line[:1000])
        if found:
            keys.setdefault(found[1].lower(), (number, found[2].strip()))
    return keys


def _sniff(document: Document) -> str | None:
    if {"kind", "model", "properties"} <= _keys(document).keys():
        return "it has the keys Kind, Model and Properties of OpenFilters"
    return None


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    keys = _keys(document)
    kind, model = (keys.get(key, (0, "nothing"))[1].lower() for key in ("kind", "model"))
    if kind != "regular" or model != "table" or "properties" not in keys:
        what = (
            f"a regular material whose model is a table; this is {kind[:20]}, {model[:20]}, which "
            "has no range of wavelengths or no single n: let OpenFilters write a table"
        )
        raise Unreadable("file", document.name, what)
    rows, lines = [], []
    for number, line in enumerate(
        document.lines[keys["properties"][0] :], keys["properties"][0] + 1
    ):
        if line.strip().lower() == "end":
            break
        found = _ROW.fullmatch(line[:200])
        if found:
            sign = -1.0 if found["sign"] == "-" else 1.0
            k = np.nan if found["k"] is None else sign * float(found["k"])
            rows.append((float(found["x"]), float(found["n"]), k))
            lines.append(number)
        elif line.strip():
            notes.leave_out(number, f"no wavelength and n-kj: {line.strip()[:60]}")
    if not rows:
        raise Unreadable("file", document.name, "rows of a wavelength and n-kj below Properties")
    numbers = np.array(rows)
    unit = decided_unit(
        numbers[:, 0], notes, named="nm", why="OpenFilters has nanometers", is_certain=True
    )
    columns = {"n": numbers[:, 1]}
    if np.isfinite(numbers[:, 2]).any():
        columns["k"] = numbers[:, 2]
    description = keys.get("description", (0, ""))[1].split("(")[0].strip()
    table = Table(numbers[:, 0], unit, columns, np.array(lines))
    return Content(tables=[table], name=description or None)


FORMAT = Format(
    id="openfilters",
    title="a material of OpenFilters",
    sniff=_sniff,
    read=_read,
)
