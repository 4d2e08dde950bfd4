"""The list of all pages: what is searched stays in memory, presets are read line by line."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import orjson
from pydantic import TypeAdapter

from app.materials.errors import UnknownMaterial
from app.materials.location import data_directory
from app.materials.schema import Preset, Range

PREFIX = "rii:"
"""What the ids of pages begin with."""

FILE = "refractiveindex/index.jsonl"
"""Below the directory of the data: a line a page, in the order of the database."""

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
    n_range_nm: Range | None
    """None where the page is refused."""
    k_range_nm: Range | None
    refused: str | None
    """Why nothing is computed of it."""
    order: int
    """Pages of a lower one stand for their material: as it is at room temperature, in the visible."""
    names: tuple[str, ...]
    """What its material is called, folded to one case."""
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

    @cached_property
    def all(self) -> tuple[ListedPage, ...]:
        """Every page, in the order of the database; refused ones too."""
        return tuple(self._listed)

    def get(self, id: str) -> ListedPage:  # noqa: A002
        """Return the page of an id.

        Raises
        ------
        UnknownPage
            If there is none, or it is refused.
        """
        number = self._by_id.get(_folded(id.strip()))
        if number is None:
            raise UnknownPage(
                id, "rii:SHELF/BOOK/PAGE of refractiveindex.info; /materials?q= finds them"
            )
        page = self._listed[number]
        if page.refused is not None:
            raise UnknownPage(id, f"a page that can be computed with, which takes {page.refused}")
        return page

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
    names = tuple(name.casefold() for name in entry["names"])
    title = entry["title"]
    return ListedPage(
        id=entry["id"],
        name=preset.get("name", title),
        title=title,
        file=entry["file"],
        n_range_nm=_range(preset.get("n_range_nm")),
        k_range_nm=_range(preset.get("k_range_nm")),
        refused=entry.get("refused"),
        order=entry["order"],
        names=names,
        words=" ".join((entry["id"].casefold(), *names, title.casefold())),
        source=preset.get("source", "").casefold(),
        start=start,
        length=length,
    )


def _range(ends: Any) -> Range | None:
    return None if ends is None else (ends[0], ends[1])


def _folded(id: str) -> str:  # noqa: A002
    return id.casefold().replace("_", " ")


@cache
def default_pages() -> Pages:
    """The list that comes with the program, read when it is first asked for."""
    return Pages(data_directory() / FILE)


def is_published(material: str) -> bool:
    """Whether an id is that of a page, existing or not."""
    return material.strip().startswith(PREFIX)
