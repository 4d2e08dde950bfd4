"""`/curves`: quantities, samples, landmarks, digits, JSON and CSV."""

import csv
import io
from math import isclose
from typing import Any

import numpy as np
import pytest
from fastapi import FastAPI
from hypothesis import given
from hypothesis import strategies as st

from app.answers.interface import CONVENTION
from app.api.params import MAX_SAMPLES
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics import significant
from app.optics.numerics.significant import round_significant
from app.optics.registry import default_registry
from tests.api.raw import send
from tests.api.shape import Ask, check_shape, error_of, json_of
from tests.optics.reference.fresnel import fresnel

RELATIVE = 1e-12
REFERENCED = [
    {"n_i": 1.0, "n_t": 1.5, "k_t": 0.0},
    {"n_i": 1.5, "n_t": 1.0, "k_t": 0.0},
    {"n_i": 1.0, "n_t": 1.0 + 1e-9, "k_t": 0.0},
    {"n_i": 1.0, "n_t": 1e-3, "k_t": 0.0},
    {"n_i": 1.0, "n_t": 100.0, "k_t": 100.0},
    {"n_i": 1.33, "n_t": 0.2, "k_t": 3.0},
]


def curves(ask: Ask, **query: Any) -> Any:
    return json_of(ask("/curves", **query))


def table(ask: Ask, **query: Any) -> tuple[list[str], list[list[str]]]:
    """Header and rows of a CSV answer."""
    answer = ask("/curves", format="csv", **query)
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    assert "fresnel.csv" in answer.headers["content-disposition"]
    assert answer.text.endswith("\r\n")
    header, *rows = csv.reader(io.StringIO(answer.text))
    return header, rows


def by_name(told: dict[str, Any]) -> dict[str, list[float | None]]:
    return {f"{c['model']}.{c['quantity']}": c["values"] for c in told["curves"]}


@pytest.mark.parametrize("index", REFERENCED, ids=str)
def test_exact_curves_have_twelve_digits(ask: Ask, index: dict[str, float]) -> None:
    told = curves(ask, samples=31, landmarks="true", **index)
    values = by_name(told)
    for i, theta_i_deg in enumerate(told["theta_i_deg"]):
        expected = fresnel(index["n_i"], index["n_t"], index["k_t"], theta_i_deg)
        for name in ("R", "Rs", "Rp", "T"):
            value = values[f"exact.{name}"][i]
            assert value is not None
            # Within rounding of the critical angle itself T is a root of the last digit.
            smallest = 1e-7 if theta_i_deg == told["interface"]["critical_deg"] else 0.0
            assert isclose(value, getattr(expected, name), rel_tol=RELATIVE, abs_tol=smallest), (
                theta_i_deg,
                name,
            )


def test_nothing_given_is_the_exact_curve_of_glass(ask: Ask) -> None:
    told = curves(ask)
    assert told["theta_i_deg"] == np.linspace(0.0, 90.0, 181).tolist()
    assert [(c["model"], c["quantity"]) for c in told["curves"]] == [
        ("exact", "R"),
        ("exact", "Rs"),
        ("exact", "Rp"),
        ("exact", "T"),
    ]
    assert told["convention"] == CONVENTION
    assert told["interface"]["n_t"] == 1.5
    assert all(c["in_domain"] is True and c["reason"] is None for c in told["curves"])


def test_models_come_in_the_order_asked(ask: Ask) -> None:
    told = curves(ask, models="schlick,exact, cos_form", samples=5)
    ids = [c["model"] for c in told["curves"]]
    assert ids == ["schlick", "exact", "exact", "exact", "exact", "cos_form"]


@pytest.mark.parametrize("model_id", default_registry())
def test_every_model_answers_with_what_the_core_computes(ask: Ask, model_id: str) -> None:
    model = default_registry()[model_id]
    for n_i, n_t, k_t in ((1.0, 1.5, 0.0), (1.5, 1.0, 0.0), (1.0, 0.2, 3.0)):
        told = curves(ask, n_i=n_i, n_t=n_t, k_t=k_t, models=model_id, samples=7)
        interface = Interface(n_i, n_t, k_t)
        R = model(interface, Incidence.from_degrees(told["theta_i_deg"]))
        shown = told["curves"][0]
        assert shown["quantity"] == "R"
        assert shown["reason"] == model.reason_outside(interface)
        assert shown["in_domain"] is (shown["reason"] is None)
        assert shown["values"] == [None if np.isnan(value) else value for value in R.tolist()]


