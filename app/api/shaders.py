"""`/shaders` and `/shaders/{model}`: models as code to take away."""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import PlainTextResponse, Response

from app.answers.answer import answer, filled
from app.answers.shaders import Shader, ShaderLink, ShadingLanguage, shader
from app.http.problems import MissingResource
from app.http.query import QueryModel
from app.http.route import LastingRoute
from app.optics.errors import NotAllowed, UnknownModel
from app.optics.registry import Registry
from app.snippets.languages import LANGUAGES
from app.snippets.snippet import reason_without

TEXT_AS_WELL: dict[int | str, dict[str, object]] = {
    200: {"content": {"text/plain": {"schema": {"type": "string"}}}}
}


class ShaderQuery(QueryModel):
    """Which language, and how much."""

    language: Literal["glsl", "hlsl", "wgsl", "osl", "javascript", "python"] = Field(
        "glsl", description="Shading language, JavaScript, or Python with NumPy."
    )
    channels: Literal["1", "3"] = Field(
        "1", description="1 for real numbers; 3 adds a function of RGB colors, `<model>_rgb`."
    )
    format: Literal["json", "text"] = Field("json", description="JSON, or the code alone.")


@answer
class Shaders:
    """All languages, and all models."""

    languages: list[ShadingLanguage]
    shaders: list[ShaderLink]


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=LastingRoute, tags=["shaders"])

    @routes.get("/shaders", summary="Models that there is code of")
    def shaders() -> Shaders:
        return Shaders(
            languages=[filled(ShadingLanguage, language) for language in LANGUAGES.values()],
            shaders=[ShaderLink.of(model) for model in registry.values()],
        )

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
