"""Every quantity of the exact solution against arithmetic of 30 and of 50 digits."""

import json
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from app.optics.amplitudes import amplitudes, power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import default_registry
from app.optics.snell import (
    field_penetration_depth_wavelengths,
    is_totally_reflected,
    penetration_depth_wavelengths,
    refraction_angle_deg,
)
from tests.optics.reference.fresnel import Reference, fresnel

HERE = Path(__file__).parent / "reference"
GOLDEN: list[dict[str, Any]] = json.loads((HERE / "interfaces.json").read_text("utf-8"))[
    "interfaces"
]

RELATIVE = 1e-12

# Radians from the angles at which a plain form loses its digits.
DISTANCES = [1e-15, 1e-12, 1e-9, 1e-7, 2e-6, 1e-5, 1e-3]

AMPLITUDES = ("r_s", "r_p", "t_s", "t_p")
POWERS = ("Rs", "Rp", "R", "Ts", "Tp", "T")


class Ray(NamedTuple):
    n_i: float
    n_t: float
    k_t: float
    theta_i_deg: float


def grid() -> Iterator[Ray]:
    """All of the range, with indices that nearly match and angles close to both ends."""
    etas = [1e-3, 0.02, 0.5, 0.9, 1.1, 1.5, 3.7, 10.0, 100.0]
    etas += [1.0 + sign * step for step in (1e-9, 1e-6, 1e-3) for sign in (-1.0, 1.0)] + [1.0]
    kappas = [0.0, 1e-12, 1e-6, 1e-2, 1.0, 8.0, 100.0]
    angles = [0.0, 1e-9, 1e-3, 1.0, 31.0, 45.0, 60.0, 80.0, 89.0, 89.999, 90.0 - 1e-9, 90.0]
    return (Ray(1.0, *rest) for rest in product(etas, kappas, angles))


def scattered() -> Iterator[Ray]:
    """Other incident media than vacuum, all three indices over their whole range."""
    rng = np.random.default_rng(20)
    for _ in range(1500):
        n_i, n_t = np.exp(rng.uniform(np.log(1e-3), np.log(100.0), 2))
        k_t = rng.choice([0.0, np.exp(rng.uniform(np.log(1e-9), np.log(100.0)))])
        yield Ray(float(n_i), float(n_t), float(k_t), float(rng.uniform(0.0, 90.0)))


def around(theta_deg: float, distances_rad: list[float]) -> Iterator[float]:
    """Angles on both sides of one, so far as there are."""
    for distance, sign in product(distances_rad, (-1.0, 1.0)):
        angle = theta_deg + sign * float(np.degrees(distance))
        if 0.0 <= angle <= 90.0:
            yield angle


def near_brewster() -> Iterator[Ray]:
    """Where Rp vanishes: a quotient of rounded numbers has no digit left there."""
    etas = [1e-3, 0.3, 0.9, 1.0 - 1e-9, 1.0 + 1e-9, 1.1, 1.33, 1.5, 2.42, 10.0, 50.0]
    for eta, n_i, k_t in product(etas, (1.0, 1.33), (0.0, 1e-12, 1e-8)):
        n_t = max(eta * n_i, 1e-3)
        for angle in around(float(np.degrees(np.arctan2(n_t, n_i))), [0.0, *DISTANCES]):
            yield Ray(n_i, n_t, k_t, angle)


def near_critical() -> Iterator[Ray]:
    """Where the curves turn vertical; thin second media pass there from Rp = 0 to Rp = 1."""
    etas = [1e-3, 0.0108, 0.02, 0.05, 0.2, 0.5, 0.7, 0.9, 0.99, 0.999, 1.0 - 1e-9]
    for eta, n_i, k_t in product(etas, (1.0, 1.33, 2.42, 7.9), (0.0, 1e-12, 1e-6)):
        n_t = max(eta * n_i, 1e-3)
        for angle in around(float(np.degrees(np.arcsin(n_t / n_i))), DISTANCES):
            yield Ray(n_i, n_t, k_t, angle)


FAMILIES = {
    "grid": grid,
    "scattered": scattered,
    "near Brewster's angle": near_brewster,
    "near the critical angle": near_critical,
}


class Batch(NamedTuple):
    rays: list[Ray]
    interface: Interface
    incidence: Incidence
    references: list[Reference]

    def expected(self, name: str) -> NDArray[Any]:
        return np.array([getattr(reference, name) for reference in self.references])


