"""`materials/refractiveindex/index.jsonl`: every page of the database as lists show it."""

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml
from pydantic import TypeAdapter

from app.materials.published.files import database_directory, plain, read_page
from app.materials.published.index import PREFIX
from app.materials.published.material import LICENCE, spectrum_file
from app.materials.reading.report import Reading
from app.materials.schema import TRANSPARENT, Axis, Category, Preset, Sample
from app.materials.spectrum import Spectrum
from app.materials.summary import REFERENCE_NM, summary
from app.optics.errors import OpticsError
from tools.build_materials.selection import Choice

MEDIA = "refractiveindex/reference_media.json"
"""What n is relative to, and where wavelengths are counted, by file."""

SELECTED = ("3d", "popular_glass")
"""Shelves that repeat pages of others."""

MISDIRECTED = {
    "main/MgO/Synowicki": "main/MgO/nk/Synowicki.yml",
    "main/ZrO2/Synowicki": "main/ZrO2/nk/Synowicki.yml",
}
"""Pages that the catalog of the release sends to the file of another material, and their own files."""

_ROOM_K = (283.0, 308.0)
_AXES: dict[str, Axis] = {
    "o": "o",
    "e": "e",
    "para": "para",
    "perp": "perp",
    "alpha": "alpha",
    "beta": "beta",
    "gamma": "gamma",
    "α": "alpha",
    "β": "beta",
    "γ": "gamma",
}
"""As the conditions of a page say it, or its name."""
_NAMED_AXIS = re.compile(r"[nk ]\((o|e|α|β|γ)\)")
_UNLIKE = ("model", "simulation", "nano", "2d", "flake", "amorphous", "supercooled")
_RANGES = re.compile(
    r"(?:n,k|n|k) ?(\([^)]*\))? ?[\d.]+(?:e[+-]?\d+)? ?[–-] ?[\d.]+(?:e\+?\d+)? µm"
)
_preset = TypeAdapter(Preset)


@dataclass
class Listing:
    """A file, and where the catalog lists it."""

    file: str
    shelf: str
    book: str
    page: str
    book_name: str
    page_name: str
    group: str
    """The heading above the page in its book."""
    also: list[str] = field(default_factory=list)
    families: list[str] = field(default_factory=list)
    """What popular glasses are called whatever their maker."""

    @property
    def path(self) -> str:
        """Shelf, book and page."""
        return f"{self.shelf}/{self.book}/{self.page}"

    @property
    def title(self) -> str:
        """What the catalog calls it."""
        return " · ".join(filter(None, (self.book_name, self.group, self.page_name)))

    @property
    def name(self) -> str:
        """What it is called as a material: a maker's glass by its own name, else with the author."""
        if self.shelf == "specs":
            return f"{self.page_name} ({self.book_name.partition(' - ')[0]})"
        author, _, rest = self.page_name.partition(":")
        said = [_RANGES.sub(lambda m: m[1] or "", part).strip(" ,") for part in rest.split(";")]
        by = " ".join(filter(None, [author, *said]))
        group = "" if self.group.startswith("Experimental") else self.group
        return ", ".join(filter(None, (self.book_name, group, by)))


def listings() -> list[Listing]:
    """Every file that the catalog lists, in its order."""
    text = (database_directory() / "catalog-nk.yml").read_bytes()
    catalog = yaml.load(text, Loader=yaml.CBaseLoader)  # noqa: S506 (strings alone)
    found: dict[str, Listing] = {}
    for one in _rows(catalog):
        first = found.setdefault(one.file, one)
        if first is not one:
            first.also.append(one.path)
            if one.shelf == "popular_glass":
                first.families.append(one.book)
    return list(found.values())


def _rows(catalog: list[dict[str, Any]]) -> Iterator[Listing]:
    for shelf in catalog:
        for book in shelf.get("content", ()):
            group = ""
            for page in book.get("content", ()):
                if "DIVIDER" in page:
                    group = plain(page["DIVIDER"])
                    continue
                path = f"{shelf['SHELF']}/{book['BOOK']}/{page['PAGE']}"
                yield Listing(
                    file=MISDIRECTED.get(path, page["data"].replace("//", "/")),
                    shelf=shelf["SHELF"],
                    book=book["BOOK"],
                    page=page["PAGE"],
                    book_name=plain(book["name"]),
                    page_name=plain(page["name"]),
                    group=group,
                )


def published_index(root: Path, choices: list[Choice]) -> str:
    """Return the text of the list.

    Parameters
    ----------
    root
        The project.
    choices
        The spectra of the catalog: a book that one of them is from gives its pages the category.
    """
    media = _media(root / "materials" / MEDIA)
    categories: dict[str, set[Category]] = {}
    chosen: dict[str, list[str]] = {}
    for choice in choices:
        book = choice.entry.page.rpartition("/")[0]
        categories.setdefault(book, set()).add(choice.material.category)
        if choice.rival_of is None:
            names = {name.casefold() for name in (choice.id, choice.name, *choice.aliases)}
            chosen[choice.entry.page] = sorted(names)
    lines = []
    for listing in listings():
        known = categories.get(f"{listing.shelf}/{listing.book}", set())
        category = known.copy().pop() if len(known) == 1 else _category(listing)
        entry = _entry(listing, category, media.get(listing.file, (None, None)))
        called = [chosen[path] for path in (listing.path, *listing.also) if path in chosen]
        if called:
            entry["chosen_as"] = called[0]
        lines.append(json.dumps(entry, ensure_ascii=False, allow_nan=False, separators=(",", ":")))
    return "\n".join(lines) + "\n"


