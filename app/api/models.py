"""`/models`, `/models/{id}` and `/parameters`: what is registered and declared."""

from dataclasses import fields
from pathlib import Path
from typing import Annotated, get_args

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.answer import ChosenFields, answer, chosen_fields
from app.answers.looks import ModelLook, Theme, theme_colors
from app.answers.models import RegisteredModel
from app.answers.shaders import shader_url
from app.http.problems import MissingResource
from app.http.query import QueryModel
from app.http.route import LastingRoute
from app.optics.errors import UnknownModel
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, Parameter
from app.optics.registry import Registry


class ModelsQuery(QueryModel):
    """What of the models."""

    fields: str | None = Field(
        None,
        max_length=500,
        description="Comma-separated names of what to send of each model; all unless given.",
        examples=["id,title,parameters"],
    )


@answer
class Models:
    """All registered models."""

    models: list[RegisteredModel | ChosenFields]


@answer
class Parameters:
    """The parameters common to all endpoints."""

    parameters: tuple[Parameter, ...]


def router(registry: Registry, static_dir: Path) -> APIRouter:
    """Routes over the models of `registry`, in the colors of the page's style sheet."""
    routes = APIRouter(route_class=LastingRoute, tags=["models"])
    themes = {theme: theme_colors(static_dir, theme) for theme in get_args(Theme)}
    described = {
        model.id: RegisteredModel.of(model, shader_url(model), ModelLook.of(model.id, themes))
        for model in registry.values()
    }

    @routes.get("/models", summary="All models")
    def models(query: Annotated[ModelsQuery, Query()]) -> Models:
        names = chosen_fields(query.fields, [field.name for field in fields(RegisteredModel)])
        if names is None:
            return Models(models=[*described.values()])
        return Models(models=[{n: getattr(row, n) for n in names} for row in described.values()])

    @routes.get("/models/{model_id}", summary="One model")
    def model(model_id: str) -> RegisteredModel:
        try:
            found = registry.find(model_id, "model_id")
        except UnknownModel as error:
            raise MissingResource(error) from None
        return described[found.id]

    @routes.get("/parameters", summary="Parameters and bounds")
    def parameters() -> Parameters:
        return Parameters(parameters=(N_I, N_T, K_T, THETA_I_DEG))

    return routes
