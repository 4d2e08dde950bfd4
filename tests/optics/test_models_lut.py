"""The lookup texture against a table built and read one texel at a time."""

import struct
import tracemalloc

import mpmath as mp
import numpy as np
import pytest

from app.optics.amplitudes import power
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import measure
from app.optics.parameters import Array
from app.optics.registry import default_registry

ANGLES_DEG = np.linspace(0.0, 90.0, 19)
INTERFACES = [
    (1.0, 1.333, 0.0),
    (1.0, 2.417, 0.0),
    (1.5, 1.0, 0.0),
    (1.0, 1.5, 5.0),
    (1.0, 0.27, 2.9),
    (1.333, 2.9, 3.0),
]


def texel(media: tuple[float, float, float], mu: float, bits: int) -> float:
    n_i, N, c = mp.mpf(media[0]), mp.mpc(media[1], media[2]), mp.mpf(mu)
    q = mp.sqrt(N**2 - n_i**2 * (1 - c**2))
    r_s, r_p = (n_i * c - q) / (n_i * c + q), (N**2 * c - n_i * q) / (N**2 * c + n_i * q)
    R = float((abs(r_s) ** 2 + abs(r_p) ** 2) / 2)
    if bits == 32:
        (stored,) = struct.unpack("f", struct.pack("f", R))
        return float(stored)
    steps = 2**bits - 1
    return float(int(R * steps + 0.5) / steps)


@pytest.mark.parametrize("filtering", ["nearest", "linear"])
@pytest.mark.parametrize("bits", [8, 16, 32])
@pytest.mark.parametrize("size", [2, 33])
def test_table(size: int, bits: int, filtering: str) -> None:
    model, incidence = default_registry()["lut_1d"], Incidence.from_degrees(ANGLES_DEG)
    for media in INTERFACES:
        texels = [texel(media, j / (size - 1), bits) for j in range(size)]
        at = [float(mu) * (size - 1) for mu in incidence.cos]
        if filtering == "linear":
            expected = np.interp(at, range(size), texels)
        else:
            expected = np.array([texels[int(x + 0.5)] for x in at])
        values = model(Interface(*media), incidence, size=size, bits=bits, filtering=filtering)
        np.testing.assert_allclose(values, expected, rtol=0.0, atol=1e-9)


def test_many_interfaces_each_have_their_own_table() -> None:
    model, incidence = default_registry()["lut_1d"], Incidence.from_degrees(ANGLES_DEG)
    together = model(Interface(1.0, np.array([[1.333], [1.5]]), [[0.0], [5.0]]), incidence, size=16)
    assert together.shape == (2, 19)
    for row, media in zip(together, [(1.0, 1.333, 0.0), (1.0, 1.5, 5.0)], strict=True):
        np.testing.assert_array_equal(row, model(Interface(*media), incidence, size=16))


def test_the_largest_tables_of_many_interfaces_stay_small() -> None:
    many = Interface(1.0, np.linspace(1.2, 2.0, 5000))
    mu = Incidence.from_cosine(np.linspace(0.0, 1.0, 5000))
    tracemalloc.start()
    try:
        default_registry()["lut_1d"](many, mu, size=4096)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < 20e6  # all texels would be 160 MB


def test_only_whole_sizes_and_real_depths() -> None:
    model, angle = default_registry()["lut_1d"], Incidence.from_degrees(0.0)
    for wrong in ({"size": 16.5}, {"bits": 10}, {"filtering": "cubic"}, {"size": 1}):
        with pytest.raises(OutOfRange, match=r"lut_1d\."):
            model(Interface(), angle, **wrong)
    with pytest.raises(NotAllowed, match=r"lut_1d\.size"):
        model(Interface(), angle, size=[16, 32])


def test_error_of_wlokas_table() -> None:
    """Eight bits cost half a step, and a finer table cannot win that back."""
    model, water = default_registry()["lut_1d"], Interface(1.0, 1.333)
    fine = measure(model, water, model.arguments(water, size=256))
    coarse = measure(model, water, model.arguments(water, size=256, bits=8))
    assert float(fine["max_abs"]) < 1e-4
    assert 0.5 / 255 * 0.9 < float(coarse["max_abs"]) < 0.5 / 255 + float(fine["max_abs"])


def test_linear_error_falls_with_the_square_of_the_size() -> None:
    model, water = default_registry()["lut_1d"], Interface(1.0, 1.333)
    errors = [
        float(measure(model, water, model.arguments(water, size=n))["rms"]) for n in (65, 129)
    ]
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)


@pytest.mark.parametrize("media", [(1.0, 1.333, 0.0), (1.333, 1.0, 0.0), (1.0, 2.9, 3.0)])
@pytest.mark.parametrize("size", [16, 256])
def test_mean_square_error_between_texels(media: tuple[float, float, float], size: int) -> None:
    """Against the plain mean over two million cosines, of the table read by NumPy."""
    model, interface = default_registry()["lut_1d"], Interface(*media)
    mu: Array = (np.arange(2_000_000, dtype=np.float64) + 0.5) / 2e6
    nodes: Array = np.linspace(0.0, 1.0, size, dtype=np.float64)

    def exact(cosine: Array) -> Array:
        return power(interface, Incidence(cosine, np.sqrt((1.0 - cosine) * (1.0 + cosine)))).R

    error = np.interp(mu, nodes, exact(nodes)) - exact(mu)
    measured = measure(model, interface, model.arguments(interface, size=size))["rms"]
    assert float(measured) == pytest.approx(np.sqrt(np.mean(error**2)), rel=1e-4)
