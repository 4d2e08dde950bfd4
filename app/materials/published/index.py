"""The list of all pages: what is searched stays in memory, presets are read line by line."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any

import orjson
from pydantic import TypeAdapter

from app.materials.errors import UnknownMaterial
from app.materials.location import data_directory
from app.materials.schema import Category, Preset, Range

PREFIX = "rii:"
"""What the ids of pages begin with."""

FILE = "refractiveindex/index.jsonl"
"""Below the directory of the data: a line a page, in the order of the database."""

SUPPLIERS = "specs"
"""The shelf of products, a book a supplier; in the books of others are measurements of a material."""

MOST_BESIDE = 3
"""Pages that are named where another is not known."""

_preset = TypeAdapter(Preset)


class UnknownPage(UnknownMaterial):
    """An id that begins as a page's and is none, or that of a page which is refused."""

    def __init__(self, id: str, hint: str, nearest: Iterable[str] = ()) -> None:  # noqa: A002
        super().__init__(id)
        self.nearest = list(nearest)
        self.allowed = hint
        self.args = (f"material = {id!r} is not allowed: {hint}",)


@dataclass(frozen=True, slots=True, kw_only=True)
class ListedPage:
    """A page as the list has it."""

    id: str
    """`rii:SHELF/BOOK/PAGE`; shelves of selected data, which repeat pages, are not among them."""
    name: str
    """What it is called as a material."""
    title: str
    """What its book and the page are called in the database."""
    file: str
    """Path below the database's `data`."""
    category: Category
    n_range_nm: Range | None
    """None where the page is refused."""
    k_range_nm: Range | None
    refused: str | None
    """Why nothing is computed of it."""
    order: int
    """Pages of a lower one stand for their material: as it is at room temperature, in the visible."""
    names: tuple[str, ...]
    """What its material is called."""
    called: str
    """The names folded to one case, each in a line of its own, for quick looks."""
    chosen_as: tuple[str, ...]
    """What the preset is called that it was chosen for, folded to one case."""
    said: str
    """What the database says of this page alone, folded: "water ice · warren 1984: ice"; nothing of
    suppliers' products, which are called so themselves."""
    words: str
    """Its id, names and title, folded."""
    source: str
    """The paper, folded."""
    start: int
    length: int
    """Where its line is."""

    @property
    def path(self) -> tuple[str, str, str]:
        """Shelf, book and page."""
        shelf, book, page = self.id.removeprefix(PREFIX).split("/")
        return shelf, book, page


class Pages:
    """All pages, by id in any case, or by that of a shelf that repeats them."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._listed: list[ListedPage] = []
        self._by_id: dict[str, int] = {}
        start = 0
        with path.open("rb") as lines:
            for number, line in enumerate(lines):
                entry = orjson.loads(line)
                self._listed.append(_listed(entry, start, len(line)))
                for id in (entry["id"], *entry.get("also", ())):  # noqa: A001
                    self._by_id.setdefault(_folded(id), number)
                start += len(line)

    @property
    def all(self) -> Sequence[ListedPage]:
        """Every page, in the order of the database; refused ones too."""
        return self._listed

    def beside(self, id: str) -> list[ListedPage]:  # noqa: A002
        """Return the other pages of a page's book; those of a supplier are other products."""
        shelf, book, _ = self.get(id).path
        if shelf == SUPPLIERS:
            return []
        return [
            page
            for page in self._listed
            if page.path[:2] == (shelf, book) and page.id != id and page.refused is None
        ]

    def known_at(self, id: str, wavelength_nm: float) -> tuple[str, ...]:  # noqa: A002
        """Return ids of pages of a page's book that are known at a wavelength, a few of them."""
        fitting = sorted(self.beside(id), key=lambda page: page.order)
        return tuple(page.id for page in fitting if _is_known(page, wavelength_nm))[:MOST_BESIDE]

    def called(self, name: str) -> list[ListedPage]:
        """Return the pages of what is called so: of each book the first."""
        return _first_of_books(self._called(name))

    def resembling(self, name: str, count: int) -> list[ListedPage]:
        """Return the pages of what is called nearly so: of each book the first."""
        wanted = name.casefold()
        known = {one.casefold() for page in self._listed for one in page.names}
        alike = [one for one in known if one[:1] == wanted[:1]]
        near = get_close_matches(wanted, alike, n=count, cutoff=0.8)
        return _first_of_books(page for one in near for page in self._called(one))[:count]

    def _called(self, name: str) -> list[ListedPage]:
        called = [page for page in self._listed if is_called(page, name)]
        return sorted(called, key=lambda page: page.order)

    def get(self, id: str) -> ListedPage:  # noqa: A002
        """Return the page of an id.

        Raises
        ------
        UnknownPage
            If there is none, or it is refused.
        """
        number = self._by_id.get(_folded(id.strip()))
        if number is None:
            near = self._nearest(id)
            hint = "rii:SHELF/BOOK/PAGE of refractiveindex.info; /materials?q= finds them"
            raise UnknownPage(id, hint + (f"; nearest: {', '.join(near)}" if near else ""), near)
        page = self._listed[number]
        if page.refused is not None:
            raise UnknownPage(id, f"a page that can be computed with, which takes {page.refused}")
        return page

    def _nearest(self, id: str) -> list[str]:  # noqa: A002
        """Ids that resemble one: of its book, or of books and pages called so."""
        book = _folded(id.rpartition("/")[0] + "/")
        beside = {key: key for key in self._by_id if key.startswith(book)}
        close = get_close_matches(_folded(id), beside or self._by_id, n=3, cutoff=0.6)
        return list(dict.fromkeys(self._listed[self._by_id[key]].id for key in close))

    def presets(self, pages: Iterable[ListedPage]) -> list[Preset]:
        """Read what lists show of pages, none of which is refused."""
        with self._path.open("rb") as file:
            return [_preset_at(file, page) for page in pages]


