"""What the contract fixes and a review found missing: CORS, failures, OpenAPI of tables."""

import asyncio
from collections.abc import Callable
from typing import Any

import httpx
import pytest
from fastapi import FastAPI

from app.main import create_app

Ask = Callable[..., httpx.Response]
ORIGIN = {"Origin": "https://elsewhere.example"}


def send(app: FastAPI, method: str, path: str, headers: dict[str, str]) -> httpx.Response:
    async def request() -> httpx.Response:
        transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
            return await client.request(method, path, headers=headers)

    return asyncio.run(request())


@pytest.mark.parametrize("method", ["GET", "HEAD"])
def test_a_page_elsewhere_may_revalidate(app: FastAPI, method: str) -> None:
    wanted = {
        "Access-Control-Request-Method": method,
        "Access-Control-Request-Headers": "if-none-match",
    }
    allowed = send(app, "OPTIONS", "/api/v1/snell", ORIGIN | wanted)
    assert allowed.status_code == 200
    assert allowed.headers["access-control-allow-origin"] == "*"
    assert "If-None-Match" in allowed.headers["access-control-allow-headers"]


def test_a_page_elsewhere_can_read_that_the_server_failed() -> None:
    app = create_app()

    async def crash() -> None:
        raise RuntimeError("secret")

    app.router.add_api_route("/crash", crash)
    app.router.routes.insert(0, app.router.routes.pop())
    answer = send(app, "GET", "/crash", ORIGIN)
    assert answer.status_code == 500
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.headers["access-control-allow-origin"] == "*"
    assert "secret" not in answer.text


def test_openapi_tells_of_csv(app: FastAPI) -> None:
    content = app.openapi()["paths"]["/api/v1/curves"]["get"]["responses"]["200"]["content"]
    assert set(content) == {"application/json", "text/csv"}
    assert content["application/json"]["schema"] == {"$ref": "#/components/schemas/Curves"}


@pytest.mark.parametrize("name", ["material", "incident"])
def test_the_examples_of_presets_can_be_sent(app: FastAPI, ask: Ask, name: str) -> None:
    declared: list[dict[str, Any]] = app.openapi()["paths"]["/api/v1/curves"]["get"]["parameters"]
    (examples,) = (p["schema"]["examples"] for p in declared if p["name"] == name)
    assert examples
    for example in examples:
        assert ask("/curves", **{name: example}).status_code == 200


def test_openapi_bounds_what_may_differ_in_r_g_and_b(app: FastAPI, ask: Ask) -> None:
    declared: list[dict[str, Any]] = app.openapi()["paths"]["/api/v1/curves"]["get"]["parameters"]
    name = "generalized_schlick.F90"
    (schema,) = (p["schema"] for p in declared if p["name"] == name)
    one, three = schema["anyOf"]
    assert (one["minimum"], one["maximum"], schema["default"]) == (0.0, 1.0, 1.0)
    assert three["type"] == "string"
    for example in schema["examples"]:
        answer = ask("/curves", models="generalized_schlick", **{name: example})
        assert answer.status_code == 200


@pytest.mark.parametrize(
    "value", ["", "a", "1,2", "0.1,,0.3", "0.1,0.2,0.3,0.4", "0_1", "0_1,0.2,0.3"]
)
def test_what_is_no_triple_is_one_error(ask: Ask, value: str) -> None:
    name = "generalized_schlick.F0"
    (error,) = ask("/curves", models="generalized_schlick", **{name: value}).json()["errors"]
    assert error == {
        "parameter": name,
        "value": value,
        "message": "one number, or three separated by commas",
    }


@pytest.mark.parametrize("value", ["nan", "2", "0.1,0.2,inf", "0.1,-0.1,0.3"])
def test_a_triple_out_of_bounds_names_them(ask: Ask, value: str) -> None:
    name = "generalized_schlick.F0"
    (error,) = ask("/curves", models="generalized_schlick", **{name: value}).json()["errors"]
    assert error["parameter"] == name
    assert error["message"] == "a finite number from 0 to 1"


def test_what_is_no_number_is_said_plainly(ask: Ask) -> None:
    (error,) = ask("/snell", n_t="1_5").json()["errors"]
    assert error["message"] == "a number has no underscore; allowed: 0.001 to 100.0"
    (error,) = ask("/convert", **{"from": "f0", "F0": "1,0_1,0"}).json()["errors"]
    assert error["message"].startswith("a number has no underscore")
    for text in ("1.5;n_i=2", "n_t", "_", "1,n_i,2"):
        for target, given in (("/snell", {"n_t": text}), ("/convert", {"from": "f0", "F0": text})):
            for error in ask(target, **given).json()["errors"]:
                assert "underscore" not in error["message"]
