"""Models as code to take away."""

from __future__ import annotations

from app.answers.answer import answer, filled
from app.optics.registry import Measured, Model
from app.snippets.languages import Language, Trust
from app.snippets.snippet import Argument, arguments_of, reason_without, write


@answer
class ShadingLanguage:
    """A language, and what our tests do with what is written in it."""

    id: str
    title: str
    checked: Trust
    """run: compiled, run and compared with Python; compiled; or untested."""
    checked_by: str
    """What checks it, or why nothing does."""


@answer
class ShaderLink:
    """Whether a model has a snippet."""

    model: str
    title: str
    url: str | None
    """Where it is; null if the model has none."""
    reason: str | None
    """Why it has none."""

    @classmethod
    def of(cls, model: Model) -> ShaderLink:
        """Tell of a model."""
        reason = reason_without(model)
        return filled(cls, model, model=model.id, url=shader_url(model), reason=reason)


@answer
class Shader:
    """A model in one language."""

    model: str
    language: str
    checked: Trust
    """run: compiled, run and compared with Python; compiled; or untested."""
    checked_by: str
    """What checks it, or why nothing does."""
    channels: int
    function: str
    """Name of the function."""
    arguments: list[Argument]
    code: str
    reference: str
    validity: str
    measured: tuple[Measured, ...]


def shader_url(model: Model) -> str | None:
    """Address of a model's snippets, or None where it has none."""
    return None if reason_without(model) else f"/api/v1/shaders/{model.id}"


def shader(model: Model, language: Language, channels: int) -> Shader:
    """Write a model, which has a closed form, in a language."""
    return filled(
        Shader,
        model,
        model=model.id,
        language=language.id,
        checked=language.checked,
        checked_by=language.checked_by,
        channels=channels,
        function=model.id,
        arguments=list(arguments_of(model)),
        code=write(model, language, channels),
    )
