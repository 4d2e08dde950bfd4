"""Nanoseconds a value of the core, one thread, beside other ways to get the same number.

Two million cosines, the fastest of the rounds, which are taken in turns: whatever else the machine
does only adds to a time.
"""

import importlib
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from tmm import interface_r

from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import default_registry

VALUES = 2_000_000
ROUNDS = 9
GLASS, COPPER = 1.5 + 0j, 0.27 + 2.9j
BARS = {"exact, conductor": 14.0}
RATIO_BARS = {"NumPy complex, conductor": 3.7, "tmm, conductor": 15.0}

Computation = Callable[[], Any]


def numpy_complex(mu: Array, index: complex) -> Array:
    """The textbook quotients in complex NumPy."""
    sin = np.sqrt(1.0 - mu**2)
    q = np.sqrt(index**2 - sin**2)
    r_s = (mu - q) / (mu + q)
    r_p = (index**2 * mu - q) / (index**2 * mu + q)
    return np.asarray(0.5 * (np.abs(r_s) ** 2 + np.abs(r_p) ** 2))


def numpy_real(mu: Array, index: float) -> Array:
    """The textbook quotients of a dielectric in real NumPy."""
    q = np.sqrt(index**2 - (1.0 - mu**2))
    r_s = (mu - q) / (mu + q)
    r_p = (index**2 * mu - q) / (index**2 * mu + q)
    return np.asarray(0.5 * (r_s**2 + r_p**2))


def tmm_R(mu: Array, index: complex) -> Array:
    """tmm's amplitudes at one interface, which take the angles on both sides."""
    theta_i = np.arccos(mu)
    theta_t = np.arcsin(np.sin(theta_i) / index)
    r = [interface_r(polarization, 1.0, index, theta_i, theta_t) for polarization in "sp"]
    return np.asarray(0.5 * (np.abs(r[0]) ** 2 + np.abs(r[1]) ** 2))


def numba_computation(mu: Array, index: complex) -> Computation | None:
    """The textbook quotients in a loop compiled by numba, where it is installed."""
    try:
        numba: Any = importlib.import_module("numba")
    except ImportError:
        return None

    @numba.njit  # type: ignore[untyped-decorator, unused-ignore]
    def loop(mu: Array, index: complex, out: Array) -> None:
        for i in range(mu.size):
            c = mu[i]
            q = np.sqrt(index * index - (1.0 - c * c))
            r_s = (c - q) / (c + q)
            r_p = (index * index * c - q) / (index * index * c + q)
            out[i] = 0.5 * (
                r_s.real * r_s.real
                + r_s.imag * r_s.imag
                + r_p.real * r_p.real
                + r_p.imag * r_p.imag
            )

    out = np.empty_like(mu)
    loop(mu[:10], index, out)
    return lambda: loop(mu, index, out)


def mitsuba_computation(mu: Array, index: complex) -> Computation | None:
    """Mitsuba's fresnel_conductor on LLVM, in single precision, where it is installed."""
    try:
        mitsuba: Any = importlib.import_module("mitsuba")
        mitsuba.set_variant("llvm_ad_rgb")
        drjit: Any = importlib.import_module("drjit")
        drjit.set_thread_count(0)
        cosines = mitsuba.Float(mu)
        eta = mitsuba.Complex2f(index.real, index.imag)
    except Exception:  # it raises what its backends raise
        return None

    def evaluate() -> None:
        drjit.eval(mitsuba.fresnel_conductor(cosines, eta))
        drjit.sync_thread()

    evaluate()
    return evaluate


def computations(mu: Array) -> dict[str, Computation]:
    """Everything that is compared, by name."""
    incidence = Incidence.from_cosine(mu)
    glass, copper = (Interface(1.0, n.real, n.imag) for n in (GLASS, COPPER))
    models = default_registry()
    named: dict[str, Computation | None] = {
        "exact, conductor": lambda: models["exact"](copper, incidence),
        "exact, dielectric": lambda: models["exact"](glass, incidence),
        "Schlick": lambda: models["schlick"](glass, incidence),
        "NumPy complex, conductor": lambda: numpy_complex(mu, COPPER),
        "NumPy complex, dielectric": lambda: numpy_complex(mu, GLASS),
        "NumPy real, dielectric": lambda: numpy_real(mu, GLASS.real),
        "tmm, conductor": lambda: tmm_R(mu, COPPER),
        "numba, conductor": numba_computation(mu, COPPER),
        "Mitsuba (single), conductor": mitsuba_computation(mu, COPPER),
    }
    return {name: computation for name, computation in named.items() if computation}


def nanoseconds(computation: Computation) -> float:
    """Time of the processor for each value."""
    start = time.process_time()
    computation()
    return 1e9 * (time.process_time() - start) / VALUES


def main() -> None:
    """Print the times, the ratios to the exact conductor, and how time grows with samples."""
    mu = np.random.default_rng(0).uniform(0.0, 1.0, VALUES)
    compared = computations(mu)
    for computation in compared.values():
        computation()
    rounds = [
        {name: nanoseconds(computation) for name, computation in compared.items()}
        for _ in range(ROUNDS)
    ]
    print(f"{'':30}{'ns/value':>9}{'ratio':>8}")
    for name in compared:
        ns = min(found[name] for found in rounds)
        ratio = ns / min(found["exact, conductor"] for found in rounds)
        bar = f"  (bar: {BARS[name]:g} ns)" if name in BARS else ""
        bar += f"  (bar: {RATIO_BARS[name]:g}x)" if name in RATIO_BARS else ""
        print(f"{name:30}{ns:9.1f}{ratio:8.2f}{bar}")
    grows()


def grows() -> None:
    """Print how the time of all four powers grows with the samples."""
    glass = Interface(1.0, GLASS.real)
    print("\nRs, Rp, Ts and Tp of glass, from degrees:")
    for samples in (181, 2_001, 20_001, 200_001, 2_000_001):
        incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, samples))
        repeats = max(3, 200_000 // samples)
        times = []
        for _ in range(ROUNDS):
            start = time.process_time()
            for _ in range(repeats):
                power(glass, incidence)
            times.append((time.process_time() - start) / repeats)
        least = min(times)
        print(f"{samples:10} samples{1e6 * least:12.1f} us{1e9 * least / samples:9.1f} ns/value")


if __name__ == "__main__":
    main()
