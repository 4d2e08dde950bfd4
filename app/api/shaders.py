"""`/shaders` and `/shaders/{model}`: models as code to take away."""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import PlainTextResponse, Response

from app.answers.answer import answer, filled
from app.answers.shaders import (
    PieceLink,
    PieceOfCode,
    Shader,
    ShaderLink,
    ShadingLanguage,
    piece_of_code,
    shader,
)
from app.http.problems import MissingResource
from app.http.query import QueryModel
from app.http.route import LastingRoute
from app.optics.errors import NotAllowed, UnknownModel
from app.optics.registry import Registry
from app.snippets import lookup, vectors
from app.snippets.languages import LANGUAGES
from app.snippets.piece import Piece
from app.snippets.snippet import reason_without

PIECES = (vectors.PIECE, lookup.PIECE)

TEXT_AS_WELL: dict[int | str, dict[str, object]] = {
    200: {"content": {"text/plain": {"schema": {"type": "string"}}}}
}


class LanguageQuery(QueryModel):
    """Which language."""

    language: Literal["glsl", "hlsl", "wgsl", "osl", "javascript", "python"] = Field(
        "glsl", description="Shading language, JavaScript, or Python with NumPy."
    )
    format: Literal["json", "text"] = Field("json", description="JSON, or the code alone.")


class ShaderQuery(LanguageQuery):
    """Which language, and how much."""

    channels: Literal["1", "3"] = Field(
        "1", description="1 for real numbers; 3 adds a function of RGB colors, `<model>_rgb`."
    )


@answer
class Shaders:
    """All languages, and all models."""

    languages: list[ShadingLanguage]
    shaders: list[ShaderLink]
    pieces: list[PieceLink]
    """What is no model's, but stands beside all of them."""


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=LastingRoute, tags=["shaders"])

    @routes.get("/shaders", summary="Models that there is code of")
    def shaders() -> Shaders:
        return Shaders(
            languages=[filled(ShadingLanguage, language) for language in LANGUAGES.values()],
            shaders=[ShaderLink.of(model) for model in registry.values()],
            pieces=[PieceLink.of(piece) for piece in PIECES],
        )

    def offer(piece: Piece) -> None:
        @routes.get(
            f"/shaders/{piece.id}",
            name=piece.id,
            response_model=PieceOfCode,
            responses=TEXT_AS_WELL,
            summary=f"{piece.title}, as code",
        )
        def code(query: Annotated[LanguageQuery, Query()]) -> PieceOfCode | Response:
            made = piece_of_code(piece, LANGUAGES[query.language])
            return PlainTextResponse(made.code) if query.format == "text" else made

    for piece in PIECES:
        offer(piece)

    @routes.get(
        "/shaders/{model_id}",
        response_model=Shader,
        responses=TEXT_AS_WELL,
        summary="A model as a function in GLSL, HLSL, WGSL, OSL, JavaScript or Python",
    )
    def one_shader(model_id: str, query: Annotated[ShaderQuery, Query()]) -> Shader | Response:
        try:
            model = registry.find(model_id, "model_id")
        except UnknownModel as error:
            raise MissingResource(error) from None
        reason = reason_without(model)
        if reason is not None:
            raise MissingResource(
                NotAllowed("model_id", model.id, f"a model with a closed form; {reason}")
            )
        made = shader(model, LANGUAGES[query.language], int(query.channels))
        return PlainTextResponse(made.code) if query.format == "text" else made

    return routes
