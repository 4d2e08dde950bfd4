"""n and k a channel for engines without spectra, beside other ways to keep three numbers."""

from __future__ import annotations

from typing import Literal

import numpy as np

from app.answers.answer import Values, answer
from app.answers.materials.about import About
from app.answers.materials.detail import Seen
from app.engines.measured import CHANNELS, Channel
from app.materials.appearance import DAYLIGHT, Viewing, appearance, averaged_interface
from app.materials.colored import colored
from app.materials.rgb_index import (
    ANGLES_DEG,
    distance,
    exact_at_angles,
    fitted_interface,
    interface_at,
    reflected_at_angles,
)
from app.materials.schema import Preset
from app.optics.color import Gamut, Space
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.f82_tint import f82_tint
from app.optics.parameters import Array

CHANNELS_NM = (650.0, 550.0, 450.0)
"""One wavelength a channel, as much code takes them."""

Way = Literal["fitted", "three_wavelengths", "averaged", "f82_tint"]

TITLES: dict[Way, str] = {
    "fitted": "Exact, from the pairs that match the spectral color best",
    "three_wavelengths": "Exact, from n and k at one wavelength a channel",
    "averaged": "Exact, from n and k averaged over each channel",
    "f82_tint": "F82-tint, from the color at 0 and 82 degrees",
}


@answer
class SpectralError:
    """How far three curves are from the spectrum's, among the angles from 0 by 0.25 degrees."""

    max_abs: float
    """Largest error of a channel."""
    at_deg: float
    channel: Channel
    rms: float
    """Over the hemisphere and the channels, each solid angle alike."""
    delta_e: float
    """Largest CIEDE2000 of the reflection of white light."""
    delta_e_at_deg: float

    @classmethod
    def of(cls, curve: Array, truth: Array, space: Space, viewing: Viewing) -> SpectralError:
        """Compare curves at the angles of `ANGLES_DEG`."""
        found = distance(curve, truth, space, viewing.observer)._asdict()
        return cls(**found | {"channel": CHANNELS[found["channel"]]})


@answer
class RgbWay:
    """Numbers of three channels, and what an engine without spectra makes of them."""

    way: Way
    title: str
    inputs: dict[str, Values]
    """By name, of red, green and blue."""
    error: SpectralError
    """Against the spectrum, not clamped."""


@answer
class RgbNk(Seen):
    """n and k a channel, with the error that is left."""

    material: About
    gamut: Gamut
    """What was done about channels outside 0 to 1 before fitting."""
    space: Space
    """The linear space whose channels these are."""
    n: Values
    """The fitted pairs: n of red, green and blue, for a surface in air or vacuum."""
    k: Values
    error: SpectralError
    """Of the fitted pairs, against the spectrum."""
    ways: list[RgbWay]
    """The fitted pairs and other ways, each with its error."""
    warnings: tuple[str, ...]


def rgb_nk(
    preset: Preset,
    viewing: Viewing = DAYLIGHT,
    gamut: Gamut = "clamped",
    space: Space = "srgb",
) -> RgbNk:
    """Fit n and k of three channels, and compare with other ways.

    Parameters
    ----------
    preset
        The material; a single index stands for all wavelengths.
    viewing, space
        How the channels are made.
    gamut
        What is done about channels outside 0 to 1.
    """
    medium = colored(preset)
    truth = reflected_at_angles(preset.id, viewing, space)
    look = appearance(medium, 1.0, viewing).in_space(space, viewing.observer).of_white()
    shown = look.within(gamut)

    def exact(way: Way, interface: Interface, **more: Array) -> RgbWay:
        inputs = {"n": interface.n_t.ravel(), "k": interface.k_t.ravel()}
        return made(way, inputs | more, exact_at_angles(interface))

    def made(way: Way, inputs: dict[str, Array], curve: Array) -> RgbWay:
        error = SpectralError.of(curve, truth, space, viewing)
        return RgbWay(way=way, title=TITLES[way], inputs=inputs, error=error)

    F0, tint = shown.F0, shown.F82_tint
    incidence = Incidence.from_degrees(ANGLES_DEG[:, np.newaxis])
    fitted = exact("fitted", fitted_interface(preset.id, viewing, gamut, space))
    ways = [
        fitted,
        exact(
            "three_wavelengths",
            interface_at(preset, CHANNELS_NM),
            wavelength_nm=np.array(CHANNELS_NM),
        ),
        exact("averaged", averaged_interface(medium, 1.0, viewing)),
        made("f82_tint", {"F0": F0, "tint": tint}, f82_tint(Interface(), incidence, F0, tint)),
    ]
    return RgbNk(
        **viewing._asdict(),
        material=About.of(preset),
        gamut=gamut,
        space=space,
        n=fitted.inputs["n"],
        k=fitted.inputs["k"],
        error=fitted.error,
        ways=ways,
        warnings=medium.visible.warnings,
    )
