"""All that the atlas has of one material: which formula for it."""

from __future__ import annotations

from typing import Any

import numpy as np

from app.answers.answer import Gaps, Table, Values, answer
from app.answers.atlas_made import AtlasMade
from app.answers.atlas_shares import Numbers, degrees, digits
from app.atlas.grid import Band
from app.atlas.pages import Kind
from app.atlas.published import METRICS, Atlas, atlas
from app.materials.media import default_catalog
from app.optics.errors import NotAllowed
from app.optics.registry import Model, Registry


@answer
class AtlasRows:
    """Errors of one model at one material, over the wavelength."""

    model: str
    title: str
    wavelength_nm: Gaps
    n: Values
    k: Gaps
    in_domain: list[bool]
    max_abs: Gaps
    max_abs_at_deg: Gaps
    rms: Gaps
    albedo_error: Gaps
    delta_e: float | None
    """Null where the model has no RGB form, or the material no color."""


@answer
class AtlasMaterial:
    """All that the atlas has of one material."""

    made: AtlasMade
    material: str
    name: str
    shelf: str
    kind: Kind
    band: Band
    models: list[AtlasRows]
    """Made for the material, the one with the smallest largest error first."""

    def table(self) -> Table:
        """Lay out a row each model and wavelength."""
        names = [n for n in AtlasRows.__dataclass_fields__ if n not in {"model", "title"}]
        columns: dict[str, list[Any]] = {
            "model": [rows.model for rows in self.models for _ in rows.in_domain]
        }
        for name in names:
            columns[name] = [
                value
                for rows in self.models
                for value in (
                    [rows.delta_e] * len(rows.in_domain)
                    if name == "delta_e"
                    else np.asarray(getattr(rows, name)).tolist()
                )
            ]
        return Table(columns, "fresnel_atlas_material.csv")


def of_material(models: Registry, name: str) -> AtlasMaterial:
    """Tell all that the atlas has of one material.

    Raises
    ------
    UnknownMaterial
        If nothing has this id, alias or name.
    NotAllowed
        If the atlas does not have it.
    """
    found, preset = atlas(), default_catalog().get(name)
    material = found.by_id.get(preset.id)
    if material is None:
        allowed = "a material of the atlas: a preset or a page, no vacuum and nobody's own"
        raise NotAllowed("material", preset.called, allowed)
    own = found.rows_of(material)
    told = [
        _rows(found, model, np.arange(own.start, own.stop)[found.model[own] == code])
        for model in models.values()
        if model.id in found.models
        for code in (found.models.index(model.id),)
    ]
    made_for = [rows for rows in told if rows.in_domain]
    return AtlasMaterial(
        made=AtlasMade.of(found),
        material=material.id,
        name=material.name,
        shelf=material.shelf,
        kind=material.kind,
        band=material.band,
        models=sorted(made_for, key=lambda rows: np.nan_to_num(rows.max_abs, nan=np.inf).max()),
    )


def _rows(found: Atlas, model: Model, rows: Numbers) -> AtlasRows:
    at = found.spot[rows]
    errors = {name: digits(found.errors[name][rows]) for name in METRICS}
    delta_e = errors.pop("delta_e")
    return AtlasRows(
        model=model.id,
        title=model.title,
        wavelength_nm=found.spots.wavelength_nm[at],
        n=found.spots.n[at],
        k=found.spots.k[at],
        in_domain=found.in_domain[rows].tolist(),
        max_abs_at_deg=degrees(found.max_abs_at_deg[rows]),
        delta_e=float(delta_e[0]) if rows.size and np.isfinite(delta_e[0]) else None,
        **{str(name): column for name, column in errors.items()},
    )
