"""The metrics against scipy's quadrature and searches, and the figures that the models state."""

import re
from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import ArrayLike
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from app.optics.albedo import albedo
from app.optics.errors import NotAllowed
from app.optics.hemisphere import branch_cosine, hemisphere
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import FAST, METRICS, Metric, measure, point_error
from app.optics.numerics.quadrature import (
    Rule,
    crowded_gauss_legendre,
    double_exponential,
    gauss_legendre,
)
from app.optics.parameters import Array
from app.optics.registry import Measured, Model, default_registry

REGISTRY = default_registry()
# Thin and dense side, next to no contrast, strong and weak absorption, a soft critical angle.
INTERFACES = [
    (1.0, 1.5, 0.0),
    (1.0, 1.01, 0.0),
    (1.0, 40.0, 0.0),
    (1.5, 1.0, 0.0),
    (1.0, 0.99, 0.0),
    (1.0, 1.5, 5.0),
    (1.0, 0.27, 2.9),
    (1.0, 0.5, 0.3),
    (1.0, 0.5, 1e-4),
    (1.333, 1.01, 0.01),
]
MODELS = ["schlick", "schlick_tir", "pharr_humphreys", "one_minus_cos", "generalized_schlick"]
CASES = [
    (model_id, media)
    for model_id in MODELS
    for media in INTERFACES
    if model_id != "schlick_tir" or media[2] == 0.0
]


def breaks(interface: Interface) -> list[float]:
    """Where scipy has to be told to look closely."""
    at = float(np.sqrt(1.0 - complex(interface.eta, interface.kappa) ** 2).real)
    near = [at + s * 10.0**-e for e in range(1, 9) for s in (-1.0, 1.0)]
    inner = [x for x in (at, *near, *(10.0**-e for e in range(1, 7))) if 0.0 < x < 1.0]
    return [0.0, *sorted(set(inner)), 1.0]


def integral(model: Model, interface: Interface, power: int, weighted: bool) -> float:
    def integrand(mu: float) -> float:
        incidence = Incidence.from_cosine(mu)
        error = model(interface, incidence) - REGISTRY["exact"](interface, incidence)
        return float(error) ** power * (2.0 * mu if weighted else 1.0)

    pieces = pairwise(breaks(interface))
    return sum(quad(integrand, a, b, epsabs=1e-13, epsrel=1e-11)[0] for a, b in pieces)


@pytest.mark.parametrize(("model_id", "media"), CASES)
def test_integrals_against_scipy(model_id: str, media: tuple[float, float, float]) -> None:
    model, interface = REGISTRY[model_id], Interface(*media)
    found = measure(model, interface)
    rms = np.sqrt(integral(model, interface, 2, weighted=False))
    assert float(found["rms"]) == pytest.approx(float(rms), abs=1e-10)
    mean = integral(model, interface, 1, weighted=True)
    assert float(found["cosine_weighted_mean"]) == pytest.approx(mean, abs=1e-10)


@pytest.mark.parametrize(("model_id", "media"), CASES)
def test_largest_error_against_a_dense_search(
    model_id: str, media: tuple[float, float, float]
) -> None:
    model, interface = REGISTRY[model_id], Interface(*media)
    pieces = [np.linspace(a, b, 400) for a, b in pairwise(breaks(interface))]
    mu = np.unique(np.concatenate(pieces))

    def error(at: ArrayLike) -> Array:
        incidence = Incidence.from_cosine(at)
        return np.abs(model(interface, incidence) - REGISTRY["exact"](interface, incidence))

    best = int(np.argmax(error(mu)))
    low, high = mu[max(best - 1, 0)], mu[min(best + 1, mu.size - 1)]
    refined = minimize_scalar(lambda x: -float(error(x)), bounds=(low, high), method="bounded")
    largest = max(float(error(mu).max()), -float(refined.fun))
    found = measure(model, interface)
    # Never less than the search found, and where it is more, the error there is really as large.
    assert float(found["max_abs"]) >= largest - 1e-9
    there = Incidence.from_degrees(float(found["max_abs_at_deg"]))
    # At a critical angle the slope is infinite: the last bit of the angle is 1e-7 of the error.
    assert float(error(there.cos)) == pytest.approx(float(found["max_abs"]), abs=1e-6)
    assert abs(float(found["error_at_max"])) == float(found["max_abs"])


