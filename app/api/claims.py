"""`/claims`: what the literature and popular code claim, measured by this server's own routes."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from typing import Annotated, Any, get_args

from fastapi import APIRouter, Query
from pydantic import BaseModel, Field
from starlette.responses import Response

from app.api import PREFIX
from app.api.answers import Answer, Large
from app.api.responses import json_body
from app.api.table import RouteTable
from app.claims import (
    Claim,
    Figure,
    Part,
    Source,
    UnknownClaim,
    Verdict,
    claims_of,
    find_claim,
)
from app.http.problems import MissingResource
from app.http.query import DigitsQuery
from app.http.route import QueryRoute


class ClaimsQuery(DigitsQuery):
    """Which claims."""

    verdict: Verdict | None = Field(None, description="Only claims that were judged so.")
    example: str | None = Field(
        None, description="Only claims that this named example of the Compare view shows."
    )


class SourceOut(BaseModel):
    """Where a claim stands."""

    author: str
    year: int
    title: str
    url: str
    where: str = Field(description="Section, equation or file of the source.")


class MeasurementOut(BaseModel):
    """A number that was measured."""

    name: str
    says: str = Field(description="What the number is, over which domain.")
    value: float
    unit: str = Field(description="deg, nm or empty.")
    request: str = Field(description="Path and query of this server whose answer holds the number.")
    reading: str = Field(description="Where in that answer it is; [key=value] picks of a list.")


class PartOut(BaseModel):
    """What has to be so for the claim to hold."""

    says: str = Field(
        description="The condition, with what counts as good where no number is given."
    )
    figure: str = Field(description="Name of the figure it is about.")
    at_least: float | str | None = Field(description="A number, or the name of another figure.")
    at_most: float | str | None = Field(description="A number, or the name of another figure.")
    holds: bool


class ClaimOut(BaseModel):
    """A claim with what was measured."""

    id: str
    title: str
    claimed: str = Field(description="What the source says, in our words.")
    source: SourceOut
    domain: str = Field(description="Interfaces and angles it is measured over.")
    verdict: Verdict
    found: str = Field(description="What the figures say, in words.")
    figures: list[MeasurementOut]
    parts: list[PartOut]
    example: str | None = Field(
        description="Named example of the page's Compare view that shows it."
    )


class ClaimsOut(BaseModel):
    """Claims, measured."""

    claims: list[ClaimOut]
    verdicts: dict[Verdict, int] = Field(
        description="How many claims were judged how: of all, or of the example's."
    )


def _source_json(source: Source, where: str) -> dict[str, Any]:
    return {
        "author": source.author,
        "year": source.year,
        "title": source.title,
        "url": source.url,
        "where": where,
    }


def _figure_json(figure: Figure, value: float) -> dict[str, Any]:
    return {
        "name": figure.name,
        "says": figure.says,
        "value": value,
        "unit": figure.unit,
        "request": PREFIX + figure.request,
        "reading": figure.reading.words,
    }


def _part_json(part: Part, values: dict[str, float]) -> dict[str, Any]:
    return {
        "says": part.says,
        "figure": part.figure,
        "at_least": part.at_least,
        "at_most": part.at_most,
        "holds": part.holds(values),
    }


def describe(claim: Claim, values: dict[str, float]) -> dict[str, Any]:
    """Turn a claim and its figures into what the API says of it."""
    return {
        "id": claim.id,
        "title": claim.title,
        "claimed": claim.claimed,
        "source": _source_json(claim.source, claim.where),
        "domain": claim.domain,
        "verdict": claim.verdict(values),
        "found": claim.found.format(**values),
        "figures": [_figure_json(figure, values[figure.name]) for figure in claim.figures],
        "parts": [_part_json(part, values) for part in claim.parts],
        "example": claim.example,
    }


class _Measured:
    """Claims with their figures, each measured when it is first asked for."""

    def __init__(self, table: RouteTable) -> None:
        self._table = table
        self._described: dict[str, dict[str, Any]] = {}
        self._one_at_a_time = threading.Lock()

    def describe(self, claims: Iterable[Claim]) -> list[dict[str, Any]]:
        """Describe claims; those that are new are measured, each request sent once."""
        wanted = list(claims)
        with self._one_at_a_time:
            new = [claim for claim in wanted if claim.id not in self._described]
            answers = {request: self._table.json(request) for c in new for request in c.requests}
            for claim in new:
                values = {f.name: f.reading.read(answers[f.request]) for f in claim.figures}
                self._described[claim.id] = describe(claim, values)
        return [self._described[claim.id] for claim in wanted]


def router(table: RouteTable) -> APIRouter:
    """Routes over the claims, which are measured by those of `table`."""
    routes = APIRouter(route_class=QueryRoute, tags=["claims"])
    measured = _Measured(table)

    def all_claims(query: ClaimsQuery) -> Response:
        every = measured.describe(claims_of(query.example))
        verdicts = [claim["verdict"] for claim in every]
        payload = {
            "claims": [c for c in every if query.verdict in (None, c["verdict"])],
            "verdicts": {verdict: verdicts.count(verdict) for verdict in get_args(Verdict)},
        }
        return json_body(payload, query.digits)

    def one_claim(claim: Claim, query: DigitsQuery) -> Response:
        (described,) = measured.describe([claim])
        return json_body(described, query.digits)

    @routes.get(
        "/claims", response_model=ClaimsOut, summary="What is claimed, and what is measured"
    )
    def claims(query: Annotated[ClaimsQuery, Query()]) -> Answer:
        return Large(all_claims, query)

    @routes.get("/claims/{claim_id}", response_model=ClaimOut, summary="One claim, measured")
    def claim(claim_id: str, query: Annotated[DigitsQuery, Query()]) -> Answer:
        try:
            found = find_claim(claim_id)
        except UnknownClaim as error:
            raise MissingResource(error) from None
        return Large(one_claim, found, query)

    return routes
