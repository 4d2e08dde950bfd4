"""The list of materials, searched, filtered and paged."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from app.answers.answer import ChosenFields, answer
from app.materials.media import default_catalog
from app.materials.schema import Category, Channels, Database, Preset
from app.optics.color import Gamut, apply_gamut, srgb_hex
from app.optics.parameters import Array


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
class Materials:
    """Presets, a page of those that the query fits."""

    materials: list[Material | ChosenFields]
    total: int
    """How many fit, on all pages."""
    offset: int
    limit: int | None
    suggestions: tuple[str, ...]
    """Ids that resemble `q`, where nothing fits it."""
    categories: dict[Category, int]
    """How many presets each category has."""
    database: Database


def materials(
    q: str | None = None,
    category: Category | None = None,
    kind: Literal["spectrum", "single"] | None = None,
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
    offset, limit
        How many to leave out at the start, and to list at most.
    gamut
        What is done about colors that sRGB cannot show.
    fields
        What to tell of each, by name; all unless given.
    """
    catalog = default_catalog()
    fitting = [p for p in catalog.search(q, category) if kind in (None, p.kind)]
    end = None if limit is None else offset + limit
    page = [
        Material(**vars(preset), swatch=_swatch(preset.color.F0, gamut))
        for preset in fitting[offset:end]
    ]
    return Materials(
        materials=[
            material if fields is None else {name: getattr(material, name) for name in fields}
            for material in page
        ],
        total=len(fitting),
        offset=offset,
        limit=limit,
        suggestions=catalog.nearest(q) if q and not fitting else (),
        categories={name: len(catalog.search(None, name)) for name in catalog.categories},
        database=catalog.database,
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
