"""`POST /materials/read`, and its ids wherever a preset's stand."""

import asyncio
import json
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest
from fastapi import FastAPI

from tests.api.shape import Ask, error_of
from tests.optics.reference.fresnel import fresnel

FILES = Path(__file__).parents[1] / "materials/reading/files"
X = np.linspace(380.0, 780.0, 200)
N = 1.8 + 0.4 * np.sin(X / 60.0)
K = 1.0 + 0.5 * np.cos(X / 45.0)
ROWS = "\n".join(
    f"{x!r},{n!r},{k!r}" for x, n, k in zip(*map(np.ndarray.tolist, (X, N, K)), strict=True)
)


def post(app: FastAPI, query: str = "", **given: Any) -> httpx.Response:
    async def request() -> httpx.Response:
        transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
            return await client.post(f"/api/v1/materials/read{query}", **given)

    return asyncio.run(request())


def of(*names: str) -> list[tuple[str, tuple[str, bytes]]]:
    return [("file", (name, (FILES / name).read_bytes())) for name in names]


PLAIN = {"content-type": "text/plain; charset=utf-8"}


@pytest.fixture(scope="module")
def read(app: FastAPI) -> dict[str, Any]:
    answer = post(app, "?name=film+7", content="nm,n,k\n" + ROWS, headers=PLAIN)
    assert answer.status_code == 200
    told: dict[str, Any] = answer.json()
    return told


def test_the_answer_says_how_it_was_read(app: FastAPI) -> None:
    answer = post(app, files=of("other-sign.csv"))
    assert answer.headers["cache-control"] == "no-store"
    told = answer.json()
    assert told["name"] == "other-sign"
    assert told["report"]["sign"] == "n-ik"
    assert {one["what"]: one["value"] for one in told["report"]["assumed"]}["sign"] == "n-ik"
    assert told["spectrum"] == {
        "wavelength_nm": [400.0, 500.0],
        "n": [0.17, 0.13],
        "k": [1.95, 2.9],
    }
    flipped = post(app, "?sign=n%2Bik", files=of("other-sign.csv")).json()
    assert flipped["spectrum"]["k"] is None


def test_two_files_are_one_material(app: FastAPI) -> None:
    told = post(app, files=of("Xx.k.spd", "Xx.eta.spd")).json()
    assert told["report"]["format"] == "spd"
    assert (told["report"]["n_range_nm"], told["spectrum"]["k"][1]) == ([298.757, 885.6], 1.95)


def test_an_id_of_200_points_answers_to_1e_5_everywhere(ask: Ask, read: dict[str, Any]) -> None:
    own = read["material"]
    assert len(own) < 12_000
    at = 555.5
    n, k = (float(np.interp(at, X, values)) for values in (N, K))
    for path in ("/snell", "/curves", "/errors"):
        interface = ask(path, material=own, wavelength_nm=at).json()["interface"]
        assert interface["n_t"] == pytest.approx(n, abs=1e-5)
        assert interface["k_t"] == pytest.approx(k, abs=1e-5)
        assert interface["material"]["id"] == own
        assert interface["material"]["name"] == "film 7"
    snell = ask("/snell", material=own, wavelength_nm=at, theta_i_deg=60).json()
    assert snell["R"] == pytest.approx(float(fresnel(1.0, n, k, 60.0).R), abs=1e-5)
    spectrum = ask(f"/materials/{own}/spectrum", step_nm=10).json()
    assert spectrum["n"] == pytest.approx(np.interp(spectrum["wavelength_nm"], X, N), abs=1e-5)
    assert spectrum["k"] == pytest.approx(np.interp(spectrum["wavelength_nm"], X, K), abs=1e-5)
    for path in (f"/materials/{own}", f"/materials/{own}/curves", f"/materials/{own}/map"):
        assert ask(path).status_code == 200
    assert ask("/lut", material=own, channels=3, size=8).status_code == 200
    assert ask("/figures/material", material=own).status_code == 200
    assert ask("/recommend", material=own, max_error=0.1).status_code == 200
    table = ask(f"/materials/{own}/spectrum", format="csv")
    assert 'filename="own-film-7_spectrum.csv"' in table.headers["content-disposition"]


def test_evaluate_takes_it(app: FastAPI, read: dict[str, Any]) -> None:
    async def request() -> httpx.Response:
        transport = httpx.ASGITransport(app=app)
        async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
            items = [
                {"material": read["material"], "wavelength_nm": 500, "theta_i_deg": 45},
                {"material": read["material"][:-3], "theta_i_deg": 45},
            ]
            return await client.post("/api/v1/evaluate", json={"items": items})

    right, wrong = asyncio.run(request()).json()["results"]
    n, k = (float(np.interp(500.0, X, values)) for values in (N, K))
    assert right == pytest.approx(float(fresnel(1.0, n, k, 45.0).R), abs=1e-5)
    assert "cut or changed" in wrong["errors"][0]["message"]


