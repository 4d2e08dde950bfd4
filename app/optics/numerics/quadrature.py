"""Rules of quadrature from 0 to 1.

References
----------
.. [1] H. Takahasi and M. Mori, Double Exponential Formulas for Numerical Integration, Publ. RIMS
   Kyoto Univ. 9, 721-741 (1974).
.. [2] A. Sidi, A New Variable Transformation for Numerical Integration, ISNM 112, 359-373 (1993).
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from app.optics.parameters import Array


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


def whole(rule: Rule) -> Nodes:
    """Nodes over mu from 0 to 1 in one interval, the same for every interface."""
    ends = np.concatenate([[0.0], rule.x, [1.0]]), np.concatenate([[0.0], rule.w, [0.0]])
    return Nodes(*ends)
