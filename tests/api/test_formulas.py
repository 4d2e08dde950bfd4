"""`/formulas`: what is registered, explained, with curves that anyone can take away."""

import csv
import io
import math
from collections.abc import Callable
from typing import Any

import httpx
import pytest

from app.optics.albedo import FITS
from app.optics.conversions import TITLES
from app.optics.registry import default_registry

Ask = Callable[..., httpx.Response]


def listed(ask: Ask, **query: str) -> list[dict[str, Any]]:
    response = ask("/formulas", **query)
    assert response.status_code == 200
    formulas: list[dict[str, Any]] = response.json()["formulas"]
    return formulas


def test_lists_everything_that_is_registered(ask: Ask) -> None:
    ids = [formula["id"] for formula in listed(ask)]
    expected = [f"model.{name}" for name in default_registry()]
    expected += [f"albedo.{name}" for name in FITS]
    expected += [f"conversion.{name}" for name in TITLES]
    assert set(expected) <= set(ids)
    assert len(set(ids)) == len(ids)


def test_lists_one_kind(ask: Ask) -> None:
    everything = listed(ask)
    for kind in ("model", "albedo", "angle", "conversion"):
        assert listed(ask, kind=kind) == [f for f in everything if f["kind"] == kind]
    response = ask("/formulas", kind="theorem")
    assert response.status_code == 422
    assert response.json()["errors"][0]["parameter"] == "kind"


def test_one_formula_is_what_the_list_says(ask: Ask) -> None:
    for formula in listed(ask):
        assert ask(f"/formulas/{formula['id']}").json() == formula


def test_says_where_a_formula_comes_from_and_what_its_letters_mean(ask: Ask) -> None:
    schlick = ask("/formulas/model.schlick").json()
    assert schlick["links"] == ["https://doi.org/10.1111/1467-8659.1330233"]
    assert [s["latex"] for s in schlick["symbols"]] == ["R", "F_0", r"\mu"]
    assert {m["value"] for m in schlick["measured"]} >= {0.0357}
    assert [taken["name"] for taken in schlick["takes"]] == ["n_i", "n_t", "k_t"]


def test_the_curve_of_snells_law(ask: Ask) -> None:
    answer = ask("/formulas/angle.refraction/curve", n_t=1.333).json()
    assert answer["x"]["name"] == "theta_i_deg"
    (series,) = answer["series"]
    for theta_i, theta_t in zip(answer["at"], series["values"], strict=True):
        expected = math.degrees(math.asin(math.sin(math.radians(theta_i)) / 1.333))
        assert theta_t == pytest.approx(expected, abs=1e-12)


def test_curves_as_csv(ask: Ask) -> None:
    query = {"format": "csv", "samples": 3, "digits": 4}
    response = ask("/formulas/conversion.ior/curve", **query)
    assert response.headers["content-type"].startswith("text/csv")
    rows = list(csv.DictReader(io.StringIO(response.text)))
    assert [row["n_t"] for row in rows] == ["1.0", "2.5", "4.0"]
    assert [row["F0"] for row in rows] == ["0.0", "0.1837", "0.36"]


@pytest.mark.parametrize("path", ["", "/curve"])
def test_an_unknown_formula_is_not_found(ask: Ask, path: str) -> None:
    response = ask(f"/formulas/model.schlik{path}")
    assert response.status_code == 404
    (error,) = response.json()["errors"]
    assert error["parameter"] == "formula_id"
    assert "model.schlick" in error["message"]


@pytest.mark.parametrize(
    ("formula", "query", "parameter"),
    [
        ("angle.brewster", {"n_t": "3"}, "n_t"),
        ("albedo.deon_2019_log", {"k_t": "1"}, "k_t"),
        ("model.schlick", {"samples": "1"}, "samples"),
        ("model.schlick", {"samples": "2002"}, "samples"),
        ("model.schlick", {"n_t": "0"}, "n_t"),
        ("model.schlick", {"n_t": "nan"}, "n_t"),
        ("model.schlick", {"theta": "3"}, "theta"),
    ],
)
def test_refuses_what_a_curve_does_not_take(
    ask: Ask, formula: str, query: dict[str, str], parameter: str
) -> None:
    response = ask(f"/formulas/{formula}/curve", **query)
    assert response.status_code == 422
    assert [e["parameter"] for e in response.json()["errors"]] == [parameter]


@pytest.mark.parametrize("n_i", [1e-3, 1.0, 100.0])
@pytest.mark.parametrize("n_t", [1e-3, 1.0, 100.0])
@pytest.mark.parametrize("k_t", [0.0, 1e-12, 100.0])
def test_corners_are_answered_or_refused(ask: Ask, n_i: float, n_t: float, k_t: float) -> None:
    numbers = {"n_i": n_i, "n_t": n_t, "k_t": k_t}
    for formula in listed(ask):
        query = {taken["name"]: numbers[taken["name"]] for taken in formula["takes"]}
        response = ask(f"/formulas/{formula['id']}/curve", **query, samples=5)
        assert response.status_code in (200, 422), (formula["id"], response.text)
