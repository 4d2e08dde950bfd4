"""Models as code to take away."""

from __future__ import annotations

from app.answers.answer import answer, filled
from app.optics.registry import Measured, Model
from app.snippets.languages import Language, Trust
from app.snippets.piece import Piece
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


@answer
class PieceLink:
    """Code that is no model's, but stands beside all of them."""

    id: str
    title: str
    url: str

    @classmethod
    def of(cls, piece: Piece) -> PieceLink:
        """Tell of one."""
        return filled(cls, piece, url=f"/api/v1/shaders/{piece.id}")


@answer
class PieceOfCode:
    """Some functions in one language."""

    id: str
    title: str
    language: str
    checked: Trust
    """run: compiled, run and compared with Python; compiled; or untested."""
    checked_by: str
    """What checks it, or why nothing does."""
    functions: tuple[str, ...]
    """Their names; one of vectors has `_xyz` behind that of its components."""
    arguments: tuple[Argument, ...]
    code: str
    reference: str
    validity: str


def piece_of_code(piece: Piece, language: Language) -> PieceOfCode:
    """Write a piece in a language."""
    checked, by = piece.trust(language)
    return filled(
        PieceOfCode,
        piece,
        language=language.id,
        checked=checked,
        checked_by=by,
        code=piece.write(language),
    )


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
