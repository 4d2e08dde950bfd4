"""A material as a file of a render engine, with the error that the engine will show."""

from __future__ import annotations

import numpy as np

from app.answers.answer import Rows, Values, answer, filled
from app.answers.materials.about import About
from app.answers.materials.rgb_nk import SpectralError
from app.engines.measured import engines
from app.export.registry import TARGETS
from app.export.surface import Surface, Typed
from app.export.target import Basis, File, Mode, ModeId, TargetId
from app.materials.appearance import DAYLIGHT
from app.materials.rgb_index import ANGLES_DEG
from app.materials.schema import Preset
from app.optics.color import Gamut, Space
from app.optics.errors import NotAllowed
from app.optics.interface import Kind
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


def chosen_mode(surface: Surface, to: TargetId, mode: ModeId | None) -> Mode:
    """Look up how a surface is written for a target.

    Raises
    ------
    NotAllowed
        If the target has no such mode for it, does not take the space, or refuses what the policy
        leaves outside 0 to 1.
    """
    target = TARGETS[to]
    able = target.of(surface.kind)
    found = next((m for m in able if mode in (None, m.id)), None)
    if found is None:
        told = "opaque" if surface.kind == "conductor" else "clear"
        ids = " or ".join(m.id for m in able)
        raise NotAllowed("mode", mode, f"{ids} for to = {to} and a material that is {told}")
    if surface.space not in target.spaces:
        raise NotAllowed("space", surface.space, f"{' or '.join(target.spaces)} for to = {to}")
    if not found.takes_above_1 and "F0" in surface.outside:
        raise NotAllowed(
            "policy", surface.policy, f"clamped or scaled for to = {to}, which takes 0 to 1"
        )
    return found


def exported_file(
    preset: Preset, to: TargetId, mode: ModeId | None, policy: Gamut, space: Space
) -> File:
    """Write a material for a target; parameters and errors as `export`."""
    surface = Surface(preset, policy, space)
    return chosen_mode(surface, to, mode).file(surface)


def export(
    preset: Preset,
    to: TargetId,
    mode: ModeId | None = None,
    policy: Gamut = "clamped",
    space: Space = "srgb",
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

    Raises
    ------
    NotAllowed
        As `chosen_mode` does.
    """
    surface = Surface(preset, policy, space)
    target, chosen = TARGETS[to], chosen_mode(surface, to, mode)
    typed = chosen.parameters(surface)
    file, curve, truth = chosen.write(surface, typed), chosen.curve(surface), surface.truth
    error = SpectralError.of(curve, truth, space, DAYLIGHT)
    lost = [*chosen.lost]
    if target.spaces[space]:
        lost.append(target.spaces[space])
    if policy != "unclamped" and Surface(preset, "unclamped", space).outside:
        lost.append(f"Colors outside 0 to 1 are brought inside: {policy}")
    return Export(
        material=About.of(preset),
        to=to,
        title=target.title,
        mode=chosen.id,
        mode_title=chosen.title,
        modes=[mode.id for mode in target.of(surface.kind)],
        kind=surface.kind,
        policy=policy,
        space=space,
        files=[ExportedFile(name=file.name, text=file.text)],
        parameters=typed,
        lost=[f"{sentence}." for sentence in lost],
        error=filled(ExportError, error, measured_with=MeasuredWith.of(chosen.basis)),
        theta_i_deg=np.array(SHOWN_DEG),
        reflectance=_shown(curve),
        spectrum=_shown(truth),
        warnings=surface.visible.warnings,
    )


def _shown(curve: Array) -> Array:
    return np.ascontiguousarray(curve[np.searchsorted(ANGLES_DEG, SHOWN_DEG)])
