"""The routes about errors: numbers, shapes, refusals."""

from typing import Any

import numpy as np
import pytest

from app.optics.interface import Interface
from app.optics.metrics import METRICS, measure
from app.optics.registry import default_registry
from tests.api.shape import Ask, json_of, rows_of

REGISTRY = default_registry()
TRAPS = [model.id for model in REGISTRY.values() if "(trap)" in model.title]


# One interface


def test_errors_of_every_model(ask: Ask) -> None:
    interface = Interface(1.0, 1.5, 5.0)
    answer = ask("/errors", models=",".join(REGISTRY), n_t=1.5, k_t=5.0, samples=7)
    body = json_of(answer)
    assert answer.headers["etag"]
    assert body["theta_i_deg"] == [0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0]
    assert {row["model"] for row in body["errors"]} == set(REGISTRY)
    for row in body["errors"]:
        model = REGISTRY[row["model"]]
        assert row["reason"] == model.reason_outside(interface)
        assert row["in_domain"] is (row["reason"] is None)
        assert len(row["error"]) == 7
        assert row["albedo_error"] == row["cosine_weighted_mean"]
        for name, value in measure(model, interface).items():
            assert row[name] == (None if np.isnan(value) else float(value)), (model.id, name)
    sizes = [row["rms"] for row in body["errors"] if row["rms"] is not None]
    assert sizes == sorted(sizes)


def test_the_error_curve_is_the_difference_of_the_curves(ask: Ask) -> None:
    shared = {"n_t": 2.9, "k_t": 3.0, "samples": 31, "landmarks": "true"}
    body = json_of(ask("/errors", **shared, models="schlick", relative="true"))
    answer = ask("/curves", **shared, models="exact,schlick").json()
    values = {(c["model"], c["quantity"]): np.array(c["values"]) for c in answer["curves"]}
    exact, schlick = values["exact", "R"], values["schlick", "R"]
    (row,) = body["errors"]
    assert body["theta_i_deg"] == answer["theta_i_deg"]
    np.testing.assert_allclose(row["error"], schlick - exact, atol=1e-15)
    np.testing.assert_allclose(row["relative_error"], (schlick - exact) / exact, atol=1e-14)


def test_solved_and_given_parameters_are_told(ask: Ask) -> None:
    glass = {"models": "lazanyi2005", "n_t": 1.5, "k_t": 5.0}
    (row,) = ask("/errors", **glass).json()["errors"]
    assert round(row["parameters"]["alpha"], 4) == 7.7054
    assert row["parameters"]["a"] == 3.0
    (given,) = ask("/errors", **glass, **{"lazanyi2005.alpha": 7.7}).json()["errors"]
    assert given["parameters"]["alpha"] == 7.7
    assert given["max_abs"] != row["max_abs"]


def test_a_triple_has_three_rows(ask: Ask) -> None:
    asked = {"models": "hoffman_f82", "n_t": 0.27, "k_t": 2.9, "samples": 5}
    answer = ask("/errors", **asked, **{"hoffman_f82.F0": "1.0,0.8,0.4"})
    rows = {row["quantity"]: row for row in json_of(answer)["errors"]}
    assert set(rows) == {"R_red", "R_green", "R_blue"}
    for quantity, F0 in (("R_red", 1.0), ("R_green", 0.8), ("R_blue", 0.4)):
        (alone,) = ask("/errors", **asked, **{"hoffman_f82.F0": F0}).json()["errors"]
        assert rows[quantity]["parameters"]["F0"] == F0
        assert rows[quantity]["error"] == alone["error"]
        for name in METRICS:
            assert rows[quantity][name] == pytest.approx(alone[name], rel=1e-12)


def test_undefined_figures_are_null_and_last(ask: Ask) -> None:
    body = ask("/errors", models="wloka_gc,schlick", n_i=1.5, n_t=1.0, samples=3).json()
    first, last = body["errors"]
    assert (first["model"], last["model"]) == ("schlick", "wloka_gc")
    assert all(last[name] is None for name in METRICS)
    assert last["error"] == [pytest.approx(0.0, abs=1e-15), None, None]


def test_no_contrast_has_no_relative_error(ask: Ask) -> None:
    (row,) = ask("/errors", models="schlick", n_t=1.0, samples=2).json()["errors"]
    assert row["max_relative"] is None
    assert row["rms"] == pytest.approx(11**-0.5)


