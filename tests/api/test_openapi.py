"""The schema says of every route and parameter what the server does."""

import re
from dataclasses import fields
from itertools import chain
from typing import Any

import pytest
from fastapi import FastAPI

from app import __version__
from app.answers.albedo import Albedos, Coat, RegisteredFit, RegisteredFits
from app.answers.albedo_grids import AlbedoMap, AlbedoSweep
from app.answers.curves import CoatedCurves, Curves
from app.answers.error_grids import ErrorMap, ErrorSweep
from app.answers.errors import Errors
from app.answers.interface import InterfaceFacts
from app.answers.lookup import (
    CoatedLookupTable,
    FilmLookupTable,
    LookupErrors,
    LookupTable,
)
from app.answers.models import RegisteredModel
from app.answers.recommendation import Recommendation
from app.answers.snell import Amplitude, CoatedRay, Ray
from app.api.health import Health
from app.api.models import Models, Parameters
from app.http.problems import MEDIA_TYPE
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, Parameter
from app.optics.registry import default_registry
from tests.api.raw import send
from tests.api.shape import Ask

PREFIX = "/api/v1"
OUTPUTS = {
    "/health": Health,
    "/models": Models,
    "/models/{model_id}": RegisteredModel,
    "/parameters": Parameters,
    "/snell": Ray,
    "/curves": Curves,
    "/albedo": Albedos,
    "/albedo/fits": RegisteredFits,
    "/albedo/fits/{fit_id}": RegisteredFit,
    "/albedo/sweep": AlbedoSweep,
    "/albedo/map": AlbedoMap,
    "/albedo/coat": Coat,
    "/errors": Errors,
    "/errors/sweep": ErrorSweep,
    "/errors/map": ErrorMap,
    "/lut": LookupTable,
    "/lut/errors": LookupErrors,
    "/recommend": Recommendation,
}
WITH_LAYERS: dict[str, list[type[Any]]] = {
    "/snell": [CoatedRay],
    "/curves": [CoatedCurves],
    "/lut": [CoatedLookupTable, FilmLookupTable],
}
OWN = [(model, p) for model in default_registry().values() for p in model.parameters]


@pytest.fixture(scope="module")
def schema(app: FastAPI) -> dict[str, Any]:
    answer = send(app, b"/openapi.json")
    assert answer.status == 200
    told: dict[str, Any] = answer.json()
    return told


def parameters(schema: dict[str, Any], path: str) -> dict[str, dict[str, Any]]:
    return {p["name"]: p for p in schema["paths"][PREFIX + path]["get"]["parameters"]}


def bounds(parameter: dict[str, Any]) -> tuple[float, float]:
    """Minimum and maximum, of the number in a number-or-null too."""
    told = parameter["schema"]
    number = next((x for x in told.get("anyOf", []) if "minimum" in x), told)
    return number["minimum"], number["maximum"]


def test_title_version_and_conventions(schema: dict[str, Any]) -> None:
    assert schema["openapi"].startswith("3.1")
    assert schema["info"]["version"] == __version__
    assert "exp(-i w t)" in schema["info"]["description"]


@pytest.mark.parametrize("path", OUTPUTS)
def test_routes_are_described(schema: dict[str, Any], path: str) -> None:
    route = schema["paths"][PREFIX + path]["get"]
    assert route["summary"]
    assert route["tags"]
    body = route["responses"]["200"]["content"]["application/json"]["schema"]
    kinds = [OUTPUTS[path], *WITH_LAYERS.get(path, [])]
    told = [{"$ref": f"#/components/schemas/{kind.__name__}"} for kind in kinds]
    assert body.get("anyOf", [body]) == told
    assert MEDIA_TYPE in route["responses"]["4XX"]["content"]
    assert "422" not in route["responses"], "FastAPI's own error shape is never sent"


def test_schemas_have_names_of_their_own(schema: dict[str, Any]) -> None:
    """FastAPI puts the module before names that two models share."""
    assert [name for name in schema["components"]["schemas"] if "__" in name] == []


def test_errors_are_problems_on_every_route(schema: dict[str, Any]) -> None:
    for path, operations in schema["paths"].items():
        for operation in operations.values():
            for status in ("4XX", "5XX"):
                content = operation["responses"][status]["content"]
                reference = {"$ref": "#/components/schemas/Problem"}
                assert content == {MEDIA_TYPE: {"schema": reference}}, path
    problem = schema["components"]["schemas"]["Problem"]
    (one,) = [problem["properties"]["errors"]["items"]]
    assert one == {"$ref": "#/components/schemas/ParameterProblem"}
    shape = schema["components"]["schemas"]["ParameterProblem"]
    assert set(shape["required"]) == {"parameter", "value", "message"}


def test_routes_tell_of_304_and_of_csv_where_they_answer_so(
    app: FastAPI, schema: dict[str, Any]
) -> None:
    tables = 0
    for path, operations in schema["paths"].items():
        if "get" not in operations or not path.startswith(PREFIX):
            continue
        responses = operations["get"]["responses"]
        assert "content" not in responses["304"], path
        given = {p["name"]: p["schema"] for p in operations["get"].get("parameters", [])}
        as_csv = "csv" in given.get("format", {}).get("enum", [])
        assert ("text/csv" in responses["200"]["content"]) == as_csv, path
        tables += as_csv
        target = re.sub(r"\{material\}", "Au", path)
        answer = send(app, target.encode() + (b"?format=csv" if as_csv else b""))
        if as_csv and answer.status == 200:
            assert answer.headers["content-type"].startswith("text/csv")
    assert tables > 8