def batch(rays: list[Ray]) -> Batch:
    n_i, n_t, k_t, theta = np.array(rays).T
    interface, incidence = Interface(n_i, n_t, k_t), Incidence.from_degrees(theta)
    return Batch(rays, interface, incidence, [fresnel(*ray) for ray in rays])


@pytest.fixture(scope="module", params=FAMILIES)
def family(request: pytest.FixtureRequest) -> Batch:
    return batch(list(FAMILIES[request.param]()))


def assert_close(actual: NDArray[Any], expected: NDArray[Any], rays: list[Ray]) -> None:
    """Compare within `RELATIVE` of the expected magnitude, naming the worst ray."""
    assert actual.shape == expected.shape
    error = np.abs(actual - expected)
    excess = np.where(np.isnan(error), np.inf, error - RELATIVE * np.abs(expected))
    worst = int(np.argmax(excess))
    assert excess[worst] <= 0.0, (
        f"{rays[worst]}: {actual[worst]!r} for {expected[worst]!r}, "
        f"{np.sum(excess > 0.0)} of {len(rays)} rays are off"
    )


@pytest.mark.parametrize("name", POWERS)
def test_powers_have_twelve_digits(family: Batch, name: str) -> None:
    energy = power(family.interface, family.incidence)
    assert_close(getattr(energy, name), family.expected(name), family.rays)


@pytest.mark.parametrize("name", AMPLITUDES)
def test_amplitudes_have_twelve_digits(family: Batch, name: str) -> None:
    amplitude = amplitudes(family.interface, family.incidence)
    assert_close(getattr(amplitude, name), family.expected(name), family.rays)


def test_refraction_angles_have_twelve_digits(family: Batch) -> None:
    refracted = ~is_totally_reflected(family.interface, family.incidence)
    angle = refraction_angle_deg(family.interface, family.incidence)
    assert np.array_equal(np.isnan(angle), ~refracted)
    rays = [ray for ray, passes in zip(family.rays, refracted, strict=True) if passes]
    assert_close(angle[refracted], family.expected("theta_t_deg")[refracted], rays)


@pytest.mark.parametrize(
    ("depth_of", "name"),
    [
        (penetration_depth_wavelengths, "depth"),
        (field_penetration_depth_wavelengths, "field_depth"),
    ],
)
def test_penetration_depths_have_twelve_digits(
    family: Batch, depth_of: Callable[[Interface, Incidence], Array], name: str
) -> None:
    depth = depth_of(family.interface, family.incidence)
    expected = family.expected(name)
    damped = np.isfinite(expected)
    assert np.array_equal(np.isnan(depth), ~damped)
    rays = [ray for ray, fades in zip(family.rays, damped, strict=True) if fades]
    assert_close(depth[damped], expected[damped], rays)


@pytest.fixture(scope="module")
def golden() -> Batch:
    return batch([Ray(*(float(row[name]) for name in Ray._fields)) for row in GOLDEN])


def test_the_golden_file_is_complete() -> None:
    assert len(GOLDEN) == 204


@pytest.mark.parametrize("name", ["Rs", "Rp", "R"])
def test_golden_powers(golden: Batch, name: str) -> None:
    energy = power(golden.interface, golden.incidence)
    assert_close(getattr(energy, name), np.array([row[name] for row in GOLDEN]), golden.rays)


@pytest.mark.parametrize("name", ["r_s", "r_p"])
def test_golden_amplitudes(golden: Batch, name: str) -> None:
    amplitude = amplitudes(golden.interface, golden.incidence)
    expected = np.array([complex(*row[name]) for row in GOLDEN])
    assert_close(getattr(amplitude, name), expected, golden.rays)


def test_the_model_exact_is_the_golden_R(golden: Batch) -> None:
    R = default_registry()["exact"](golden.interface, golden.incidence)
    assert_close(R, np.array([row["R"] for row in GOLDEN]), golden.rays)


@pytest.mark.parametrize("name", ["r_s", "r_p", "Rs", "Rp", "R"])
def test_both_references_agree(golden: Batch, name: str) -> None:
    """The two were written apart, so that one vouches for the other."""
    expected = [complex(*row[name]) if name in AMPLITUDES else row[name] for row in GOLDEN]
    assert_close(golden.expected(name), np.array(expected), golden.rays)
