"""The search for the largest modulus, on curves whose peaks are known."""

import numpy as np
import pytest

from app.optics.numerics.peaks import largest, largest_of_smooth
from app.optics.numerics.quadrature import root_gauss_legendre, whole
from app.optics.parameters import Array


@pytest.mark.parametrize("shared", [True, False])
def test_parabolas(shared: bool) -> None:
    at, height = np.array([[0.137], [0.5], [0.93]]), np.array([[1.0], [-2.0], [0.5]])

    def curve(x: Array) -> Array:
        return np.asarray(height * (1.0 - (x - at) ** 2))

    x = np.linspace(0.0, 1.0, 6)
    nodes = x if shared else np.tile(x, (3, 1))
    found = largest(curve, nodes, curve(nodes), points=5, rounds=1)
    np.testing.assert_allclose(found.at, at[:, 0], atol=1e-12)
    np.testing.assert_allclose(found.value, height[:, 0], rtol=1e-15)


@pytest.mark.parametrize(("slope", "end"), [(1.0, 1.0), (-1.0, 0.0)])
def test_a_peak_at_either_end(slope: float, end: float) -> None:
    def line(x: Array) -> Array:
        return np.asarray(2.0 + slope * x)

    x = np.linspace(0.0, 1.0, 5)
    assert float(largest(line, x, line(x)[np.newaxis], points=7, rounds=3).at[0]) == end


def test_a_cusp_is_found_by_the_divisions() -> None:
    def cusp(x: Array) -> Array:
        return np.asarray(1.0 - np.sqrt(np.abs(x - 0.3137)))

    x = np.linspace(0.0, 1.0, 5)
    found = largest(cusp, x, cusp(x)[np.newaxis], points=15, rounds=8)
    assert float(found.value[0]) == pytest.approx(1.0, abs=1e-3)


def test_the_higher_of_two_peaks_where_the_samples_tell_the_lower() -> None:
    def peaks(x: Array) -> Array:
        return np.asarray(
            np.exp(-(((x - 0.5) / 0.1) ** 2)) - 1.1 * np.exp(-(((x - 0.9) / 0.03) ** 2))
        )

    x = np.array([0.0, 0.25, 0.5, 0.75, 0.88, 1.0])
    assert np.argmax(np.abs(peaks(x))) == 2
    found = largest(peaks, x, peaks(x)[np.newaxis], points=7, rounds=4)
    assert float(found.value[0]) == pytest.approx(-1.1, abs=1e-6)
    assert float(found.at[0]) == pytest.approx(0.9, abs=1e-6)


def test_undefined_samples_count_as_nothing() -> None:
    def broken(x: Array) -> Array:
        return np.where(np.abs(x - 0.5) < 0.2, np.nan, x)

    x = np.linspace(0.0, 1.0, 5)
    found = largest(broken, x, np.nan_to_num(broken(x))[np.newaxis], 5, 2)
    assert float(found.value[0]) == 1.0


def test_an_infinite_error_stays_infinite() -> None:
    x = np.linspace(0.0, 1.0, 3)
    found = largest(lambda t: np.full_like(t, np.inf), x, np.full((1, 3), np.inf), 5, 2)
    assert np.isinf(found.value[0])


def test_the_polynomial_through_the_samples() -> None:
    x = np.sqrt(whole(root_gauss_legendre(14)).mu)
    at = np.array([[0.2], [0.55], [0.9]])

    def curves(t: Array) -> Array:
        return np.asarray([[1.0], [-2.0], [3.0]] * np.exp(-((t - at) ** 2) / 0.08))

    found = largest_of_smooth(x, curves(x))
    np.testing.assert_allclose(found.value, [1.0, -2.0, 3.0], atol=1e-4)
    np.testing.assert_allclose(found.at, at[:, 0], atol=1e-3)


def test_the_polynomials_ends() -> None:
    x = np.sqrt(whole(root_gauss_legendre(14)).mu)
    found = largest_of_smooth(x, np.array([2.0 + x, 2.0 - x, np.zeros_like(x), np.ones_like(x)]))
    np.testing.assert_allclose(found.value, [3.0, 2.0, 0.0, 1.0], atol=1e-12)
    np.testing.assert_allclose(found.at[:2], [1.0, 0.0], atol=1e-9)


def test_a_plateau_does_not_hide_a_narrow_hill() -> None:
    """As the plateau of total reflection would the dip before it, at Brewster's angle."""

    def curve(x: Array) -> Array:
        return np.where(x > 0.5, 1.0, 1.2 * np.exp(-(((x - 0.305) / 0.01) ** 2)))

    x = np.linspace(0.0, 1.0, 101)
    found = largest(curve, x, curve(x[np.newaxis]), 7, 4)
    np.testing.assert_allclose(found.value, 1.2, rtol=1e-4)
    np.testing.assert_allclose(found.at, 0.305, atol=1e-3)
