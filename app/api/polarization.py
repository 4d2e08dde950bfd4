"""`/polarization`: Jones and Mueller matrices of a surface, and what becomes of a Stokes vector."""

from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.polarization import Polarization, polarization
from app.api.params import AngleQuery, ConventionQuery, LayersQuery, numbers_of
from app.http.query import DigitsQuery
from app.http.route import QueryRoute


class PolarizationQuery(DigitsQuery, ConventionQuery, AngleQuery, LayersQuery):
    """One ray and its polarization."""

    stokes: Annotated[tuple[float, float, float, float], numbers_of("S0,S1,S2,S3")] = Field(
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
        where = query.interface(), query.incidence()
        return polarization(*where, np.array(query.stokes), query.coated(), query.signs())

    return routes