def test_a_clear_one_stands_in_front(ask: Ask, app: FastAPI) -> None:
    own = post(app, content="nm,n\n400,1.34\n700,1.33\n", headers=PLAIN).json()["material"]
    interface = ask("/snell", incident=own, n_t=1.5, wavelength_nm=550).json()["interface"]
    assert interface["n_i"] == pytest.approx(1.335, abs=1e-5)


@pytest.mark.parametrize(
    ("path", "parameter", "status"),
    [("/snell?material=", "material", 422), ("/materials/", "material", 404)],
)
def test_a_broken_id_is_a_problem_that_says_so(
    ask: Ask, read: dict[str, Any], path: str, parameter: str, status: int
) -> None:
    answer = ask(path + read["material"][:-5])
    assert answer.status_code == status
    error = answer.json()["errors"][0]
    assert error["parameter"] == parameter
    assert "cut or changed" in error["message"]


def test_outside_its_range_it_names_the_range_and_not_the_data(
    ask: Ask, read: dict[str, Any]
) -> None:
    error = error_of(ask("/snell", material=read["material"], wavelength_nm=900))
    assert error["message"] == "380 to 780 nm, where n of own-film-7 is known"


@pytest.mark.parametrize(
    ("name", "parameter"),
    [
        ("headerless-um-or-ev.txt", "unit"),
        ("two-glasses.agf", "glass"),
        ("either-sign.csv", "sign"),
    ],
)
def test_what_cannot_be_decided_names_the_parameter_that_decides(
    app: FastAPI, name: str, parameter: str
) -> None:
    answer = post(app, files=of(name))
    assert answer.status_code == 422
    (error,) = answer.json()["errors"]
    assert error["parameter"] == parameter
    assert answer.json()["detail"].startswith(f"{parameter}: ")  # no value was given


@pytest.mark.parametrize(
    ("query", "given", "status", "words"),
    [
        (
            "",
            {"content": b"{}", "headers": {"content-type": "application/json"}},
            415,
            "text/plain",
        ),
        ("", {"content": b"", "headers": PLAIN}, 422, "not empty"),
        ("", {"content": b"x" * 5_000_000, "headers": PLAIN}, 413, "2,000,000"),
        ("", {"files": [("other", ("a.csv", b"nm,n\n1,2"))]}, 400, "field `file`"),
        ("", {"files": [("file", ("a.csv", b"1 2"))] * 3}, 400, "Too many files"),
        (
            "",
            {"content": b"--x\r\n", "headers": {"content-type": "multipart/form-data"}},
            400,
            "boundary",
        ),
        ("?unit=furlong", {"content": b"1 2", "headers": PLAIN}, 422, "nm"),
        ("?units=nm", {"content": b"1 2", "headers": PLAIN}, 422, "nearest: unit"),
        ("?format=tabel", {"content": b"1 2", "headers": PLAIN}, 422, "nearest: table"),
    ],
)
def test_what_is_wrong_is_a_problem(
    app: FastAPI, query: str, given: dict[str, Any], status: int, words: str
) -> None:
    answer = post(app, query, **given)
    assert answer.status_code == status
    assert answer.headers["content-type"] == "application/problem+json"
    assert words in json.dumps(answer.json())


def test_the_answer_is_as_openapi_tells(app: FastAPI, read: dict[str, Any]) -> None:
    operation = app.openapi()["paths"]["/api/v1/materials/read"]["post"]
    schema = operation["responses"]["200"]["content"]["application/json"]["schema"]
    properties = app.openapi()["components"]["schemas"][schema["$ref"].rpartition("/")[2]]
    assert set(properties["properties"]) == set(read)
    assert set(operation["requestBody"]["content"]) == {"multipart/form-data", "text/plain"}
    assert {p["name"] for p in operation["parameters"]} >= {"format", "unit", "columns", "sign"}


def test_a_catalog_s_glass_is_relative_to_air(ask: Ask, app: FastAPI) -> None:
    """N-BK7's coefficients from a glass catalog: n_d = 1.5168 in air, 0.0421646 of it reflected."""
    text = (FILES / "two-glasses.agf").read_bytes().split(b"IT ")[0]
    told = post(app, files=[("file", ("glass.agf", text))]).json()
    assert told["report"]["relative_to"] == "air"
    in_air = ask("/snell", material=told["material"], incident="air", wavelength_nm=587.5618).json()
    assert in_air["interface"]["F0"] == pytest.approx(0.0421646, abs=5e-8)
    from_vacuum = ask("/snell", material=told["material"], wavelength_nm=587.5618).json()
    assert from_vacuum["interface"]["F0"] == pytest.approx(0.0422179, abs=2e-6)
    assert from_vacuum["interface"]["material"]["relative_to"] == "air"
