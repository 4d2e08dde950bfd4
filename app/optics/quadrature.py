r"""Integrals over the hemisphere by cos(theta_i), split where the exact curve bends sharply.

The exact R has its branch point where q = sqrt(N^2 - 1 + mu^2) vanishes, at
mu = sqrt(1 - N^2). Its real part is the cosine of the critical angle without absorption and of the
angle where R turns up with weak absorption. Each interval is integrated by a rule whose nodes crowd
toward both of its ends, so that neither the square root there nor a pole just outside costs digits.

References
----------
.. [1] H. Takahasi and M. Mori, Double Exponential Formulas for Numerical Integration, Publ. RIMS
   Kyoto Univ. 9, 721-741 (1974).
.. [2] A. Sidi, A New Variable Transformation for Numerical Integration, ISNM 112, 359-373 (1993).
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.optics.amplitudes import Wave, wave
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array

# Where no branch point lies within 0 and 1, the interval is split here all the same: half of what
# happens, happens close to grazing incidence.
_SPLIT = 0.3
_MARGIN = 1e-9

# With these distances 14 nodes integrate Schlick's squared error to 4e-7 over d'Eon's ranges.
_FAR, _BESIDE = 0.5, 0.1


class Rule(NamedTuple):
    """Nodes within 0 and 1, ascending, and their weights."""

    x: Array
    w: Array


class Nodes(NamedTuple):
    """Cosines, ascending along the last axis, and weights of an integral over them from 0 to 1.

    Shape (nodes,) where they are the same for every interface. The ends of the intervals are among
    them with weight 0, as candidates for an extremum.
    """

    mu: Array
    w: Array


@cache
def double_exponential(step: float = 0.07, reach: float = 3.1) -> Rule:
    """Takahasi and Mori's rule [1]_; with these defaults good to the last digits."""
    count = round(reach / step)
    t = step * np.arange(-count, count + 1)
    u = np.exp(np.pi * np.sinh(t))
    x = u / (1.0 + u)
    return Rule(x, step * np.pi * np.cosh(t) * x / (1.0 + u))


@cache
def gauss_legendre(count: int) -> Rule:
    """Gauss and Legendre's rule, for short intervals where the curve is a parabola."""
    v, w = np.polynomial.legendre.leggauss(count)
    return Rule(0.5 * (v + 1.0), 0.5 * w)


@cache
def root_gauss_legendre(count: int) -> Rule:
    """Gauss and Legendre's rule in sqrt(x), which looks closely at the lower end."""
    v, w = gauss_legendre(count)
    return Rule(v * v, 2.0 * v * w)


@cache
def crowded_gauss_legendre(count: int) -> Rule:
    """Gauss and Legendre's rule after a substitution that crowds the nodes toward the ends [2]_."""
    v, w = gauss_legendre(count)
    low, high = v * v, (1.0 - v) ** 2
    return Rule(low / (low + high), w * 2.0 * v * (1.0 - v) / (low + high) ** 2)


def branch_cosine(interface: Interface) -> Array:
    """Real part of mu where q vanishes, |Re sqrt(1 - N^2)|, of the interface's shape."""
    return _grazing(interface).b


def bends_gently(interface: Interface) -> NDArray[np.bool_]:
    """Where the branch point is so far from 0 < mu < 1 that one interval will do."""
    q = _grazing(interface)  # Im q is the real and Re q the imaginary part of the branch point
    return np.asarray((q.a > _FAR) | (q.b > 1.0 + _BESIDE))


def _grazing(interface: Interface) -> Wave:
    return wave(interface, Incidence(np.zeros(()), np.ones(())))


def whole(rule: Rule) -> Nodes:
    """Nodes over mu from 0 to 1 in one interval, the same for every interface."""
    ends = np.concatenate([[0.0], rule.x, [1.0]]), np.concatenate([[0.0], rule.w, [0.0]])
    return Nodes(*ends)


def hemisphere(interface: Interface, rule: Rule, kinks: Array | None = None) -> Nodes:
    """Nodes and weights over mu from 0 to 1.

    Parameters
    ----------
    interface
        Boundaries of any shape.
    rule
        Used in each interval.
    kinks
        Cosines, one-dimensional, where intervals have to end besides.

    Returns
    -------
    Nodes
        Of the interface's shape with one more axis.
    """
    branch = branch_cosine(interface)
    inside = (branch > _MARGIN) & (branch < 1.0 - _MARGIN)
    split = np.where(inside, branch, _SPLIT)[..., np.newaxis]
    fixed = np.concatenate([[0.0, 1.0], [] if kinks is None else kinks])
    parts = [np.broadcast_to(fixed, (*branch.shape, fixed.size)), split]
    edges = np.sort(np.concatenate(parts, axis=-1), axis=-1)
    low, width = edges[..., :-1, np.newaxis], np.diff(edges, axis=-1)[..., np.newaxis]
    x, w = np.concatenate([[0.0], rule.x]), np.concatenate([[0.0], rule.w])
    shape = (*branch.shape, -1)
    mu, weights = (low + width * x).reshape(shape), (width * w).reshape(shape)
    end = np.ones((*branch.shape, 1))
    return Nodes(np.concatenate([mu, end], axis=-1), np.concatenate([weights, 0.0 * end], axis=-1))
