"""What the four sources claim, beside what is measured, by textbook formulas written out here.

The page's named examples fetch these figures from the server; these tests hold the server's metrics
against an evaluation that shares no code with it.
"""

from itertools import pairwise

import numpy as np
import pytest

from app.optics.interface import Interface
from app.optics.metrics import Metric, measure
from app.optics.parameters import Array
from app.optics.registry import default_registry

REGISTRY = default_registry()
MU = np.cos(np.radians(np.linspace(0.0, 90.0, 90_001)))


def amplitudes(n_i: float, n_t: complex) -> tuple[Array, Array]:
    cos_t = np.sqrt(1.0 - (1.0 - MU**2) * (n_i / n_t) ** 2 + 0j)
    s = (n_i * MU - n_t * cos_t) / (n_i * MU + n_t * cos_t)
    p = (n_t * MU - n_i * cos_t) / (n_t * MU + n_i * cos_t)
    return np.abs(s) ** 2, np.abs(p) ** 2


def exact(n_i: float, n_t: complex) -> Array:
    s, p = amplitudes(n_i, n_t)
    return np.asarray((s + p) / 2.0)


def schlick(n_i: float, n_t: complex) -> Array:
    F0 = abs((n_t - n_i) / (n_t + n_i)) ** 2
    return np.asarray(F0 + (1.0 - F0) * (1.0 - MU) ** 5)


def pharr(n: float, k: float) -> Array:
    t = n * n + k * k
    s = (t - 2 * n * MU + MU**2) / (t + 2 * n * MU + MU**2)
    p = (t * MU**2 - 2 * n * MU + 1) / (t * MU**2 + 2 * n * MU + 1)
    return np.asarray((s + p) / 2.0)


def largest(approximation: Array, truth: Array) -> float:
    return float(np.max(np.abs(approximation - truth)))


def found(
    model: str, metric: Metric, n_t: float, k_t: float = 0.0, n_i: float = 1.0, **given: float
) -> float:
    interface = Interface(n_i, n_t, k_t)
    arguments = REGISTRY[model].arguments(interface, **given)
    return float(measure(REGISTRY[model], interface, arguments)[metric])


def test_shirley_schlick_lies_close_for_glass() -> None:
    """Close and far cheaper: 0.036 at 85 degrees, yet a quarter of R where R is small."""
    truth, curve = exact(1.0, 1.5), schlick(1.0, 1.5)
    assert found("schlick", "max_abs", 1.5) == pytest.approx(largest(curve, truth), abs=1e-8)
    assert round(found("schlick", "max_abs", 1.5), 4) == 0.0357
    assert round(found("schlick", "max_abs_at_deg", 1.5)) == 85
    relative = float(np.max(np.abs(curve / truth - 1.0)))
    assert found("schlick", "max_relative", 1.5) == pytest.approx(relative, abs=1e-7)
    assert round(relative, 3) == 0.232


@pytest.mark.parametrize(
    ("k", "error"), [(0.0, 0.0987), (0.5, 0.0516), (1.0, 0.0168), (2.0, 0.0065), (3.0, 0.0070)]
)
def test_lagarde_the_conductor_form_is_not_good_without_absorption(k: float, error: float) -> None:
    """Not good at k = 0, great for other k: it takes k > 1 to come below 0.02."""
    measured = largest(pharr(1.5, k), exact(1.0, complex(1.5, k)))
    assert round(measured, 4) == error
    assert found("pharr_humphreys", "max_abs", 1.5, k) == pytest.approx(measured, abs=1e-8)


def test_lagarde_lazanyi_with_alpha_7_7() -> None:
    """The dip of 0.132 is met at 82 degrees; 0.028 remain at 68."""
    truth, plain = exact(1.0, 1.5 + 5j), schlick(1.0, 1.5 + 5j)
    assert round(largest(plain, truth), 3) == 0.132
    remaining = largest(plain - 3.0 * MU * (1.0 - MU) ** 7.7, truth)
    assert round(remaining, 4) == 0.0284
    measured = found("lazanyi2005", "max_abs", 1.5, 5.0, alpha=7.7)
    assert measured == pytest.approx(remaining, abs=1e-8)
    assert round(found("lazanyi2005", "max_abs_at_deg", 1.5, 5.0, alpha=7.7)) == 68


