"""Presets in place of numbers: what `material`, `incident` and `wavelength_nm` resolve to."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Any

from app.api.problems import BadParameters
from app.materials import Catalog, Constants, Preset, load_catalog
from app.optics.errors import NotAllowed, OpticsError, OutOfRange
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_T

NEGLIGIBLE_K = 1e-6
"""k below which a preset counts as transparent: light of 500 nm goes 40 mm before it falls to 1/e.

One rule for both sides of a boundary and for the page (static/js/constants.js): the answer still
tells the measured k, and a warning says that it counts as 0. Glass measured as 1e-8 would otherwise
be a conductor without Brewster's angle. Numbers given as `k_t` are taken as they are.
"""


@cache
def default_catalog() -> Catalog:
    """The catalog that comes with the program, loaded once a process."""
    return load_catalog()


@contextmanager
def reported_as(**names: str) -> Iterator[None]:
    """Turn what the core refuses into the API's own error, its parameters renamed.

    Inside a pydantic validator nothing of the core's errors, which are ValueErrors, would be left.

    Parameters
    ----------
    names
        What the client calls the core's parameters.
    """
    try:
        yield
    except OpticsError as error:
        name = names.get(error.parameter, error.parameter)
        raise BadParameters(
            {"parameter": name, "value": str(error.value), "message": error.allowed}
        ) from None


@dataclass(frozen=True, slots=True)
class Resolved:
    """A preset at the wavelength it was evaluated at, and what has to be said about it."""

    preset: Preset
    constants: Constants
    warnings: tuple[str, ...]

    @property
    def k_t(self) -> float:
        """What the k counts as in the second medium: 0 where it is not known or negligible."""
        k = self.constants.k
        return 0.0 if k is None or k < NEGLIGIBLE_K else k

    def as_json(self) -> dict[str, Any]:
        """Describe where n and k come from."""
        preset = self.preset
        return {
            "id": preset.id,
            "name": preset.name,
            "wavelength_nm": self.constants.wavelength_nm,
            "n": self.constants.n,
            "k": self.constants.k,
            "sample": preset.sample,
            "confidence": preset.confidence,
            "source": preset.source,
            "doi": list(preset.doi),
            "warnings": list(self.warnings),
        }


class PresetInterface(Interface):
    """An interface that knows which presets it was made from, so that answers can say so."""

    incident: Resolved | None
    material: Resolved | None

    def __init__(
        self,
        n_i: float,
        n_t: float,
        k_t: float,
        incident: Resolved | None,
        material: Resolved | None,
    ) -> None:
        super().__init__(n_i, n_t, k_t)
        object.__setattr__(self, "incident", incident)
        object.__setattr__(self, "material", material)


def resolve_material(name: str, wavelength_nm: float | None) -> Resolved:
    """Evaluate a preset as the second medium.

    A k that is not known or below `NEGLIGIBLE_K` counts as 0, which the warnings say.

    Raises
    ------
    UnknownMaterial
        If nothing has this id, alias or name.
    WavelengthOutOfRange, NotAllowed
        If the preset is not known at the wavelength, or is known to be beyond n_t's or k_t's bounds.
    """
    preset, constants = _constants(name, wavelength_nm)
    _within_bounds(preset, constants)
    warnings = _of_the_middle(preset)
    if constants.k is None:
        warnings.append("k is not known and counts as 0")
    elif 0.0 < constants.k < NEGLIGIBLE_K:
        warnings.append(
            f"k = {constants.k:.3g} is below {NEGLIGIBLE_K:g} and counts as 0; "
            f"give n_t = {float(constants.n)!r} and k_t = {float(constants.k)!r} to keep it"
        )
    return Resolved(preset, constants, tuple(warnings))


def resolve_incident(name: str, wavelength_nm: float | None) -> Resolved:
    """Evaluate a preset as the medium in front, whose index is real.

    Raises
    ------
    UnknownMaterial
        If nothing has this id, alias or name.
    WavelengthOutOfRange, NotAllowed
        If the preset is not known at the wavelength, is beyond n_i's bounds or absorbs there.
    """
    preset, constants = _constants(name, wavelength_nm)
    _within_bounds(preset, constants)
    warnings = _of_the_middle(preset)
    warnings += transparency_warnings(preset, constants.k)
    return Resolved(preset, constants, tuple(warnings))


def transparency_warnings(preset: Preset, k: float | None) -> list[str]:
    """Say what is left out of a medium in front whose largest k is this.

    Raises
    ------
    NotAllowed
        If it absorbs.
    """
    if k is None:
        return ["k is not known and counts as 0"]
    if k >= NEGLIGIBLE_K:
        raise NotAllowed(
            "incident",
            repr(preset.id),
            f"a transparent medium: n_i is real, and this one has k = {k:.4g}; "
            "give it as material, or its n alone as n_i",
        )
    return [f"k = {k:.3g} is left out: n_i is real"] if k > 0.0 else []


def _constants(name: str, wavelength_nm: float | None) -> tuple[Preset, Constants]:
    catalog = default_catalog()
    preset = catalog.get(name)
    if preset.category == "vacuum":  # 1 by definition, whatever the wavelength of the table
        at = preset.wavelength_nm if wavelength_nm is None else wavelength_nm
        return preset, Constants(preset.n, 0.0, at)
    return preset, catalog.constants(preset.id, wavelength_nm)


def _within_bounds(preset: Preset, constants: Constants) -> None:
    for quantity, value, bounds in (("n", constants.n, N_T), ("k", constants.k, K_T)):
        if value is not None and not bounds.minimum <= value <= bounds.maximum:
            raise OutOfRange(
                "wavelength_nm",
                constants.wavelength_nm,
                f"one where {quantity} of {preset.id} is {bounds.allowed}; here it is {value:.5g}",
            )


def _of_the_middle(preset: Preset) -> list[str]:
    if preset.n_min is None or preset.n_max is None:
        return []
    return [f"the source gives n from {preset.n_min:g} to {preset.n_max:g}; this is the middle"]
