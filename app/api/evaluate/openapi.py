"""What OpenAPI says of `/evaluate`, whose body and answers FastAPI does not see."""

from typing import Any

from app.api.evaluate.arrow import MEDIA_TYPE
from app.api.params import LayersQuery
from app.batch.rows import ANGLES, MEDIA
from app.optics.parameters import THETA_I_RAD, Parameter
from app.optics.quantities import QUANTITIES
from app.optics.registry import Registry

_DESCRIPTION = """
Up to 1,000,000 values of any models, media and quantities in one call, answered in the order asked.
An item that is wrong does not keep the others from their answers: its error stands in its place. The
first hundred errors are told in full; of the others it is said that there is one, and the end of a JSON
answer counts them by parameter. A field that an item gives twice is an error.

A body of `application/json` holds items; `application/vnd.apache.arrow.stream` columns of the same
names, one row a value, null for what is left out. The answer is JSON, CSV or an Arrow stream by
`Accept`, and of the body's kind where that leaves the choice. JSON holds a number for each item, a
list where its angle was one, and null where a model is undefined; CSV and Arrow hold a row a value.
Presets are evaluated as everywhere else, but without warnings: `/snell` tells of one what it was
measured as, and what of it counts as 0. A parameter of a model is one number: for R, G and B ask three
times.
Arrow is there where the server has the extra `[arrow]`; 415 or 406 tell where not.
"""

_EXAMPLE = {
    "items": [
        {"n_t": 1.5, "theta_i_deg": [0, 56.31, 80]},
        {"n_t": 0.27, "k_t": 2.9, "theta_i_deg": 45, "quantity": "Rp"},
        {"n_t": 1.5, "theta_i_deg": 60, "model": "schlick", "schlick.F0": 0.05},
        {"material": "Au", "incident": "water", "wavelength_nm": 550, "theta_i_deg": [0, 60]},
        {"material": "BK7", "layers": "MgF2:99.6", "wavelength_nm": 550, "quantity": "Rp"},
    ]
}


def operation(registry: Registry) -> dict[str, Any]:
    """Arguments of the route's declaration."""
    arrow = {"schema": {"type": "string", "format": "binary"}}
    body = {"schema": _body(registry), "example": _EXAMPLE}
    answers = {
        "application/json": {"schema": _ANSWER},
        "text/csv": {"schema": {"type": "string"}},
        MEDIA_TYPE: arrow,
    }
    return {
        "description": _DESCRIPTION.strip(),
        "response_model": None,
        "responses": {200: {"description": "The values.", "content": answers}},
        "openapi_extra": {
            "requestBody": {
                "required": True,
                "content": {"application/json": body, MEDIA_TYPE: arrow},
            }
        },
    }


def _number(parameter: Parameter) -> dict[str, Any]:
    schema: dict[str, Any] = {
        "type": "number",
        "minimum": parameter.minimum,
        "maximum": parameter.maximum,
    }
    if parameter.choices:
        schema = {"enum": [name for name, _ in parameter.choices]}
    return schema


def _described(parameter: Parameter, schema: dict[str, Any]) -> dict[str, Any]:
    named = {number: name for name, number in parameter.choices}
    default = named.get(parameter.default or 0.0, parameter.default)
    described = schema | {"description": parameter.description}
    return described if default is None else described | {"default": default}


def _body(registry: Registry) -> dict[str, Any]:
    properties: dict[str, Any] = {
        "model": {"type": "string", "enum": list(registry), "default": "exact"},
        "quantity": {"type": "string", "enum": list(QUANTITIES), "default": "R"},
    }
    properties |= _presets()
    for parameter in (*MEDIA, THETA_I_RAD):
        schema = _number(parameter)
        if parameter.name in ANGLES:
            schema = {"anyOf": [schema, {"type": "array", "items": schema}]}
        properties[parameter.name] = _described(parameter, schema)
    for model in registry.values():
        for parameter in model.parameters:
            name = f"{model.id}.{parameter.name}"
            properties[name] = _described(parameter, _number(parameter))
    item = {"type": "object", "properties": properties, "additionalProperties": False}
    return {
        "type": "object",
        "properties": {"items": {"type": "array", "items": item}},
        "required": ["items"],
        "additionalProperties": False,
    }


def _presets() -> dict[str, Any]:
    """What stands in the place of numbers, as the routes that take a single one describe it."""
    told = LayersQuery.model_json_schema()["properties"]
    return {
        name: {
            "description": told[name]["description"],
            **next(kind for kind in told[name]["anyOf"] if kind["type"] != "null"),
        }
        for name in ("material", "incident", "wavelength_nm", "layers")
    }


_NUMBER_OR_NULL = {"anyOf": [{"type": "number"}, {"type": "null"}]}

_FAULT = {
    "type": "object",
    "properties": {
        "index": {"type": "integer", "description": "Number of the item, from 0."},
        "errors": {
            "type": "array",
            "description": "What is wrong; empty beyond the first hundred items that are.",
            "items": {
                "type": "object",
                "properties": {
                    "parameter": {"type": "string"},
                    "value": {},
                    "message": {"type": "string"},
                },
                "required": ["parameter", "value", "message"],
            },
        },
    },
    "required": ["index", "errors"],
}

_ANSWER = {
    "type": "object",
    "properties": {
        "convention": {"type": "string"},
        "results": {
            "type": "array",
            "items": {
                "anyOf": [
                    *_NUMBER_OR_NULL["anyOf"],
                    {"type": "array", "items": _NUMBER_OR_NULL},
                    _FAULT,
                ]
            },
        },
        "failed": {"type": "integer", "description": "How many items were wrong."},
        "failed_by": {
            "type": "object",
            "additionalProperties": {"type": "integer"},
            "description": "How many in which parameter, where more were wrong than are told in full.",
        },
    },
    "required": ["convention", "results", "failed"],
}
