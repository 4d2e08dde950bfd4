"""Which materials a word means, and which it may have meant."""

import re
from collections.abc import Iterable
from difflib import get_close_matches
from enum import IntEnum

from app.materials.schema import Preset

LEAST_LIKENESS = 0.6
"""Ratio of common letters (difflib) under which a name is no suggestion."""
SHORTEST_SOURCE_WORD = 4
"""Letters from which a query is looked up in references too: shorter ones match nearly all."""
_WORD = re.compile(r"[^\s,()]+")


class Fit(IntEnum):
    """How a query fits, the best way first."""

    NAME = 0
    """It is the whole name."""
    WORD = 1
    """Words of it begin so."""
    PART = 2
    """It is inside a word alone."""


def means_another(text: str) -> bool:
    """Whether a word names something that is no preset, though folded to one case it would be one.

    Tin and carbon monoxide differ from titanium nitride and cobalt by the case of a letter.
    """
    return text == "CO" or (text != "TiN" and text.casefold() == "tin")


def word_start(text: str) -> re.Pattern[str]:
    """Find a text, folded to one case, where a word begins: setting has no tin."""
    return re.compile(r"(?<![^\W_])" + re.escape(text))


def names(preset: Preset) -> tuple[str, ...]:
    """Everything that a material is called, folded to one case."""
    return tuple(name.casefold() for name in (preset.id, *preset.aliases, preset.name))


def matches(presets: Iterable[Preset], query: str) -> list[tuple[Fit, Preset]]:
    """Presets that a query fits, best first; within a rank in their own order.

    A whole name beats the beginning of one, that the beginning of a word, that a word of the
    reference, that any part. Rivals follow the materials they belong to.
    """
    wanted = query.casefold().strip()
    is_another = means_another(query.strip())
    start = word_start(wanted)
    ranked = [
        (rank, preset.rival_of is not None, position, preset)
        for position, preset in enumerate(presets)
        if (rank := _rank(preset, wanted, start)) is not None
    ]
    return [
        (Fit.WORD if rank == 0 and is_another else _FITS[rank], preset)
        for rank, *_, preset in sorted(ranked, key=lambda entry: entry[:3])
    ]


def nearest(presets: Iterable[Preset], query: str, count: int = 5) -> tuple[str, ...]:
    """Ids of the materials that a query names a part or the kind of, else those that resemble it."""
    wanted = query.casefold().strip()
    ordered = sorted(presets, key=lambda preset: preset.rival_of is not None)
    meant = [p for p in ordered if wanted == p.category or _has_word(p, wanted)]
    if meant:
        return tuple(preset.id for preset in meant[:count])
    owners: dict[str, str] = {}
    for preset in ordered:
        for name in names(preset):
            for word in (name, *name.replace(",", " ").split()):
                owners.setdefault(word, preset.id)
    close = get_close_matches(wanted, owners, n=4 * count, cutoff=LEAST_LIKENESS)
    return tuple(dict.fromkeys(owners[word] for word in close))[:count]


def _has_word(preset: Preset, wanted: str) -> bool:
    return any(wanted in _WORD.findall(name) for name in names(preset))


_FITS = (Fit.NAME, Fit.WORD, Fit.WORD, Fit.WORD, Fit.PART, Fit.PART)


def _rank(preset: Preset, wanted: str, start: re.Pattern[str]) -> int | None:
    known = names(preset)
    if wanted in known:
        return 0
    if any(name.startswith(wanted) for name in known):
        return 1
    if any(start.search(name) for name in known):
        return 2
    source = preset.source.casefold() if len(wanted) >= SHORTEST_SOURCE_WORD else ""
    if start.search(source):
        return 3
    if any(wanted in name for name in known):
        return 4
    return 5 if wanted in source else None
