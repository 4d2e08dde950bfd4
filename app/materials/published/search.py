"""Which pages a query fits, best first."""

import re
from collections.abc import Sequence

from app.materials.published.index import ListedPage, is_called
from app.materials.search import SHORTEST_SOURCE_WORD, Fit, word_start


def fitting(pages: Sequence[ListedPage], query: str) -> list[tuple[Fit, ListedPage]]:
    """Pages that a query fits, best first.

    A whole name beats the beginning of one, that the beginning of a word; then come pages with words
    that begin as all those of the query, then those whose paper has them, then those that have them
    inside other words. Of one name, a glass comes before other materials, then the page that a preset
    called so was made from, and pages that say it themselves, as those of ice among those of water;
    then those that stand for the material best: see `ListedPage.order`.
    """
    asked = query.strip()
    wanted = asked.casefold()
    is_spelled = any(asked in page.names for page in pages)  # CO is a gas, and co cobalt
    words = [(word, word_start(word)) for word in wanted.split()]
    ranked = []
    for position, page in enumerate(pages):
        rank = _rank(page, wanted, words)
        if rank is None:
            continue
        before = rank == 0 and (asked in page.names if is_spelled else is_called(page, asked))
        fit = Fit.NAME if before else Fit.WORD if rank < _INSIDE else Fit.PART
        glass, chosen = page.category == "glass", wanted in page.chosen_as
        likeness = (not before, not glass, not chosen, wanted not in page.said, page.order)
        ranked.append((rank, *likeness, position, fit, page))
    return [(fit, page) for *_, fit, page in sorted(ranked, key=lambda entry: entry[:7])]


_INSIDE = 5


def _rank(page: ListedPage, wanted: str, words: list[tuple[str, re.Pattern[str]]]) -> int | None:
    if wanted in page.called:
        if f"\n{wanted}\n" in page.called:
            return 0
        if f"\n{wanted}" in page.called:
            return 1
        if f" {wanted}" in page.called:
            return 2
    if not all(word in page.words or _in_paper(page, word) for word, _ in words):
        return None
    if all(start.search(page.words) for _, start in words):
        return 3
    if all(start.search(page.words) or _in_paper(page, word, start) for word, start in words):
        return 4
    return _INSIDE if all(word in page.words for word, _ in words) else _INSIDE + 1


def _in_paper(page: ListedPage, word: str, start: re.Pattern[str] | None = None) -> bool:
    if len(word) < SHORTEST_SOURCE_WORD:
        return False
    return bool(start.search(page.source)) if start is not None else word in page.source
