"""Which materials a word means, and which it may have meant."""

import re
from collections.abc import Iterable
from difflib import get_close_matches

from app.materials.schema import Preset

LEAST_LIKENESS = 0.6
"""Ratio of common letters (difflib) under which a name is no suggestion."""
SHORTEST_SOURCE_WORD = 4
"""Letters from which a query is looked up in references too: shorter ones match nearly all."""
_WORD = re.compile(r"[^\s,()]+")


def means_another(text: str) -> bool:
    """Whether a word names something that is no preset, though folded to one case it would be one.

    Tin and carbon monoxide differ from titanium nitride and cobalt by the case of a letter.
    """
    return text == "CO" or (text != "TiN" and text.casefold() == "tin")


def names(preset: Preset) -> tuple[str, ...]:
    """Everything that a material is called, folded to one case."""
    return tuple(name.casefold() for name in (preset.id, *preset.aliases, preset.name))


def matches(presets: Iterable[Preset], query: str) -> list[Preset]:
    """Presets that a query fits, best first; within a rank in their own order.

    A whole name beats the beginning of one, that the beginning of a word, that any part; a word of
    the reference comes last. Rivals follow the materials they belong to.
    """
    wanted = query.casefold().strip()
    ranked = [
        (rank, preset.rival_of is not None, position, preset)
        for position, preset in enumerate(presets)
        if (rank := _rank(preset, wanted)) is not None
    ]
    return [preset for *_, preset in sorted(ranked, key=lambda entry: entry[:3])]


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


def _rank(preset: Preset, wanted: str) -> int | None:
    known = names(preset)
    if wanted in known:
        return 0
    if any(name.startswith(wanted) for name in known):
        return 1
    if any(word.startswith(wanted) for name in known for word in name.split()):
        return 2
    if any(wanted in name for name in known):
        return 3
    if len(wanted) >= SHORTEST_SOURCE_WORD and wanted in preset.source.casefold():
        return 4
    return None
