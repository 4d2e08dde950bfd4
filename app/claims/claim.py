"""What a claim is: who said what, which requests measure it, and what has to come out."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from string import Formatter
from typing import Literal

from app.claims.readings import Reading
from app.optics.errors import UnknownName

Verdict = Literal["holds", "holds in part", "does not hold", "nothing to hold"]


class UnknownClaim(UnknownName):
    """An id that is no claim's."""


class UnknownExample(UnknownName):
    """An example that no claim names."""


@dataclass(frozen=True, slots=True)
class Source:
    """Where a claim stands."""

    author: str
    year: int
    title: str
    """Title of the publication or the program."""
    url: str
    """Where it can be read."""


@dataclass(frozen=True, slots=True)
class Figure:
    """One number, measured by one request."""

    name: str
    """Its name within the claim, which `Claim.found` and `Part` use."""
    says: str
    """What the number is, and over which domain."""
    request: str
    """Path and query below /api/v1 whose answer holds it."""
    reading: Reading
    """Which number of the answer it is."""
    unit: str = ""
    """`deg`, `nm` or empty."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """One thing that has to be so for the claim to hold."""

    says: str
    """The claim as a condition, with what is counted as "good" where the source gives no number."""
    figure: str
    """Name of the figure that it is about."""
    at_least: float | str | None = None
    at_most: float | str | None = None
    """Bounds, each a number or the name of another figure."""

    def holds(self, values: Mapping[str, float]) -> bool:
        """Whether the figures measured fulfil it."""
        value = values[self.figure]
        low, high = (
            values[bound] if isinstance(bound, str) else bound
            for bound in (self.at_least, self.at_most)
        )
        return (low is None or value >= low) and (high is None or value <= high)


@dataclass(frozen=True, slots=True, kw_only=True)
class Claim:
    """One claim of a source."""

    id: str
    title: str
    """Name in the API (lower case, hyphens) and name on the page."""
    claimed: str
    """What the source says, in our words."""
    source: Source
    """Where it says so."""
    where: str
    """Section, equation or file of the source."""
    domain: str
    """Interfaces and angles it is measured over."""
    figures: tuple[Figure, ...]
    """The numbers that it is judged by, and those that put them into place."""
    parts: tuple[Part, ...]
    """What has to be so; without any, the source gives nothing that could fail."""
    found: str
    """What the figures say, in words; `{name}` and `{name:.1%}` stand for the figures."""
    example: str | None = None
    """Id of the page's named example in Compare that shows it."""

    def __post_init__(self) -> None:
        """Refuse figures of one name, and parts and words about none."""
        names = [figure.name for figure in self.figures]
        bounds = [b for p in self.parts for b in (p.at_least, p.at_most) if isinstance(b, str)]
        told = [name for _, name, _, _ in Formatter().parse(self.found) if name is not None]
        missing = {*(part.figure for part in self.parts), *bounds, *told} - set(names)
        if missing or len(set(names)) < len(names):
            raise ValueError(f"{self.id}: figures {names}, missing {sorted(missing)}")

    @property
    def requests(self) -> tuple[str, ...]:
        """The requests that reproduce it, each once."""
        return tuple(dict.fromkeys(figure.request for figure in self.figures))

    def verdict(self, values: Mapping[str, float]) -> Verdict:
        """Judge the claim by its figures."""
        if not self.parts:
            return "nothing to hold"
        held = [part.holds(values) for part in self.parts]
        if all(held):
            return "holds"
        return "holds in part" if any(held) else "does not hold"


def by_id(claims: Iterable[Claim]) -> dict[str, Claim]:
    """Claims by their ids.

    Raises
    ------
    ValueError
        If two share one.
    """
    listed = list(claims)
    named = {claim.id: claim for claim in listed}
    if len(named) < len(listed):
        raise ValueError("two claims share an id")
    return named