def test_errors_as_csv(ask: Ask) -> None:
    asked = {"models": "schlick,wloka_gc", "n_i": 1.5, "n_t": 1.0, "format": "csv", "samples": 3}
    rows = rows_of(ask("/errors", **asked))
    assert [row["model"] for row in rows] == ["schlick", "wloka_gc"]
    assert rows[0]["in_domain"] == "false"
    assert float(rows[0]["max_abs"]) == pytest.approx(0.959, abs=1e-3)
    assert rows[1]["rms"] == ""
    rounded = rows_of(ask("/errors", **asked, digits=3))
    assert rounded[0]["max_abs"] == "0.959"
    angles = rows_of(ask("/errors", **asked, table="curves"))
    assert [row["theta_i_deg"] for row in angles] == ["0.0", "45.0", "90.0"]
    assert set(angles[0]) == {"theta_i_deg", "schlick.R.error", "wloka_gc.R.error"}


# Along a line


@pytest.mark.parametrize("over", ["n_t", "k_t", "eta"])
@pytest.mark.parametrize("scale", ["linear", "log"])
def test_a_sweep_is_the_errors_at_each_interface(ask: Ask, over: str, scale: str) -> None:
    asked = {"model": "schlick", "n_i": 1.5, "minimum": 0.5, "maximum": 2.3, "steps": 4}
    body = ask("/errors/sweep", **asked, over=over, scale=scale).json()
    expected = np.linspace(0.5, 2.3, 4) if scale == "linear" else np.geomspace(0.5, 2.3, 4)
    np.testing.assert_allclose(body["values"], expected)
    assert {n: body[n] for n in ("n_i", "n_t", "k_t")} == {
        "n_i": 1.5,
        "n_t": 1.5 if over == "k_t" else None,
        "k_t": None if over == "k_t" else 0.0,
    }
    for index, value in enumerate(body["values"]):
        media = {"n_t": 1.5 * value} if over == "eta" else {over: value}
        (row,) = ask("/errors", models="schlick", n_i=1.5, samples=2, **media).json()["errors"]
        assert body["in_domain"][index] is row["in_domain"]
        for name in (*METRICS, "albedo_error"):
            assert body[name][index] == pytest.approx(row[name], rel=1e-9, abs=1e-15), name


def test_a_sweep_as_csv(ask: Ask) -> None:
    rows = rows_of(ask("/errors/sweep", over="k_t", steps=3, format="csv", digits=4))
    assert [row["k_t"] for row in rows] == ["0.0", "2.5", "5.0"]
    assert set(rows[0]) == {"k_t", *METRICS, "albedo_error"}


def test_a_sweep_with_a_models_own_parameter(ask: Ask) -> None:
    asked = {"model": "generalized_schlick", "steps": 3, "k_t": 3.0}
    plain = ask("/errors/sweep", **asked).json()
    bent = ask("/errors/sweep", **asked, **{"generalized_schlick.exponent": 4.0}).json()
    assert plain["rms"] != bent["rms"]


# Over a rectangle


@pytest.mark.parametrize("metric", ["error", "absolute", "relative"])
def test_a_map_over_the_angle(ask: Ask, metric: str) -> None:
    asked = {"x_steps": 4, "y": "n_t", "y_minimum": 1.2, "y_maximum": 2.2, "y_steps": 3}
    body = json_of(ask("/errors/map", **asked, metric=metric))
    assert body["x"] == {"name": "theta_i_deg", "values": [0.0, 30.0, 60.0, 90.0]}
    assert len(body["values"]) == 3
    for n_t, cells in zip(body["y"]["values"], body["values"], strict=True):
        (row,) = ask("/errors", models="schlick", n_t=n_t, samples=4, relative="true").json()[
            "errors"
        ]
        curve = np.array(row["relative_error" if metric == "relative" else "error"])
        np.testing.assert_allclose(
            cells, np.abs(curve) if metric == "absolute" else curve, atol=1e-15
        )


@pytest.mark.parametrize("metric", [*METRICS, "albedo_error"])
def test_a_map_over_index_and_extinction(ask: Ask, metric: str) -> None:
    asked = {"x": "n_t", "y": "k_t", "x_steps": 5, "y_steps": 4, "x_minimum": 1.1, "y_minimum": 0.5}
    body = json_of(ask("/errors/map", **asked, metric=metric, model="pharr_humphreys"))
    n, k = np.meshgrid(body["x"]["values"], body["y"]["values"])
    name = "cosine_weighted_mean" if metric == "albedo_error" else metric
    expected = measure(REGISTRY["pharr_humphreys"], Interface(1.0, n, k))[name]  # type: ignore[index]
    tolerance = 0.5 if metric.endswith("_deg") else 5e-4
    np.testing.assert_allclose(np.array(body["values"]), expected, atol=tolerance)


