"""`/formulas`: what is registered, explained, with curves that anyone can take away."""

import math
from typing import Any

import pytest

from app.optics.albedo import FITS
from app.optics.conversions import TITLES
from app.optics.registry import default_registry
from tests.api.shape import Ask, error_of, json_of, rows_of


def listed(ask: Ask, **query: str) -> Any:
    return json_of(ask("/formulas", **query))["formulas"]


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
    rows = rows_of(ask("/formulas/conversion.ior/curve", **query))
    assert [row["n_t"] for row in rows] == ["1.0", "2.5", "4.0"]
    assert [row["F0"] for row in rows] == ["0.0", "0.1837", "0.36"]


@pytest.mark.parametrize("path", ["", "/curve"])
def test_an_unknown_formula_is_not_found(ask: Ask, path: str) -> None:
    error = error_of(ask(f"/formulas/model.schlik{path}"), 404)
    assert error["parameter"] == "formula_id"
    assert "model.schlick" in error["message"]


@pytest.mark.parametrize("n_i", [1e-3, 1.0, 100.0])
@pytest.mark.parametrize("n_t", [1e-3, 1.0, 100.0])
@pytest.mark.parametrize("k_t", [0.0, 1e-12, 100.0])
def test_corners_are_answered_or_refused(ask: Ask, n_i: float, n_t: float, k_t: float) -> None:
    numbers = {"n_i": n_i, "n_t": n_t, "k_t": k_t}
    for formula in listed(ask):
        query = {taken["name"]: numbers[taken["name"]] for taken in formula["takes"]}
        response = ask(f"/formulas/{formula['id']}/curve", **query, samples=5)
        assert response.status_code in (200, 422), (formula["id"], response.text)
