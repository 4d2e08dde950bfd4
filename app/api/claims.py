"""`/claims`: what the literature and popular code claim, measured by this server's own routes."""

from typing import Annotated, get_args

from fastapi import APIRouter, Query
from pydantic import Field

from app.api import PREFIX
from app.api.table import RouteTable
from app.claims import UnknownClaim, Verdict, claims_of, find_claim
from app.claims.measured import Measured, MeasuredClaim, MeasuredClaims
from app.http.problems import MissingResource
from app.http.query import DigitsQuery, LongQuery
from app.http.route import QueryRoute


class ClaimQuery(LongQuery, DigitsQuery):
    """How one claim is sent."""


class ClaimsQuery(ClaimQuery):
    """Which claims."""

    verdict: Verdict | None = Field(None, description="Only claims that were judged so.")
    example: str | None = Field(
        None, description="Only claims that this named example of the Compare view shows."
    )


def router(table: RouteTable) -> APIRouter:
    """Routes over the claims, which are measured by those of `table`."""
    routes = APIRouter(route_class=QueryRoute, tags=["claims"])
    measured = Measured(table.ask, PREFIX)

    @routes.get("/claims", summary="What is claimed, and what is measured")
    def claims(query: Annotated[ClaimsQuery, Query()]) -> MeasuredClaims:
        every = measured.judge(claims_of(query.example))
        verdicts = [claim.verdict for claim in every]
        return MeasuredClaims(
            claims=[claim for claim in every if query.verdict in (None, claim.verdict)],
            verdicts={verdict: verdicts.count(verdict) for verdict in get_args(Verdict)},
        )

    @routes.get("/claims/{claim_id}", summary="One claim, measured")
    def claim(claim_id: str, query: Annotated[ClaimQuery, Query()]) -> MeasuredClaim:  # noqa: ARG001
        try:
            found = find_claim(claim_id)
        except UnknownClaim as error:
            raise MissingResource(error) from None
        (described,) = measured.judge([found])
        return described

    return routes
