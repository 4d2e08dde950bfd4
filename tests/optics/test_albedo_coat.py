"""The diffuse body under a clear coat."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.optics.albedo import coat_split
from app.optics.amplitudes import power
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface


def test_internal_and_external_albedo_are_reciprocal() -> None:
    split = coat_split(Interface(1.0, np.linspace(1.01, 3.0, 50)), 0.5)
    n = np.linspace(1.01, 3.0, 50)
    np.testing.assert_allclose(split.internal, 1.0 - (1.0 - split.external) / n**2, rtol=1e-12)


def test_a_ray_splits_by_its_own_reflectance() -> None:
    """The mean over all directions of the rays is the split of diffuse light."""
    coat, rho = Interface(n_t=1.5), np.array([[0.2], [0.9]])
    x, w = np.polynomial.legendre.leggauss(60)
    mu = 0.5 * (x + 1.0)
    rays = coat_split(coat, rho, Incidence.from_cosine(mu))
    assert rays.body.shape == (2, 60)
    np.testing.assert_array_equal(rays.surface[0], power(coat, Incidence.from_cosine(mu)).R)
    diffuse = coat_split(coat, rho)
    for name in ("surface", "body", "absorbed"):
        mean = np.sum(getattr(rays, name) * mu * w, axis=1, keepdims=True)
        np.testing.assert_allclose(mean, getattr(diffuse, name), rtol=1e-6)


def test_without_a_coat_the_body_is_seen_bare() -> None:
    split = coat_split(Interface(1.3, 1.3), 0.37)
    assert float(split.surface) == 0.0
    assert float(split.body) == pytest.approx(0.37, rel=1e-15)


@given(st.floats(1e-3, 100.0), st.floats(1e-3, 100.0), st.floats(0.0, 1.0))
def test_nothing_is_lost(n_i: float, n_t: float, rho: float) -> None:
    split = coat_split(Interface(n_i, n_t), rho)
    parts = [float(part) for part in (split.surface, split.body, split.absorbed)]
    assert all(0.0 <= part <= 1.0 for part in parts)
    assert sum(parts) == pytest.approx(1.0, abs=1e-14)


def test_black_and_white_bodies() -> None:
    assert float(coat_split(Interface(), 0.0).body) == 0.0
    assert float(coat_split(Interface(), 1.0).absorbed) == pytest.approx(0.0, abs=1e-15)


def test_refused() -> None:
    with pytest.raises(NotAllowed, match="k_t"):
        coat_split(Interface(1.0, 1.5, 0.1), 0.5)
    with pytest.raises(OutOfRange, match="body_albedo"):
        coat_split(Interface(), 1.01)
