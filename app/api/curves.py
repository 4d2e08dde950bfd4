"""`/curves`: reflectance over the angle of incidence, of any models."""

# No `from __future__ import annotations` here: the query's type is made from the registry at run
# time, and FastAPI could not look up its name.

from collections.abc import Iterator
from functools import lru_cache
from typing import Annotated, Any, NamedTuple

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field

from app.api.answers import Answer, Large
from app.api.model_parameters import (
    ModelsParameter,
    model_arguments,
    parse_models,
    refuse_foreign_parameters,
    with_model_parameters,
)
from app.api.params import InterfaceQuery, SamplesQuery, TableQuery
from app.api.responses import (
    CONVENTION,
    csv_body,
    interface_json,
    json_body,
)
from app.api.schemas import CurvesOut
from app.http.body import ReadyBody
from app.http.route import QueryRoute
from app.optics.amplitudes import amplitudes, phase_deg, power
from app.optics.angles import LANDMARKS
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import Model, Registry
from app.optics.snell import penetration_depth_wavelengths, refraction_angle_deg

# Above this many values a curve is computed in a thread, so that other requests are answered
# meanwhile; below it the hand-over would cost more than the curve.
_INLINE_VALUES = 20_000


class CurvesQuery(TableQuery, SamplesQuery, InterfaceQuery):
    """Curves over the angle of incidence."""

    models: ModelsParameter = "exact"
    phase: bool = Field(False, description="Add phase_s_deg and phase_p_deg of `exact`.")
    refraction: bool = Field(
        False, description="Add theta_t_deg and penetration_depth_wavelengths of `exact`."
    )


class Curve(NamedTuple):
    """One quantity of one model over the angles."""

    model: str
    quantity: str
    values: Array
    reason: str | None


@lru_cache(maxsize=8)  # a reader's page asks for the same angles again and again
def _equally_spaced(samples: int) -> Incidence:
    return Incidence.from_degrees(np.linspace(0.0, 90.0, samples))


def sampled_incidence(interface: Interface, samples: int, landmarks: bool) -> Incidence:
    """Equally spaced angles from 0 to 90 degrees, with the landmarks sorted in if asked for."""
    equally_spaced = _equally_spaced(samples)
    if not landmarks:
        return equally_spaced
    marks = np.array([float(angle(interface)) for angle in LANDMARKS.values()])
    marks = marks[np.isfinite(marks)]
    return Incidence.from_degrees(np.unique(np.concatenate([equally_spaced.theta_i_deg, marks])))


def exact_curves(
    interface: Interface, incidence: Incidence, phase: bool, refraction: bool
) -> Iterator[tuple[str, Array]]:
    """Yield the quantities that only the exact solution has, R first."""
    energy = power(interface, incidence)
    yield "R", energy.R
    yield "Rs", energy.Rs
    yield "Rp", energy.Rp
    yield "T", energy.T
    if phase:
        amplitude = amplitudes(interface, incidence)
        yield "phase_s_deg", phase_deg(amplitude.r_s)
        yield "phase_p_deg", phase_deg(amplitude.r_p)
    if refraction:
        yield "theta_t_deg", refraction_angle_deg(interface, incidence)
        yield (
            "penetration_depth_wavelengths",
            penetration_depth_wavelengths(interface, incidence),
        )


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])
    Query_ = with_model_parameters(CurvesQuery, registry)

    def compute(query: CurvesQuery, models: list[Model], interface: Interface) -> Any:
        incidence = sampled_incidence(interface, query.samples, query.landmarks)
        curves: list[Curve] = []
        for model in models:
            reason = model.reason_outside(interface)
            if model.id == "exact":
                quantities = exact_curves(interface, incidence, query.phase, query.refraction)
                curves += [Curve(model.id, name, values, reason) for name, values in quantities]
            else:
                values = model(interface, incidence, **model_arguments(query, model))
                names = ("R",) if values.ndim == 1 else ("R_red", "R_green", "R_blue")
                curves += [
                    Curve(model.id, name, np.ascontiguousarray(row), reason)
                    for name, row in zip(names, np.atleast_2d(values), strict=True)
                ]
        return incidence.theta_i_deg, curves

    @routes.get(
        "/curves",
        response_model=CurvesOut,
        summary="Reflectance over the angle",
    )
    def curves(query: Annotated[Query_, Query()]) -> Answer:  # type: ignore[valid-type]
        return answer(query)

    def answer(query: CurvesQuery) -> Answer:
        models = parse_models(query.models, registry)
        refuse_foreign_parameters(query, models, registry)
        interface = query.interface()
        if query.samples * len(models) > _INLINE_VALUES:
            return Large(respond, query, models, interface)
        return respond(query, models, interface)

    def respond(query: CurvesQuery, models: list[Model], interface: Interface) -> ReadyBody:
        theta_i_deg, curves = compute(query, models, interface)
        if query.format == "csv":
            columns = {f"{c.model}.{c.quantity}": c.values for c in curves}
            return csv_body({"theta_i_deg": theta_i_deg} | columns, query.digits)
        payload = {
            "interface": interface_json(interface),
            "convention": CONVENTION,
            "theta_i_deg": theta_i_deg,
            "curves": [
                {
                    "model": c.model,
                    "quantity": c.quantity,
                    "values": c.values,
                    "in_domain": c.reason is None,
                    "reason": c.reason,
                }
                for c in curves
            ],
        }
        return json_body(payload, query.digits)

    return routes