def test_lagarde_water_to_air() -> None:
    """Schlick misses total reflection altogether; the transmitted angle brings it back to 0.06."""
    truth = exact(1.33, 1.0)
    wrong = found("schlick", "max_abs", 1.0, n_i=1.33)
    # Grazing the critical angle the samples come near the jump, not onto it.
    assert wrong == pytest.approx(largest(schlick(1.33, 1.0), truth), abs=1e-4)
    assert round(wrong, 3) == 0.975
    sin_t = np.sqrt(1.0 - MU**2) * 1.33
    F0 = (0.33 / 2.33) ** 2
    cos_t = np.sqrt(np.maximum(1.0 - sin_t**2, 0.0))
    curve = np.where(sin_t > 1.0, 1.0, F0 + (1.0 - F0) * (1.0 - cos_t) ** 5)
    right = found("schlick_tir", "max_abs", 1.0, n_i=1.33)
    assert right == pytest.approx(largest(curve, truth), abs=1e-4)
    assert round(right, 4) == 0.0599


def test_lagarde_schlick_is_accurate_from_1_4_to_2_2_alone() -> None:
    """Inside that range R is still up to 23 % off; water at 1.33 is no worse than 1.4."""

    def relative(n: float) -> float:
        return float(np.max(np.abs(schlick(1.0, n) / exact(1.0, n) - 1.0)))

    expected = {1.1: 1.874, 1.33: 0.227, 1.4: 0.235, 1.5: 0.232, 2.0: 0.140, 2.2: 0.103, 3.0: 0.247}
    for n, value in expected.items():
        assert round(relative(n), 3) == value
        assert found("schlick", "max_relative", n) == pytest.approx(relative(n), abs=1e-5)
    inside = [found("schlick", "max_relative", n) for n in np.linspace(1.4, 2.2, 17)]
    assert max(inside) < 0.24


def test_wloka_a_family_of_curves() -> None:
    """The denser, the more is reflected; but beyond 79 degrees the densest falls behind."""
    curves = [exact(1.0, n) for n in (1.31, 1.52, 2.417, 3.5)]
    assert [round(float(curve[0]), 4) for curve in curves] == [0.0180, 0.0426, 0.1720, 0.3086]
    theta = np.degrees(np.arccos(MU))
    for thin, dense in pairwise(curves):
        assert np.all(dense[theta < 79.0] > thin[theta < 79.0])
    behind = theta[(curves[3] < curves[2]) & (theta < 89.9)]
    assert round(float(behind.min()), 1) == 79.8


@pytest.mark.parametrize(
    ("n", "polynomial", "cosine", "polarization"),
    [(1.333333, 0.0591, 0.532, 0.109), (2.417, 0.0754, 0.411, 0.301)],
    ids=["water", "diamond"],
)
def test_wloka_schlick_against_1_minus_cos(
    n: float, polynomial: float, cosine: float, polarization: float
) -> None:
    """Schlick's error is smaller than that of leaving out polarization; 1 - cos is far larger."""
    truth = exact(1.0, n)
    s, _ = amplitudes(1.0, n)
    assert round(largest(schlick(1.0, n), truth), 4) == polynomial
    assert round(largest(1.0 - MU, truth), 3) == cosine
    assert round(largest(s, truth), 3) == polarization
    assert found("schlick", "max_abs", n) == pytest.approx(polynomial, abs=5e-5)
    assert found("one_minus_cos", "max_abs", n) == pytest.approx(cosine, abs=5e-4)


def test_deon_conductors_compared() -> None:
    """Pharr's form gains with k; the complex index in the dielectric formula never does."""
    N, truth = 1.5 + 2j, exact(1.0, 1.5 + 2j)
    cos_t = np.sqrt(1.0 - (1.0 - MU**2) / N**2)
    s = (MU - N * cos_t) / (MU + N * cos_t)
    p = (N * MU - cos_t) / (N * MU + cos_t)
    misunderstood = np.abs(s**2 + p**2) / 2.0
    expected = {
        "schlick": largest(schlick(1.0, N), truth),
        "pharr_humphreys": largest(pharr(1.5, 2.0), truth),
        "complex_dielectric": largest(misunderstood, truth),
    }
    assert [round(value, 4) for value in expected.values()] == [0.0326, 0.0065, 0.2218]
    for model, value in expected.items():
        assert found(model, "max_abs", 1.5, 2.0) == pytest.approx(value, abs=1e-8)
