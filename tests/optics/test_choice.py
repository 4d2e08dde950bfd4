"""One number and many, either of two forms: bit by bit what NumPy's plain form gives."""

import numpy as np
import pytest

from app.optics.amplitudes import power
from app.optics.angles import LANDMARKS
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.choice import select
from app.optics.specular import F82

ODD = np.array([0.0, -0.0, np.nan, np.inf, -np.inf, 5e-324, -1.5, 1e300])
SHAPES = [((), (), ()), ((7,), (7,), (7,)), ((9000,), (9000,), (9000,))]
SHAPES += [((100, 90), (90,), (100, 1)), ((9000,), (), (9000,)), ((5000,), (3, 1), (5000,))]


@pytest.mark.parametrize("shapes", SHAPES)
def test_select_is_where(shapes: tuple[tuple[int, ...], ...]) -> None:
    rng = np.random.default_rng(3)
    condition = np.asarray(rng.random(shapes[0]) < 0.5)
    yes, no = (np.asarray(rng.choice(ODD, shape)) for shape in shapes[1:])
    for pair in ((yes, no), (yes, 2.5), (-0.0, no), (yes[..., ::-1] if yes.ndim else yes, no)):
        found, expected = np.asarray(select(condition, *pair)), np.where(condition, *pair)
        assert found.shape == expected.shape
        assert found.dtype == np.float64
        assert found.tobytes() == expected.tobytes()


@pytest.mark.parametrize(
    "media", [(1, 1.5, 0), (1.5, 1, 0), (1, 1, 0), (1, 0.27, 2.9), (1, 0.9, 1e-9)]
)
def test_one_number_is_one_of_many(media: tuple[float, float, float]) -> None:
    """A figure of one interface is computed in Python's floats, one of many by NumPy."""
    one, many = Interface(*media), Interface(*(np.full(3, number) for number in media))
    marks = [float(angle(one)) for angle in LANDMARKS.values()]
    angles = [0.0, 33.0, 90.0, *(mark for mark in marks if np.isfinite(mark))]
    for angle in angles:
        single, several = Incidence.from_degrees(angle), Incidence.from_degrees(np.full(3, angle))
        for name in ("R", "Rs", "Rp", "Ts", "Tp"):
            number = getattr(power(one, single), name)
            assert number.shape == ()
            for array in (power(many, several), power(one, several), power(many, single)):
                assert (getattr(array, name) == number).all(), (angle, name)
    for figure in (*LANDMARKS.values(), F82):
        assert np.array_equal(figure(many), np.full(3, figure(one)), equal_nan=True)
        assert figure(one) is figure(one), "worked out once"