def test_schlicks_largest_errors() -> None:
    """The table of formulas.md."""
    printed = {1.1: 0.2105, 1.2: 0.1130, 1.33: 0.0599, 1.5: 0.0357, 1.8: 0.0345}
    printed |= {2.2: 0.0582, 2.42: 0.0757, 3.0: 0.1250, 4.0: 0.2009}
    found = measure(REGISTRY["schlick"], Interface(1.0, list(printed)))["max_abs"]
    assert [round(float(value), 4) for value in found] == list(printed.values())


def test_traps_of_formulas_md() -> None:
    """Schlick inside water is wrong by up to -0.975, schlick_tir by 0.059."""
    inside = Interface(1.333, 1.0)
    wrong = measure(REGISTRY["schlick_wrong_angle"], inside)
    assert round(float(wrong["error_at_max"]), 3) == -0.975
    assert float(wrong["max_abs_at_deg"]) == pytest.approx(
        np.degrees(np.arcsin(1 / 1.333)), abs=1e-4
    )
    assert round(float(measure(REGISTRY["schlick_tir"], inside)["max_abs"]), 3) == 0.059


def test_cosine_weighted_mean_is_the_error_of_the_albedo() -> None:
    """Schlick's albedo is F0 + (1 - F0)/21, the exact one is tested beside the albedos."""
    found = float(measure(REGISTRY["schlick"], Interface())["cosine_weighted_mean"])
    exact = float(albedo(Interface()).unpolarized)
    assert found == pytest.approx(0.04 + 0.96 / 21 - exact, abs=1e-12)


def test_relative_error() -> None:
    model, interface = REGISTRY["schlick"], Interface(1.0, 1.1)
    found = measure(model, interface)
    there = Incidence.from_degrees(float(found["max_relative_at_deg"]))
    arguments = model.arguments(interface)
    relative = point_error(model, interface, there, arguments, "relative")
    assert abs(float(relative)) == pytest.approx(float(found["max_relative"]), abs=1e-6)
    grid = Incidence.from_degrees(np.linspace(0.0, 90.0, 2001))
    everywhere = point_error(model, interface, grid, arguments, "relative")
    assert float(np.max(np.abs(everywhere))) <= float(found["max_relative"]) * (1 + 1e-12)


def test_point_errors() -> None:
    model, interface = REGISTRY["schlick"], Interface(1.0, 1.1)
    incidence, arguments = Incidence.from_degrees([0.0, 40.0, 85.0]), model.arguments(interface)
    signed = point_error(model, interface, incidence, arguments)
    exact = REGISTRY["exact"](interface, incidence)
    np.testing.assert_array_equal(signed, model(interface, incidence) - exact)
    absolute = point_error(model, interface, incidence, arguments, "absolute")
    np.testing.assert_array_equal(absolute, np.abs(signed))
    nothing = Interface(1.0, 1.0)
    relative = point_error(model, nothing, incidence, model.arguments(nothing), "relative")
    assert np.isnan(relative).all()  # there is no exact R to compare with


def test_without_a_boundary_relative_errors_are_infinite() -> None:
    found = measure(REGISTRY["schlick"], Interface(1.0, 1.0))
    assert np.isinf(found["max_relative"])
    # (1 - mu)^5 alone: 1/sqrt(11) and 1/21.
    assert float(found["rms"]) == pytest.approx(11**-0.5, abs=1e-14)
    assert float(found["cosine_weighted_mean"]) == pytest.approx(1 / 21, abs=1e-14)


def test_undefined_over_a_range_is_nan_and_at_a_point_is_not() -> None:
    beyond = measure(REGISTRY["wloka_gc"], Interface(1.5, 1.0))
    assert all(np.isnan(beyond[name]) for name in METRICS)
    absorber = measure(REGISTRY["schlick_tir"], Interface(1.5, 1.0, 0.1))
    assert all(np.isnan(absorber[name]) for name in METRICS)
    at_90 = measure(REGISTRY["shirley_ab"], Interface(1.0, 1.5, 5.0))
    assert float(at_90["max_abs"]) < 1e-14


def test_shapes_are_those_of_the_interface() -> None:
    model = REGISTRY["schlick"]
    grid = Interface(1.0, np.linspace(1.2, 3.0, 5)[:, np.newaxis], np.linspace(0.0, 4.0, 7))
    for quality in (None, FAST):
        found = measure(model, grid) if quality is None else measure(model, grid, quality=quality)
        assert {values.shape for values in found.values()} == {(5, 7)}
    assert set(measure(model, grid, wanted=["rms"])) == {"rms"}
    one = measure(model, Interface(1.0, 1.2, 4.0))
    many = measure(model, grid)
    assert float(many["rms"][0, 6]) == float(one["rms"])


