"""What is said of a file that was read: assumptions, rows left out, and questions."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from app.materials.schema import Quantity, Reference
from app.optics.errors import NotAllowed

Sign = Literal["n+ik", "n-ik"]
Order = Literal["rising", "falling", "unsorted"]

MOST_LEFT_OUT = 500
"""Rows left out that are listed one by one."""


class Unreadable(NotAllowed):
    """A file that cannot be used; `allowed` says what would be."""


class Undecided(NotAllowed):
    """A question that the file leaves open; `parameter` is what answers it."""

    def __init__(self, parameter: str, question: str) -> None:
        super().__init__(parameter, None, question)


@dataclass(frozen=True, kw_only=True)
class Choices:
    """What is set by hand; None is left to the reader."""

    format: str | None = None
    unit: str | None = None
    columns: tuple[str, ...] | None = None
    sign: Sign | None = None
    decimal: Literal[".", ","] | None = None
    zero_k: Literal["known", "unknown"] | None = None
    relative_to: Reference | None = None
    n_from: Literal["table", "formula"] | None = None
    glass: str | None = None
    name: str | None = None


@dataclass(frozen=True)
class Assumption:
    """Something that the file does not say, or that may be read in another way."""

    what: str
    """The parameter that sets it by hand."""
    value: str
    """What was assumed."""
    why: str
    alternatives: tuple[str, ...] = ()
    """Values of the parameter that are possible as well."""


@dataclass(frozen=True)
class LeftOut:
    """A row that is not used."""

    line: int
    """Its number in the file, from 1."""
    why: str


@dataclass
class Notes:
    """What has to be said, gathered while a file is read."""

    choices: Choices
    assumed: list[Assumption] = field(default_factory=list)
    left_out: list[LeftOut] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    merged: int = 0
    more_left_out: int = 0

    def assume(self, what: str, value: str, why: str, alternatives: Sequence[str] = ()) -> None:
        """Say what was assumed; nothing is, where it was set by hand."""
        assumption = Assumption(what, value, why, tuple(alternatives))
        if getattr(self.choices, what, None) is None and assumption not in self.assumed:
            self.assumed.append(assumption)

    def leave_out(self, line: int, why: str) -> None:
        """Say that a row is not used."""
        if len(self.left_out) < MOST_LEFT_OUT:
            self.left_out.append(LeftOut(line, why))
        else:
            self.more_left_out += 1

    @property
    def first_left_out(self) -> str:
        """The end of a sentence on what is missing: the first row left out, if there is one."""
        if not self.left_out:
            return ""
        row = min(self.left_out, key=lambda row: row.line)
        return f"; the first row left out: line {row.line}, {row.why}"

    def warn(self, sentence: str) -> None:
        """Say something once."""
        if sentence not in self.warnings:
            self.warnings.append(sentence)


@dataclass(frozen=True, kw_only=True)
class Reading:
    """n and k of one material as a file has them, and how the file was read."""

    name: str
    format: str
    """Id of the format."""
    unit: str
    """Of the abscissa in the file."""
    columns: tuple[str, ...]
    """What the columns are."""
    sign: Sign
    order: Order
    """Of the abscissa in the file."""
    relative_to: Reference | None
    """What n is relative to; None where nothing says it."""
    n: Quantity
    k: Quantity | None
    assumed: tuple[Assumption, ...]
    left_out: tuple[LeftOut, ...]
    merged: int
    """Points that stood at the wavelength of another one, and are part of its mean."""
    warnings: tuple[str, ...]