@pytest.mark.parametrize("samples", [2, 3, 7, 1000, MAX_SAMPLES])
def test_samples_are_equally_spaced_with_both_ends(ask: Ask, samples: int) -> None:
    theta = curves(ask, samples=samples)["theta_i_deg"]
    assert theta == np.linspace(0.0, 90.0, samples).tolist()
    assert (theta[0], theta[-1]) == (0.0, 90.0)


def test_a_long_curve_is_the_same_as_a_short_one(ask: Ask) -> None:
    """Beyond some length the work is handed to a thread."""
    long = by_name(curves(ask, samples=20001, models="exact,schlick"))
    short = by_name(curves(ask, samples=2001, models="exact,schlick"))
    for name, values in short.items():
        assert np.allclose(
            np.array(long[name][::10], float), np.array(values, float), rtol=1e-12, atol=1e-15
        )


@pytest.mark.parametrize(
    ("index", "landmarks"),
    [
        ({"n_t": 1.5}, ["brewster_deg"]),
        ({"n_i": 1.5, "n_t": 1.0}, ["brewster_deg", "critical_deg"]),
        ({"n_t": 0.2, "k_t": 3.0}, ["pseudo_brewster_deg", "principal_deg"]),
    ],
)
def test_landmarks_are_sorted_in(ask: Ask, index: dict[str, float], landmarks: list[str]) -> None:
    plain = curves(ask, samples=10, **index)
    marked = curves(ask, samples=10, landmarks="true", **index)
    extra = {plain["interface"][name] for name in landmarks}
    assert None not in extra
    assert marked["theta_i_deg"] == sorted({*plain["theta_i_deg"], *extra})
    Rp = dict(zip(marked["theta_i_deg"], by_name(marked)["exact.Rp"], strict=True))
    if "brewster_deg" in landmarks:
        assert Rp[plain["interface"]["brewster_deg"]] < 1e-28


def test_a_landmark_among_the_samples_is_not_repeated(ask: Ask) -> None:
    theta = curves(ask, n_t=1, samples=3, landmarks="true")["theta_i_deg"]
    assert theta == [0.0, 45.0, 90.0]


def test_phases(ask: Ask) -> None:
    told = by_name(curves(ask, n_t=1.5, samples=4, phase="true"))
    assert told["exact.phase_s_deg"] == [180.0] * 4
    assert told["exact.phase_p_deg"] == [0.0, 0.0, 180.0, 180.0]
    inside = by_name(curves(ask, n_i=1.5, n_t=1.0, samples=181, phase="true"))
    expected = fresnel(1.5, 1.0, 0.0, 60.0)
    assert inside["exact.phase_s_deg"][120] == pytest.approx(
        np.degrees(np.angle(expected.r_s)), rel=1e-12
    )
    assert inside["exact.phase_p_deg"][120] == pytest.approx(
        np.degrees(np.angle(expected.r_p)), rel=1e-12
    )


def test_refraction_is_null_where_there_is_none(ask: Ask) -> None:
    told = curves(ask, n_i=1.5, n_t=1.0, samples=10, refraction="true")
    values = by_name(told)
    beyond = np.array(told["theta_i_deg"]) > told["interface"]["critical_deg"]
    angle, depth = values["exact.theta_t_deg"], values["exact.penetration_depth_wavelengths"]
    assert [value is None for value in angle] == beyond.tolist()
    assert [value is None for value in depth] == (~beyond).tolist()
    field = values["exact.field_penetration_depth_wavelengths"]
    assert field == [value and pytest.approx(2.0 * value, rel=1e-15) for value in depth]
    metal = by_name(curves(ask, n_t=0.2, k_t=3.0, samples=10, refraction="true"))
    assert None not in metal["exact.theta_t_deg"]
    assert None not in metal["exact.penetration_depth_wavelengths"]


def test_a_form_is_null_where_it_is_undefined(ask: Ask) -> None:
    told = curves(ask, n_i=1.5, n_t=1.0, models="cos_form,lagarde_gc", samples=10)
    values = by_name(told)
    beyond = np.array(told["theta_i_deg"]) > told["interface"]["critical_deg"]
    assert [value is None for value in values["cos_form.R"]] == beyond.tolist()
    assert None not in values["lagarde_gc.R"]


def test_outside_its_domain_a_model_says_why_and_answers_still(ask: Ask) -> None:
    (inside,) = curves(ask, n_i=1.5, n_t=1.0, models="schlick", samples=3)["curves"]
    assert inside["in_domain"] is False
    assert "critical angle" in inside["reason"]
    assert None not in inside["values"]


