"""Three pairs of n and k for engines that keep one a channel, and how far such engines are off.

What a channel reflects is the spectrum's share in it, integrated at every angle. The pair whose exact
curve comes closest to that is fitted, see `app.optics.fitted_index`. Pairs of the catalog under the
defaults stand in a file.
"""

import json
from collections.abc import Mapping
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np

from app.materials.appearance import DAYLIGHT, Viewing, averaged_interface, color_curve
from app.materials.colored import colored
from app.materials.location import data_directory
from app.materials.media import NEGLIGIBLE_K, default_catalog
from app.materials.schema import Preset
from app.optics.amplitudes import reflectance
from app.optics.color import (
    WAVELENGTH_NM,
    Gamut,
    Observer,
    Space,
    acescg_from_srgb,
    apply_gamut,
    delta_e_2000,
    in_space,
    lab,
    rendered_white,
)
from app.optics.fitted_index import FITTED_K, FITTED_N, fit_index, fitting_nodes
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.specular import polynomial

ANGLES_DEG: Array = np.linspace(0.0, 89.75, 360)
"""Angles at which curves are compared; at 90 degrees everything reflects everything."""
ANGLES_DEG.flags.writeable = False

PAIRS_FILE = "rgb_nk.json"

KEPT = 2048
"""Results that a process keeps: every preset has one a policy, a space and a light."""


class Distance(NamedTuple):
    """How far curves of three channels are from the spectrum's, among `ANGLES_DEG`."""

    max_abs: float
    at_deg: float
    channel: int
    """0 to 2, where the largest error is."""
    rms: float
    """Over the hemisphere and the channels, each solid angle alike."""
    delta_e: float
    """Largest CIEDE2000 of the reflection of white light."""
    delta_e_at_deg: float


def reflected(
    preset: Preset, incidence: Incidence, viewing: Viewing = DAYLIGHT, space: Space = "srgb"
) -> Array:
    """What a surface in vacuum reflects of each channel, integrated from its spectrum, not clamped.

    Parameters
    ----------
    preset
        Which material; a single index stands for all wavelengths.
    incidence
        Directions, any shape.
    viewing, space
        How the channels are made; the cast of a light that keeps one is divided out.

    Returns
    -------
    Array
        The angles' shape followed by 3.
    """
    curve = color_curve(colored(preset), incidence, 1.0, viewing)
    white = rendered_white(*viewing)
    return in_space(curve, space, viewing.observer) / in_space(white, space, viewing.observer)


@lru_cache(maxsize=KEPT)
def reflected_at_angles(
    preset_id: str, viewing: Viewing = DAYLIGHT, space: Space = "srgb"
) -> Array:
    """Return `reflected` at `ANGLES_DEG`, kept for whoever compares with it next."""
    preset = default_catalog().get(preset_id)
    curve = reflected(preset, Incidence.from_degrees(ANGLES_DEG), viewing, space)
    curve.flags.writeable = False
    return curve


@cache
def _pairs_on_file() -> Mapping[str, Interface]:
    """Fitted pairs of the catalog under the defaults, to ten digits; `tools.rgb_nk` writes them."""
    told = json.loads((data_directory() / PAIRS_FILE).read_text())
    return {
        one["id"]: Interface(1.0, [[n] for n in one["n"]], [[k] for k in one["k"]])
        for one in told["pairs"]
    }


@lru_cache(maxsize=KEPT)
def fitted_interface(
    preset_id: str,
    viewing: Viewing = DAYLIGHT,
    gamut: Gamut = "clamped",
    space: Space = "srgb",
) -> Interface:
    """Boundary with vacuum whose three exact curves come closest to what the channels reflect.

    Parameters
    ----------
    preset_id
        Which material.
    viewing, space
        How the channels are made.
    gamut
        What is done about channels outside 0 to 1 before: `scaled` divides the curves by the largest
        channel of F0 where that exceeds 1, less toward grazing incidence, by Schlick's fifth power,
        where all is reflected. No boundary reflects more than 1, so that `unclamped` changes little.

    Returns
    -------
    Interface
        Of shape (3, 1).
    """
    if (viewing, gamut, space) == (DAYLIGHT, "clamped", "srgb"):
        on_file = _pairs_on_file().get(preset_id)
        if on_file is not None:
            return on_file
    return fit(preset_id, viewing, gamut, space)


def fit(
    preset_id: str,
    viewing: Viewing = DAYLIGHT,
    gamut: Gamut = "clamped",
    space: Space = "srgb",
) -> Interface:
    """Find the same from the spectrum, whatever stands in the file."""
    preset = default_catalog().get(preset_id)
    medium = colored(preset)
    mu = fitting_nodes().x
    target = reflected(preset, Incidence.from_cosine(mu), viewing, space)
    if gamut == "scaled":
        F0 = reflected_at_angles(preset_id, viewing, space)[0]
        target = target * polynomial(1.0 / max(float(F0.max()), 1.0), mu)[:, np.newaxis]
    if gamut != "unclamped":
        target = apply_gamut(target, "clamped")
    near = averaged_interface(medium, 1.0, viewing)
    start = (
        np.clip(near.n_t.ravel(), FITTED_N.minimum, FITTED_N.maximum).tolist(),
        np.clip(near.k_t.ravel(), FITTED_K.minimum, FITTED_K.maximum).tolist(),
    )
    transparent = bool(medium.visible.k.max() < NEGLIGIBLE_K)
    fits = [
        fit_index(curve, (n, k), transparent) for curve, n, k in zip(target.T, *start, strict=True)
    ]
    return Interface(1.0, [[fit.n] for fit in fits], [[fit.k] for fit in fits])


def interface_at(preset: Preset, wavelengths_nm: tuple[float, float, float]) -> Interface:
    """Boundary with vacuum at one wavelength a channel, of shape (3, 1); end values are held."""
    seen = colored(preset).visible
    at = np.array(wavelengths_nm)
    n, k = (np.interp(at, WAVELENGTH_NM, values) for values in (seen.n, seen.k))
    return Interface(1.0, n[:, np.newaxis], k[:, np.newaxis])


def exact_at_angles(interface: Interface) -> Array:
    """Exact reflectance of an interface of shape (3, 1) at `ANGLES_DEG`, an angle a row."""
    return np.asarray(reflectance(interface, Incidence.from_degrees(ANGLES_DEG)).T)


def distance(
    curve: Array, truth: Array, space: Space = "srgb", observer: Observer = "cie1931_2deg"
) -> Distance:
    """Compare curves at `ANGLES_DEG`, an angle a row and a channel a column."""
    error = curve - truth
    size = np.abs(error)
    row, channel = np.unravel_index(int(np.argmax(size)), size.shape)
    first, second = (lab(_linear_srgb(c, space, observer), observer) for c in (curve, truth))
    apart = delta_e_2000(first, second)
    farthest = int(np.argmax(apart))
    mu = Incidence.from_degrees(ANGLES_DEG).cos
    mean_square = -np.trapezoid((error**2).mean(axis=1), mu)
    return Distance(
        max_abs=float(size[row, channel]),
        at_deg=float(ANGLES_DEG[row]),
        channel=int(channel),
        rms=float(np.sqrt(mean_square)),
        delta_e=float(apart[farthest]),
        delta_e_at_deg=float(ANGLES_DEG[farthest]),
    )


def _linear_srgb(colors: Array, space: Space, observer: Observer) -> Array:
    if space == "srgb":
        return colors
    return np.asarray(colors @ np.linalg.inv(acescg_from_srgb(observer)).T)
