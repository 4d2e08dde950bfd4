"""`/materials/{material}/spectrum` and `/map`: n, k and R over the wavelength, nothing held."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.api.answers import Answer, Large
from app.api.materials.queries import (
    FrontQuery,
    boundary,
    described,
    found,
    refuse_more_than,
    unknown_k,
    visible_part,
)
from app.api.materials.schemas import MaterialMapOut, SpectrumOut
from app.api.params import MAX_SAMPLES, wavelength
from app.api.responses import CONVENTION, csv_body, json_body
from app.http.query import Count, Number, QueryModel, TableQuery
from app.materials import Preset, Spectrum, WavelengthOutOfRange, default_catalog
from app.materials.schema import Points, Quantity
from app.optics.amplitudes import power
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_T, Array

FORMULA_POINTS = 241
"""Wavelengths in equal ratios at which a formula is evaluated where no step is asked for."""


class RangeQuery(QueryModel):
    """A range of wavelengths."""

    minimum_nm: Number | None = wavelength(
        None, "Shortest wavelength, in nm, within the preset's own range.", examples=[380.0]
    )
    maximum_nm: Number | None = wavelength(
        None, "Longest wavelength, in nm, within the preset's own range.", examples=[780.0]
    )

    def range_within(
        self, material: str, known: tuple[float, float], default: tuple[float, float]
    ) -> tuple[float, float]:
        """Return the range asked for.

        Raises
        ------
        WavelengthOutOfRange
            If an end is outside what is known.
        NotAllowed
            If they are in the wrong order.
        """
        low = default[0] if self.minimum_nm is None else self.minimum_nm
        high = default[1] if self.maximum_nm is None else self.maximum_nm
        for name, value in (("minimum_nm", low), ("maximum_nm", high)):
            if not known[0] <= value <= known[1]:
                error = WavelengthOutOfRange(material, "n", value, *known)
                error.parameter = name
                raise error
        if low > high:
            raise NotAllowed("minimum_nm", low, f"at most maximum_nm = {high:.10g}")
        return low, high


class SpectrumQuery(RangeQuery, TableQuery):
    """Constants over the wavelength; all that is known unless a range is given."""

    step_nm: Number | None = wavelength(
        None, "Distance of the wavelengths, in nm; the native points unless given.", examples=[5.0]
    )


class MapQuery(FrontQuery, RangeQuery, TableQuery):
    """Reflectance over angle and wavelength; from 380 to 780 nm unless a range is given."""

    cells: ClassVar[tuple[str, ...]] = ("steps", "samples")

    quantity: Literal["R", "Rs", "Rp"] = Field("R", description="Unpolarized, s or p.")
    samples: Count = Field(
        91,
        ge=2,
        le=MAX_SAMPLES,
        description="Equally spaced angles from 0 to 90 degrees, both ends included.",
    )
    steps: Count = Field(
        201, ge=2, le=MAX_SAMPLES, description="Equally spaced wavelengths, both ends included."
    )


def known_range(spectrum: Spectrum) -> tuple[float, float]:
    """Where n or k is known."""
    ranges = [spectrum.n_range_nm, spectrum.k_range_nm or spectrum.n_range_nm]
    return min(low for low, _ in ranges), max(high for _, high in ranges)


def native_wavelengths(quantity: Quantity) -> Array:
    """Wavelengths of a source's points, or enough of a formula's range to draw it."""
    if isinstance(quantity, Points):
        return np.array(quantity.wavelength_nm)
    return np.asarray(np.geomspace(*quantity.range_nm, FORMULA_POINTS))


def native(quantity: Quantity, low: float, high: float) -> dict[str, Any]:
    """What the source gives between two wavelengths."""
    if not isinstance(quantity, Points):
        return quantity.model_dump(mode="json")
    nodes, values = np.array(quantity.wavelength_nm), np.array(quantity.values)
    inside = (nodes >= low) & (nodes <= high)
    return {"kind": "points", "wavelength_nm": nodes[inside], "values": values[inside]}


def stepped(low: float, high: float, step: float) -> Array:
    """Wavelengths from `low` in equal steps, none above `high`."""
    count = int(min((high - low) / step + 1e-9, 1e9)) + 1
    refuse_more_than("step_nm", step, count, "wavelengths", MAX_SAMPLES)
    return np.asarray(np.minimum(low + step * np.arange(count), high))


def where_known(
    evaluate: Callable[[Array], Array | None], span: tuple[float, float], wavelength_nm: Array
) -> Array:
    """Evaluate within a range; NaN outside it."""
    inside = (wavelength_nm >= span[0]) & (wavelength_nm <= span[1])
    values: Array = np.full(wavelength_nm.shape, np.nan)
    values[inside] = evaluate(wavelength_nm[inside])
    return values


def normal_reflectance(n: Array, k: Array | None) -> tuple[Array, list[str]]:
    """F0 from vacuum where the constants are known and within the core's bounds, else NaN."""
    absorbing = np.zeros_like(n) if k is None else k
    known = np.isfinite(n) & np.isfinite(absorbing)
    computed = known & (n >= N_T.minimum) & (n <= N_T.maximum) & (absorbing <= K_T.maximum)
    F0 = np.full(n.shape, np.nan)
    F0[computed] = Interface(1.0, n[computed], absorbing[computed]).F0
    beyond = f"F0 is not computed where n is not {N_T.allowed} or k above {K_T.maximum:g}"
    return F0, [] if np.array_equal(known, computed) else [beyond]


