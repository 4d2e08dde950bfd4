"""Values picked without a branch are those that NumPy picks, bit by bit."""

from __future__ import annotations

import numpy as np
import pytest

from app.optics.numerics.choice import select

ODD = np.array([0.0, -0.0, np.nan, np.inf, -np.inf, 5e-324, -1.5, 1e300])
SHAPES = [((), (), ()), ((7,), (7,), (7,)), ((9000,), (9000,), (9000,))]
SHAPES += [((100, 90), (90,), (100, 1)), ((9000,), (), (9000,)), ((5000,), (3, 1), (5000,))]


@pytest.mark.parametrize("shapes", SHAPES)
def test_select_is_where(shapes: tuple[tuple[int, ...], ...]) -> None:
    rng = np.random.default_rng(3)
    condition = np.asarray(rng.random(shapes[0]) < 0.5)
    yes, no = (np.asarray(rng.choice(ODD, shape)) for shape in shapes[1:])
    for pair in ((yes, no), (yes, 2.5), (-0.0, no), (yes[..., ::-1] if yes.ndim else yes, no)):
        found, expected = select(condition, *pair), np.where(condition, *pair)
        assert found.shape == expected.shape
        assert found.dtype == np.float64
        assert found.tobytes() == expected.tobytes()
