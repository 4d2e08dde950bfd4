"""A material as a file of a render engine, with the error that the engine will show."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.answers.answer import Rows, Values, answer, filled
from app.answers.film_media import FilmMedia, Side
from app.answers.materials.about import About
from app.answers.materials.rgb_nk import SpectralError
from app.engines.measured import engines
from app.export.film import TypedFilm, film_curve
from app.export.registry import TARGETS
from app.export.surface import OPAQUE_K, Surface, Typed
from app.export.target import Basis, File, Mode, ModeId, Target, TargetId
from app.materials.appearance import DAYLIGHT
from app.materials.films import Film, film_constants
from app.materials.front import Front
from app.materials.rgb_index import ANGLES_DEG
from app.materials.schema import Preset
from app.optics.color import WAVELENGTH_NM, Gamut, Space, srgb_weights
from app.optics.errors import NotAllowed
from app.optics.film_color import swept_colors
from app.optics.incidence import Incidence
from app.optics.interface import Kind
from app.optics.knobs.dispersion import D_LINE_NM
from app.optics.parameters import Array

SHOWN_DEG = (0.0, 30.0, 60.0, 80.0, 85.0)


@answer
class ExportedFile:
    """A file by its text."""

    name: str
    text: str


@answer
class MeasuredWith:
    """What the error is computed with: a model, and the engine that was measured to follow it."""

    model: str | None
    """Id of a model; null for a formula of the engine alone."""
    engine: str | None
    """Id of the engine among /engines; null where it was not run."""
    version: str | None
    """Of the engine that was measured."""
    way: str | None
    """Which of the engine's materials was measured."""
    note: str
    """What stands for a measurement where there is none."""

    @classmethod
    def of(cls, basis: Basis) -> MeasuredWith:
        """Name the engine with its version."""
        version = None if basis.engine is None else engines()[basis.engine].version
        return cls(
            model=basis.model or None,
            engine=basis.engine,
            version=version,
            way=basis.way,
            note=basis.note,
        )


@answer
class ExportError(SpectralError):
    """How far the engine will be from the spectrum, among the angles from 0 by 0.25 degrees."""

    measured_with: MeasuredWith


@answer
class ExportedFilm:
    """The film on the surface, as it is typed."""

    medium: str
    """As it was asked for: a preset or an index."""
    n: float
    """At the d line, 587.6 nm: engines have one index for all wavelengths."""
    thickness_nm: float
    model: str
    """Id among /films/models of the shortcut that the engine takes for it."""


@answer
class Export:
    """A material for an engine."""

    material: About
    to: TargetId
    title: str
    mode: ModeId
    mode_title: str
    modes: list[ModeId]
    """The modes that this material has there."""
    kind: Kind
    """Whether it is exported as opaque or as clear."""
    policy: Gamut
    space: Space
    files: list[ExportedFile]
    parameters: dict[str, Typed]
    """What is typed, by the engine's own names: all numbers linear."""
    lost: list[str]
    """What the file does not keep, in sentences."""
    error: ExportError
    theta_i_deg: Values
    reflectance: Rows
    """What the engine will reflect at these angles, a row an angle of red, green and blue."""
    spectrum: Rows
    """What the spectrum reflects there, not clamped."""
    warnings: tuple[str, ...]
    film: ExportedFilm | None
    """The film with interference on the surface; null where it is bare."""


def chosen_mode(
    surface: Surface, to: TargetId, mode: ModeId | None, film: Film | None = None
) -> Mode:
    """Look up how a surface, with or without a film, is written for a target.

    Raises
    ------
    NotAllowed
        If the target has no such mode for it, does not take its index or the space, or refuses what
        the policy leaves outside 0 to 1.
    """
    target = TARGETS[to]
    able = _able(target, surface, film)
    found = next((m for m in able if mode in (None, m.id)), None)
    if found is None:
        told = "opaque" if surface.kind == "conductor" else "clear"
        ids = " or ".join(m.id for m in able)
        raise NotAllowed("mode", mode, f"{ids} for to = {to} and a material that is {told}")
    if surface.kind == "dielectric" and surface.ior < target.least_ior:
        allowed = f"another target: its ior is at least {target.least_ior:g}, and n {surface.ior:g}"
        raise NotAllowed("to", to, allowed)
    if surface.space not in target.spaces:
        raise NotAllowed("space", surface.space, f"{' or '.join(target.spaces)} for to = {to}")
    if not found.takes_above_1 and "F0" in surface.outside:
        raise NotAllowed(
            "policy", surface.policy, f"clamped or scaled for to = {to}, which takes 0 to 1"
        )
    return found


def _able(target: Target, surface: Surface, film: Film | None) -> tuple[Mode, ...]:
    """Return the modes that a target has for a surface.

    Raises
    ------
    NotAllowed
        If there is a film and the target has none.
    """
    able = target.of(surface.kind)
    if film is None:
        return able
    coated = tuple(mode for mode in able if mode.film is not None)
    if not coated:
        known = [each.id for each in TARGETS.values() if any(m.film for m in each.of(surface.kind))]
        allowed = f"none for to = {target.id}, which has no film; {', '.join(known)} have one"
        raise NotAllowed("layers", film.spelled, allowed)
    if surface.space != "srgb":
        raise NotAllowed("space", surface.space, "srgb with a film, whose color is made there")
    return coated


