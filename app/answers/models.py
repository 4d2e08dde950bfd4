"""What is registered and declared: models and parameters."""

from __future__ import annotations

from dataclasses import asdict

from app.answers.answer import answer
from app.optics.interface import Kind
from app.optics.parameters import Parameter
from app.optics.registry import Model, ModelKind


@answer
class DeclaredParameter:
    """A declared parameter with its bounds."""

    name: str
    symbol: str
    """LaTeX"""
    default: float | None
    """Null where it is solved from the interface."""
    minimum: float
    maximum: float
    unit: str
    description: str
    integer: bool
    """Whether only whole numbers make sense."""
    choices: list[tuple[str, float]]
    """The only values, where not all are."""
    triple: bool
    """Whether three values, for R, G and B, give three curves."""

    @classmethod
    def of(cls, parameter: Parameter) -> DeclaredParameter:
        """Describe a parameter."""
        return cls(**asdict(parameter))


@answer
class MeasuredError:
    """The error of a model at one interface, which a test measures again."""

    n_i: float
    n_t: float
    k_t: float
    max_abs: float
    """Largest |R - exact| over the hemisphere."""
    at_deg: float
    """Angle where it is reached."""
    rms: float
    """Root mean square over the solid angle."""


@answer
class RegisteredModel:
    """A registered model."""

    id: str
    title: str
    kind: ModelKind
    trap: bool
    """Whether the model is kept to show a mistake."""
    applies_to: tuple[Kind, ...]
    parameters: list[DeclaredParameter]
    latex: str
    reference: str
    validity: str
    cost: dict[str, int]
    """Operations of one evaluation."""
    measured: list[MeasuredError]
    """Errors at representative interfaces."""
    shaders: str | None
    """Where it is as code for shaders; null where it has no closed form."""

    @classmethod
    def of(cls, model: Model, shaders: str | None) -> RegisteredModel:
        """Describe a model that is found as code at `shaders`."""
        return cls(
            id=model.id,
            title=model.title,
            kind=model.kind,
            trap=model.trap,
            applies_to=model.applies_to,
            parameters=[DeclaredParameter.of(parameter) for parameter in model.parameters],
            latex=model.latex,
            reference=model.reference,
            validity=model.validity,
            cost=asdict(model.cost),
            measured=[MeasuredError(**asdict(measured)) for measured in model.measured],
            shaders=shaders,
        )