def spectrum_answer(preset: Preset, query: SpectrumQuery) -> Response:
    """Constants over the wavelength as JSON or CSV."""
    spectrum = default_catalog().spectrum(preset.id)
    file, known = spectrum.file, known_range(spectrum)
    low, high = query.range_within(preset.id, known, known)
    if query.step_nm is not None:
        wavelength_nm = stepped(low, high, query.step_nm)
    else:
        nodes = [native_wavelengths(q) for q in (file.n, file.k) if q is not None]
        wavelength_nm = np.unique(np.concatenate(nodes))
        wavelength_nm = wavelength_nm[(wavelength_nm >= low) & (wavelength_nm <= high)]
        if not wavelength_nm.size:
            raise NotAllowed(
                "step_nm", None, f"a step: no native point is from {low:.10g} to {high:.10g} nm"
            )
    n = where_known(spectrum.n, spectrum.n_range_nm, wavelength_nm)
    k = None
    if spectrum.k_range_nm is not None:
        k = where_known(spectrum.k, spectrum.k_range_nm, wavelength_nm)
    F0, said = normal_reflectance(n, k)
    if query.format == "csv":
        unknown = np.full(n.shape, np.nan)
        columns = {"wavelength_nm": wavelength_nm, "n": n, "k": unknown if k is None else k}
        name = f"{preset.id}_spectrum.csv"
        return csv_body(columns | {"F0": F0}, query.digits, name)
    pair = {
        "n": native(file.n, low, high),
        "k": None if file.k is None else native(file.k, low, high),
    }
    payload = {
        "material": described(preset),
        "n_range_nm": spectrum.n_range_nm,
        "k_range_nm": spectrum.k_range_nm,
        "sampling": "native" if query.step_nm is None else "step",
        "wavelength_nm": wavelength_nm,
        "n": n,
        "k": k,
        "F0": F0,
        "native": pair if query.step_nm is None else None,
        "warnings": [*file.warnings, *unknown_k(spectrum), *said],
    }
    return json_body(payload, query.digits)


def map_answer(preset: Preset, query: MapQuery) -> Response:
    """Reflectance over angle and wavelength as JSON, or as CSV with a row a cell."""
    spectrum, front = default_catalog().spectrum(preset.id), query.front()
    known = front.range_beside(spectrum)
    names = preset.id if front.spectrum is None else f"{preset.id} and of {front.spectrum.id}"
    low, high = query.range_within(names, known, visible_part(known))
    refuse_more_than("steps", query.steps, query.steps * query.samples, "cells")
    wavelength_nm = np.linspace(low, high, query.steps)
    theta_i_deg = np.linspace(0.0, 90.0, query.samples)
    n_i, said = front.at(wavelength_nm)
    interface = boundary(spectrum, wavelength_nm[:, np.newaxis], np.atleast_1d(n_i)[:, np.newaxis])
    values = getattr(power(interface, Incidence.from_degrees(theta_i_deg)), query.quantity)
    if query.format == "csv":
        columns = {
            "wavelength_nm": np.repeat(wavelength_nm, query.samples),
            "theta_i_deg": np.tile(theta_i_deg, query.steps),
            query.quantity: values.ravel(),
        }
        return csv_body(columns, query.digits, f"{preset.id}_map.csv")
    payload = {
        "material": described(preset),
        "front": front.as_json(),
        "convention": CONVENTION,
        "quantity": query.quantity,
        "theta_i_deg": theta_i_deg,
        "wavelength_nm": wavelength_nm,
        "n_i": np.broadcast_to(n_i, wavelength_nm.shape).copy(),
        "n": np.ascontiguousarray(interface.n_t[:, 0]),
        "k": np.broadcast_to(interface.k_t.ravel(), wavelength_nm.shape).copy(),
        "values": np.ascontiguousarray(values),
        "warnings": [*unknown_k(spectrum), *said],
    }
    return json_body(payload, query.digits)


def add_spectrum_and_map(routes: APIRouter) -> None:
    """Add what depends on the wavelength to `routes`."""

    @routes.get(
        "/materials/{material}/spectrum",
        response_model=SpectrumOut,
        summary="n, k and F0 over the wavelength",
    )
    def spectrum(material: str, query: Annotated[SpectrumQuery, Query()]) -> Answer:
        return spectrum_answer(found(material), query)

    @routes.get(
        "/materials/{material}/map",
        response_model=MaterialMapOut,
        summary="Reflectance over angle and wavelength",
    )
    def theta_by_wavelength(material: str, query: Annotated[MapQuery, Query()]) -> Answer:
        return Large(map_answer, found(material), query)
