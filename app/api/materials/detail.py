"""`/materials/{material}`: constants, color, provenance and rivals of one preset."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Query

from app.api.answers import Answer
from app.api.materials.listing import row, swatch
from app.api.materials.queries import ColorQuery, found, swatch_gamut
from app.api.materials.schemas import MaterialDetailOut
from app.api.params import wavelength
from app.api.responses import json_body
from app.http.query import DigitsQuery, Number
from app.materials import (
    Appearance,
    Preset,
    appearance,
    default_catalog,
    resolve_material,
)
from app.optics.color import WAVELENGTH_NM, Gamut, apply_gamut, linear_srgb, luminance
from app.optics.interface import Interface
from app.optics.specular import F82, tint_at_82


class DetailQuery(ColorQuery, DigitsQuery):
    """How one preset is shown."""

    wavelength_nm: Number | None = wavelength(
        None,
        "Where the constants are evaluated, in nm, within the preset's own range; by default its "
        "reference wavelength.",
        examples=[587.6],
    )
    gamut: Gamut = swatch_gamut("scaled")


def seen(preset: Preset, query: ColorQuery) -> Appearance:
    """Colors of a preset; a single index reflects all wavelengths alike."""
    how = query.illuminant, query.observer, query.adaptation
    if preset.kind == "spectrum":
        return appearance(default_catalog().spectrum(preset.id), 1.0, *how)
    boundary = Interface(1.0, preset.n, preset.k or 0.0)
    spectra = [np.full(WAVELENGTH_NM.size, float(value)) for value in (boundary.F0, F82(boundary))]
    F0, at_82 = (linear_srgb(values, *how) for values in spectra)
    Y = float(luminance(spectra[0], query.illuminant, query.observer))
    return Appearance(F0, at_82, Y, ())


def constants(preset: Preset, wavelength_nm: float | None) -> dict[str, Any]:
    """Evaluate n, k, F0 and F82 at a wavelength."""
    at = resolve_material(preset.id, wavelength_nm).constants
    boundary = Interface(1.0, at.n, at.k or 0.0)
    return {
        "wavelength_nm": at.wavelength_nm,
        "n": at.n,
        "k": at.k,
        "F0": float(boundary.F0),
        "F82": float(F82(boundary)),
    }


def display(color: Appearance, gamut: Gamut) -> dict[str, Any]:
    """Bring a color into the gamut, with the tint that belongs to what came out."""
    F0, at_82 = apply_gamut(color.F0, gamut), apply_gamut(color.F82, gamut)
    return swatch(color.F0, gamut) | {
        "F0": F0,
        "F82": at_82,
        "F82_tint": tint_at_82(F0, at_82),
        "in_gamut": bool(((color.F0 >= 0.0) & (color.F0 <= 1.0)).all()),
    }


def rival(preset: Preset) -> dict[str, Any]:
    """Describe another measurement in a line."""
    fields = {"id", "name", "n", "k", "wavelength_nm", "sample", "confidence", "source"}
    color = preset.color
    return preset.model_dump(mode="json", include=fields) | {
        "F0": list(color.F0),
        "luminance": color.luminance,
    }


def detailed(preset: Preset, query: DetailQuery) -> dict[str, Any]:
    """All that is known of a preset."""
    catalog = default_catalog()
    color, spread = seen(preset, query), catalog.spread(preset.id)
    file = catalog.spectrum(preset.id).file if preset.kind == "spectrum" else None
    return row(preset, query.gamut) | {
        "constants": constants(preset, query.wavelength_nm),
        "color": {
            "illuminant": query.illuminant,
            "observer": query.observer,
            "adaptation": query.adaptation,
            "F0": color.F0,
            "F82": color.F82,
            "F82_tint": color.F82_tint,
            "luminance": color.luminance,
        },
        "display": (shown := display(color, query.gamut)),
        "swatch": {"gamut": query.gamut, "hex": shown["hex"]},
        "conditions": {} if file is None else dict(file.conditions),
        "provenance": None if file is None else file.provenance.model_dump(mode="json"),
        "rivals": [rival(other) for other in catalog.rivals(preset.id)],
        "spread": {
            "minimum": spread.minimum,
            "maximum": spread.maximum,
            "ids": [member.id for member in spread.presets],
        },
        "database": catalog.database.model_dump(mode="json"),
    }


def add_detail(routes: APIRouter) -> None:
    """Add one preset's page to `routes`."""

    @routes.get(
        "/materials/{material}",
        response_model=MaterialDetailOut,
        summary="One material: constants, color, provenance, rivals",
    )
    def one(material: str, query: Annotated[DetailQuery, Query()]) -> Answer:
        return json_body(detailed(found(material), query), query.digits)
