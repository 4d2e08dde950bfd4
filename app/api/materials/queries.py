"""What the routes over materials share: the path's preset, the medium in front, colors, lists."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from pydantic import Field, model_validator

from app.api.params import number, preset_name, refuse_beside
from app.api.presets import reported_as
from app.http.problems import MissingResource
from app.http.query import Number, QueryModel
from app.materials import (
    NoSpectrum,
    Preset,
    Spectrum,
    UnknownMaterial,
    default_catalog,
    transparency_warnings,
)
from app.optics.color import Adaptation, Gamut, Illuminant, Observer
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.interface import Interface
from app.optics.parameters import N_I, Array

MOST_VALUES = 250_000
"""Cells of a map, or values of all curves together."""

GAMUT = (
    "What is done about colors that sRGB cannot show: `unclamped` nothing, `clamped` cuts each "
    "channel to 0 and 1, `scaled` divides by the largest channel where that exceeds 1."
)


def found(material: str) -> Preset:
    """Look up the preset of a path.

    Raises
    ------
    MissingResource
        If there is none, naming the nearest.
    """
    try:
        return default_catalog().get(material)
    except UnknownMaterial as error:
        raise MissingResource(error) from None


def described(preset: Preset) -> dict[str, Any]:
    """Say what an answer is about, and where that comes from."""
    fields = {"id", "name", "category", "axis", "sample", "confidence", "source", "doi", "licence"}
    return preset.model_dump(mode="json", include=fields)


class ColorQuery(QueryModel):
    """Under which light, by which observer colors are seen."""

    illuminant: Illuminant = Field("D65", description="What lights the surface.")
    observer: Observer = Field("cie1931_2deg", description="Color-matching functions.")
    adaptation: Adaptation = Field(
        "bradford",
        description="How the illuminant's white becomes that of sRGB, D65; `none` leaves its cast.",
    )


@dataclass(frozen=True, slots=True)
class Front:
    """The medium in front of a material, at any wavelength."""

    n_i: float
    preset: Preset | None
    spectrum: Spectrum | None

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
        with reported_as():
            n, k = self.spectrum.n(wavelength_nm), self.spectrum.k(wavelength_nm)
            said = transparency_warnings(self.preset, None if k is None else float(k.max()))
        return n, [f"{self.preset.id}: {warning}" for warning in said]

    def visible(self) -> tuple[Array | float, list[str]]:
        """Return n_i over the visible, end values held, and what has to be said about it."""
        if self.preset is None or self.spectrum is None:
            return self.n_i, []
        seen = self.spectrum.visible
        said = list(seen.warnings)
        if self.spectrum.k_range_nm is not None:
            with reported_as():
                said += transparency_warnings(self.preset, float(seen.k.max()))
        return seen.n, [f"{self.preset.id}: {warning}" for warning in said]

    def as_json(self) -> dict[str, Any]:
        """Say what it is: a number, or a preset whose index varies."""
        name = None if self.preset is None else described(self.preset)
        return {"n_i": self.n_i if self.spectrum is None else None, "incident": name}


class FrontQuery(QueryModel):
    """The medium in front, by a number or by a preset that is evaluated at every wavelength."""

    n_i: Number = number(N_I, examples=[1.0])
    incident: str | None = preset_name(
        "Id or alias of a transparent preset with a spectrum, in place of n_i."
    )

    @model_validator(mode="after")
    def _one_of_them(self) -> Self:
        refuse_beside(self, "incident", "n_i")
        return self

    def front(self) -> Front:
        """Look up the medium in front.

        Raises
        ------
        BadParameters
            If there is no such preset, or it is a single index.
        """
        if self.incident is None:
            return Front(self.n_i, None, None)
        catalog = default_catalog()
        with reported_as(material="incident"):
            preset = catalog.get(self.incident)
            if preset.category == "vacuum":
                return Front(1.0, preset, None)
            try:
                return Front(preset.n, preset, catalog.spectrum(preset.id))
            except NoSpectrum as error:
                allowed = f"{error.allowed}, which can be given as n_i = {preset.n:.10g}"
                raise NotAllowed(error.parameter, error.value, allowed) from None


def boundary(spectrum: Spectrum, wavelength_nm: Array, n_i: Array | float) -> Interface:
    """Boundary to a material at wavelengths that its source covers.

    Raises
    ------
    WavelengthOutOfRange
        If n, or k where the source gives any, is not known at one.
    OutOfRange
        If n or k is beyond what the core takes, as those of metals in the far infrared.
    """
    n, k = spectrum.n(wavelength_nm), spectrum.k(wavelength_nm)
    try:
        return Interface(n_i, n, 0.0 if k is None else k)
    except OutOfRange as error:
        values = n if error.parameter == "n_t" else np.asarray(k)
        at = wavelength_nm[values == error.value]
        raise OutOfRange(
            "wavelength_nm",
            at[0] if at.size else None,
            f"one where {error.parameter} is {error.allowed}; "
            f"of {spectrum.id} it is {error.value:.5g} here",
        ) from None


def unknown_k(spectrum: Spectrum) -> list[str]:
    """Say that k counts as 0, where it does."""
    return [] if spectrum.k_range_nm is not None else ["k is not known and counts as 0"]


def visible_part(known: tuple[float, float]) -> tuple[float, float]:
    """The part of a range from 380 to 780 nm, or all of it where there is none."""
    low, high = max(known[0], 380.0), min(known[1], 780.0)
    return (low, high) if low < high else known


def refuse_more_than(
    parameter: str, value: object, count: int, what: str, most: int = MOST_VALUES
) -> None:
    """Refuse an answer of too many values.

    Raises
    ------
    NotAllowed
        Naming the parameter that makes it so large.
    """
    if count > most:
        raise NotAllowed(parameter, value, f"at most {most} {what} in an answer")


def parse_wavelengths(text: str) -> Array:
    """Read comma-separated wavelengths in nm.

    Raises
    ------
    NotAllowed
        If a part is no number, or is there twice.
    """
    numbers: list[float] = []
    for part in text.split(","):
        try:
            value = float(part) if "_" not in part else np.nan
        except ValueError:
            value = np.nan
        if not np.isfinite(value):
            raise NotAllowed("wavelengths_nm", part, "comma-separated numbers, in nm")
        if value in numbers:
            raise NotAllowed("wavelengths_nm", part, "each wavelength once")
        numbers.append(value)
    return np.array(numbers)


def swatch_gamut(default: Gamut) -> Any:
    """Pydantic field of a gamut policy."""
    return Field(default, description=GAMUT)
