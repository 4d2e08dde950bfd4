"""The presets by id, alias and category, loaded once; spectra when they are asked for."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from app.materials.errors import NoSpectrum, UnknownMaterial, WavelengthOutOfRange
from app.materials.location import data_directory
from app.materials.own.material import own
from app.materials.own.token import is_own
from app.materials.published.index import default_pages, is_published
from app.materials.published.material import published_preset, published_spectrum, rivals
from app.materials.schema import Category, Database, Index, Preset, SpectrumFile
from app.materials.search import matches, means_another, names, nearest
from app.materials.spectrum import Spectrum
from app.optics.errors import NotAllowed

MOST_PAGES_NEAR = 2
"""Pages of refractiveindex.info among what an unknown name may have meant."""


@dataclass(frozen=True, slots=True)
class Constants:
    """n and k of a material at one wavelength.

    `k` is None where the source does not give it; `wavelength_nm` where it names none.
    """

    n: float
    """Relative to what the source measured it."""
    n_absolute: float
    """The same against vacuum: what a boundary is made of."""
    k: float | None
    wavelength_nm: float | None


@dataclass(frozen=True, slots=True)
class Spread:
    """How far the measurements lie apart: luminous reflectance at normal incidence, D65."""

    minimum: float
    maximum: float
    ids: tuple[str, ...]


class Catalog:
    """All presets, found by id, alias or name without regard to case, but for words of another's.

    Where several presets share an alias or a name, the first in the index has it: materials with a
    spectrum come before their rivals, and those before the single indices of the tables.

    Attributes
    ----------
    presets
        Every preset, in the order of the index.
    database
        The release that the spectra were taken from.
    """

    def __init__(self, presets: Iterable[Preset], database: Database, spectra: Path) -> None:
        self.presets = tuple(presets)
        self.database = database
        self._directory = spectra
        self._spectra: dict[str, Spectrum] = {}
        self._by_id = {preset.id: preset for preset in self.presets}
        self._by_name = {preset.id.casefold(): preset for preset in self.presets}
        for preset in self.presets:
            for name in names(preset):
                self._by_name.setdefault(name, preset)
        self._by_category: dict[Category, tuple[Preset, ...]] = {}
        for preset in self.presets:
            before = self._by_category.get(preset.category, ())
            self._by_category[preset.category] = (*before, preset)

    @property
    def categories(self) -> tuple[Category, ...]:
        """The categories that have members, in the order of the index."""
        return tuple(self._by_category)

    def get(self, id: str) -> Preset:  # noqa: A002
        """Return the preset of an id, else of an alias or name; an own material's id holds it.

        Raises
        ------
        UnknownMaterial
            With the nearest ids, or with what is wrong with that of an own material or a page.
        """
        if is_own(id):
            return own(id).preset
        if is_published(id):
            return published_preset(id)
        found = self.find(id)
        if found is None:
            raise UnknownMaterial(id, self.nearest(id))
        return found

    def find(self, id: str) -> Preset | None:  # noqa: A002
        """Return the preset of an id, else of an alias or name, or None."""
        word = id.strip()
        if is_own(word) or is_published(word):
            try:
                return self.get(word)
            except UnknownMaterial:
                return None
        if means_another(word):
            return None
        return self._by_id.get(word) or self._by_name.get(word.casefold())

    def search(
        self, query: str | None = None, category: Category | None = None
    ) -> tuple[Preset, ...]:
        """Return the presets of a category that a query fits, best first; all without either."""
        among = self.presets if category is None else self._by_category.get(category, ())
        if not query or not query.strip():
            return among
        return tuple(preset for _, preset in matches(among, query))

    def nearest(self, query: str, count: int = 5) -> tuple[str, ...]:
        """Return the ids whose names resemble a query most, for when nothing fits it.

        Pages of what is called so come first, those of what is called nearly so after presets.
        """
        pages = default_pages()
        called = [page.id for page in pages.called(query.strip())[:MOST_PAGES_NEAR]]
        close = [] if called else [p.id for p in pages.resembling(query.strip(), MOST_PAGES_NEAR)]
        among = nearest(self.presets, query, count - len(called) - len(close))
        return (*called, *among, *close)

    def spectrum(self, id: str) -> Spectrum:  # noqa: A002
        """Return n and k over the wavelength, read when first asked for.

        Raises
        ------
        UnknownMaterial
            If there is no such preset.
        NoSpectrum
            If its source prints a single index.
        """
        if is_own(id):
            return own(id).spectrum
        if is_published(id):
            return published_spectrum(id)
        preset = self.get(id)
        if preset.kind == "single":
            raise NoSpectrum(preset.id)
        if preset.id not in self._spectra:
            text = (self._directory / f"{preset.id}.json").read_bytes()
            file = SpectrumFile.model_validate_json(text)
            self._spectra[preset.id] = Spectrum(file, partial(self.rivals_at, preset.id))
        return self._spectra[preset.id]

    def constants(self, id: str, wavelength_nm: float | None = None) -> Constants:  # noqa: A002
        """Return n and k at a wavelength, by default the preset's own reference wavelength.

        Raises
        ------
        UnknownMaterial
            If there is no such preset.
        WavelengthOutOfRange
            If n, or k where the source gives any, is not known there; a single index is known at
            its own wavelength alone.
        NotAllowed
            If a wavelength is asked of a single index whose source names none.
        """
        preset = self.get(id)
        at = preset.wavelength_nm if wavelength_nm is None else wavelength_nm
        if preset.kind == "single" or at is None:
            if wavelength_nm is not None and preset.wavelength_nm is None:
                raise NotAllowed(
                    "wavelength_nm", wavelength_nm, f"none: the source of {preset.id} names none"
                )
            if at is not None and at != preset.wavelength_nm and preset.wavelength_nm is not None:
                only = preset.wavelength_nm
                raise WavelengthOutOfRange(preset.id, "n", at, only, only)
            return Constants(preset.n, preset.n_absolute, preset.k, preset.wavelength_nm)
        spectrum = self.spectrum(preset.id)
        n, n_absolute, k = spectrum.n(at), spectrum.n_absolute(at), spectrum.k(at)
        return Constants(float(n), float(n_absolute), None if k is None else float(k), at)

    def rivals(self, id: str) -> tuple[Preset, ...]:  # noqa: A002
        """Return the other measurements of the same material; a rival's include the chosen one.

        Those of a page are the other pages of its book.
        """
        preset = self.get(id)
        if is_published(preset.id):
            return rivals(preset)
        family = preset.rival_of or preset.id
        return tuple(
            other
            for other in self.presets
            if other.id != preset.id and family in (other.id, other.rival_of)
        )

    def rivals_at(self, id: str, wavelength_nm: float) -> tuple[str, ...]:  # noqa: A002
        """Return the ids of other measured spectra that are known at a wavelength; of pages a few."""
        if is_published(id):
            return default_pages().known_at(id, wavelength_nm)
        spectra = [self.spectrum(rival.id) for rival in self.rivals(id) if rival.kind == "spectrum"]
        ranges = {spectrum.id: spectrum.range_nm for spectrum in spectra}
        return tuple(i for i, (low, high) in ranges.items() if low <= wavelength_nm <= high)

    def spread(self, id: str) -> Spread:  # noqa: A002
        """Return how far the measurements of a material lie apart, itself included."""
        family = (self.get(id), *self.rivals(id))
        bright = [preset.color.luminance for preset in family]
        return Spread(min(bright), max(bright), tuple(preset.id for preset in family))


def load_catalog(path: Path | None = None) -> Catalog:
    """Load the catalog of a data directory, by default the one that comes with the program.

    Parameters
    ----------
    path
        Directory that holds `index.json` and `spectra/`.
    """
    directory = data_directory() if path is None else path
    index = Index.model_validate_json((directory / "index.json").read_bytes())
    return Catalog(index.presets, index.database, directory / "spectra")
