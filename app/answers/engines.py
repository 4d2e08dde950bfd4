"""What render engines reflect, beside the boundary and the models that explain them."""

from __future__ import annotations

from typing import Any

import numpy as np

from app.answers.answer import Rows, Values, answer, filled
from app.engines.explained import DEPARTURES, explained
from app.engines.measured import CHANNELS, Channel, Curve, Engine, Light, Medium
from app.optics.incidence import Incidence
from app.optics.interface import Kind
from app.optics.parameters import Array
from app.optics.registry import Registry


@answer
class MeasuredEngine:
    """A render engine that was measured."""

    id: str
    title: str
    package: str
    """Its package, of npm or of Python's index."""
    version: str
    date: str
    """When it was measured."""
    how: str
    """What was drawn, and what was read of it."""
    repeat: str
    """The command that measures it again."""
    noise: float
    """How far white metal is from white, or the rounding of the pixels where that is more."""
    departures: list[str]
    """Where it leaves the boundary, in sentences with the figures measured."""

    @classmethod
    def of(cls, engine: Engine) -> MeasuredEngine:
        """Describe an engine."""
        return filled(cls, engine, departures=_departures(engine))


@answer
class MeasuredEngines:
    """All engines that were measured."""

    engines: list[MeasuredEngine]


@answer
class FarthestAngle:
    """Where a curve is farthest from another."""

    max_abs: float
    at_deg: float
    channel: Channel

    @classmethod
    def of(cls, error: Array, engine: Engine) -> FarthestAngle:
        """Find the largest of rows of angles and columns of channels."""
        size = np.abs(error)
        row, column = np.unravel_index(int(np.argmax(size)), size.shape)
        return cls(
            max_abs=float(size[row, column]),
            at_deg=float(engine.theta_i_deg[row]),
            channel=CHANNELS[column],
        )


@answer
class EngineMedium:
    """A medium, and what its boundary with vacuum reflects."""

    name: str
    kind: Kind
    n: Values
    """Of red, green and blue."""
    k: Values
    exact: Rows
    """Unpolarized reflectance, a row an angle of red, green and blue."""

    @classmethod
    def of(cls, engine: Engine, medium: Medium) -> EngineMedium:
        """Describe a medium."""
        return filled(cls, medium, exact=engine.exact(medium))


@answer
class EngineCurve:
    """What an engine reflects of a medium."""

    medium: str
    light: Light
    """An even environment, or one light in the mirror's direction as a share of white metal."""
    way: str
    """Which of the engine's materials, or of their modes."""
    typed: dict[str, Any]
    """What was typed in, by the engine's own names."""
    reflectance: Rows
    """A row an angle of red, green and blue."""
    error: FarthestAngle
    """Farthest from the boundary, among the angles measured."""
    model: str | None
    """The model of /models that explains the curve, if one does."""
    model_error: FarthestAngle | None
    """Farthest from that model, among the angles measured."""

    @classmethod
    def of(cls, engine: Engine, curve: Curve, registry: Registry) -> EngineCurve:
        """Compare a curve with the boundary and with the model that explains it."""
        model = explained(engine, curve)
        distance = None
        if model is not None:
            incidence = Incidence.from_degrees(engine.theta_i_deg[:, None])
            values = registry[model](curve.medium.interface, incidence)
            distance = FarthestAngle.of(curve.reflectance - values, engine)
        return filled(
            cls,
            curve,
            medium=curve.medium.name,
            error=FarthestAngle.of(curve.reflectance - engine.exact(curve.medium), engine),
            model=model,
            model_error=distance,
        )


@answer
class EngineCurves(MeasuredEngine):
    """Everything that was measured of an engine."""

    channels_nm: tuple[float, ...]
    """The wavelengths at which n and k of a metal are its red, green and blue."""
    theta_i_deg: Values
    media: list[EngineMedium]
    curves: list[EngineCurve]


def engine_curves(engine: Engine, registry: Registry) -> EngineCurves:
    """Answer with all curves of an engine."""
    return filled(
        EngineCurves,
        engine,
        departures=_departures(engine),
        media=[EngineMedium.of(engine, medium) for medium in engine.media],
        curves=[EngineCurve.of(engine, curve, registry) for curve in engine.curves],
    )


def _departures(engine: Engine) -> list[str]:
    return [departure.told(engine) for departure in DEPARTURES.get(engine.id, ())]
