"""Registered models."""

from __future__ import annotations

from app.answers.answer import answer, filled
from app.answers.looks import ModelLook
from app.optics.interface import Kind
from app.optics.parameters import Parameter
from app.optics.registry import Cost, Measured, Model, ModelKind


@answer
class RegisteredModel:
    """A registered model."""

    id: str
    title: str
    kind: ModelKind
    trap: bool
    """Whether the model is kept to show a mistake."""
    applies_to: tuple[Kind, ...]
    parameters: tuple[Parameter, ...]
    takes_color: bool
    """Whether a material's color, F0 with F82 or a tint, is all that it has to be given."""
    latex: str
    reference: str
    validity: str
    cost: Cost
    """Operations of one evaluation."""
    measured: tuple[Measured, ...]
    """Errors at representative interfaces."""
    shaders: str | None
    """Where it is as code for shaders; null where it has no closed form."""
    look: ModelLook

    @classmethod
    def of(cls, model: Model, shaders: str | None, look: ModelLook) -> RegisteredModel:
        """Describe a model that is found as code at `shaders`."""
        return filled(cls, model, shaders=shaders, look=look)
