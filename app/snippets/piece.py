"""Code to take away that is no model's, but stands beside all of them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from app.snippets.languages import Language, Trust
from app.snippets.snippet import Argument


@dataclass(frozen=True, slots=True, kw_only=True)
class Piece:
    """Some functions in every language."""

    id: str
    title: str
    """Name in the API and on the page."""
    reference: str
    validity: str
    """What is to be known of its arguments, in words."""
    functions: tuple[str, ...]
    arguments: tuple[Argument, ...]
    write: Callable[[Language], str]
    checked: Mapping[str, tuple[Trust, str]] | None = None
    """By language how it is checked and by what; None where that is as with models."""

    def trust(self, language: Language) -> tuple[Trust, str]:
        """How it is checked in a language, and by what."""
        if self.checked is None:
            return language.checked, language.checked_by
        return self.checked[language.id]
