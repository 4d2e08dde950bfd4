"""The errors the optics core raises; each names the parameter, the value and what is allowed."""

from __future__ import annotations

from difflib import get_close_matches
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


class OpticsError(ValueError):
    """A quantity that the optics core cannot take.

    Parameters
    ----------
    parameter
        Name of the offending parameter, as spelled in Python, JSON and URL.
    value
        What was given.
    allowed
        What would have been accepted, in words.
    """

    def __init__(self, parameter: str, value: object, allowed: str) -> None:
        shown = repr(value) if isinstance(value, str) else value
        super().__init__(f"{parameter} = {shown} is not allowed: {allowed}")
        self.parameter = parameter
        self.value = value
        self.allowed = allowed


class OutOfRange(OpticsError):
    """A number outside its declared bounds, NaN or infinite."""


class NotAllowed(OpticsError):
    """A legal value that makes no sense beside the others."""


class UnknownName(OpticsError):
    """An id that nothing is registered under; `nearest` holds similar ones that exist."""

    def __init__(self, parameter: str, value: str, known: Iterable[str]) -> None:
        names = sorted(known)
        self.nearest = get_close_matches(value.lower(), names, n=3, cutoff=0.5)
        one_of = f"one of {', '.join(names)}"
        hint = f"nearest: {', '.join(self.nearest)}" if self.nearest else one_of
        super().__init__(parameter, value, hint)


class UnknownModel(UnknownName):
    """A model id that the registry does not hold."""
