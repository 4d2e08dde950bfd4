"""Exact albedos against 30-digit values, and the laws they obey."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.optics.albedo import albedo, flatland_albedo, method
from app.optics.albedo.dielectric import dielectric_albedo
from app.optics.albedo.exact import flatland_by_quadrature
from app.optics.albedo.quadrature import integrate
from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from tests.optics.reference import albedo as reference

GOLDEN: dict[str, list[dict[str, float]]] = json.loads(
    (Path(__file__).parent / "reference" / "albedo.json").read_text("utf-8")
)

RELATIVE = 1e-10
FLATLAND_RELATIVE = 1e-9
# What is achieved; a loss of digits should be seen long before the bars break.
ACHIEVED = 1e-12

POINTS: list[dict[str, float]] = json.loads(reference.POINTS.read_text("utf-8"))


def relative_error(computed: Any, expected: float) -> float:
    return abs(float(computed) - expected) / expected


@pytest.mark.parametrize("row", GOLDEN["dielectric"] + GOLDEN["conductor"], ids=str)
def test_golden(row: dict[str, float]) -> None:
    found = albedo(Interface(1.0, row["n"], row.get("k", 0.0)))
    assert relative_error(found.s, row["s"]) < ACHIEVED
    assert relative_error(found.p, row["p"]) < ACHIEVED
    assert relative_error(found.unpolarized, row["unpolarized"]) < ACHIEVED


@pytest.mark.parametrize("row", GOLDEN["flatland"], ids=str)
def test_golden_flatland(row: dict[str, float]) -> None:
    found = flatland_albedo(Interface(n_t=row["n"]))
    assert relative_error(found, row["unpolarized"]) < ACHIEVED


@pytest.mark.parametrize("row", POINTS[::60], ids=str)
def test_the_points_are_what_35_digits_give(row: dict[str, float]) -> None:
    expected = asdict(reference.albedo(row["n_i"], row["n_t"], row["k_t"]))
    assert {name: row[name] for name in expected} == expected


def test_a_whole_array_reaches_the_same() -> None:
    """Interfaces of all kinds at once, each in the batch and at the place it belongs to."""
    n_i, n_t, k_t, s, p, flat = (
        np.array([row[name] for row in POINTS])
        for name in ("n_i", "n_t", "k_t", "s", "p", "flatland")
    )
    together = Interface(n_i, n_t, k_t)
    found = albedo(together)
    np.testing.assert_allclose(found.s, s, rtol=RELATIVE)
    np.testing.assert_allclose(found.p, p, rtol=RELATIVE)
    np.testing.assert_allclose(flatland_albedo(together), flat, rtol=FLATLAND_RELATIVE)


def test_shapes_are_kept() -> None:
    n_t, k_t = np.linspace(0.5, 3.0, 4)[:, np.newaxis], np.array([0.0, 0.1, 2.0])
    interface = Interface(1.0, n_t, k_t)
    assert albedo(interface).unpolarized.shape == (4, 3)
    assert flatland_albedo(interface).shape == (4, 3)
    assert albedo(Interface()).s.shape == ()
    assert albedo(Interface(1.0, n_t)).s.shape == (4, 1)
    assert albedo(Interface(1.0, np.array([]))).s.shape == (0,)
    assert albedo(Interface(1.0, np.array([]), 1.0)).s.shape == (0,)
    assert flatland_albedo(Interface(1.0, np.array([]))).shape == (0,)


def quadrature(interface: Interface) -> list[Array]:
    def s_and_p(boundary: Interface, incidence: Incidence) -> tuple[Array, Array]:
        energy = power(boundary, incidence)
        return energy.Rs, energy.Rp

    return integrate(interface, s_and_p)


def test_closed_form_agrees_with_quadrature() -> None:
    eta = np.concatenate(
        [
            np.geomspace(1e-3, 1e2, 400),
            1.0 + np.geomspace(1e-9, 0.5, 60),
            1.0 - np.geomspace(1e-9, 0.5, 60),
        ]
    )
    interface = Interface(1.0, eta)
    for closed, summed in zip(dielectric_albedo(interface), quadrature(interface), strict=True):
        np.testing.assert_allclose(closed, summed, rtol=ACHIEVED)


def test_allens_closed_form_agrees_with_quadrature() -> None:
    interface = Interface(1.0, np.geomspace(1e-2, 1e2, 400))
    summed = flatland_by_quadrature(interface).unpolarized
    np.testing.assert_allclose(flatland_albedo(interface), summed, rtol=1e-11)


def test_dunkles_printed_closed_form() -> None:
    """The expression in n, without the stray term of the source text."""
    n = np.linspace(1.5, 20.0, 100)
    logs = 8 * n**4 * (n**4 + 1) / ((n**2 + 1) * (n**4 - 1) ** 2) * np.log(n)
    logs += n**2 * (n**2 - 1) ** 2 / (n**2 + 1) ** 3 * np.log((n - 1) / (n + 1))
    rational = 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) ** 2)
    rational -= 2 * n**3 * (n**2 + 2 * n - 1) / ((n**2 + 1) * (n**4 - 1))
    found = albedo(Interface(1.0, n))
    np.testing.assert_allclose(found.unpolarized, rational + logs, rtol=1e-11)
    np.testing.assert_allclose(found.s, 1 - 4 / 3 * (2 * n + 1) / (n + 1) ** 2, rtol=1e-13)


def test_unpolarized_is_the_mean_of_s_and_p() -> None:
    n_t = np.array([0.3, 1.0, 1.5, 2.0])
    found = albedo(Interface(1.0, n_t, np.array([0.0, 0.2, 0.0, 4.0])))
    np.testing.assert_array_equal(found.unpolarized, 0.5 * (found.s + found.p))
    assert np.all(found.s >= found.p)


def test_reciprocity() -> None:
    """What leaves a medium is what enters it: n_i^2 (1 - A) is the same from either side."""
    n = np.concatenate([np.geomspace(1.0 + 1e-9, 70.0, 200), [1.0]])
    outside, inside = albedo(Interface(1.3, 1.3 * n)), albedo(Interface(1.3 * n, 1.3))
    np.testing.assert_allclose(1 - outside.s, n**2 * (1 - inside.s), rtol=1e-10)
    np.testing.assert_allclose(1 - outside.p, n**2 * (1 - inside.p), rtol=1e-10)
    flat = flatland_albedo(Interface(1.3, 1.3 * n)), flatland_albedo(Interface(1.3 * n, 1.3))
    np.testing.assert_allclose(1 - flat[0], n * (1 - flat[1]), rtol=1e-10)


def test_only_ratios_of_the_indices_matter() -> None:
    relative, scaled = albedo(Interface(1.0, 0.4, 3.0)), albedo(Interface(2.0, 0.8, 6.0))
    assert relative_error(scaled.s, float(relative.s)) < 1e-14
    assert relative_error(scaled.p, float(relative.p)) < 1e-14


def test_limit_of_matched_indices() -> None:
    """A -> (n - 1)/3 from above and 7 (1 - n)/3 from below, each to first order."""
    step = 2.0**-30
    above, below = albedo(Interface(1.0, 1.0 + step)), albedo(Interface(1.0, 1.0 - step))
    for limit, found in ((step / 3, above), (7 * step / 3, below)):
        assert relative_error(found.s, limit) < 1e-8
        assert relative_error(found.p, limit) < 1e-6
    assert float(albedo(Interface(1.3, 1.3)).unpolarized) == 0.0
    assert float(flatland_albedo(Interface(1.3, 1.3))) == 0.0


def test_a_vanishing_absorption_between_matched_media() -> None:
    """A is proportional to kappa, down to the smallest double."""
    base = float(albedo(Interface(1.0, 1.0, 1e-25)).unpolarized) / 1e-25
    for k_t in (1e-40, 1e-200, 1e-300):
        assert relative_error(albedo(Interface(1.0, 1.0, k_t)).unpolarized / k_t, base) < 1e-12


@pytest.mark.parametrize("eta", [1e-3, 0.3, 0.9, 1.0 - 1e-9, 1.0 + 1e-9, 1.5, 100.0])
def test_vanishing_absorption_leaves_a_dielectric(eta: float) -> None:
    clear, dim = Interface(1.0, eta), Interface(1.0, eta, 1e-30)
    for name in ("s", "p"):
        expected = float(getattr(albedo(clear), name))
        assert relative_error(getattr(albedo(dim), name), expected) < RELATIVE
    expected = float(flatland_albedo(clear))
    assert relative_error(flatland_albedo(dim), expected) < FLATLAND_RELATIVE


def test_limits_of_large_indices() -> None:
    # 1 - A -> 8/(3 n) for s and 8/n for p as n grows; 16 n/(3 k^2) unpolarized as k does.
    far = albedo(Interface(1e-3, 100.0))
    assert relative_error(1 - far.s, 8 / 3 * 1e-5) < 1e-4
    assert relative_error(1 - far.p, 8 * 1e-5) < 1e-3
    metal = albedo(Interface(1e-3, 1e-3, 100.0))
    assert relative_error(1 - metal.unpolarized, 16 / 3 * 1e-10) < 1e-4


def test_method_is_stated() -> None:
    assert method(Interface(1.0, 1.5)) == "closed form"
    assert method(Interface(1.5, 1.0)) == "closed form by reciprocity"
    assert method(Interface(1.0, 1.5, 1e-9)) == "quadrature"


indices = st.floats(1e-3, 100.0)


@given(indices, indices, st.one_of(st.just(0.0), st.floats(0.0, 100.0)))
def test_albedos_are_within_0_and_1(n_i: float, n_t: float, k_t: float) -> None:
    interface = Interface(n_i, n_t, k_t)
    found = albedo(interface)
    for value in (found.s, found.p, found.unpolarized, flatland_albedo(interface)):
        assert 0.0 <= float(value) <= 1.0


@given(indices, st.floats(1.001, 3.0), st.floats(0.0, 10.0))
def test_absorption_never_lowers_s(n_i: float, eta: float, kappa: float) -> None:
    n_t = min(n_i * eta, 100.0)
    k_t = min(n_i * kappa, 100.0)
    if n_t < n_i:
        return
    clear, dim = albedo(Interface(n_i, n_t)), albedo(Interface(n_i, n_t, k_t))
    assert float(dim.s) >= float(clear.s) * (1.0 - 1e-12)
