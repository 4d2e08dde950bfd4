"""Recommendations: every answer is right by the figures it carries, every model is accounted for."""

import pytest

from app.optics.interface import Interface
from app.optics.metrics import Metric
from app.optics.recommendation import BUDGET_METRICS, WEIGHTS, recommend, weighted
from app.optics.registry import Cost, default_registry

REGISTRY = default_registry()
GLASS, GOLD, IRON = Interface(1.0, 1.5), Interface(1.0, 0.27, 2.9), Interface(1.0, 2.9, 3.0)


@pytest.mark.parametrize("metric", BUDGET_METRICS)
@pytest.mark.parametrize("budget", [0.05, 0.02, 0.005])
@pytest.mark.parametrize("interface", [GLASS, GOLD, IRON])
def test_every_model_is_either_within_or_refused(
    interface: Interface, budget: float, metric: Metric
) -> None:
    accepted, refused = recommend(REGISTRY.values(), interface, budget, metric)
    assert {c.model.id for c in (*accepted, *refused)} == set(REGISTRY)
    for candidate in accepted:
        assert candidate.figures is not None
        assert abs(candidate.figures[metric]) <= budget
        assert candidate.model.reason_outside(interface) is None
    for candidate in refused:
        assert candidate.reason
        if candidate.figures is not None:
            assert abs(candidate.figures[metric]) > budget
    assert [c.cost for c in accepted] == sorted(c.cost for c in accepted)


def test_what_is_recommended() -> None:
    def ids(interface: Interface, budget: float) -> list[str]:
        return [c.model.id for c in recommend(REGISTRY.values(), interface, budget)[0]]

    assert ids(GLASS, 0.05)[0] == "schlick"
    assert "schlick" not in ids(GLASS, 0.02)
    assert ids(GOLD, 0.02)[0] == "schlick"
    assert ids(GOLD, 0.015)[0] == "f82_tint"
    assert ids(IRON, 0.02)[0] == "f82_tint"
    assert "pharr_humphreys" in ids(GOLD, 0.005)
    assert "pharr_humphreys" not in ids(IRON, 0.005)


@pytest.mark.parametrize("interface", [GLASS, GOLD, IRON, Interface(1.5, 1.0)])
def test_no_trap_is_ever_recommended(interface: Interface) -> None:
    accepted, _ = recommend(REGISTRY.values(), interface, 1.0)
    assert all("(trap)" not in candidate.model.title for candidate in accepted)


def test_a_refusal_says_how_far_off_and_where() -> None:
    refused = {c.model.id: c.reason for c in recommend(REGISTRY.values(), GLASS, 0.02)[1]}
    assert refused["schlick"] == "Largest absolute error 0.0357 at 85.0 degrees, more than 0.02"
    assert refused["pharr_humphreys"] == "made for a conductor, and this is a dielectric"


def test_cost_is_a_sum_of_weights() -> None:
    assert weighted(Cost(add=2, mul=4)) == 6
    assert weighted(Cost(**dict.fromkeys(WEIGHTS, 1))) == sum(WEIGHTS.values())
