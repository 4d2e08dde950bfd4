"""Large arrays are evaluated in pieces: the same numbers, without memory that grows beside them."""

import tracemalloc
from math import prod

import numpy as np
import pytest

from app.optics.amplitudes import amplitudes, power, reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics import blocks
from app.optics.parameters import Array
from app.optics.registry import Model, default_registry

MODELS = list(default_registry().values())
SHAPES = [(), (1,), (7,), (10,), (3, 4), (2, 30), (30, 2), (5, 1, 9), (0,), (4, 0)]


@pytest.fixture
def tiny_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(blocks, "VALUES", 10)


@pytest.mark.parametrize("shape", SHAPES)
def test_the_pieces_cover_an_array_once(shape: tuple[int, ...]) -> None:
    count = np.zeros(shape)
    for block in blocks.blocks(shape, 10):
        assert count[block].size <= 10
        count[block] += 1
    assert np.all(count == 1)


def test_long_axes_stay_long() -> None:
    assert [prod(s.stop - s.start for s in block) for block in blocks.blocks((4, 5), 10)] == [
        10,
        10,
    ]


def media(seed: int) -> tuple[Interface, Incidence]:
    """Interfaces by angles, dielectrics and weak and strong absorbers beside each other."""
    rng = np.random.default_rng(seed)
    eta, kappa = np.exp(rng.uniform(-4.0, 4.0, (2, 23, 1)))
    kappa[::3] = 0.0
    kappa[1::6] = 1e-9
    return Interface(1.33, 1.33 * eta, np.minimum(kappa, 100.0)), Incidence.from_degrees(
        np.linspace(0.0, 90.0, 37)
    )


def whole_and_pieces(model: Model) -> tuple[Array, Array]:
    interface, incidence = media(3)
    whole = model(interface, incidence)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(blocks, "VALUES", 10)
        return whole, model(interface, incidence)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)
def test_every_model_gives_the_same_in_pieces(model: Model) -> None:
    whole, pieces = whole_and_pieces(model)
    # Some forms choose a branch of NumPy's loops by the length of an array, which shows in a last bit.
    np.testing.assert_allclose(pieces, whole, rtol=1e-14, atol=1e-300)


def test_the_exact_values_do_not_depend_on_their_neighbours() -> None:
    interface, incidence = media(4)
    together = power(interface, incidence)
    for row in range(23):
        alone = power(
            Interface(
                *(
                    np.ravel(m)[min(row, m.size - 1)]
                    for m in (interface.n_i, interface.n_t, interface.k_t)
                )
            ),
            incidence,
        )
        for name in ("Rs", "Rp", "Ts", "Tp"):
            np.testing.assert_array_equal(getattr(together, name)[row], getattr(alone, name))


def test_reflectance_is_the_R_of_power() -> None:
    interface, incidence = media(5)
    np.testing.assert_array_equal(reflectance(interface, incidence), power(interface, incidence).R)


@pytest.mark.usefixtures("tiny_blocks")
def test_amplitudes_in_pieces() -> None:
    interface, incidence = media(6)
    found, energy = amplitudes(interface, incidence), power(interface, incidence)
    assert found.r_p.dtype == np.complex128
    np.testing.assert_allclose(np.abs(found.r_p) ** 2, energy.Rp, rtol=1e-12, atol=1e-300)
    np.testing.assert_allclose(np.abs(found.r_s) ** 2, energy.Rs, rtol=1e-12, atol=1e-300)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.id)
@pytest.mark.parametrize("k_t", [0.0, 2.9])
def test_memory_does_not_grow_with_the_input(model: Model, k_t: float) -> None:
    incidence = Incidence.from_cosine(np.linspace(0.0, 1.0, 400_000))
    interface = Interface(1.0, 1.5, k_t)
    model(interface, Incidence.from_cosine([0.0, 1.0]))
    tracemalloc.start()
    R = model(interface, incidence)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert R.nbytes == 3_200_000
    assert peak < R.nbytes + 100 * 8 * blocks.VALUES / 3


def test_power_needs_little_beside_its_result() -> None:
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 400_000))
    tracemalloc.start()
    energy = power(Interface(1.5, 1.0), incidence)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 5 * energy.Rs.nbytes + 30 * 8 * blocks.VALUES
