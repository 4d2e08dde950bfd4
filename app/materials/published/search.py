"""Which pages a query fits, best first."""

from collections.abc import Iterable

from app.materials.published.index import ListedPage, is_called

SHORTEST_SOURCE_WORD = 4
"""Letters from which a word is looked up in papers too: shorter ones match nearly all."""


def fitting(pages: Iterable[ListedPage], query: str) -> list[ListedPage]:
    """Pages that a query fits, best first.

    A whole name beats the beginning of one, that the beginning of a word; then come pages with all
    words of the query, then those whose paper has them. Of one name, a glass comes before other
    materials, then the page that a preset called so was made from, and pages that say it themselves,
    as those of ice among those of water; then those that stand for the material best: see
    `ListedPage.order`.
    """
    asked = query.strip()
    wanted = asked.casefold()
    words = wanted.split()
    ranked = []
    for position, page in enumerate(pages):
        rank = _rank(page, wanted, words)
        if rank is None:
            continue
        before = rank == 0 and is_called(page, asked)
        glass, chosen = page.category == "glass", wanted in page.chosen_as
        likeness = (not before, not glass, not chosen, wanted not in page.said, page.order)
        ranked.append((rank, *likeness, position, page))
    return [page for *_, page in sorted(ranked, key=lambda entry: entry[:7])]


def _rank(page: ListedPage, wanted: str, words: list[str]) -> int | None:
    if wanted in page.words:
        if f"\n{wanted}\n" in page.called:
            return 0
        if f"\n{wanted}" in page.called:
            return 1
        if f" {wanted}" in page.called:
            return 2
        return 3
    if all(word in page.words for word in words):
        return 3
    if all(
        word in page.words or (len(word) >= SHORTEST_SOURCE_WORD and word in page.source)
        for word in words
    ):
        return 4
    return None
