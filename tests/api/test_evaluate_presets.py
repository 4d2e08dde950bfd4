"""Presets in `POST /evaluate`: what `/snell` answers and refuses, for many at once."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from fastapi import FastAPI

from app.batch.evaluation import evaluate
from app.batch.rows import Hints, Names, Rows
from app.materials.media import (
    NEGLIGIBLE_K,
    constants_at,
    default_catalog,
    resolve_incident,
    resolve_material,
)
from app.optics.errors import OpticsError
from app.optics.registry import default_registry
from tests.api.shape import Ask, error_of, rows_of
from tests.api.test_evaluate import ARROW, Post, as_arrow, from_arrow, poster, results
from tests.optics.reference.fresnel import fresnel

CATALOG = default_catalog()
WAVELENGTHS_NM = (None, 1.0, 299.9, 300.0, 430.5, 587.6, 589.0, 1064.0, 24_930.0, 1e6, 1e7)


@pytest.fixture
def post(app: FastAPI) -> Post:
    return poster(app)


QUESTIONS: list[dict[str, Any]] = [
    {"material": "Au", "theta_i_deg": 60},
    {"material": "gold", "wavelength_nm": 430.5, "theta_i_deg": 45},
    {"material": "Cu", "incident": "water", "wavelength_nm": 650, "theta_i_deg": 30},
    {"incident": "BK7", "n_t": 1.0, "theta_i_deg": 35},
    {"incident": "vacuum-shirley", "material": "BK7", "wavelength_nm": 400, "theta_i_deg": 10},
    {"material": "water-shirley", "n_i": 1.2, "theta_i_deg": 50},
    {"material": "diamond", "theta_i_deg": 70},
    {"material": " au ", "theta_i_deg": 80},
]

WRONG: list[dict[str, Any]] = [
    {"material": "Au", "n_t": 1.5},
    {"material": "Au", "k_t": 0},
    {"incident": "water", "n_i": 1},
    {"incident": "watr"},
    {"incident": "Au"},
    {"incident": "Au", "wavelength_nm": 500},
    {"wavelength_nm": 500},
    {"material": "Au", "wavelength_nm": 299.9},
    {"material": "Au", "wavelength_nm": 1e6},
    {"material": "Au", "wavelength_nm": 24930},
    {"incident": "water-shirley", "wavelength_nm": 500},
    {"material": "ice-wloka", "wavelength_nm": 500},
    {"material": "aurun"},
]


def test_the_same_as_for_one_ray(post: Post, ask: Ask) -> None:
    items = [item | {"quantity": q} for item in QUESTIONS for q in ("R", "Rs", "Rp", "T")]
    found = results(post(items))
    for number, item in enumerate(QUESTIONS):
        ray = ask("/snell", **item).json()
        expected = [ray[name] for name in ("R", "Rs", "Rp", "T")]
        np.testing.assert_allclose(found[4 * number : 4 * number + 4], expected, rtol=1e-13)


def test_the_numbers_of_the_source_by_thirty_digits(post: Post) -> None:
    """Gold at 430.5 nm lies between rows of the table, water is a formula."""
    file = CATALOG.spectrum("Au").file
    assert file.k is not None
    at = 430.5
    tables = {name: getattr(file, name) for name in ("n", "k")}
    n, k = (np.interp(at, t.wavelength_nm, t.values) for t in tables.values())
    (found,) = results(post([{"material": "Au", "wavelength_nm": at, "theta_i_deg": [0, 60, 89]}]))
    expected = [float(fresnel(1.0, n, k, theta).R) for theta in (0.0, 60.0, 89.0)]
    np.testing.assert_allclose(found, expected, rtol=1e-12)


@pytest.mark.parametrize("item", WRONG, ids=str)
def test_what_is_refused_of_one_ray_is_wrong_with_the_item(
    post: Post, ask: Ask, item: dict[str, Any]
) -> None:
    (one,) = ask("/snell", **item).json()["errors"]
    good = {"material": "Au"}
    before, answered, after = results(post([good, item, good]))
    assert before == after == pytest.approx(ask("/snell", material="Au").json()["R"])
    assert answered["index"] == 1
    (error,) = answered["errors"]
    assert (error["parameter"], error["message"]) == (one["parameter"], one["message"])
    assert error["value"] == item.get(error["parameter"])


@pytest.mark.parametrize(
    ("item", "parameter", "hint"),
    [
        ({"material": "Au", "wavelength_nm": 0}, "wavelength_nm", "above 0, up to 1e+07 nm"),
        ({"material": "vacuum-shirley", "wavelength_nm": 2e7}, "wavelength_nm", "up to 1e+07"),
        ({"material": ""}, "material", "id or an alias"),
        ({"material": "x" * 10_000}, "material", "id or an alias"),
        ({"material": None}, "material", "str"),
        ({"material": 5}, "material", "str"),
        ({"wavelength_nm": "red"}, "wavelength_nm", "float"),
        ({"materiel": "Au"}, "materiel", "material"),
        ({"model": "schlick", "schlick.F0": [1, 0.7, 0.3]}, "schlick.F0", "/curves"),
    ],
    ids=str,
)
def test_what_is_no_preset(post: Post, item: dict[str, Any], parameter: str, hint: str) -> None:
    (answered,) = results(post([item]))
    (error,) = answered["errors"]
    assert error["parameter"] == parameter
    assert hint in error["message"]
    assert len(json.dumps(error)) < 1000


@pytest.mark.parametrize("preset", CATALOG.presets, ids=lambda preset: preset.id)
def test_many_wavelengths_by_the_rules_of_one(preset: Any) -> None:
    many = np.array([np.nan if at is None else at for at in WAVELENGTHS_NM])
    for at, n, k in zip(WAVELENGTHS_NM, *constants_at(preset, many), strict=True):
        error = refusal(resolve_material, preset.id, at)
        if error is None:
            one = resolve_material(preset.id, at)
            assert n == pytest.approx(one.constants.n_absolute, rel=1e-14)
            assert np.isnan(k) if one.constants.k is None else k == pytest.approx(one.constants.k)
            assert one.k_t == pytest.approx(k if k >= NEGLIGIBLE_K else 0.0, rel=1e-14)
        else:
            assert np.isnan(n) == (error.allowed.find("here it is") < 0)


@pytest.mark.parametrize("side", ["material", "incident"])
@pytest.mark.parametrize("id", ["Au", "Ag", "BK7", "water", "diamond", "ice-wloka", "Si"])
def test_rows_are_refused_as_one_is(side: str, id: str) -> None:  # noqa: A002
    """In one call, so that the words found for one wavelength may serve others."""
    rng = np.random.default_rng(3)
    at = np.concatenate([10.0 ** rng.uniform(1.0, 6.0, 200), [np.nan, np.nan, 587.6]])
    names = {side: Names(np.zeros(at.size, np.intp), [id])}
    outcome = evaluate(Rows(at.size, {"wavelength_nm": at}, names), default_registry())
    resolve = resolve_material if side == "material" else resolve_incident
    for row, wavelength_nm in enumerate(at.tolist()):
        error = refusal(resolve, id, None if np.isnan(wavelength_nm) else wavelength_nm)
        if error is None:
            assert row not in outcome.faults
            assert np.isfinite(outcome.values[row])
        else:
            expected = side if error.parameter == "material" else error.parameter
            assert outcome.faults[row].parameter == expected
            assert outcome.faults[row].message == error.allowed


@pytest.mark.parametrize(
    ("side", "id", "nm"),
    [("incident", "Au", 400), ("material", "Au", 1e6), ("material", "Si", 150)],
)
def test_what_is_refused_is_looked_into_once_a_cause(
    monkeypatch: pytest.MonkeyPatch,
    side: str,
    id: str,  # noqa: A002
    nm: float,
) -> None:
    """An error raised a row takes so long that a full body runs into the time limit."""
    raised, init = [], OpticsError.__init__

    def counted(error: OpticsError, *args: Any) -> None:
        raised.append(error)
        init(error, *args)

    monkeypatch.setattr(OpticsError, "__init__", counted)
    at = np.linspace(nm, 1.1 * nm, 1000)
    names = {side: Names(np.zeros(at.size, np.intp), [id])}
    outcome = evaluate(Rows(at.size, {"wavelength_nm": at}, names), default_registry())
    assert len(outcome.faults) == at.size
    assert len(raised) <= 1


def refusal(resolve: Callable[..., Any], name: str, at: float | None) -> OpticsError | None:
    try:
        resolve(name, at)
    except OpticsError as error:
        return error
    return None


@pytest.mark.parametrize("encoded", [False, True])
def test_columns_of_an_arrow_stream(post: Post, ask: Ask, encoded: bool) -> None:
    materials = pa.array(["Au", None, "Cu", "nope", "Au"] * 1000)
    incident = pa.array([None, "water", "water", None, "Au"] * 1000)
    if encoded:
        materials, incident = materials.dictionary_encode(), incident.dictionary_encode()
    columns = {
        "material": materials,
        "incident": incident,
        "wavelength_nm": pa.array([500.0, 500.0, None, 500.0, 500.0] * 1000),
        "theta_i_deg": pa.array(np.linspace(0.0, 90.0, 5000)),
        "n_t": pa.array([None, 2.0, None, None, None] * 1000, pa.float64()),
    }
    table = from_arrow(post(as_arrow(columns), ARROW))
    values, errors = table["value"].to_pylist(), table["error"].to_pylist()
    for row in (0, 1, 2, 2500, 2501, 4997):
        given = {name: column[row].as_py() for name, column in columns.items()}
        told = {name: value for name, value in given.items() if value is not None}
        assert values[row] == pytest.approx(ask("/snell", **told).json()["R"], rel=1e-12)
        assert errors[row] is None
    assert values[3::5] == values[4::5] == [None] * 1000
    assert set(errors[3:250:5]) == {errors[3]}  # the first hundred, told in full
    assert errors[3].startswith("material = nope: the id or an alias of a material")
    assert errors[4].startswith("incident = Au: a transparent medium")


def test_three_numbers_in_a_column(post: Post) -> None:
    columns = {"schlick.F0": pa.array([[1.0, 0.7, 0.3]])}
    assert "/curves" in error_of(post(as_arrow(columns), ARROW))["message"]


@pytest.mark.parametrize("column", ["model", "material", "odd"])
def test_what_a_name_may_have_meant_is_looked_for_a_few_times_alone(
    post: Post, column: str
) -> None:
    items = [{("odd" + str(i) if column == "odd" else column): f"au{i}x"} for i in range(100)]
    messages = [answered["errors"][0]["message"] for answered in results(post(items))]
    assert sum("unknown; the nearest" in message for message in messages) == 100 - Hints.MOST
    again = [items[0]] * 100
    (message,) = {answered["errors"][0]["message"] for answered in results(post(again))}
    assert message == messages[0]


@pytest.mark.parametrize("kind", ["application/json", "text/csv", ARROW])
def test_digits(post: Post, kind: str) -> None:
    items = [{"n_t": 1.7, "theta_i_deg": 55}]
    exact = float(fresnel(1.0, 1.7, 0.0, 55.0).R)
    response = post(items, accept=kind, query="digits=4")
    if kind == ARROW:
        (value,) = from_arrow(response)["value"].to_pylist()
    elif kind == "text/csv":
        (row,) = rows_of(response)
        value = float(row["value"])
    else:
        (value,) = results(response)
    assert value == float(f"{exact:.4g}") != exact
    assert error_of(post(items, accept=kind, query="digits=2"))["parameter"] == "digits"
