"""A material under something: its colors from there, and what engines' shortcuts make of it."""

from __future__ import annotations

import numpy as np

from app.answers.answer import Rows, Values, answer, filled
from app.answers.materials.about import About, FrontMedium, Rgb
from app.answers.materials.detail import Look, Seen
from app.answers.materials.rgb_nk import SpectralError
from app.engines.measured import engines
from app.materials.appearance import DAYLIGHT, Viewing, appearance
from app.materials.colored import colored
from app.materials.covered import Cover, CoverKind, below, through, whole
from app.materials.rgb_index import ANGLES_DEG
from app.materials.schema import Preset
from app.optics.coats import Base, CoatShortcut, coat_shortcuts
from app.optics.color import Gamut, rendered_white
from app.optics.incidence import Incidence


@answer
class CoatError:
    """An engine's shortcut for a coat."""

    id: str
    title: str
    reference: str
    validity: str
    measured: list[str]
    """Engines, each with its version, in which coated gold was measured to follow it."""
    F0: Rgb
    """What it takes for F0 of the surface below, from its color in air."""
    F0_error: Rgb
    """By how much that is off from `below`."""
    reflectance: Rows
    """What the engine shows of the whole, a row an angle."""
    error: SpectralError
    """Of the whole, against the spectrum."""


@answer
class Covered(Seen):
    """A material from another medium, from its coat or through a pane: linear sRGB."""

    material: About
    cover: CoverKind
    medium: FrontMedium
    """Its index, or the preset."""
    gamut: Gamut
    """What was done about channels outside 0 to 1 of F0, F82 and tints."""
    air: Look
    """The bare surface in air: what is typed for it without the cover."""
    below: Look
    """The surface below the cover, seen from there: what is typed where an engine renders the cover."""
    whole: Look
    """Cover and material together, seen from outside: what is typed where it does not."""
    largest_angle_deg: float | None
    """The angle in a coat that light from air has at grazing incidence, of n at the d line: F82 is
    beyond it. Null where all angles are met."""
    theta_i_deg: Values
    """In air; of a medium, in it."""
    reflectance: Rows
    """Of the whole, from the spectrum, not clamped."""
    shortcuts: list[CoatError]
    """Of coats alone."""
    outside_0_to_1: tuple[str, ...]
    """Which of the colors have channels outside 0 to 1 before the gamut policy."""
    warnings: tuple[str, ...]


SHOWN = slice(None, None, 4)
"""Every degree of `ANGLES_DEG` is sent."""


def covered(
    preset: Preset, cover: Cover, viewing: Viewing = DAYLIGHT, gamut: Gamut = "clamped"
) -> Covered:
    """Tell how a material looks under something.

    Parameters
    ----------
    preset
        The material; a single index stands for all wavelengths.
    cover
        What is in front of it.
    viewing
        How the channels are made; shortcuts are compared in the white that it leaves.
    gamut
        What is done about channels outside 0 to 1, of what shortcuts are given as well.

    Raises
    ------
    NotAllowed
        If the cover absorbs.
    """
    incidence = Incidence.from_degrees(ANGLES_DEG)
    in_air = appearance(colored(preset), 1.0, viewing)
    under, together = below(preset, cover, viewing), whole(preset, cover, viewing)
    truth = through(preset, cover, incidence, viewing)
    looks = {"air": in_air, "below": under, "whole": together}
    shown = {name: look.within(gamut) for name, look in looks.items()}
    bare, exact = shown["air"].of_white(), under.of_white()
    n = cover.front.n_i
    base = Base(bare.F0, bare.F82_tint, n)
    white = rendered_white(*viewing)

    def error(shortcut: CoatShortcut) -> CoatError:
        F0, curve = shortcut.F0_below(base.F0, n), shortcut.color(base, incidence)
        run = [engines()[name] for name in shortcut.engines]
        return filled(
            CoatError,
            shortcut,
            measured=[f"{engine.title} {engine.version}" for engine in run],
            F0=F0,
            F0_error=F0 - exact.F0,
            reflectance=np.ascontiguousarray(curve[SHOWN]),
            error=SpectralError.of(curve, truth / white, "srgb", viewing),
        )

    is_coat = cover.kind == "coat"
    return Covered(
        **viewing._asdict(),
        material=About.of(preset),
        cover=cover.kind,
        medium=FrontMedium.of(cover.front),
        gamut=gamut,
        air=filled(Look, shown["air"]),
        below=filled(Look, shown["below"]),
        whole=filled(Look, shown["whole"]),
        largest_angle_deg=float(np.degrees(np.arcsin(1.0 / n))) if is_coat and n > 1.0 else None,
        theta_i_deg=np.ascontiguousarray(ANGLES_DEG[SHOWN]),
        reflectance=np.ascontiguousarray(truth[SHOWN]),
        shortcuts=[error(one) for one in coat_shortcuts().values()] if is_coat else [],
        outside_0_to_1=tuple(
            f"{name}.{what}" for name, look in looks.items() for what in look.outside
        ),
        warnings=tuple(dict.fromkeys(together.warnings)),
    )
