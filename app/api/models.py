"""`/models`, `/models/{id}` and `/parameters`: what is registered and declared."""

from __future__ import annotations

from dataclasses import asdict
from functools import lru_cache
from typing import Annotated, Any

import orjson
from fastapi import APIRouter, Query
from pydantic import Field

from app.api.answers import Answer
from app.api.params import QueryModel
from app.api.responses import json_body
from app.api.schemas import ModelOut, ModelsOut, ParametersOut
from app.api.shaders import shader_url
from app.http.body import ReadyBody
from app.http.problems import MissingResource
from app.http.route import QueryRoute
from app.optics.errors import NotAllowed, UnknownModel
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG
from app.optics.registry import Model, Registry


class ModelsQuery(QueryModel):
    """What of the models."""

    fields: str | None = Field(
        None,
        max_length=500,
        description="Comma-separated names of what to send of each model; all unless given.",
        examples=["id,title,parameters"],
    )


def describe(model: Model) -> dict[str, Any]:
    """Turn a model into what the API says of it."""
    return {
        "id": model.id,
        "title": model.title,
        "kind": model.kind,
        "trap": model.trap,
        "applies_to": list(model.applies_to),
        "parameters": [asdict(parameter) for parameter in model.parameters],
        "latex": model.latex,
        "reference": model.reference,
        "validity": model.validity,
        "cost": asdict(model.cost),
        "measured": [asdict(measured) for measured in model.measured],
        "shaders": shader_url(model),
    }


def _for_ever(payload: dict[str, Any]) -> ReadyBody:
    """Make an answer that stays the same while the program runs."""
    return ReadyBody(orjson.dumps(payload), "application/json", effort="thorough")


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["models"])
    described = [describe(model) for model in registry.values()]

    @lru_cache(maxsize=8)
    def every_model(fields: str | None) -> ReadyBody:
        if fields is None:
            return _for_ever({"models": described})
        names = {name.strip() for name in fields.split(",")}
        if not names <= set(ModelOut.model_fields):
            allowed = f"names among {', '.join(ModelOut.model_fields)}"
            raise NotAllowed("fields", fields, allowed)
        return _for_ever(
            {"models": [{k: v for k, v in row.items() if k in names} for row in described]}
        )

    every_parameter = _for_ever(
        {"parameters": [asdict(parameter) for parameter in (N_I, N_T, K_T, THETA_I_DEG)]}
    )

    @routes.get("/models", response_model=ModelsOut, summary="All models")
    def models(query: Annotated[ModelsQuery, Query()]) -> Answer:
        return every_model(query.fields)

    @routes.get("/models/{model_id}", response_model=ModelOut, summary="One model")
    def model(model_id: str) -> Answer:
        try:
            found = registry.find(model_id, "model_id")
        except UnknownModel as error:
            raise MissingResource(error) from None
        return json_body(describe(found))

    @routes.get("/parameters", response_model=ParametersOut, summary="Parameters and bounds")
    def parameters() -> Answer:
        return every_parameter

    return routes
