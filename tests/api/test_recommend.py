"""Recommendations, held against the curves that the API itself sends; every model is accounted for."""

import numpy as np
import pytest

from app.answers.recommendation import WEIGHTS, recommendation, weighted
from app.optics.interface import Interface
from app.optics.registry import Cost, default_registry
from tests.api.shape import Ask, json_of, rows_of

REGISTRY = default_registry()
GLASS = {"n_t": 1.5}
GOLD = {"n_t": 0.27, "k_t": 2.9}
IRON = {"n_t": 2.9, "k_t": 3.0}
MEDIA = pytest.mark.parametrize("media", [GLASS, GOLD, IRON], ids=["glass", "gold", "iron"])
METRICS = ["max_abs", "rms", "cosine_weighted_mean", "max_relative", "albedo_error"]


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


@MEDIA
def test_the_answers_hold_by_the_curves_alone(ask: Ask, media: dict[str, float]) -> None:
    largest = recomputed(ask, media)
    for budget in (0.05, 0.02, 0.005):
        body = json_of(ask("/recommend", **media, max_error=budget))
        assert body["models"]
        assert all(largest[candidate["model"]] <= budget for candidate in body["models"])
        for candidate in body["refused"]:
            if candidate["figures"] is not None:  # within its domain and still refused
                assert largest[candidate["model"]] > budget * (1.0 - 1e-5)
        for candidate in body["models"]:  # 0.01 degrees apart, the samples miss the peak by little
            assert candidate["figures"]["max_abs"] == pytest.approx(
                largest[candidate["model"]], rel=1e-3, abs=1e-5
            )


@pytest.mark.parametrize("metric", METRICS)
@pytest.mark.parametrize("budget", [0.05, 0.01, 0.005])
@MEDIA
def test_every_model_is_either_within_or_refused_and_the_cheapest_first(
    ask: Ask, media: dict[str, float], budget: float, metric: str
) -> None:
    body = json_of(ask("/recommend", **media, max_error=budget, metric=metric))
    everything = [*body["models"], *body["refused"]]
    assert {candidate["model"] for candidate in everything} == set(REGISTRY)
    for candidate in everything:
        operations = candidate["cost"].items()
        assert candidate["weighted_cost"] == sum(body["weights"][n] * k for n, k in operations)
    costs = [candidate["weighted_cost"] for candidate in body["models"]]
    assert costs == sorted(costs)
    for candidate in body["models"]:
        assert candidate["reason"] is None
        assert abs(candidate["figures"][metric]) <= budget
        assert REGISTRY[candidate["model"]].reason_outside(Interface(**media)) is None
    for candidate in body["refused"]:
        assert candidate["reason"]
        value = 1.0 if candidate["figures"] is None else candidate["figures"][metric]
        assert value is None or abs(value) > budget  # an infinite one is null


def ids(media: dict[str, float], budget: float) -> list[str]:
    found = recommendation(REGISTRY.values(), Interface(**media), budget)
    return [candidate.model for candidate in found.models]


def test_what_will_do() -> None:
    assert ids(GLASS, 0.05)[0] == "schlick"
    assert "schlick" not in ids(GLASS, 0.02)
    assert ids(GOLD, 0.02)[0] == "schlick"
    assert ids(GOLD, 0.015)[0] == "f82_tint"
    assert ids(IRON, 0.02)[0] == "f82_tint"
    assert "pharr_humphreys" in ids(GOLD, 0.005)
    assert "pharr_humphreys" not in ids(IRON, 0.005)


@pytest.mark.parametrize("media", [GLASS, GOLD, IRON, {"n_i": 1.5, "n_t": 1.0}])
def test_no_trap_is_ever_recommended(media: dict[str, float]) -> None:
    assert all("(trap)" not in REGISTRY[model].title for model in ids(media, 1.0))


def test_a_refusal_says_how_far_off_and_where() -> None:
    found = recommendation(REGISTRY.values(), Interface(**GLASS), 0.02)
    refused = {candidate.model: candidate.reason for candidate in found.refused}
    assert refused["schlick"] == "Largest absolute error 0.0357 at 85.0 degrees, more than 0.02"
    assert refused["pharr_humphreys"] == "made for a conductor, and this is a dielectric"


def test_cost_is_a_sum_of_weights() -> None:
    assert weighted(Cost(add=2, mul=4)) == 6
    assert weighted(Cost(**dict.fromkeys(WEIGHTS, 1))) == sum(WEIGHTS.values())


def test_a_material_in_place_of_numbers(ask: Ask) -> None:
    body = ask("/recommend", material="Au", max_error=0.02).json()
    assert body["interface"]["material"]["id"] == "Au"
    assert "exact" in {candidate["model"] for candidate in body["models"]}


def test_as_csv(ask: Ask) -> None:
    answer = ask("/recommend", **GLASS, max_error=0.02, format="csv", digits=3)
    rows = {row["model"]: row for row in rows_of(answer)}
    assert set(rows) == set(REGISTRY)
    assert rows["exact"]["accepted"] == "true"
    assert rows["schlick"]["accepted"] == "false"
    assert rows["schlick"]["max_abs"] == "0.0357"
    assert "more than 0.02" in rows["schlick"]["reason"]
    assert rows["pharr_humphreys"]["max_abs"] == ""
