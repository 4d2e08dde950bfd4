"""`/polarization`: Jones and Mueller matrices of a surface, and what becomes of a Stokes vector."""

import re
from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query
from pydantic import BeforeValidator, Field

from app.answers.polarization import Polarization, polarization
from app.api.params import AngleQuery, ConventionQuery, LayersQuery
from app.http.query import DigitsQuery
from app.http.route import QueryRoute
from app.optics.incidence import Incidence

_NUMBER = re.compile(r"\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*")


def _four(given: object) -> object:
    """Read four numbers separated by commas."""
    if not isinstance(given, str):
        return given
    parts = given.split(",")
    if len(parts) != 4 or not all(map(_NUMBER.fullmatch, parts)):
        raise ValueError("four numbers S0,S1,S2,S3")
    return tuple(map(float, parts))


class PolarizationQuery(DigitsQuery, ConventionQuery, AngleQuery, LayersQuery):
    """One ray and its polarization."""

    stokes: Annotated[
        tuple[float, float, float, float], BeforeValidator(_four, json_schema_input_type=str)
    ] = Field(
        (1.0, 0.0, 0.0, 0.0),
        description="Stokes vector S0,S1,S2,S3 of the incident light, with S1 = I_p - I_s; "
        "unpolarized unless given.",
        examples=["1,0,1,0"],
    )


def router() -> APIRouter:
    """Routes about polarization."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get(
        "/polarization", summary="Jones and Mueller matrices, and a Stokes vector through them"
    )
    def polarized(query: Annotated[PolarizationQuery, Query()]) -> Polarization:
        incidence = Incidence.from_degrees(query.theta_i_deg)
        stokes = np.array(query.stokes)
        return polarization(query.interface(), incidence, stokes, query.coated(), query.signs())

    return routes
