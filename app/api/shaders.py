"""`/shaders` and `/shaders/{model}`: models as code to take away."""

from __future__ import annotations

from dataclasses import asdict
from functools import cache
from typing import Annotated, Literal

import orjson
from fastapi import APIRouter, Query
from pydantic import BaseModel, Field
from starlette.responses import Response

from app.api.answers import Answer
from app.api.responses import ReadyBody
from app.api.schemas import MeasuredOut
from app.http.problems import MissingResource
from app.http.query import QueryModel
from app.http.route import QueryRoute
from app.optics.errors import NotAllowed, UnknownModel
from app.optics.registry import Model, Registry
from app.snippets.languages import LANGUAGES, Language, Trust
from app.snippets.snippet import arguments_of, reason_without, write

TEXT_AS_WELL: dict[int | str, dict[str, object]] = {
    200: {"content": {"text/plain": {"schema": {"type": "string"}}}}
}


class ShaderQuery(QueryModel):
    """Which language, and how much."""

    language: Literal["glsl", "hlsl", "wgsl", "osl", "python"] = Field(
        "glsl", description="Shading language, or Python with NumPy."
    )
    channels: Literal["1", "3"] = Field(
        "1", description="1 for real numbers; 3 adds a function of RGB colors, `<model>_rgb`."
    )
    format: Literal["json", "text"] = Field("json", description="JSON, or the code alone.")


class LanguageOut(BaseModel):
    """A language, and what our tests do with what is written in it."""

    id: str
    title: str
    checked: Trust = Field(
        description="run: compiled, run and compared with Python; compiled; or untested."
    )
    checked_by: str = Field(description="What checks it, or why nothing does.")


class ArgumentOut(BaseModel):
    """An argument of the function."""

    name: str
    description: str
    per_channel: bool = Field(description="Whether the function of colors takes a color there.")


class ShaderOut(BaseModel):
    """A model in one language."""

    model: str
    language: str
    checked: Trust = Field(
        description="run: compiled, run and compared with Python; compiled; or untested."
    )
    checked_by: str = Field(description="What checks it, or why nothing does.")
    channels: int
    function: str = Field(description="Name of the function.")
    arguments: list[ArgumentOut]
    code: str
    reference: str
    validity: str
    measured: list[MeasuredOut]


class ShaderLinkOut(BaseModel):
    """Whether a model has a snippet."""

    model: str
    title: str
    url: str | None = Field(description="Where it is; null if the model has none.")
    reason: str | None = Field(description="Why it has none.")


class ShadersOut(BaseModel):
    """All languages, and all models."""

    languages: list[LanguageOut]
    shaders: list[ShaderLinkOut]


def describe(language: Language) -> dict[str, str]:
    """Turn a language into what the API says of it."""
    return {
        "id": language.id,
        "title": language.title,
        "checked": language.checked,
        "checked_by": language.checked_by,
    }


def shader_url(model: Model) -> str | None:
    """Address of a model's snippets, or None where it has none."""
    return None if reason_without(model) else f"/api/v1/shaders/{model.id}"


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["shaders"])

    @cache
    def every_shader() -> Response:
        links = [
            {
                "model": model.id,
                "title": model.title,
                "url": shader_url(model),
                "reason": reason_without(model),
            }
            for model in registry.values()
        ]
        payload = {"languages": [describe(x) for x in LANGUAGES.values()], "shaders": links}
        return ReadyBody(orjson.dumps(payload), "application/json", effort="thorough")

    def one_shader(model: Model, language_id: str, channels: int, form: str) -> Response:
        reason = reason_without(model)
        if reason is not None:
            raise MissingResource(
                NotAllowed("model_id", model.id, f"a model with a closed form; {reason}")
            )
        language = LANGUAGES[language_id]
        code = write(model, language, channels)
        if form == "text":
            return ReadyBody(code.encode(), "text/plain; charset=utf-8")
        payload = {
            "model": model.id,
            "language": language.id,
            "checked": language.checked,
            "checked_by": language.checked_by,
            "channels": channels,
            "function": model.id,
            "arguments": [asdict(argument) for argument in arguments_of(model)],
            "code": code,
            "reference": model.reference,
            "validity": model.validity,
            "measured": [asdict(measured) for measured in model.measured],
        }
        return ReadyBody(orjson.dumps(payload), "application/json")

    @routes.get("/shaders", response_model=ShadersOut, summary="Models that there is code of")
    def shaders() -> Answer:
        return every_shader()

    @routes.get(
        "/shaders/{model_id}",
        response_model=ShaderOut,
        responses=TEXT_AS_WELL,
        summary="A model as a function in GLSL, HLSL, WGSL, OSL or Python",
    )
    def shader(model_id: str, query: Annotated[ShaderQuery, Query()]) -> Answer:
        try:
            model = registry.find(model_id, "model_id")
        except UnknownModel as error:
            raise MissingResource(error) from None
        return one_shader(model, query.language, int(query.channels), query.format)

    return routes