def _media(path: Path) -> dict[str, tuple[str | None, str | None]]:
    groups = json.loads(path.read_text(encoding="utf-8"))["groups"]
    return {
        file: (group["relative_to"], group["wavelength_in"])
        for group in groups
        for file in group["files"]
    }


def _category(listing: Listing) -> Category:
    if "glass" in listing.book_name.casefold():
        return "glass"
    return "generic"


def _entry(
    listing: Listing,
    category: Category,
    medium: tuple[str | None, str | None],
) -> dict[str, Any]:
    entry: dict[str, Any] = {"id": PREFIX + listing.path, "file": listing.file}
    if listing.also:
        entry["also"] = [PREFIX + path for path in dict.fromkeys(listing.also)]
    entry |= {"title": listing.title, "names": _names(listing)}
    try:
        reading, told = read_page(listing.file)
        about: dict[str, Any] = {
            "id": PREFIX + listing.path,
            "name": listing.name,
            "category": category,
            "axis": _axis(listing, told.conditions),
            "sample": _sample(listing, told.conditions),
            "confidence": "unstated",
            "relative_to": medium[0],
            "wavelength_in": medium[1],
            "note": None,
            "warnings": _warnings(reading),
        }
        spectrum = Spectrum(spectrum_file(listing.file, reading, told, about))
        made = summary(spectrum)
    except OpticsError as error:
        return entry | {"order": 99, "refused": error.allowed}
    warnings = (*about["warnings"], *made.pop("warnings"))
    abbe = spectrum.abbe_number if category in TRANSPARENT else None
    preset = Preset(
        **about | made | {"warnings": warnings},
        kind="spectrum",
        source=told.reference,
        doi=told.doi,
        licence=LICENCE,
        abbe=None if abbe is None else round(abbe, 4),
    )
    kept = _preset.dump_python(preset, mode="json", exclude_defaults=True, exclude={"id"})
    order = _order(listing, spectrum, told.conditions)
    return entry | {"order": order, "preset": _rounded(kept)}


def _rounded(preset: dict[str, Any]) -> dict[str, Any]:
    """Ten digits, as the index of the catalog has."""
    for name in ("n", "n_absolute", "k", "F0"):
        if preset.get(name) is not None:
            preset[name] = float(f"{preset[name]:.10g}")
    preset["color"]["luminance"] = round(preset["color"]["luminance"], 6)
    return preset


def _warnings(reading: Reading) -> tuple[str, ...]:
    warnings = list(reading.warnings)
    if reading.merged:
        warnings.append(f"{reading.merged} points repeat a wavelength: the mean is used")
    if reading.left_out:
        first = reading.left_out[0]
        warnings.append(f"rows are left out, the first in line {first.line}: {first.why}")
    return tuple(warnings)


def _names(listing: Listing) -> list[str]:
    """What the material is called."""
    about = database_directory() / "data" / listing.file.partition("/nk/")[0] / "about.yml"
    names: list[str] = [listing.page] if listing.shelf == "specs" else [listing.book]
    names += listing.families
    if listing.shelf != "specs":
        outside, _, inside = listing.book_name.partition(" (")
        names += [*outside.split(", "), *inside.removesuffix(")").split(", ")]
        if about.is_file():
            told = yaml.load(about.read_bytes(), Loader=yaml.CBaseLoader)  # noqa: S506
            names += [plain(name) for name in told.get("NAMES") or ()]
    return list(dict.fromkeys(name.strip() for name in names if name.strip()))


def _axis(listing: Listing, conditions: Mapping[str, Any]) -> Axis:
    named = _NAMED_AXIS.search(listing.page_name)
    said = str(conditions.get("direction", named[1] if named else ""))
    return _AXES.get(said, "isotropic")


def _sample(listing: Listing, conditions: Mapping[str, Any]) -> Sample:
    said = f"{listing.group} {listing.page_name} {listing.page}".casefold()
    if "dft" in said or ("simulation" in said and "model" not in said):
        return "calculated"
    if "model" in said:
        return "model"
    if "bulk" in said:
        return "bulk"
    if "film" in said or "film_thickness_nm" in conditions:
        return "film"
    return "unstated"


def _order(listing: Listing, spectrum: Spectrum, conditions: Mapping[str, Any]) -> int:
    """How far a page is from what its material is taken for: at room temperature, visible, bulk."""
    low, high = spectrum.range_nm
    said = f"{listing.group} {listing.page_name}".casefold()
    temperature = conditions.get("temperature_k")
    warm = isinstance(temperature, float) and not _ROOM_K[0] <= temperature <= _ROOM_K[1]
    return (
        8 * any(word in said for word in _UNLIKE)
        + 4 * (not low <= REFERENCE_NM <= high)
        + 2 * warm
        + ("film" in said or "film_thickness_nm" in conditions)
    )
