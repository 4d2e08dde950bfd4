"""`/materials/{material}/curves`: R over the angle, per wavelength and as R, G and B.

The spectrum is integrated at every angle; beside that stand the curves that renderers get who keep
three numbers a material, each with its error.
"""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.api.answers import Answer, Large
from app.api.materials.queries import (
    Front,
    FrontQuery,
    boundary,
    described,
    found,
    parse_wavelengths,
    refuse_more_than,
    unknown_k,
)
from app.api.materials.rgb import CHANNELS, RgbQuery, check_models, rgb_json
from app.api.materials.schemas import MaterialCurvesOut
from app.api.model_parameters import parse_models
from app.api.params import MAX_SAMPLES
from app.api.presets import reported_as
from app.api.responses import CONVENTION, csv_body, json_body
from app.http.query import Count, TableQuery
from app.materials import Preset, Spectrum, default_catalog
from app.optics.amplitudes import reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import Model, Registry
from app.optics.specular import F82

SHIRLEY_NM = (400.0, 500.0, 600.0, 700.0, 800.0)
"""The wavelengths of Shirley's figure of copper."""


class MaterialCurvesQuery(FrontQuery, RgbQuery, TableQuery):
    """R over the angle of incidence at wavelengths of choice and as R, G and B."""

    wavelengths_nm: str | None = Field(
        None,
        min_length=1,
        max_length=2000,
        description="Comma-separated wavelengths in nm, within the presets' own range; those of "
        "400, 500, 600, 700 and 800 that are, unless given.",
        examples=["400,500,600,700,800"],
    )
    samples: Count = Field(
        181,
        ge=2,
        le=MAX_SAMPLES,
        description="Equally spaced angles from 0 to 90 degrees, both ends included.",
    )


def wavelengths_of(spectrum: Spectrum, front: Front, query: MaterialCurvesQuery) -> Array:
    """Wavelengths asked for, or those of Shirley's figure where both media are known."""
    if query.wavelengths_nm is not None:
        return parse_wavelengths(query.wavelengths_nm)
    low, high = front.range_beside(spectrum)
    return np.array([value for value in SHIRLEY_NM if low <= value <= high])


def wavelength_curves(
    spectrum: Spectrum, front: Front, wavelength_nm: Array, incidence: Incidence
) -> tuple[list[dict[str, Any]], list[str]]:
    """R over the angle at each wavelength, and what has to be said."""
    with reported_as(wavelength_nm="wavelengths_nm"):
        n_i, said = front.at(wavelength_nm)
        interface = boundary(spectrum, wavelength_nm, n_i)
    known_k = spectrum.k_range_nm is not None
    rows = Interface(
        *(np.atleast_1d(a)[:, np.newaxis] for a in (interface.n_i, interface.n_t, interface.k_t))
    )
    R = reflectance(rows, incidence)
    columns = [
        np.broadcast_to(a, wavelength_nm.shape)
        for a in (interface.n_i, interface.n_t, interface.k_t, interface.F0, F82(interface))
    ]
    curves = [
        {
            "wavelength_nm": float(wavelength_nm[at]),
            "n_i": float(columns[0][at]),
            "n": float(columns[1][at]),
            "k": float(columns[2][at]) if known_k else None,
            "F0": float(columns[3][at]),
            "F82": float(columns[4][at]),
            "R": np.ascontiguousarray(R[at]),
        }
        for at in range(wavelength_nm.size)
    ]
    return curves, said


def _written(number: float) -> str:
    """The shortest digits that mean the number."""
    return repr(number).removesuffix(".0")


def curves_answer(preset: Preset, query: MaterialCurvesQuery, models: list[Model]) -> Response:
    """Curves as JSON or CSV."""
    spectrum, front = default_catalog().spectrum(preset.id), query.front()
    wavelength_nm = wavelengths_of(spectrum, front, query)
    count = wavelength_nm.size * query.samples
    refuse_more_than("samples", query.samples, count, "values of all curves")
    theta_i_deg = np.linspace(0.0, 90.0, query.samples)
    incidence = Incidence.from_degrees(theta_i_deg)
    warnings = unknown_k(spectrum)
    single: list[dict[str, Any]] = []
    if wavelength_nm.size:
        single, said = wavelength_curves(spectrum, front, wavelength_nm, incidence)
        warnings += said
    rgb: list[dict[str, Any]] = []
    if query.rgb:
        n_i, said = front.visible()
        warnings += [*spectrum.visible.warnings, *said]
        rgb = rgb_json(spectrum, n_i, incidence, models, query)
    if query.format == "csv":
        columns = {"theta_i_deg": theta_i_deg}
        columns |= {f"R_{_written(curve['wavelength_nm'])}nm": curve["R"] for curve in single}
        for curve in rgb:
            columns |= {f"{curve['model']}.R_{name}": curve[f"R_{name}"] for name in CHANNELS}
        return csv_body(columns, query.digits, f"{preset.id}_curves.csv")
    color = {name: getattr(query, name) for name in ("illuminant", "observer", "adaptation")}
    payload = {
        "material": described(preset),
        "front": front.as_json(),
        "convention": CONVENTION,
        "theta_i_deg": theta_i_deg,
        "wavelengths": single,
        "rgb": color | {"gamut": query.gamut, "curves": rgb} if query.rgb else None,
        "warnings": list(dict.fromkeys(warnings)),
    }
    return json_body(payload, query.digits)


def add_curves(routes: APIRouter, registry: Registry) -> None:
    """Add the curves to `routes`."""

    @routes.get(
        "/materials/{material}/curves",
        response_model=MaterialCurvesOut,
        summary="R over the angle, per wavelength and as R, G and B",
    )
    def curves(material: str, query: Annotated[MaterialCurvesQuery, Query()]) -> Answer:
        preset = found(material)
        query.refuse_what_is_of_no_use()
        models = parse_models(query.models, registry)
        check_models(models, registry)
        return Large(curves_answer, preset, query, models)
