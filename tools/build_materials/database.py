"""Reads pages of the refractiveindex.info database as the pinned package ships it."""

import re
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation
from functools import cache
from hashlib import sha256
from html import unescape
from importlib import import_module
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import yaml

from app.materials.reading.document import document
from app.materials.reading.formats import refractiveindex_info
from app.materials.reading.report import Choices, Notes
from app.materials.reading.units import UNITS
from app.materials.schema import Database, Points, Quantity
from app.optics.parameters import Array

PACKAGE = "refractiveindex"
LICENCE = "CC0-1.0"
LEAST_K = -1e-9
"""Rounding below 0 that a table may contain; anything lower is an error in it."""

_UNITS = {
    "temperature": ("k", Decimal(1)),
    "pressure": ("pa", Decimal(1)),
    "thickness": ("nm", Decimal(10) ** 9),
}


@dataclass(frozen=True)
class Page:
    """One measurement, with n and k as the database has them."""

    file: str
    sha256: str
    reference: str
    doi: tuple[str, ...]
    links: tuple[str, ...]
    comments: str | None
    conditions: dict[str, float | str]
    n: Quantity
    k: Quantity | None
    warnings: tuple[str, ...]


def release() -> Database:
    """Describe the release that the package ships."""
    shipped = import_module(f"{PACKAGE}._database_version")
    return Database(
        name="refractiveindex.info",
        tag=shipped.DATABASE_VERSION,
        commit=shipped.DATABASE_COMMIT,
        package=f"{PACKAGE} {version(PACKAGE)}",
        licence=LICENCE,
    )


def read_page(path: str) -> Page:
    """Read the page at shelf/book/page."""
    file = _pages()[path]
    content = (_root() / file).read_bytes()
    page = refractiveindex_info.page(content.decode(), file)
    warnings: list[str] = []
    quantities = _quantities(file, content, warnings)
    reference, links = _reference(page["REFERENCES"])
    doi = tuple(_doi(link) for link in links if "doi.org/" in link)
    comments = _plain(page["COMMENTS"]) if page.get("COMMENTS") else None
    return Page(
        file=file,
        sha256=sha256(content).hexdigest(),
        reference=reference,
        doi=doi,
        links=tuple(link for link in links if "doi.org/" not in link),
        comments=comments or None,
        conditions=_conditions(page.get("CONDITIONS") or {}),
        n=quantities["n"],
        k=quantities.get("k"),
        warnings=tuple(warnings),
    )


def _root() -> Path:
    found = find_spec(PACKAGE)
    if found is None or found.origin is None:
        raise ModuleNotFoundError(f"{PACKAGE} is not installed: install the extra 'data'")
    return Path(found.origin).parent / "database"


@cache
def _pages() -> dict[str, str]:
    catalog = yaml.load((_root() / "catalog-nk.yml").read_bytes(), Loader=yaml.CBaseLoader)  # noqa: S506
    files: dict[str, str] = {}
    for shelf in catalog:
        for book in shelf.get("content", ()):
            for page in book.get("content", ()):
                if "PAGE" in page:
                    path = f"{shelf['SHELF']}/{book['BOOK']}/{page['PAGE']}"
                    files.setdefault(path, f"data/{page['data']}")
    return files


def _quantities(file: str, content: bytes, warnings: list[str]) -> dict[str, Quantity]:
    """n and k as the program's own reader finds them; a page that it cannot read whole is refused."""
    notes = Notes(Choices())
    found = refractiveindex_info.FORMAT.read([document(file, content)], notes)
    if notes.left_out:
        raise ValueError(f"{file}: {notes.left_out}")
    quantities: dict[str, Quantity] = {} if found.formula is None else {"n": found.formula}
    for table in found.tables:
        wavelength_nm = UNITS[table.unit].nanometers(table.x)
        for name, values in table.columns.items():
            if name in quantities:
                raise ValueError(f"{file} gives {name} twice")
            quantities[name] = native_points(name, wavelength_nm, values, warnings)
    return quantities


def native_points(name: str, wavelength_nm: Array, measured: Array, warnings: list[str]) -> Points:
    """Sort the native points, and merge those at one wavelength into their mean."""
    at: dict[float, list[float]] = {}
    for wavelength, number in zip(wavelength_nm.tolist(), measured.tolist(), strict=True):
        at.setdefault(wavelength, []).append(number)
    values: list[float] = []
    negative = 0
    for wavelength, same in sorted(at.items()):
        if len(set(same)) > 1:
            warnings.append(f"{name} is given {len(same)} times at {wavelength:.10g} nm: the mean")
        value = same[0] if len(set(same)) == 1 else sum(same) / len(same)
        if name == "n" and not value > 0.0:
            raise ValueError(f"n = {value} at {wavelength} nm")
        if name == "k" and not value >= LEAST_K:
            raise ValueError(f"k = {value} at {wavelength} nm")
        negative += value < 0.0
        values.append(max(value, 0.0))
    if negative:
        warnings.append(f"{name} is rounded below 0 at {negative} wavelengths: set to 0")
    return Points(kind="points", wavelength_nm=tuple(sorted(at)), values=tuple(values))


def _plain(html: str) -> str:
    """Turn a line of HTML into text; crystal directions such as <100> are no tags."""
    spaced = re.sub(r"<br\s*/?>|</?p>", " ", html)
    raised = re.sub(r"<sup>(.*?)</sup>", r"^\1", spaced)
    return " ".join(unescape(re.sub(r"</?[a-zA-Z][^>]*>", "", raised)).split())


def _reference(html: str) -> tuple[str, tuple[str, ...]]:
    """Split a citation into its text and its links; links to plotting scripts are left out."""
    without_scripts = re.sub(r"\[?<a [^>]*refractiveindex\.info-scripts.*?</a>\]?", "", html)
    links = re.findall(r'href="([^"]+)"', without_scripts)
    return _plain(without_scripts), tuple(dict.fromkeys(unquote(unescape(link)) for link in links))


def _doi(link: str) -> str:
    return link.split("doi.org/", 1)[1]


def _conditions(conditions: dict[str, Any]) -> dict[str, float | str]:
    """Name the unit in the key, and give films in nanometers; the database has SI units."""
    result: dict[str, float | str] = {}
    for key, value in conditions.items():
        unit, factor = _UNITS.get(key.rsplit("_", 1)[-1], (None, Decimal(1)))
        try:
            number = Decimal(value) * factor
        except InvalidOperation:
            result[key] = str(value)
        else:
            result[f"{key}_{unit}" if unit else key] = float(number)
    return result