@pytest.mark.parametrize(
    ("asked", "least"),
    [
        # Over the angle the largest error of a model is that of /errors at the medium of the map.
        ({"x": "theta_i_deg", "y": "n_t", "y_minimum": 1.5, "y_maximum": 1.5000001}, 0.0356747),
        ({"x": "n_t", "y": "k_t", "x_minimum": 1.4, "x_maximum": 2.2, "y_maximum": 1e-9}, 0.0581),
        ({"x": "k_t", "y": "n_t", "metric": "rms", "model": "f82_tint"}, 0.02),
    ],
)
def test_the_largest_of_a_map_is_found_whatever_the_grid(
    ask: Ask, asked: dict[str, Any], least: float
) -> None:
    fine = ask("/errors/map", **asked, x_steps=181, y_steps=61).json()
    coarse = ask("/errors/map", **asked, x_steps=2, y_steps=2).json()
    assert fine["largest"] == coarse["largest"]
    found = coarse["largest"]
    assert abs(found["value"]) >= np.abs(fine["values"]).max() * (1.0 - 1e-6)
    assert abs(found["value"]) > least
    here = {asked["x"]: found["x"], asked["y"]: found["y"]}
    row = ask("/errors", models=asked.get("model", "schlick"), **without_angle(here)).json()
    metric = asked.get("metric", "max_abs")
    assert abs(found["value"]) == pytest.approx(row["errors"][0][metric], rel=1e-5)


def without_angle(here: dict[str, float]) -> dict[str, float]:
    return {name: value for name, value in here.items() if name != "theta_i_deg"}


def test_an_angle_and_what_has_no_bound_have_no_largest(ask: Ask) -> None:
    asked = {"x": "n_t", "y": "k_t", "x_steps": 2, "y_steps": 2}
    assert ask("/errors/map", **asked, metric="max_abs_at_deg").json()["largest"] is None
    # Beside n_t = n_i the exact R is 0, and 4 % are infinitely more.
    asked |= {"model": "schlick_four_percent", "metric": "max_relative", "x_minimum": 0.5}
    assert ask("/errors/map", **asked).json()["largest"] is None


def test_defaults_of_a_map(ask: Ask) -> None:
    body = ask("/errors/map").json()
    assert (body["metric"], body["x"]["name"], body["y"]["name"]) == ("error", "theta_i_deg", "n_t")
    assert (len(body["values"]), len(body["values"][0])) == (121, 181)
    swapped = ask("/errors/map", x="k_t", y="n_t", x_steps=3, y_steps=2).json()
    assert swapped["metric"] == "max_abs"
    assert (len(swapped["values"]), len(swapped["values"][0])) == (2, 3)


def test_a_map_as_csv(ask: Ask) -> None:
    rows = rows_of(ask("/errors/map", x_steps=2, y_steps=2, format="csv"))
    assert [(row["theta_i_deg"], row["n_t"]) for row in rows] == [
        ("0.0", "0.1"),
        ("90.0", "0.1"),
        ("0.0", "5.0"),
        ("90.0", "5.0"),
    ]
    assert set(rows[0]) == {"theta_i_deg", "n_t", "error"}


def test_a_map_of_large_tables_is_answered_without_its_largest(ask: Ask) -> None:
    """Seeking it would measure 8,576 interfaces with 16,388 nodes each, longer than a call may take."""
    asked = {"model": "lut_1d", "x": "n_t", "y": "n_i", "x_steps": 4, "y_steps": 4}
    answer = ask("/errors/map", **asked, **{"lut_1d.size": 4096}).json()
    assert np.all(np.array(answer["values"]) > 0.0)
    assert answer["largest"] is None
    assert ask("/errors/map", **asked).json()["largest"]["value"] > 0.0


def test_the_largest_map_is_answered(ask: Ask) -> None:
    answer = ask("/errors/map", x="n_t", y="k_t", x_steps=500, y_steps=500, digits=3, metric="rms")
    assert answer.status_code == 200
    assert len(answer.json()["values"]) == 500


def test_traps_are_measured_and_marked(ask: Ask) -> None:
    rows = ask("/errors", models=",".join(TRAPS), n_t=1.5, k_t=2.0, samples=2).json()["errors"]
    assert len(rows) == len(TRAPS)
    assert not any(row["in_domain"] for row in rows)


# On a mesh


def test_a_mesh(ask: Ask) -> None:
    answer = ask("/errors/mesh", n_t=1.333333)
    body = json_of(answer)
    assert (body["latitudes"], body["spacing"]) == (16, "angle")
    assert body["per_vertex"]["max_abs"] == pytest.approx(0.1593, abs=5e-5)
    assert 85.0 < body["per_vertex"]["max_abs_at_deg"] < 90.0
    rows = rows_of(ask("/errors/mesh", n_t=1.333333, latitudes=32, format="csv"))
    assert [row["shading"] for row in rows] == ["per_vertex", "per_pixel", "apart"]
    assert float(rows[0]["max_abs"]) == pytest.approx(0.0791, abs=5e-5)
    wrong = ask("/errors/mesh", latitudes=1)
    assert wrong.status_code == 422
    assert wrong.json()["errors"][0]["parameter"] == "latitudes"