def test_operation_ids_differ(schema: dict[str, Any]) -> None:
    operations = [op for path in schema["paths"].values() for op in path.values()]
    assert all(set(path) <= {"get", "post"} for path in schema["paths"].values())
    ids = [operation["operationId"] for operation in operations]
    assert len(set(ids)) == len(ids)


def test_every_parameter_is_described(schema: dict[str, Any]) -> None:
    for path, operations in schema["paths"].items():
        for operation in operations.values():
            for parameter in operation.get("parameters", []):
                if parameter["in"] == "query":
                    assert parameter.get("description"), (path, parameter["name"])


@pytest.mark.parametrize(
    ("path", "declared"),
    [(path, p) for path in ("/snell", "/curves") for p in (N_I, N_T, K_T)]
    + [("/snell", THETA_I_DEG)],
    ids=lambda x: getattr(x, "name", x),
)
def test_declared_parameters_have_bounds_units_and_examples(
    schema: dict[str, Any], path: str, declared: Parameter
) -> None:
    shown = parameters(schema, path)[declared.name]
    assert shown["required"] is False
    assert shown["description"] == declared.description
    assert bounds(shown) == (declared.minimum, declared.maximum)
    assert shown["schema"]["default"] == declared.default
    assert shown["schema"]["unit"] == declared.unit
    assert shown["schema"]["symbol"] == declared.symbol
    (example,) = shown["schema"]["examples"]
    assert declared.minimum <= example <= declared.maximum


def test_bounds_of_the_contract(schema: dict[str, Any]) -> None:
    shown = parameters(schema, "/curves")
    assert bounds(shown["samples"]) == (2, 20001)
    assert shown["samples"]["schema"]["default"] == 181
    assert bounds(shown["digits"]) == (3, 17)
    assert shown["digits"]["schema"]["default"] == 17
    assert shown["format"]["schema"]["enum"] == ["json", "csv"]
    assert shown["landmarks"]["schema"]["default"] is False
    assert shown["models"]["schema"]["default"] == "exact"


@pytest.mark.parametrize("model_id", default_registry())
def test_every_model_is_named(schema: dict[str, Any], model_id: str) -> None:
    described = parameters(schema, "/curves")["models"]["description"]
    assert model_id in re.findall(r"[a-z0-9_]+", described)


@pytest.mark.parametrize(("model", "own"), OWN, ids=[f"{m.id}.{p.name}" for m, p in OWN])
def test_parameters_of_models(schema: dict[str, Any], model: Any, own: Parameter) -> None:
    shown = parameters(schema, "/curves")[f"{model.id}.{own.name}"]
    assert shown["description"].startswith(own.description)
    assert shown["required"] is False
    if own.choices:
        assert shown["schema"]["enum"] == [name for name, _ in own.choices]
    else:
        assert bounds(shown) == (own.minimum, own.maximum)
        assert shown["schema"].get("default") == own.default
    if own.triple:
        assert "string" in {kind["type"] for kind in shown["schema"]["anyOf"]}
        assert any("," in example for example in shown["schema"]["examples"])


@pytest.mark.parametrize(
    "output",
    [*OUTPUTS.values(), *chain.from_iterable(WITH_LAYERS.values()), InterfaceFacts, Amplitude],
)
def test_shapes_of_answers_are_in_the_schema(schema: dict[str, Any], output: type) -> None:
    shape = schema["components"]["schemas"][output.__name__]
    assert set(shape["properties"]) == {field.name for field in fields(output)}


@pytest.mark.parametrize("name", ["material", "incident", "generalized_schlick.F90"])
def test_examples_can_be_sent(schema: dict[str, Any], ask: Ask, name: str) -> None:
    examples = parameters(schema, "/curves")[name]["schema"]["examples"]
    assert examples
    own = {"models": "generalized_schlick"} if "." in name else {}
    for example in examples:
        assert ask("/curves", **own, **{name: example}).status_code == 200


def test_fields_of_answers_are_described(schema: dict[str, Any]) -> None:
    shown = schema["components"]["schemas"]["InterfaceFacts"]["properties"]
    assert shown["F0"]["description"] == "Reflectance at normal incidence."
    assert schema["components"]["schemas"]["Curve"]["properties"]["values"]["items"] == {
        "anyOf": [{"type": "number"}, {"type": "null"}]
    }


def test_nothing_of_the_program_itself_shows(app: FastAPI) -> None:
    text = send(app, b"/openapi.json").body
    for word in (b"WithModels", b"HTTPValidationError", b"app.optics", b".py"):
        assert word not in text


@pytest.mark.parametrize(("path", "array"), [("/models", "models"), ("/materials", "materials")])
def test_answers_of_chosen_fields_are_described(
    schema: dict[str, Any], path: str, array: str
) -> None:
    answers = schema["paths"][PREFIX + path]["get"]["responses"]["200"]["content"]
    name = answers["application/json"]["schema"]["$ref"].rpartition("/")[2]
    whole, chosen = schema["components"]["schemas"][name]["properties"][array]["items"]["anyOf"]
    assert "$ref" in whole
    assert chosen["type"] == "object"
    assert "required" not in chosen
