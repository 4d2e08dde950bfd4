"""Recommendations, held against the curves that the API itself sends."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from typing import Any

import httpx
import numpy as np
import pytest

from app.answers.recommendation import Recommendation
from app.optics.recommendation import BUDGET_METRICS
from app.optics.registry import default_registry
from tests.api.shapes import json_of

Ask = Callable[..., httpx.Response]
REGISTRY = default_registry()
GLASS = {"n_t": 1.5}
GOLD = {"n_t": 0.27, "k_t": 2.9}
IRON = {"n_t": 2.9, "k_t": 3.0}


def recomputed(ask: Ask, media: dict[str, float]) -> dict[str, float]:
    """Largest error of every model from densely sampled curves and nothing else."""
    answer = ask(
        "/curves", **media, models=",".join(REGISTRY), samples=9001, landmarks="true"
    ).json()
    curve = {
        c["model"]: np.array(c["values"], dtype=np.float64)
        for c in answer["curves"]
        if c["quantity"] == "R"
    }
    return {
        m: float(np.max(np.nan_to_num(np.abs(values - curve["exact"]))))
        for m, values in curve.items()
    }


@pytest.mark.parametrize("media", [GLASS, GOLD, IRON], ids=["glass", "gold-like", "iron-like"])
def test_the_answers_hold_by_the_curves_alone(ask: Ask, media: dict[str, float]) -> None:
    largest = recomputed(ask, media)
    for budget in (0.05, 0.02, 0.005):
        body = json_of(Recommendation, ask("/recommend", **media, max_error=budget))
        accepted = [candidate["model"] for candidate in body["models"]]
        assert accepted
        assert all(largest[model] <= budget for model in accepted)
        for candidate in body["refused"]:
            if candidate["figures"] is not None:  # within its domain and still refused
                assert largest[candidate["model"]] > budget * (1.0 - 1e-5)
        assert {*accepted, *(c["model"] for c in body["refused"])} == set(REGISTRY)
        for candidate in body["models"]:  # 0.01 degrees apart, the samples miss the peak by little
            assert candidate["figures"]["max_abs"] == pytest.approx(
                largest[candidate["model"]], rel=1e-3, abs=1e-5
            )


@pytest.mark.parametrize("metric", [*BUDGET_METRICS, "albedo_error"])
def test_cheapest_first_and_every_refusal_explained(ask: Ask, metric: str) -> None:
    body = json_of(Recommendation, ask("/recommend", **GOLD, max_error=0.01, metric=metric))
    costs = [candidate["weighted_cost"] for candidate in body["models"]]
    assert costs == sorted(costs)
    for candidate in (*body["models"], *body["refused"]):
        operations = candidate["cost"].items()
        assert candidate["weighted_cost"] == sum(body["weights"][n] * k for n, k in operations)
    assert all(abs(c["figures"][metric]) <= 0.01 for c in body["models"])
    assert all(c["reason"] is None for c in body["models"])
    assert all(c["reason"] for c in body["refused"])


def test_what_will_do(ask: Ask) -> None:
    def first(media: dict[str, float], budget: float) -> str:
        return str(ask("/recommend", **media, max_error=budget).json()["models"][0]["model"])

    assert first(GLASS, 0.05) == "schlick"
    assert first(GOLD, 0.02) == "schlick"
    assert first(IRON, 0.02) == "f82_tint"


def test_a_material_in_place_of_numbers(ask: Ask) -> None:
    body = ask("/recommend", material="Au", max_error=0.02).json()
    assert body["interface"]["material"]["id"] == "Au"
    assert "exact" in {candidate["model"] for candidate in body["models"]}


def test_as_csv(ask: Ask) -> None:
    answer = ask("/recommend", **GLASS, max_error=0.02, format="csv", digits=3)
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    rows = {row["model"]: row for row in csv.DictReader(io.StringIO(answer.text))}
    assert set(rows) == set(REGISTRY)
    assert rows["exact"]["accepted"] == "true"
    assert rows["schlick"]["accepted"] == "false"
    assert rows["schlick"]["max_abs"] == "0.0357"
    assert "more than 0.02" in rows["schlick"]["reason"]
    assert rows["pharr_humphreys"]["max_abs"] == ""


@pytest.mark.parametrize(
    ("parameters", "name"),
    [
        ({"max_error": 0.0}, "max_error"),
        ({"max_error": 2.0}, "max_error"),
        ({"metric": "max_abs_at_deg"}, "metric"),
        ({"models": "schlick"}, "models"),
        ({"n_t": "inf"}, "n_t"),
    ],
)
def test_refused(ask: Ask, parameters: dict[str, Any], name: str) -> None:
    answer = ask("/recommend", **parameters)
    assert answer.status_code == 422
    assert [error["parameter"] for error in answer.json()["errors"]] == [name]
