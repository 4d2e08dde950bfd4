"""The media of films over the wavelength, and what has to be said of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from app.answers.answer import answer
from app.answers.materials.about import About
from app.materials.films import Constants, Film, film_constants, layer_of, material_constants
from app.materials.front import Front
from app.materials.media import NEGLIGIBLE_K, default_catalog
from app.optics.errors import NotAllowed
from app.optics.film_color import sampled_nm
from app.optics.parameters import Array
from app.optics.stack import Stack


@answer
class FilmFacts:
    """A layer whose index varies with the wavelength."""

    medium: str
    """As it was asked for: a preset or an index."""
    thickness_nm: float | None
    """Null where it is what varies or what was looked for."""
    incoherent: bool
    material: About | None
    """The preset; null if it was given as a number."""

    @classmethod
    def of(cls, film: Film) -> FilmFacts:
        """Describe a layer."""
        return cls(
            medium=film.medium,
            thickness_nm=film.thickness_nm,
            incoherent=film.incoherent,
            material=None if film.index else About.of(default_catalog().get(film.medium)),
        )


@dataclass(frozen=True, slots=True)
class Side:
    """The second medium: a number, or a preset whose index varies."""

    index: complex
    material: str | None = None

    def over(self, wavelength_nm: Array | None) -> Constants:
        """n and k over wavelengths, a negligible k as 0; parameters as of `material_constants`."""
        if self.material is None:
            shape = () if wavelength_nm is None else wavelength_nm.shape
            return Constants(np.full(shape, self.index.real), np.full(shape, self.index.imag), ())
        found = material_constants(self.material, wavelength_nm)
        return replace(found, k=np.where(found.k < NEGLIGIBLE_K, 0.0, found.k))


@answer
class MediaFacts:
    """The two media and the layers between them."""

    n_i: float | None
    """Null where a preset's index varies."""
    incident: About | None
    n_t: float | None
    k_t: float | None
    """Null where a preset's varies."""
    material: About | None
    layers: list[FilmFacts]
    """From the incident side on."""


@dataclass(frozen=True, slots=True)
class FilmMedia:
    """Two media with layers between them, at any wavelength."""

    front: Front
    layers: Sequence[Film]
    side: Side

    def facts(self) -> MediaFacts:
        """Describe them."""
        front, side = self.front, self.side
        named = None if side.material is None else default_catalog().get(side.material)
        return MediaFacts(
            n_i=front.n_i if front.spectrum is None else None,
            incident=None if front.preset is None else About.of(front.preset),
            n_t=side.index.real if named is None else None,
            k_t=side.index.imag if named is None else None,
            material=None if named is None else About.of(named),
            layers=[FilmFacts.of(film) for film in self.layers],
        )

    def stack(self, wavelength_nm: Array) -> tuple[Stack, list[str]]:
        """Make the stack at wavelengths, and tell what has to be said of it.

        Raises
        ------
        OpticsError
            If a medium is not known at a wavelength.
        """
        n_i, warnings = self.front.at(wavelength_nm)
        known = [film_constants(film, wavelength_nm) for film in self.layers]
        return self._made(wavelength_nm, n_i, warnings, known, self.side.over(wavelength_nm))

    def visible(self, step: int = 1) -> tuple[Stack, list[str]]:
        """Make the stack at the wavelengths of colors, end values held where a range ends."""
        n_i, warnings = self.front.visible()
        known = [film_constants(film, None) for film in self.layers]
        media = [
            Constants(every(each.n, step), every(each.k, step), each.warnings)
            for each in (*known, self.side.over(None))
        ]
        return self._made(sampled_nm(step), every(n_i, step), warnings, media[:-1], media[-1])

    def _made(
        self,
        wavelength_nm: Array,
        n_i: Array | float,
        warnings: list[str],
        known: Sequence[Constants],
        behind: Constants,
    ) -> tuple[Stack, list[str]]:
        layers = [
            layer_of(film, each.n, each.k, film.thickness_nm or 0.0)
            for film, each in zip(self.layers, known, strict=True)
        ]
        told = [warning for each in (*known, behind) for warning in each.warnings]
        stack = Stack(n_i, layers, behind.n, behind.k, wavelength_nm=wavelength_nm)
        return stack, list(dict.fromkeys([*warnings, *told]))


def every(values: Array | float, step: int) -> Array:
    """Values at every `step`-th of the wavelengths of colors."""
    array = np.asarray(values)
    return array[::step] if array.ndim else array


def swept_place(layers: Sequence[Film], layer: int) -> int:
    """Place of the layer whose thickness varies, from 0; only that one may come without its own.

    Raises
    ------
    NotAllowed
        If there is no such layer, or another has no thickness.
    """
    if layer > len(layers):
        raise NotAllowed("layer", layer, f"1 to {len(layers)}, counted from the incident side")
    for number, film in enumerate(layers, start=1):
        if film.thickness_nm is None and number != layer:
            allowed = f"MEDIUM:NM; only layer {layer} is without a thickness"
            raise NotAllowed("layers", film.spelled, allowed)
    return layer - 1
