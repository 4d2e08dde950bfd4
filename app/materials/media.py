"""Presets as the two media of a boundary: what may be known of them, and what counts as 0."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np

from app.materials.catalog import Catalog, Constants, load_catalog
from app.materials.schema import Preset
from app.materials.spectrum import UNKNOWN_K
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.parameters import K_T, N_T, Array, Parameter

NEGLIGIBLE_K = 1e-6
"""k below which a preset counts as transparent: light of 500 nm goes 40 mm before it falls to 1/e.

One rule for both sides of a boundary and for the page (static/js/media/constants.js): an answer
about one boundary tells the measured k, and a warning says that it counts as 0. Glass measured as
1e-8 would otherwise be a conductor without Brewster's angle. Numbers given as `k_t` are taken as
they are.
"""


@cache
def default_catalog() -> Catalog:
    """The catalog that comes with the program, loaded once a process."""
    return load_catalog()


USELESS_WAVELENGTH = "given although no material or incident depends on it"


def given_beside(column: str, preset: str) -> str:
    """What is wrong with a number that is given beside the preset which takes its place."""
    return f"given beside {column} = {preset}, which takes its place; leave one out"


def transparent(k: float) -> str:
    """What is allowed in front instead of a medium with this k."""
    return (
        f"a transparent medium: n_i is real, and this one has k = {k:.4g}; "
        "give it as material, or its n alone as n_i"
    )


def within(bounds: Parameter, quantity: str, preset: Preset) -> Callable[[float], str]:
    """What is allowed instead of a wavelength at which n or k of a preset is out of bounds."""
    wanted = f"one where {quantity} of {preset.called} is {bounds.allowed}; here it is "
    return lambda value: f"{wanted}{value:.5g}"


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
    warnings = _of_the_middle(preset)
    if constants.k is None:
        warnings.append(UNKNOWN_K)
    elif 0.0 < constants.k < NEGLIGIBLE_K:
        warnings.append(
            f"k = {constants.k:.3g} is below {NEGLIGIBLE_K:g} and counts as 0; "
            f"give n_t = {float(constants.n_absolute)!r} and k_t = {float(constants.k)!r} to keep it"
        )
    return Resolved(preset, constants, tuple(warnings))


def resolve_layer(name: str, wavelength_nm: float | None) -> Resolved:
    """Evaluate a preset as a layer, of which a k however small counts.

    Raises
    ------
    UnknownMaterial
        If nothing has this id, alias or name.
    WavelengthOutOfRange, NotAllowed
        If the preset is not known at the wavelength, or is known to be beyond n_t's or k_t's bounds.
    """
    preset, constants = _constants(name, wavelength_nm)
    warnings = _of_the_middle(preset) + ([UNKNOWN_K] if constants.k is None else [])
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
    warnings = _of_the_middle(preset) + transparency_warnings(preset, constants.k)
    return Resolved(preset, constants, tuple(warnings))


def transparency_warnings(preset: Preset, k: float | None) -> list[str]:
    """Say what is left out of a medium in front whose largest k is this.

    Raises
    ------
    NotAllowed
        If it absorbs.
    """
    if k is None:
        return [UNKNOWN_K]
    if k >= NEGLIGIBLE_K:
        raise NotAllowed("incident", preset.id, transparent(k))
    return [f"k = {k:.3g} is left out: n_i is real"] if k > 0.0 else []


def _constants(name: str, wavelength_nm: float | None) -> tuple[Preset, Constants]:
    catalog = default_catalog()
    preset = catalog.get(name)
    if preset.category == "vacuum":  # 1 by definition, whatever the wavelength of the table
        at = preset.wavelength_nm if wavelength_nm is None else wavelength_nm
        return preset, Constants(preset.n, preset.n_absolute, 0.0, at)
    constants = catalog.constants(preset.id, wavelength_nm)
    for quantity, value, bounds in (("n", constants.n_absolute, N_T), ("k", constants.k, K_T)):
        if value is not None and not bounds.minimum <= value <= bounds.maximum:
            allowed = within(bounds, quantity, preset)
            raise OutOfRange("wavelength_nm", constants.wavelength_nm, allowed(value))
    return preset, constants


def _of_the_middle(preset: Preset) -> list[str]:
    if preset.n_min is None or preset.n_max is None:
        return []
    return [f"the source gives n from {preset.n_min:g} to {preset.n_max:g}; this is the middle"]


def constants_at(preset: Preset, wavelength_nm: Array) -> tuple[Array, Array]:
    """Evaluate a preset at many wavelengths, as `resolve_material` does at one.

    Parameters
    ----------
    preset
        The preset.
    wavelength_nm
        Wavelengths in nanometers; NaN for the preset's own.

    Returns
    -------
    tuple
        n against vacuum, NaN at a wavelength at which the preset is not known, and k, NaN where
        that is not known.
    """
    left_out = np.isnan(wavelength_nm)
    if preset.category == "vacuum":
        known, n, k = np.ones(left_out.shape, np.bool_), np.asarray(1.0), np.asarray(0.0)
    elif preset.kind == "single":
        known = left_out | (wavelength_nm == preset.wavelength_nm)
        n = np.asarray(preset.n_absolute)
        k = np.asarray(np.nan if preset.k is None else preset.k)
    else:
        spectrum = default_catalog().spectrum(preset.id)
        own = np.nan if preset.wavelength_nm is None else preset.wavelength_nm
        at = np.where(left_out, own, wavelength_nm)
        low, high = spectrum.range_nm
        known = (at >= low) & (at <= high)
        within = np.where(known, at, low)
        absorbs = spectrum.k(within)
        n = spectrum.n_absolute(within)
        k = np.full(at.shape, np.nan) if absorbs is None else absorbs
    return np.where(known, n, np.nan), np.broadcast_to(k, known.shape)
