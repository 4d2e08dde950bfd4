"""Albedos in 35-digit arithmetic: Fresnel's textbook quotients, summed over sin^2(theta_i).

The interval is cut at the critical angle, and each piece into panels that shrink toward both of its
ends (equal steps of the logarithm of t / (1 - t)), on which Gauss-Legendre's rule is exact to more
digits than are compared. Squared cosines are sums of positive terms, so no digit is lost anywhere.

`python -m tests.optics.reference.albedo` writes albedo_points.json.
"""

import json
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

import numpy as np
from mpmath import mp, mpc, mpf

DIGITS = 35
_ORDER, _REACH, _PANEL = 14, 100, mpf("1.25")

POINTS = Path(__file__).with_name("albedo_points.json")
CORNERS = [
    (1.0, 1.0 + 1e-12, 0.0),
    (1.0, 1.0001, 0.0),
    (1.0, 1.24999, 0.0),
    (1.0, 1.25001, 0.0),
    (2.3, 2.3 * 1.8571, 0.0),
    (1.0, 100.0, 0.0),
    (1.0, 1e-3, 0.0),
    (1.0, 1.0 - 1e-9, 0.0),
    (1.5, 1.5 * 0.79999, 0.0),
    (3.0, 1e-3, 0.0),
    (1e-3, 100.0, 0.0),
    (100.0, 1e-3, 0.0),
    (100.0, 1e-3, 1e-3),
    (1e-3, 100.0, 1e-3),
    (1.0, 1.0, 1e-15),
    (1.0, 1.0, 1e-3),
    (1.0, 1.0, 100.0),
    (1.0, 1.0 + 1e-9, 1e-9),
    (1.0, 1.0 - 1e-9, 1e-9),
    (1.0, 1.0 - 1e-9, 0.5),
    (1.0, 1e-3, 1e-3),
    (1.0, 1e-3, 1e-7),
    (1.0, 1e-3, 0.999),
    (1.0, 1e-3, 1.001),
    (1.0, 1e-3, 100.0),
    (1.0, 100.0, 1e-12),
    (1.0, 100.0, 100.0),
    (1.0, 0.5, 1e-16),
    (1.0, 0.999, 1e-300),
    (3.0, 2.0, 1e-5),
    (1.7, 0.2, 1.69),
]


@dataclass(frozen=True)
class Reference:
    """Albedos rounded to doubles; `flatland` is unpolarized."""

    s: float
    p: float
    unpolarized: float
    flatland: float


def albedo(n_i: float, n_t: float, k_t: float) -> Reference:
    """Integrate one interface."""
    with mp.workdps(DIGITS):
        eta, kappa = mpf(n_t) / mpf(n_i), mpf(k_t) / mpf(n_i)
        square = mpc(eta, kappa) ** 2
        contrast = (mpf(n_t) - mpf(n_i)) / mpf(n_i) * (eta + 1)  # eta^2 - 1
        absorption = mpc(-(kappa**2), 2 * eta * kappa)  # N^2 - eta^2
        total = [mpf(0)] * 4
        for t, u, weight in _nodes():  # u = 1 - t
            if eta < 1:
                pieces = [
                    (eta**2 * t, -contrast + eta**2 * u, eta**2 * u, eta**2),
                    (eta**2 - contrast * t, -contrast * u, contrast * t, -contrast),
                ]
            else:
                pieces = [(t, u, contrast + u, mpf(1))]
            for sin2, cos2, above, width in pieces:
                cos, q = mp.sqrt(cos2), mp.sqrt(above + absorption)
                Rs = abs((cos - q) / (cos + q)) ** 2
                Rp = abs((square * cos - q) / (square * cos + q)) ** 2
                w = weight * width
                flat = w / (2 * mp.sqrt(sin2))
                terms = (Rs * w, Rp * w, Rs * flat, Rp * flat)
                total = [a + b for a, b in zip(total, terms, strict=True)]
        s, p, flat_s, flat_p = total
        return Reference(float(s), float(p), float((s + p) / 2), float((flat_s + flat_p) / 2))


@cache
def _nodes() -> list[tuple[mpf, mpf, mpf]]:
    """t, 1 - t and weight of the rule on 0 to 1."""
    with mp.workdps(DIGITS):
        nodes = []
        panels = int(2 * _REACH / _PANEL)
        for panel in range(panels):
            middle = -_REACH + (panel + mpf(1) / 2) * _PANEL
            for x, w in _gauss_legendre(_ORDER):
                e = mp.exp(-(middle + x * _PANEL / 2))
                t, u = 1 / (1 + e), e / (1 + e)
                nodes.append((t, u, t * u * w * _PANEL / 2))
        return nodes


def _gauss_legendre(order: int) -> list[tuple[mpf, mpf]]:
    roots = []
    for j in range(order):
        x = mp.cos(mp.pi * (j + mpf(3) / 4) / (order + mpf(1) / 2))
        for _ in range(8):
            x -= mp.legendre(order, x) / _slope(order, x)
        roots.append((x, 2 / ((1 - x * x) * _slope(order, x) ** 2)))
    return roots


def _slope(order: int, x: mpf) -> mpf:
    return order * (x * mp.legendre(order, x) - mp.legendre(order - 1, x)) / (x * x - 1)


def _random_points(count: int) -> list[tuple[float, float, float]]:
    """Indices all over the range, half of them nearly matched, half of them nearly clear."""
    random = np.random.default_rng(20240501)
    points = []
    for _ in range(count):
        n_i, n_t, k_t = random.uniform(1.0, 3.0), *10.0 ** random.uniform([-3.0, -3.0], 2.0)
        if random.random() < 0.5:
            n_t = n_i * (1.0 + random.choice([-1.0, 1.0]) * 10.0 ** random.uniform(-10.0, -0.5))
        if random.random() < 0.5:
            k_t = 10.0 ** random.uniform(-14.0, 0.0)
        clear = random.random() < 0.25
        points.append((float(n_i), float(n_t), 0.0 if clear else float(k_t)))
    return points


if __name__ == "__main__":
    points = CORNERS + _random_points(200)
    rows = [
        json.dumps({"n_i": p[0], "n_t": p[1], "k_t": p[2]} | asdict(albedo(*p))) for p in points
    ]
    POINTS.write_text("[\n" + ",\n".join(rows) + "\n]\n", "utf-8")