def test_fast_maps_agree_with_precise_ones() -> None:
    """Over d'Eon's ranges; the tolerance is what the docstring of FAST promises."""
    n, k = np.meshgrid(np.linspace(0.1, 5.0, 25), np.linspace(0.0, 5.0, 26))
    grid = Interface(1.0, n, k)
    tolerances: dict[Metric, float] = {"rms": 1e-4, "cosine_weighted_mean": 1e-4, "max_abs": 5e-4}
    for model_id in ("schlick", "pharr_humphreys"):
        model = REGISTRY[model_id]
        precise, fast = measure(model, grid), measure(model, grid, None, FAST)
        for name, tolerance in tolerances.items():
            np.testing.assert_allclose(fast[name], precise[name], rtol=0.0, atol=tolerance)


@pytest.mark.parametrize("name", ["max_abs", "max_relative"])
def test_the_largest_of_a_map_is_found_too(name: Metric) -> None:
    """Of every approximation, at media drawn at random, to what the docstring of FAST promises."""
    rng = np.random.default_rng(3)
    for model in REGISTRY.values():
        for kind in model.applies_to if model.kind == "approximation" else ():
            n = 10.0 ** rng.uniform(-1.0, 1.0, 150)
            k = 10.0 ** rng.uniform(-2.0, 1.0, n.size) if kind == "conductor" else 0.0 * n
            interface = Interface(1.0, n, k)
            precise = measure(model, interface, wanted=[name])[name]
            fast = measure(model, interface, None, FAST, [name])[name]
            np.testing.assert_allclose(fast, precise, rtol=2e-3, atol=1e-5, err_msg=model.id)


def test_too_much_work_is_refused() -> None:
    model, interface = REGISTRY["lut_1d"], Interface(1.0, np.full(20_000, 1.5))
    with pytest.raises(NotAllowed, match="lut_1d"):
        measure(model, interface, model.arguments(interface, size=4096))


@pytest.mark.parametrize(
    ("rule", "tolerance"),
    [(double_exponential(), 1e-14), (crowded_gauss_legendre(12), 1e-6), (gauss_legendre(3), 1e-14)],
)
def test_nodes_are_a_partition_of_the_hemisphere(rule: Rule, tolerance: float) -> None:
    interface = Interface(1.0, [0.5, 1.0, 1.5], [0.0, 0.0, 3.0])
    nodes = hemisphere(interface, rule, np.array([0.25, 0.5]))
    np.testing.assert_allclose(nodes.w.sum(axis=-1), 1.0, rtol=tolerance)
    assert np.all(np.diff(nodes.mu, axis=-1) >= 0.0)
    assert np.all(nodes.w >= 0.0)
    assert nodes.mu.min() == 0.0
    assert nodes.mu.max() == 1.0


def test_branch_is_the_cosine_of_the_critical_angle() -> None:
    cosine = branch_cosine(Interface(1.5, 1.0))
    assert float(cosine) == pytest.approx(np.cos(np.arcsin(1.0 / 1.5)), abs=1e-15)


STATED = [(m.id, stated) for m in REGISTRY.values() for stated in m.measured]


@pytest.mark.parametrize(("model_id", "stated"), STATED)
def test_stated_errors_are_measured(model_id: str, stated: Measured) -> None:
    found = measure(REGISTRY[model_id], Interface(stated.n_i, stated.n_t, stated.k_t))
    assert f"{float(found['max_abs']):.3g}" == f"{stated.max_abs:.3g}"
    assert f"{float(found['rms']):.3g}" == f"{stated.rms:.3g}"
    assert round(float(found["max_abs_at_deg"]), 1) == stated.at_deg


def test_every_approximation_states_its_error() -> None:
    without = [m.id for m in REGISTRY.values() if m.kind == "approximation" and not m.measured]
    assert without == []


def test_no_validity_quotes_an_error_that_nothing_measures() -> None:
    """Numbers in a validity are indices, bounds and angles; errors belong into `measured`."""
    allowed = {"0.02", "1.33", "1.5", "0", "1", "2", "4", "5", "82", "90", "16", "8", "32"}
    for model in REGISTRY.values():
        for number in re.findall(r"\d+(?:\.\d+)?", model.validity):
            assert number in allowed, (model.id, number)
