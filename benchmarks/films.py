"""Nanoseconds a value of films, one thread, beside other ways to get the same number.

One film on an absorbing substrate at 1,000 wavelengths by 100 angles, in both polarizations; the
fastest of the rounds, which are taken in turns. The ratio is to Rs and Rp of `reflectances`.
"""

from __future__ import annotations

import importlib
import time
import tracemalloc
from collections.abc import Callable
from typing import Any

import numpy as np
import tmm

from app.answers.film_colors import film_colors
from app.answers.film_media import FilmMedia, Side
from app.materials.films import read_layers
from app.materials.front import Front
from app.optics.films import power, reflectances
from app.optics.incidence import Incidence
from app.optics.parameters import Array
from app.optics.stack import Layer, Stack

WAVELENGTHS, ANGLES = 1000, 100
ROUNDS = 15
THICKNESS_NM = 100.0
BARS = {"NumPy closed form": 2.0, "pystratify": 15.0}
# Of those that are slow a part is timed: this many wavelengths.
SLOW = 4

Computation = Callable[[], Any]


def media() -> tuple[Array, Array, Array]:
    """Wavelengths in nm, index of the film, of the substrate; one a row."""
    wavelength_nm = np.linspace(400.0, 800.0, WAVELENGTHS)
    film = 1.38 + 3000.0 / wavelength_nm**2
    return wavelength_nm, film, 0.2 + wavelength_nm / 2000.0 + 1j * (2.0 + wavelength_nm / 200.0)


def numpy_closed_form(theta_i_deg: Array) -> tuple[Array, Array]:
    """Airy's sum in complex NumPy."""
    wavelength_nm, film, substrate = (values[:, np.newaxis] for values in media())
    cos, sin2 = np.cos(np.radians(theta_i_deg)), np.sin(np.radians(theta_i_deg)) ** 2
    q1, q2 = np.sqrt(film**2 - sin2 + 0j), np.sqrt(substrate**2 - sin2)
    turn = np.exp(4j * np.pi * q1 * THICKNESS_NM / wavelength_nm)
    found = []
    for y0, y1, y2 in ((cos, q1, q2), (cos, q1 / film**2, q2 / substrate**2)):
        r01, r12 = (y0 - y1) / (y0 + y1), (y1 - y2) / (y1 + y2)
        found.append(np.abs((r01 + r12 * turn) / (1.0 + r01 * r12 * turn)) ** 2)
    return found[0], found[1]


def tmm_loop(theta_i_deg: Array) -> None:
    """S. J. Byrnes' tmm, a call each value, at a few of the wavelengths."""
    thicknesses = [np.inf, THICKNESS_NM, np.inf]
    for wavelength_nm, film, substrate in zip(*(v[:SLOW] for v in media()), strict=True):
        for theta in np.radians(theta_i_deg):
            for polarization in "sp":
                index = [1.0, film, substrate]
                tmm.coh_tmm(polarization, index, thicknesses, theta, wavelength_nm)


def tmm_faster_computation(theta_i_deg: Array) -> Computation | None:
    """tmm-faster, in C++, where it is installed."""
    try:
        package: Any = importlib.import_module("tmm_faster")
    except ImportError:
        return None
    wavelength_nm, film, substrate = media()
    index = np.stack([np.ones(WAVELENGTHS, complex), film + 0j, substrate], axis=1)
    thicknesses = np.array([np.inf, THICKNESS_NM, np.inf])
    return lambda: package.calc_coherent(index, thicknesses, theta_i_deg, wavelength_nm)


def pystratify_computation(theta_i_deg: Array) -> Computation | None:
    """pystratify's ellipsometry, an angle a call, where it is installed."""
    try:
        package: Any = importlib.import_module("pystratify.ellipsometry")
        tables: Any = importlib.import_module("pystratify.dispersion")
    except ImportError:
        return None
    wavelength_nm, film, substrate = media()
    zero = np.zeros(WAVELENGTHS)
    layer = package.Layer(tables.Table(wavelength_nm, film, zero), THICKNESS_NM)
    sample = package.Sample([layer], tables.Table(wavelength_nm, substrate.real, substrate.imag))

    def run() -> None:
        for theta in theta_i_deg.tolist():
            package.simulate(sample, wavelength_nm, theta)

    return run


def computations() -> dict[str, tuple[Computation, int]]:
    """Everything that is compared, by name, and how many values it makes."""
    theta_i_deg = np.linspace(0.0, 89.0, ANGLES)
    incidence = Incidence.from_degrees(theta_i_deg)

    def stack() -> Stack:
        wavelength_nm, film, substrate = (values[:, np.newaxis] for values in media())
        layer = Layer(film, 0.0, THICKNESS_NM)
        at = {"wavelength_nm": wavelength_nm}
        return Stack(1.0, [layer], substrate.real.copy(), substrate.imag.copy(), **at)

    values = 2 * WAVELENGTHS * ANGLES
    named = {
        "Rs, Rp": (lambda: reflectances(stack(), incidence), values),
        "R, Rs, Rp, Ts, Tp": (lambda: power(stack(), incidence), values),
        "NumPy closed form": (lambda: numpy_closed_form(theta_i_deg), values),
        "tmm": (lambda: tmm_loop(theta_i_deg), 2 * SLOW * ANGLES),
    }
    installed = {"pystratify": pystratify_computation, "tmm-faster": tmm_faster_computation}
    for name, make in installed.items():
        computation = make(theta_i_deg)
        if computation:
            named[name] = computation, values
    return named


def nanoseconds(computation: Computation, values: int) -> float:
    """Time of the processor for each value."""
    start = time.process_time()
    computation()
    return 1e9 * (time.process_time() - start) / values


def strip() -> float:
    """Seconds of a strip of colors over thickness and angle, the fastest of the rounds."""
    media_ = FilmMedia(Front(1.0), read_layers("1.33", without_thickness=True), Side(1.0 + 0j))
    thickness_nm = np.linspace(0.0, 1000.0, 256)
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 128))
    times = []
    for _ in range(ROUNDS):
        start = time.process_time()
        film_colors(media_, 1, thickness_nm, incidence)
        times.append(time.process_time() - start)
    return min(times)


def main() -> None:
    """Print the times, the ratios, the largest difference and the memory."""
    print(f"colors of a soap film, 256 x 128: {1e3 * strip():.0f} ms (bar: 100 ms)")
    compared = computations()
    rounds = [{name: nanoseconds(*each) for name, each in compared.items()} for _ in range(ROUNDS)]
    print(f"{'':22}{'ns/value':>10}{'ratio':>9}")
    for name in compared:
        ns = min(found[name] for found in rounds)
        ratio = ns / min(found["Rs, Rp"] for found in rounds)
        bar = f"  (bar: {BARS[name]:g}x)" if name in BARS else ""
        print(f"{name:22}{ns:10.1f}{ratio:9.2f}{bar}")
    ours, plain = compared["Rs, Rp"][0](), compared["NumPy closed form"][0]()
    print(
        f"largest difference {max(abs(a - b).max() for a, b in zip(ours, plain, strict=True)):.1e}"
    )
    tracemalloc.start()
    energy = compared["R, Rs, Rp, Ts, Tp"][0]()
    peak = tracemalloc.get_traced_memory()[1]
    print(f"memory {peak / (5 * energy.R.nbytes):.1f} times the answer (bar: 3x)")


if __name__ == "__main__":
    main()
