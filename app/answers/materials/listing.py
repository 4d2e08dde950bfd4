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
    """Presets, some of those that the query fits: curated ones before pages of refractiveindex.info."""

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
    curated: list[Preset] = []
    pages: list[ListedPage] = []
    if catalog != "pages":
        curated = [p for p in presets.search(q, category) if kind in (None, p.kind)]
    if kind != "single" and (catalog == "pages" or (catalog is None and q and q.strip())):
        listed = default_pages().all
        found = fitting(listed, q) if q and q.strip() else listed
        pages = [page for page in found if category in (None, page.category)]
    taken = [page for page in pages if page.refused is None]
    end = offset + (len(curated) + MOST_PAGES if limit is None else limit)
    chosen = curated[offset:end]
    chosen += default_pages().presets(
        taken[max(0, offset - len(curated)) : max(0, end - len(curated))]
    )
    rows = [Material(**vars(preset), swatch=_swatch(preset.color.F0, gamut)) for preset in chosen]
    total = len(curated) + len(taken)
    return Materials(
        materials=[
            row if fields is None else {name: getattr(row, name) for name in fields} for row in rows
        ],
        total=total,
        curated=len(curated),
        refused=[
            RefusedPage(id=page.id, title=page.title, why=page.refused)
            for page in pages
            if page.refused is not None
        ],
        offset=offset,
        limit=limit,
        suggestions=presets.nearest(q) if q and not total else (),
        categories={name: len(presets.search(None, name)) for name in presets.categories},
        database=presets.database,
    )


@lru_cache(maxsize=2048)  # every preset by every policy
def _swatch(rgb: Channels, gamut: Gamut) -> Swatch:
    return Swatch(gamut=gamut, hex=hex_of(apply_gamut(rgb, gamut)))


def hex_of(rgb: Array) -> str | None:
    """Write a linear color as sRGB, None where it is outside the gamut."""
    return srgb_hex(rgb) if in_gamut(rgb) else None


def in_gamut(rgb: Array) -> bool:
    """Whether sRGB has a linear color."""
    return bool(np.all((rgb >= 0.0) & (rgb <= 1.0)))