def one_film(films: Sequence[Film]) -> Film:
    """Return the film that an engine can have.

    Raises
    ------
    NotAllowed
        If there are several, or it is so thick that nothing interferes.
    """
    if len(films) != 1 or films[0].incoherent:
        spelled = ",".join(film.spelled for film in films)
        raise NotAllowed("layers", spelled, "one film with interference: engines know no more")
    return films[0]


def _typed_film(film: Film, to: TargetId) -> tuple[TypedFilm, bool]:
    """Return what is typed of a film, and whether it absorbs."""
    constants = film_constants(film, None)
    n, k = (np.broadcast_to(values, WAVELENGTH_NM.shape) for values in (constants.n, constants.k))
    index = float(np.interp(D_LINE_NM, WAVELENGTH_NM, n))
    if index < (least := TARGETS[to].least_ior):
        allowed = f"n of at least {least:g} for to = {to}; it is {index:.4g}"
        raise NotAllowed("layers", film.spelled, allowed)
    return TypedFilm(index, film.thickness_nm or 0.0), bool(k.max() >= OPAQUE_K)


def _film_truth(preset: Preset, film: Film) -> Array:
    """Linear sRGB of the film on the material at `ANGLES_DEG`, from the whole spectrum."""
    index = complex(preset.n_absolute, preset.k or 0.0)
    side = Side(index, preset.id if preset.kind == "spectrum" else None)
    stack, _ = FilmMedia(Front(1.0), (film,), side).visible()
    thickness = np.array([film.thickness_nm or 0.0])
    incidence = Incidence.from_degrees(ANGLES_DEG)
    return np.asarray(swept_colors(stack, 0, thickness, incidence, srgb_weights(*DAYLIGHT))[0])


def _typed(
    mode: Mode, surface: Surface, to: TargetId, film: Film | None
) -> tuple[dict[str, Typed], TypedFilm | None, list[str]]:
    """Return what is typed, that of the film, and what is lost of it."""
    typed = mode.parameters(surface)
    if film is None or mode.film is None:
        return typed, None, []
    known, absorbs = _typed_film(film, to)
    lost = [*([_FILM_ABSORBS] if absorbs else []), _FILM_INDEX]
    return typed | mode.film.parameters(known.n, known.thickness_nm), known, lost


_FILM_ABSORBS = "What the film absorbs is lost: engines' films are clear"
_FILM_INDEX = "The film has one index for all wavelengths, that at 587.6 nm"


def exported_file(
    preset: Preset,
    to: TargetId,
    mode: ModeId | None,
    policy: Gamut,
    space: Space,
    film: Film | None = None,
) -> File:
    """Write a material for a target; parameters and errors as `export`."""
    surface = Surface(preset, policy, space)
    chosen = chosen_mode(surface, to, mode, film)
    return chosen.write(surface, _typed(chosen, surface, to, film)[0])


def export(
    preset: Preset,
    to: TargetId,
    mode: ModeId | None = None,
    policy: Gamut = "clamped",
    space: Space = "srgb",
    film: Film | None = None,
) -> Export:
    """Write a material for a target, and say what the target makes of it.

    Parameters
    ----------
    preset
        The material; a single index stands for all wavelengths.
    to, mode
        The target, and which of its ways; the first that the material has unless given.
    policy, space
        What is done about colors outside 0 to 1, and whose channels the numbers are.
    film
        On the surface, with interference.

    Raises
    ------
    NotAllowed
        As `chosen_mode` does, and if the film is none that the target takes.
    """
    surface = Surface(preset, policy, space)
    target, chosen = TARGETS[to], chosen_mode(surface, to, mode, film)
    typed, typed_film, lost_of_film = _typed(chosen, surface, to, film)
    file, basis = chosen.write(surface, typed), chosen.basis
    coated = None
    if film is None or typed_film is None or chosen.film is None:
        curve, truth = chosen.curve(surface), surface.truth
    else:
        curve, truth = film_curve(surface, chosen.film, typed_film), _film_truth(preset, film)
        basis = Basis("", note=f"the shortcut for films {chosen.film.model} of /films/models")
        coated = ExportedFilm(
            medium=film.medium,
            n=typed_film.n,
            thickness_nm=typed_film.thickness_nm,
            model=chosen.film.model,
        )
    error = SpectralError.of(curve, truth, space, DAYLIGHT)
    lost = [*chosen.lost, *lost_of_film]
    if target.spaces[space]:
        lost.append(target.spaces[space])
    has_colors = chosen.id not in ("spectral", "ior")
    if has_colors and policy != "unclamped" and Surface(preset, "unclamped", space).outside:
        lost.append(f"Colors outside 0 to 1 are brought inside: {policy}")
    return Export(
        material=About.of(preset),
        to=to,
        title=target.title,
        mode=chosen.id,
        mode_title=chosen.title,
        modes=[each.id for each in _able(target, surface, film)],
        kind=surface.kind,
        policy=policy,
        space=space,
        files=[ExportedFile(name=file.name, text=file.text)],
        parameters=typed,
        lost=[f"{sentence}." for sentence in lost],
        error=filled(ExportError, error, measured_with=MeasuredWith.of(basis)),
        theta_i_deg=np.array(SHOWN_DEG),
        reflectance=_shown(curve),
        spectrum=_shown(truth),
        warnings=surface.visible.warnings,
        film=coated,
    )


def _shown(curve: Array) -> Array:
    return np.ascontiguousarray(curve[np.searchsorted(ANGLES_DEG, SHOWN_DEG)])
