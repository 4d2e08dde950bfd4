"""`/mystery/{code}`: a material to guess, which is not told by what is sent of it."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.mystery import CLUES, Mystery
from app.answers.mystery import mystery as guessed
from app.http.problems import MissingResource
from app.http.query import Count, DigitsQuery
from app.http.route import QueryRoute
from app.optics.errors import NotAllowed


class MysteryQuery(DigitsQuery):
    """How much is given away."""

    clues: Count = Field(
        0,
        ge=0,
        le=CLUES,
        description="How many clues are sent: Rs and Rp, F0, the kind, the angle of least Rp.",
    )


def router() -> APIRouter:
    """The route of the materials to guess."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get("/mystery/{code}", summary="The curve of a material to guess")
    def mystery(code: str, query: Annotated[MysteryQuery, Query()]) -> Mystery:
        try:
            return guessed(code, query.clues)
        except NotAllowed as error:
            raise MissingResource(error) from None

    return routes
