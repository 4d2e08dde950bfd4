"""`/materials`: the list, searched, filtered and paged."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated, Any, Literal

import orjson
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.api.answers import Answer
from app.api.materials.queries import swatch_gamut
from app.api.materials.schemas import MaterialsOut
from app.api.responses import ReadyBody, json_body
from app.http.query import Count, DigitsQuery
from app.materials import Category, Preset, default_catalog
from app.optics.color import Gamut, apply_gamut, srgb_hex
from app.optics.errors import NotAllowed


class ListQuery(DigitsQuery):
    """Which presets."""

    q: str | None = Field(
        None,
        max_length=100,
        description="Part of a name, an alias, an id or a reference; best matches come first.",
        examples=["gold"],
    )
    category: Category | None = Field(None, description="Only presets of this category.")
    kind: Literal["spectrum", "single"] | None = Field(
        None, description="Only measured spectra, or only single indices of tables."
    )
    offset: Count = Field(0, ge=0, le=100_000, description="How many to leave out at the start.")
    limit: Count | None = Field(
        None, ge=1, le=1000, description="How many to send at most; all unless given."
    )
    gamut: Gamut = swatch_gamut("scaled")
    fields: str | None = Field(
        None,
        max_length=500,
        description="Comma-separated names of what to send of each preset; all unless given.",
        examples=["id,name,category,n,k"],
    )

    def chosen_fields(self) -> set[str] | None:
        """Names of the fields to send, None for all.

        Raises
        ------
        NotAllowed
            If a preset has no such field.
        """
        if self.fields is None:
            return None
        names = {name.strip() for name in self.fields.split(",")}
        known = [*Preset.model_fields, "swatch"]
        if not names <= set(known):
            raise NotAllowed("fields", self.fields, f"names among {', '.join(known)}")
        return names


def swatch(rgb: Any, gamut: Gamut) -> dict[str, Any]:
    """Write a linear color as sRGB; null where the policy leaves it outside the gamut."""
    shown = apply_gamut(rgb, gamut)
    inside = bool(((shown >= 0.0) & (shown <= 1.0)).all())
    return {"gamut": gamut, "hex": srgb_hex(shown) if inside else None}


def row(preset: Preset, gamut: Gamut, fields: set[str] | None = None) -> dict[str, Any]:
    """Describe a preset as lists do."""
    described = preset.model_dump(mode="json", include=fields)
    if fields is None or "swatch" in fields:
        described["swatch"] = swatch(preset.color.F0, gamut)
    return described


def listed(query: ListQuery) -> dict[str, Any]:
    """Answer a query of the list."""
    catalog = default_catalog()
    fitting = [
        preset
        for preset in catalog.search(query.q, query.category)
        if query.kind in (None, preset.kind)
    ]
    fields = query.chosen_fields()
    end = None if query.limit is None else query.offset + query.limit
    suggestions = catalog.nearest(query.q) if query.q and not fitting else ()
    return {
        "materials": [row(preset, query.gamut, fields) for preset in fitting[query.offset : end]],
        "total": len(fitting),
        "offset": query.offset,
        "limit": query.limit,
        "suggestions": list(suggestions),
        "categories": {name: len(catalog.search(None, name)) for name in catalog.categories},
        "database": catalog.database.model_dump(mode="json"),
    }


@lru_cache(maxsize=8)
def whole_list(fields: str | None) -> Response:
    """The answers that most clients ask for, made once a process."""
    query = ListQuery() if fields is None else ListQuery(fields=fields)
    return ReadyBody(orjson.dumps(listed(query)), "application/json", effort="thorough")


def add_list(routes: APIRouter) -> None:
    """Add the list to `routes`."""

    @routes.get("/materials", response_model=MaterialsOut, summary="Media and materials by name")
    def materials(query: Annotated[ListQuery, Query()]) -> Answer:
        if query.model_fields_set <= {"fields"}:
            return whole_list(query.fields)
        return json_body(listed(query), query.digits)