def _preset_at(file: Any, page: ListedPage) -> Preset:
    file.seek(page.start)
    return _preset.validate_python(_complete(orjson.loads(file.read(page.length))), strict=False)


def _complete(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {**entry["preset"], "id": entry["id"], "page": page_of(entry)}


def page_of(entry: Mapping[str, Any]) -> dict[str, str]:
    """Shelf, book and page of a line, with their title."""
    shelf, book, page = entry["id"].removeprefix(PREFIX).split("/")
    return {"shelf": shelf, "book": book, "page": page, "title": entry["title"]}


def _listed(entry: Mapping[str, Any], start: int, length: int) -> ListedPage:
    preset = entry.get("preset", {})
    names, title = tuple(entry["names"]), entry["title"]
    chosen_as = tuple(entry.get("chosen_as", ()))
    of_page = title.partition(" · ")[2]
    if entry["id"].startswith(f"{PREFIX}{SUPPLIERS}/"):
        of_page = ""
    return ListedPage(
        id=entry["id"],
        name=preset.get("name", title),
        category=preset.get("category", "generic"),
        title=title,
        file=entry["file"],
        n_range_nm=_range(preset.get("n_range_nm")),
        k_range_nm=_range(preset.get("k_range_nm")),
        refused=entry.get("refused"),
        order=entry["order"],
        names=names,
        called="\n".join(("", *names, "")).casefold(),
        chosen_as=chosen_as,
        said=of_page.casefold(),
        words=" ".join((entry["id"], *names, *chosen_as, title)).casefold(),
        source=preset.get("source", "").casefold(),
        start=start,
        length=length,
    )


def _first_of_books(pages: Iterable[ListedPage]) -> list[ListedPage]:
    first: dict[tuple[str, ...], ListedPage] = {}
    for page in pages:
        if page.refused is None:
            first.setdefault(page.path[:2], page)
    return list(first.values())


def _is_known(page: ListedPage, wavelength_nm: float) -> bool:
    ranges = (page.n_range_nm, page.k_range_nm)
    return all(ends is None or ends[0] <= wavelength_nm <= ends[1] for ends in ranges)


def _range(ends: Any) -> Range | None:
    return None if ends is None else (ends[0], ends[1])


def _folded(id: str) -> str:  # noqa: A002
    return id.casefold().replace("_", " ")


def is_called(page: ListedPage, name: str) -> bool:
    """Whether the material of a page is called so; formulas are spelled as they are, unlike words.

    Tin is no titanium nitride.
    """
    folded = name.casefold()
    return any(
        one.casefold() == folded and (one == name or one[1:].islower() or not one.isalpha())
        for one in page.names
    )


@cache
def default_pages() -> Pages:
    """The list that comes with the program, read when it is first asked for."""
    return Pages(data_directory() / FILE)


def is_published(material: str) -> bool:
    """Whether an id is that of a page, existing or not."""
    return material.strip().startswith(PREFIX)
