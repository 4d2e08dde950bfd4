"""The medium in front of a material, at any wavelength."""

from __future__ import annotations

from dataclasses import dataclass

from app.materials.errors import NoSpectrum
from app.materials.media import default_catalog, transparency_warnings
from app.materials.schema import Preset
from app.materials.spectrum import Spectrum
from app.optics.errors import NotAllowed
from app.optics.parameters import Array


@dataclass(frozen=True, slots=True)
class Front:
    """A medium in front: a number, or a preset whose index varies."""

    n_i: float
    """The index against vacuum, at the reference wavelength of a preset."""
    preset: Preset | None = None
    """The preset that it comes from."""
    spectrum: Spectrum | None = None
    """Its constants, where they vary."""

    @classmethod
    def named(cls, name: str) -> Front:
        """Look up a preset.

        Raises
        ------
        UnknownMaterial
            If there is none.
        NotAllowed
            If it is a single index.
        """
        catalog = default_catalog()
        preset = catalog.get(name)
        if preset.category == "vacuum":
            return cls(1.0, preset)
        try:
            return cls(preset.n_absolute, preset, catalog.spectrum(preset.id))
        except NoSpectrum as error:
            allowed = f"{error.allowed}, which can be given as n_i = {preset.n_absolute:.10g}"
            raise NotAllowed(error.parameter, error.value, allowed) from None

    def range_beside(self, spectrum: Spectrum) -> tuple[float, float]:
        """Where this medium and the one behind it are both known.

        Raises
        ------
        NotAllowed
            If nowhere.
        """
        low, high = spectrum.range_nm
        if self.spectrum is None:
            return low, high
        own = self.spectrum.range_nm
        if max(low, own[0]) > min(high, own[1]):
            raise NotAllowed(
                "incident",
                self.spectrum.id,
                f"a medium known somewhere from {low:.10g} to {high:.10g} nm",
            )
        return max(low, own[0]), min(high, own[1])

    def at(self, wavelength_nm: Array) -> tuple[Array | float, list[str]]:
        """Return n_i at wavelengths, and what has to be said about it."""
        if self.preset is None or self.spectrum is None:
            return self.n_i, []
        n, k = self.spectrum.n_absolute(wavelength_nm), self.spectrum.k(wavelength_nm)
        said = transparency_warnings(self.preset, None if k is None else float(k.max()))
        return n, [f"{self.preset.called}: {warning}" for warning in said]

    def visible(self) -> tuple[Array | float, list[str]]:
        """Return n_i over the visible, end values held, and what has to be said about it."""
        if self.preset is None or self.spectrum is None:
            return self.n_i, []
        seen = self.spectrum.visible  # of an unknown k, which is 0 there, it says so itself
        warnings = transparency_warnings(self.preset, float(seen.k.max()))
        return seen.n, [
            f"{self.preset.called}: {warning}" for warning in (*seen.warnings, *warnings)
        ]
