"""The list of materials, searched, filtered and paged."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from app.answers.answer import ChosenFields, answer
from app.materials.media import default_catalog
from app.materials.published.index import ListedPage, default_pages
from app.materials.published.search import fitting
from app.materials.schema import Category, Channels, Database, Preset
from app.materials.search import Fit, matches
from app.optics.color import Gamut, apply_gamut, srgb_hex
from app.optics.parameters import Array

Collected = Literal["curated", "pages"]

MOST_PAGES = 100
"""Pages of refractiveindex.info that are listed unless more are asked for."""


@answer
class Swatch:
    """A color as a screen shows it."""

    gamut: Annotated[Gamut, Field(description="What was done about channels outside 0 to 1.")]
    hex: Annotated[
        str | None, Field(description="#rrggbb; null where unclamped channels leave 0 to 1.")
    ]


@answer
class Material(Preset):
    """A preset as lists show it."""

    swatch: Swatch
    """F0 as sRGB."""


@answer
class RefusedPage:
    """A page of refractiveindex.info that nothing is computed of."""

    id: str
    title: str
    why: str
    """What it would have to have, and has not."""


@answer
class Materials:
    """Some of the materials that the query fits: words come before parts of words.

    Of both, curated presets come before pages of refractiveindex.info, but for pages that alone are
    called so.
    """

    materials: list[Material | ChosenFields]
    total: int
    """How many fit."""
    curated: int
    """How many of those are curated presets; the others are pages."""
    refused: list[RefusedPage]
    """Pages that fit, of which nothing is computed."""
    offset: int
    limit: int | None
    suggestions: tuple[str, ...]
    """Ids that resemble `q`, where nothing fits it."""
    categories: dict[Category, int]
    """How many curated presets each category has."""
    database: Database


def materials(
    q: str | None = None,
    category: Category | None = None,
    kind: Literal["spectrum", "single"] | None = None,
    catalog: Collected | None = None,
    *,
    offset: int = 0,
    limit: int | None = None,
    gamut: Gamut = "scaled",
    fields: Sequence[str] | None = None,
) -> Materials:
    """List materials.

    Parameters
    ----------
    q
        Part of a name, an alias, an id or a reference.
    category, kind
        Of which alone.
    catalog
        Whether curated presets alone, or pages of refractiveindex.info alone; both where `q` is given,
        else the curated ones.
    offset, limit
        How many to leave out at the start, and to list at most: all curated ones and `MOST_PAGES`
        pages unless given.
    gamut
        What is done about colors that sRGB cannot show.
    fields
        What to tell of each, by name; all unless given.
    """
    presets = default_catalog()
    word = q.strip() if q else ""
    curated: list[tuple[Fit, Preset]] = []
    pages: list[tuple[Fit, ListedPage]] = []
    if catalog != "pages":
        among = presets.search(None, category)
        found = matches(among, word) if word else [(Fit.NAME, preset) for preset in among]
        curated = [(fit, preset) for fit, preset in found if kind in (None, preset.kind)]
    if kind != "single" and (catalog == "pages" or (catalog is None and word)):
        listed = default_pages().all
        those = fitting(listed, word) if word else [(Fit.NAME, page) for page in listed]
        pages = [(fit, page) for fit, page in those if category in (None, page.category)]
    taken = [(fit, page) for fit, page in pages if page.refused is None]
    total = len(curated) + len(taken)
    if limit is None:
        taken = taken[: offset + MOST_PAGES]
    end = None if limit is None else offset + limit
    rows = [
        Material(**vars(preset), swatch=_swatch(preset.color.F0, gamut))
        for preset in _presets(_merged(curated, taken)[offset:end])
    ]
    return Materials(
        materials=[
            row if fields is None else {name: getattr(row, name) for name in fields} for row in rows
        ],
        total=total,
        curated=len(curated),
        refused=[
            RefusedPage(id=page.id, title=page.title, why=page.refused)
            for _, page in pages
            if page.refused is not None
        ],
        offset=offset,
        limit=limit,
        suggestions=presets.nearest(q) if q and not total else (),
        categories={name: len(presets.search(None, name)) for name in presets.categories},
        database=presets.database,
    )


def _merged(
    curated: Sequence[tuple[Fit, Preset]], pages: Sequence[tuple[Fit, ListedPage]]
) -> list[Preset | ListedPage]:
    """Presets before pages, but for what is said at `Materials`."""
    led = Fit.NAME if curated and curated[0][0] is Fit.NAME else Fit.WORD
    ranked: list[tuple[Fit, int, Preset | ListedPage]] = [
        *((led if fit < Fit.PART else fit, 0, preset) for fit, preset in curated),
        *((fit, 1, page) for fit, page in pages),
    ]
    return [one for *_, one in sorted(ranked, key=lambda entry: entry[:2])]


def _presets(found: Sequence[Preset | ListedPage]) -> list[Preset]:
    """Read the presets of pages among those that are."""
    pages = iter(default_pages().presets(one for one in found if isinstance(one, ListedPage)))
    return [next(pages) if isinstance(one, ListedPage) else one for one in found]


@lru_cache(maxsize=2048)  # every preset by every policy
def _swatch(rgb: Channels, gamut: Gamut) -> Swatch:
    return Swatch(gamut=gamut, hex=hex_of(apply_gamut(rgb, gamut)))


def hex_of(rgb: Array) -> str | None:
    """Write a linear color as sRGB, None where it is outside the gamut."""
    return srgb_hex(rgb) if in_gamut(rgb) else None


def in_gamut(rgb: Array) -> bool:
    """Whether sRGB has a linear color."""
    return bool(np.all((rgb >= 0.0) & (rgb <= 1.0)))
