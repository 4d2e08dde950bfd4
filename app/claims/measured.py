"""Claims with what was measured of them."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from app.answers.answer import answer, filled
from app.claims.claim import Claim, Verdict


@answer
class SourceOf:
    """Where a claim stands."""

    author: str
    year: int
    title: str
    url: str
    where: str
    """Section, equation or file of the source."""


@answer
class Measurement:
    """A number that was measured."""

    name: str
    says: str
    """What the number is, over which domain."""
    value: float
    unit: str
    """deg, nm or empty."""
    request: str
    """Path and query of this server whose answer holds the number."""
    reading: str
    """Where in that answer it is; [key=value] picks of a list."""


@answer
class JudgedPart:
    """What has to be so for the claim to hold."""

    says: str
    """The condition, with what counts as good where no number is given."""
    figure: str
    """Name of the figure it is about."""
    at_least: float | str | None
    """A number, or the name of another figure."""
    at_most: float | str | None
    """A number, or the name of another figure."""
    holds: bool


@answer
class MeasuredClaim:
    """A claim with what was measured."""

    id: str
    title: str
    claimed: str
    """What the source says, in our words."""
    source: SourceOf
    domain: str
    """Interfaces and angles it is measured over."""
    verdict: Verdict
    found: str
    """What the figures say, in words."""
    figures: list[Measurement]
    parts: list[JudgedPart]
    example: str | None
    """Named example of the page's Compare view that shows it."""


@answer
class MeasuredClaims:
    """Claims, measured."""

    claims: list[MeasuredClaim]
    verdicts: dict[Verdict, int]
    """How many claims were judged how: of all, or of the example's."""


def judged(claim: Claim, values: Mapping[str, float], prefix: str) -> MeasuredClaim:
    """Judge a claim by its figures; `prefix` stands before the requests that measure them."""
    return filled(
        MeasuredClaim,
        claim,
        source=filled(SourceOf, claim.source, where=claim.where),
        verdict=claim.verdict(values),
        found=claim.found.format(**values),
        figures=[
            filled(
                Measurement,
                figure,
                value=values[figure.name],
                request=prefix + figure.request,
                reading=figure.reading.words,
            )
            for figure in claim.figures
        ],
        parts=[filled(JudgedPart, part, holds=part.holds(values)) for part in claim.parts],
    )


class Measured:
    """Claims with their figures, each measured when it is first asked for.

    Parameters
    ----------
    ask
        Answers a request.
    prefix
        What stands before the requests that users are told.
    """

    def __init__(self, ask: Callable[[str], Any], prefix: str) -> None:
        self._ask = ask
        self._prefix = prefix
        self._judged: dict[str, MeasuredClaim] = {}
        self._one_at_a_time = threading.Lock()

    def judge(self, claims: Iterable[Claim]) -> list[MeasuredClaim]:
        """Judge claims; those that are new are measured, each request answered once."""
        wanted = list(claims)
        with self._one_at_a_time:
            new = [claim for claim in wanted if claim.id not in self._judged]
            answers = {request: self._ask(request) for c in new for request in c.requests}
            for claim in new:
                values = {f.name: f.reading.read(answers[f.request]) for f in claim.figures}
                self._judged[claim.id] = judged(claim, values, self._prefix)
        return [self._judged[claim.id] for claim in wanted]
