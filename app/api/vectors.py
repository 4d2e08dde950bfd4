"""`/vectors`: reflected and refracted directions in space."""

from typing import Annotated

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.vectors import Directions, directions
from app.api.params import InterfaceQuery, numbers_of, reported_as
from app.http.query import DigitsQuery
from app.http.route import QueryRoute

Vector = Annotated[tuple[float, float, float], numbers_of("x,y,z")]


class VectorsQuery(DigitsQuery, InterfaceQuery):
    """A ray in space."""

    incident_direction: Vector = Field(
        ...,
        description="Unit vector x,y,z that points toward the surface.",
        examples=["0.6,-0.8,0"],
    )
    normal: Vector = Field(
        (0.0, 1.0, 0.0),
        description="Unit normal x,y,z on the incident side; 0,1,0 unless given.",
        examples=["0,1,0"],
    )


def router() -> APIRouter:
    """Routes about directions."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get("/vectors", summary="Reflected and refracted directions in space")
    def vectors(query: Annotated[VectorsQuery, Query()]) -> Directions:
        incident, normal = np.array(query.incident_direction), np.array(query.normal)
        with reported_as(incident="incident_direction"):
            return directions(query.interface(), incident, normal)

    return routes
