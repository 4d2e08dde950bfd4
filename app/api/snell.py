"""`/snell`: one ray at the interface."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Query

from app.api.answers import Answer
from app.api.params import AngleQuery, DigitsQuery, InterfaceQuery
from app.api.responses import CONVENTION, interface_json, json_body, number_or_null
from app.api.schemas import SnellOut
from app.http.route import QueryRoute
from app.optics.amplitudes import amplitudes, phase_deg, power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.snell import (
    is_totally_reflected,
    penetration_depth_wavelengths,
    refraction_angle_deg,
)


class SnellQuery(DigitsQuery, AngleQuery, InterfaceQuery):
    """One ray."""


def _complex_json(value: complex) -> dict[str, float]:
    return {
        "re": value.real,
        "im": value.imag + 0.0,  # 0, never -0
        "abs": abs(value),
        "phase_deg": float(phase_deg(np.asarray(value))),
    }


def ray_json(interface: Interface, incidence: Incidence) -> dict[str, Any]:
    """Everything that is known of one ray."""
    amplitude, energy = amplitudes(interface, incidence), power(interface, incidence)
    theta_t_deg = number_or_null(refraction_angle_deg(interface, incidence))
    refracted = None
    if theta_t_deg is not None:
        below = Incidence.from_degrees(theta_t_deg)
        refracted = [float(below.sin), -float(below.cos)]
    return {
        "interface": interface_json(interface),
        "convention": CONVENTION,
        "theta_i_deg": float(incidence.theta_i_deg),
        "theta_t_deg": theta_t_deg,
        "total_internal_reflection": bool(is_totally_reflected(interface, incidence)),
        "reflected": [float(incidence.sin), float(incidence.cos)],
        "refracted": refracted,
        **{
            name: _complex_json(complex(getattr(amplitude, name)))
            for name in ("r_s", "r_p", "t_s", "t_p")
        },
        **{name: float(getattr(energy, name)) for name in ("Rs", "Rp", "R", "Ts", "Tp", "T")},
        "penetration_depth_wavelengths": number_or_null(
            penetration_depth_wavelengths(interface, incidence)
        ),
    }


def router() -> APIRouter:
    """Routes about one ray."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get("/snell", response_model=SnellOut, summary="One ray at the surface")
    def snell(query: Annotated[SnellQuery, Query()]) -> Answer:
        ray = ray_json(query.interface(), Incidence.from_degrees(query.theta_i_deg))
        return json_body(ray, query.digits)

    return routes
