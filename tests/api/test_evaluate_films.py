"""Films in `POST /evaluate`: what `/snell` answers and refuses, for many at once."""

from typing import Any

import pytest
from fastapi import FastAPI

from app.optics.quantities import QUANTITIES
from tests.api.shape import Ask, json_of
from tests.api.test_evaluate import ARROW, Post, as_arrow, from_arrow, poster, results

SNELL = ("R", "Rs", "Rp", "T", "Ts", "Tp", "A", "As", "Ap", "psi_deg", "delta_deg", "theta_t_deg")
QUESTIONS: list[dict[str, Any]] = [
    {"layers": "MgF2:99.6", "material": "BK7", "wavelength_nm": 550, "theta_i_deg": 40},
    {"layers": "0.055+3.32i:30", "n_t": 1.52, "theta_i_deg": 60},
    {"layers": "Ag:30,1.38:100", "n_t": 1.52, "wavelength_nm": 500, "theta_i_deg": 10},
    {"layers": "1.0:100", "n_i": 1.5, "n_t": 1.5, "theta_i_deg": 41.810314895778596},
    {"n_t": 2.0, "k_t": 1.0, "theta_i_deg": 60},
]
WRONG: list[tuple[dict[str, Any], str]] = [
    ({"layers": "1.38"}, "layers"),
    ({"layers": "goldd:5"}, "layers"),
    ({"layers": "Ag:5", "wavelength_nm": 1.0}, "wavelength_nm"),
    ({"layers": "water-shirley:5", "wavelength_nm": 500}, "wavelength_nm"),
    ({"layers": "1.5+0.5i:5:incoherent"}, "layers"),
    ({"layers": "1.5:5", "model": "schlick"}, "model"),
    ({"layers": "1.5:5:incoherent", "quantity": "psi_deg"}, "layers"),
    ({"layers": "1.5:5", "material": "Au", "n_t": 2}, "n_t"),
    ({"wavelength_nm": 500}, "wavelength_nm"),
]


@pytest.fixture
def post(app: FastAPI) -> Post:
    return poster(app)


def expected(ask: Ask, question: dict[str, Any], quantity: str) -> float:
    told = json_of(ask("/snell", **question))
    return float(told.get(quantity, 0.0) or 0.0)


def test_each_item_is_answered_as_by_snell(ask: Ask, post: Post) -> None:
    items = [{**question, "quantity": name} for question in QUESTIONS for name in SNELL]
    found = results(post(items))
    for item, value in zip(items, found, strict=True):
        name = str(item.pop("quantity"))
        assert value == pytest.approx(expected(ask, item, name), rel=1e-12, abs=1e-14), (item, name)


def test_an_arrow_stream_is_answered_alike(post: Post) -> None:
    asked = [{**question, "quantity": name} for question in QUESTIONS for name in ("Rs", "A")]
    columns = {key for item in asked for key in item}
    table = as_arrow({key: [item.get(key) for item in asked] for key in sorted(columns)})
    values = from_arrow(post(table, ARROW)).column("value").to_pylist()
    assert values == pytest.approx(results(post(asked)), rel=1e-13)


def test_wavelengths_of_many_rows(ask: Ask, post: Post) -> None:
    items = [
        {"layers": "Ag:30,MgF2:100", "wavelength_nm": nm, "theta_i_deg": [0, 60], "material": "Al"}
        for nm in (400.0, 550.0, 700.0)
    ]
    for item, values in zip(items, results(post(items)), strict=True):
        for theta, value in zip((0, 60), values, strict=True):
            assert value == pytest.approx(expected(ask, item | {"theta_i_deg": theta}, "R"))


def test_a_wrong_item_keeps_no_other_from_its_answer(ask: Ask, post: Post) -> None:
    items = [item for wrong, _ in WRONG for item in (wrong, QUESTIONS[0])]
    found = results(post(items))
    right = expected(ask, QUESTIONS[0], "R")
    for place, (wrong, name) in enumerate(WRONG):
        (error,) = found[2 * place]["errors"]
        assert error["parameter"] == name, wrong
        assert found[2 * place + 1] == pytest.approx(right, rel=1e-13)


@pytest.mark.parametrize(("wrong", "name"), WRONG[:5])
def test_what_snell_refuses_is_refused_in_its_words(
    ask: Ask, post: Post, wrong: dict[str, Any], name: str
) -> None:
    (told,) = ask("/snell", **wrong).json()["errors"]
    (error,) = results(post([wrong]))[0]["errors"]
    assert (error["parameter"], error["message"]) == (name, told["message"])


def test_every_quantity_has_its_answer_with_layers(post: Post) -> None:
    asked = [{"layers": "Ag:30", "theta_i_deg": 30, "quantity": name} for name in QUANTITIES]
    found = results(post(asked))
    depths = {name for name in QUANTITIES if "penetration" in name}
    assert {n for n, v in zip(QUANTITIES, found, strict=True) if v is None} == depths


def test_rs_and_rp_of_the_conductor_form_of_air(post: Post) -> None:
    item = {"n_t": 0.27, "k_t": 2.9, "theta_i_deg": 60, "model": "pharr_humphreys"}
    R, Rs, Rp, T = results(post([item | {"quantity": name} for name in ("R", "Rs", "Rp", "T")]))
    assert pytest.approx(0.5 * (Rs + Rp), rel=1e-14) == R
    assert Rs > Rp
    assert "has R, Rs and Rp alone" in T["errors"][0]["message"]