def test_parameters_of_a_model(ask: Ask) -> None:
    query: dict[str, Any] = {"models": "lut_1d", "samples": 19}
    (default,) = curves(ask, **query)["curves"]
    (coarse,) = curves(ask, **query, **{"lut_1d.size": 4, "lut_1d.filtering": "nearest"})["curves"]
    assert default["values"] != coarse["values"]
    assert len(set(coarse["values"])) <= 4
    (same,) = curves(ask, **query, **{"lut_1d.size": 256})["curves"]
    assert same == default


def test_the_parameters_of_a_curve_are_told(ask: Ask) -> None:
    ends = {"generalized_schlick.F0": 0.02, "generalized_schlick.F90": "0.5,1,0.5"}
    told = curves(ask, models="exact,generalized_schlick", samples=2, **ends)["curves"]
    assert [c["parameters"] for c in told if c["model"] == "exact"] == [{}] * 4
    *_, green, blue = told
    assert green["parameters"] == {"F0": 0.02, "F90": 1.0, "exponent": 5.0, "a": 0.0}
    assert blue["parameters"] == {"F0": 0.02, "F90": 0.5, "exponent": 5.0, "a": 0.0}
    (solved,) = curves(ask, models="lazanyi2005", samples=2, k_t=5.0)["curves"]
    assert round(solved["parameters"]["alpha"], 4) == 7.7054


def test_a_triple_gives_three_curves(ask: Ask) -> None:
    gold = {"models": "hoffman_f82", "samples": 3, "hoffman_f82.F0": "1.0,0.766,0.336"}
    told = curves(ask, n_t=0.2, k_t=3.0, **gold)["curves"]
    assert [c["quantity"] for c in told] == ["R_red", "R_green", "R_blue"]
    assert [c["values"][0] for c in told] == [1.0, 0.766, 0.336]
    header, rows = table(ask, n_t=0.2, k_t=3.0, **gold)
    assert header[1:] == ["hoffman_f82.R_red", "hoffman_f82.R_green", "hoffman_f82.R_blue"]
    assert [float(cell) for cell in rows[0][1:]] == [1.0, 0.766, 0.336]


@pytest.mark.parametrize(
    "query",
    [
        {},
        {"n_i": 1.5, "n_t": 1.0, "models": "exact,cos_form,schlick", "refraction": "true"},
        {"n_t": 0.2, "k_t": 3.0, "phase": "true", "landmarks": "true", "digits": 5},
    ],
    ids=str,
)
def test_csv_holds_the_numbers_of_json(ask: Ask, query: dict[str, Any]) -> None:
    told = curves(ask, samples=19, **query)
    header, rows = table(ask, samples=19, **query)
    columns = {"theta_i_deg": told["theta_i_deg"]} | by_name(told)
    assert header == list(columns)
    for name, cells in zip(header, zip(*rows, strict=True), strict=True):
        assert [float(cell) if cell else None for cell in cells] == columns[name]


@pytest.mark.parametrize("digits", range(3, 18))
def test_digits(ask: Ask, digits: int) -> None:
    full, short = (
        curves(ask, n_t=1.37, samples=61),
        curves(ask, n_t=1.37, samples=61, digits=digits),
    )
    for name, values in by_name(full).items():
        for value, rounded in zip(values, by_name(short)[name], strict=True):
            assert value is not None
            assert rounded is not None
            assert_rounded(rounded, value, digits)


def assert_rounded(rounded: float, value: float, digits: int) -> None:
    """The double that at most so many digits spell, and one of the nearest such."""
    assert float(f"{rounded:.{digits}g}") == rounded
    unit = 10.0 ** (np.floor(np.log10(abs(value))) - digits + 1) if value else 0.0
    assert abs(rounded - value) <= 0.5 * unit * (1.0 + 1e-9) + abs(value) * 2e-16


magnitudes = st.floats(1e-300, 1e300) | st.floats(1e-12, 1e3)


@given(st.lists(magnitudes | magnitudes.map(lambda x: -x), min_size=1), st.integers(3, 16))
def test_rounding_is_to_the_spelled_decimal(numbers: list[float], digits: int) -> None:
    for rounded, value in zip(
        round_significant(np.array(numbers), digits).tolist(), numbers, strict=True
    ):
        assert_rounded(rounded, value, digits)


