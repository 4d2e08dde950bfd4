"""The index whose exact curve comes closest to a given one over the hemisphere.

A reflectance integrated over a band of wavelengths is no boundary's, but some boundary's curve lies
within a thousandth of it. An engine that evaluates Fresnel's equations from one n and k a channel does
its best with that pair, and not with the constants at some wavelength or their mean.
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from app.optics.amplitudes import reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.quadrature import Rule, gauss_legendre
from app.optics.parameters import Array, Parameter

FITTED_N = Parameter("n", "n", 1.5, 0.01, 100.0, "", "n of a fitted index.")
FITTED_K = Parameter("k", "k", 0.0, 0.0, 100.0, "", "k of a fitted index.")
"""What a fitted index may be: every engine takes it, and a metal of n = 0.01 is a mirror."""

_NODES = 32
_SMALLEST_STEP = 0.1
_BETTER = 0.5
"""How much less a node of the grid must cost than what was found to be worth a search of its own."""


class FittedIndex(NamedTuple):
    """An index, and the error that is left."""

    n: float
    k: float
    rms: float
    """Root mean square over the hemisphere, each solid angle alike."""


def fitting_nodes() -> Rule:
    """Cosines at which `fit_index` wants the curve, and their weights over the hemisphere."""
    return gauss_legendre(_NODES)


def fit_index(R: Array, start: tuple[float, float], transparent: bool = False) -> FittedIndex:
    r"""Fit the index of a boundary with vacuum to a curve.

    .. math:: \min_{n, k} \int_0^1 (R(\mu; n, k) - R(\mu))^2 \, d\mu

    Searched from `start` by Levenberg and Marquardt's method; should a node of a coarse grid of all
    indices cost less than half of what that finds, also from there.

    Parameters
    ----------
    R
        Reflectance at the cosines of `fitting_nodes`.
    start
        n and k that are not far off.
    transparent
        Whether k is to be 0.

    Returns
    -------
    FittedIndex
        Within `FITTED_N` and `FITTED_K`.
    """
    rule = fitting_nodes()
    root = np.sqrt(rule.w)

    def index(x: Array) -> tuple[float, float]:
        n = float(np.clip(np.exp(x[0]), FITTED_N.minimum, FITTED_N.maximum))
        return n, 0.0 if transparent else min(abs(float(x[1])), FITTED_K.maximum)

    def residual(x: Array) -> Array:
        return np.asarray((reflectance(Interface(1.0, *index(x)), _incidence()) - R) * root)

    def search(n: float, k: float) -> tuple[float, Array]:
        # R is even in k, so that its bound at 0 needs no other care than not to start there.
        unknown = [np.log(n)] if transparent else [np.log(n), max(k, 1e-2)]
        scale = [1.0] if transparent else [1.0, max(k, _SMALLEST_STEP)]
        found = least_squares(residual, unknown, method="lm", xtol=1e-9, ftol=1e-9, x_scale=scale)
        return 2.0 * float(found.cost), np.asarray(found.x)

    best, x = search(*start)
    n, k, curves = _grid(transparent)
    costs = (curves - R) ** 2 @ rule.w
    nearest = int(np.argmin(costs))
    if costs[nearest] < _BETTER * best:
        best, x = min((best, x), search(n[nearest], k[nearest]), key=lambda found: found[0])
    return FittedIndex(*index(x), float(np.sqrt(best)))


@cache
def _incidence() -> Incidence:
    return Incidence.from_cosine(fitting_nodes().x)


@cache
def _grid(transparent: bool) -> tuple[Array, Array, Array]:
    """Indices all over the plane, flat, and their curves."""
    along_n = np.geomspace(FITTED_N.minimum, 20.0, 48)
    along_k = np.zeros(1) if transparent else np.geomspace(0.02, 30.0, 48)
    n, k = (a.ravel() for a in np.meshgrid(along_n, along_k))
    return n, k, reflectance(Interface(1.0, n[:, np.newaxis], k[:, np.newaxis]), _incidence())