@pytest.mark.parametrize("digits", range(3, 17))
def test_rounding_is_that_of_formatting(digits: int) -> None:
    rng = np.random.default_rng(digits)
    random = rng.uniform(-1.0, 1.0, 20_000) * 10.0 ** rng.integers(-30, 30, 20_000)
    ties = (rng.integers(10 ** (digits - 1), 10**digits, 5_000) + 0.5) / 10.0 ** rng.integers(
        0, 9, 5_000
    )
    powers = 10.0 ** np.arange(-40.0, 40.0)
    near = [powers, np.nextafter(powers, 0.0), np.nextafter(powers, np.inf), powers * (1.0 - 1e-14)]
    values = np.concatenate([random, ties, *near])
    expected = [float(f"{value:.{digits}g}") for value in values.tolist()]
    assert round_significant(values, digits).tolist() == expected
    assert round_significant(values[0], digits) == expected[0]


@pytest.mark.parametrize("digits", range(3, 17))
def test_few_numbers_are_formatted_one_by_one(monkeypatch: pytest.MonkeyPatch, digits: int) -> None:
    """Of a large answer; at 16 digits those are that lie among the odd ones beyond 2^53."""
    asked: list[float] = []
    formatted = significant.formatted

    def counted(value: float, digits: int) -> float:
        asked.append(value)
        return formatted(value, digits)

    monkeypatch.setattr(significant, "formatted", counted)
    rng = np.random.default_rng(digits)
    values = np.concatenate([rng.uniform(0.0, 1.0, 32_768), rng.uniform(0.0, 1e6, 32_768)])
    rounded = round_significant(values, digits)
    assert len(asked) < (values.size // 16 if digits == 16 else 10)
    assert rounded.tolist() == [formatted(value, digits) for value in values.tolist()]


def test_rounding_leaves_alone_what_has_no_digits() -> None:
    rounded = round_significant(np.array([0.0, -0.0, np.nan, 1.0, np.inf, -np.inf]), 3)
    assert np.array_equal(rounded, [0.0, 0.0, np.nan, 1.0, np.inf, -np.inf], equal_nan=True)


@given(
    n_i=st.floats(1e-3, 100.0),
    n_t=st.floats(1e-3, 100.0),
    k_t=st.just(0.0) | st.floats(0.0, 100.0),
    samples=st.integers(2, 50),
    flags=st.sets(st.sampled_from(["landmarks", "phase", "refraction"])),
    digits=st.integers(3, 17),
    models=st.lists(st.sampled_from(list(default_registry())), min_size=1, max_size=4, unique=True),
)
def test_every_legal_query_is_answered(
    app: FastAPI,
    n_i: float,
    n_t: float,
    k_t: float,
    samples: int,
    flags: set[str],
    digits: int,
    models: list[str],
) -> None:
    query = f"n_i={n_i!r}&n_t={n_t!r}&k_t={k_t!r}&samples={samples}&digits={digits}"
    query += f"&models={','.join(models)}" + "".join(f"&{flag}=true" for flag in sorted(flags))
    answer = send(app, f"/api/v1/curves?{query}".encode())
    assert answer.status == 200, answer.body
    told = answer.json()
    check_shape(app, "/api/v1/curves", told)
    count = len(told["theta_i_deg"])
    assert samples <= count <= samples + 3 * ("landmarks" in flags)
    assert all(len(curve["values"]) == count for curve in told["curves"])
    assert {curve["model"] for curve in told["curves"]} == set(models)


def test_a_range_of_indices_is_a_band(ask: Ask) -> None:
    told = json_of(ask("/curves", material="garnet-wloka", band="true", samples=31))
    values = {curve["quantity"]: np.array(curve["values"]) for curve in told["curves"]}
    low, high = values["R_minimum"], values["R_maximum"]
    assert np.all(low <= values["R"])
    assert np.all(values["R"] <= high)
    ends = [
        np.array(json_of(ask("/curves", n_t=n, samples=31))["curves"][0]["values"])
        for n in (1.73, 1.89)
    ]
    np.testing.assert_allclose(low[:20], ends[0][:20], rtol=1e-12)
    np.testing.assert_allclose(high[:20], ends[1][:20], rtol=1e-12)
    assert np.all(low <= np.minimum(*ends) + 1e-15)
    error = error_of(ask("/curves", n_t=1.5, band="true"))
    assert error["parameter"] == "band"


def test_forms_tell_s_and_p_apart_where_asked(ask: Ask) -> None:
    query = {"models": "exact,cos_form,schlick", "samples": 19, "polarized": "true"}
    told = json_of(ask("/curves", **query))
    values = {(c["model"], c["quantity"]): np.array(c["values"]) for c in told["curves"]}
    of_form = [quantity for model, quantity in values if model == "cos_form"]
    assert of_form == ["R", "Rs", "Rp"]
    assert [quantity for model, quantity in values if model == "schlick"] == ["R"]
    for name in ("Rs", "Rp"):
        np.testing.assert_allclose(values["cos_form", name], values["exact", name], atol=1e-13)
