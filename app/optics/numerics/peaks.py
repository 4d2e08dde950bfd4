"""The largest modulus of many curves at once, sought between the nodes they were sampled at.

References
----------
.. [1] J.-P. Berrut and L. N. Trefethen, Barycentric Lagrange Interpolation, SIAM Review 46, 501-517
   (2004).
"""

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.optics.parameters import Array

_HILLS = 3
_SUMMITS, _DIVISIONS, _ACROSS = 8, 16, 7
_STILL = 1.001  # a modulus that still grows by more when it should stand is that of a pole
_DENSE = 61
# A product of so few rows is too small for BLAS to wake its threads, which would cost more.
_ROWS = 256


class Peaks(NamedTuple):
    """Value of largest modulus of each curve, and where it is."""

    value: Array
    at: Array


def largest(
    function: Callable[[Array], Array], x: Array, y: Array, points: int, rounds: int
) -> Peaks:
    """Find the value of largest modulus of every curve, near its largest samples.

    Parameters
    ----------
    function
        Values at abscissas of shape (curves, any), of the same shape.
    x
        Ascending nodes, shape (nodes,) or (curves, nodes).
    y
        Values there, shape (curves, nodes).
    points, rounds
        The interval between the neighbors of each of the largest samples is divided so many times by
        so many points; a parabola through the last three has the last word.

    Returns
    -------
    Peaks
        Shape (curves,) each; never less than the samples, NaN counting as 0.
    """
    # Peaks of nearly the same height compete, and which is higher the samples may not tell.
    best = _hills(np.abs(y))[..., np.newaxis]
    triple = np.clip(best + np.arange(-1, 2), 0, y.shape[1] - 1)
    rows = np.arange(len(y))[:, np.newaxis, np.newaxis]
    xs = x[triple] if x.ndim == 1 else x[rows, triple]
    ys = y[rows, triple]
    top = Peaks(ys[..., 1], xs[..., 1])
    fractions = np.arange(1, points + 1) / (points + 1)
    for _ in range(rounds):
        inner = xs[..., :1] + (xs[..., 2:] - xs[..., :1]) * fractions
        values = _finite(function(inner.reshape(len(y), -1))).reshape(inner.shape)
        at = np.argmax(np.abs(values), axis=-1)[..., np.newaxis]
        triple = at + np.arange(3)
        xs = np.take_along_axis(
            np.concatenate([xs[..., :1], inner, xs[..., 2:]], axis=-1), triple, axis=-1
        )
        ys = np.take_along_axis(
            np.concatenate([ys[..., :1], values, ys[..., 2:]], axis=-1), triple, axis=-1
        )
        top = _larger(top, Peaks(ys[..., 1], xs[..., 1]))
    vertex = _vertex(xs, np.abs(ys))
    top = _larger(top, Peaks(_finite(function(vertex)), vertex))
    highest = np.argmax(np.abs(top.value), axis=1)[:, np.newaxis]
    value, at = (np.take_along_axis(part, highest, axis=1)[:, 0] for part in top)
    return Peaks(value, at)


def _hills(heights: Array) -> NDArray[np.intp]:
    """Indices of the samples that no neighbor exceeds, the `_HILLS` highest of each curve.

    A plateau is one hill, by its first sample, or it would hide all others: of total reflection, say.
    """
    padded = np.pad(heights, ((0, 0), (1, 1)), constant_values=-1.0)
    hill = (heights > padded[:, :-2]) & (heights >= padded[:, 2:])
    return np.argsort(np.where(hill, -heights, 1.0), axis=1, kind="stable")[:, :_HILLS]


SUMMIT_VALUES = 48**2 + _SUMMITS * _DIVISIONS * _ACROSS**2
"""Values that `summit` asks for at most."""


class Summit(NamedTuple):
    """Value of largest modulus over a rectangle, and where it is."""

    value: float
    x: float
    y: float


def summit(
    function: Callable[[Array, Array], Array], x: tuple[float, float], y: tuple[float, float]
) -> Summit | None:
    """Find the value of largest modulus over a rectangle.

    The rectangle is sampled, more densely toward its lower ends, and around the highest samples it is
    divided again and again.

    Parameters
    ----------
    function
        Values at x and y of one shape, of that shape; NaN and infinite where it has none.
    x, y
        Ends of the sides, included.

    Returns
    -------
    Summit or None
        None where the function has no value, or grows without bound.
    """
    sides = [_dense_at_the_low_end(*x), _dense_at_the_low_end(*y)]
    height = _heights(function(*np.meshgrid(*sides)))
    rows, columns = height.shape
    padded = np.pad(height, 1, constant_values=-1.0)
    around = [padded[i : i + rows, j : j + columns] for i in range(3) for j in range(3)]
    hills = np.flatnonzero((height >= np.max(around, axis=0)) & (height >= 0.0))
    if hills.size == 0:
        return None
    hills = hills[np.argsort(-height.ravel()[hills], kind="stable")][:_SUMMITS]
    row, column = np.unravel_index(hills, height.shape)
    at_x, at_y = sides[0][column], sides[1][row]
    reach_x, reach_y = _steps(sides[0])[column], _steps(sides[1])[row]
    offsets = np.linspace(-1.0, 1.0, _ACROSS)
    dx, dy = (offset.ravel() for offset in np.meshgrid(offsets, offsets))
    tops: list[Summit] = []
    for _ in range(_DIVISIONS):
        near_x = np.clip(at_x[:, np.newaxis] + reach_x[:, np.newaxis] * dx, *x)
        near_y = np.clip(at_y[:, np.newaxis] + reach_y[:, np.newaxis] * dy, *y)
        values = function(near_x, near_y)
        height = _heights(values)
        top = np.arange(len(hills)), np.argmax(height, axis=1)
        at_x, at_y = near_x[top], near_y[top]
        reach_x, reach_y = reach_x * (3.0 / _ACROSS), reach_y * (3.0 / _ACROSS)
        best = int(np.argmax(height[top]))
        tops.append(Summit(float(values[top][best]), float(at_x[best]), float(at_y[best])))
    grown = abs(tops[-1].value) > _STILL * abs(tops[-1 - _DIVISIONS // 4].value)
    return None if grown else tops[-1]


def _heights(values: Array) -> Array:
    """Moduli, -1 where there is none."""
    return np.nan_to_num(np.abs(values), nan=-1.0, posinf=-1.0)


def _steps(side: Array) -> Array:
    """Width of a side's samples."""
    return np.gradient(side) if side.size > 1 else np.zeros(1)


def _dense_at_the_low_end(low: float, high: float) -> Array:
    if low == high:
        return np.array([low])
    shares = np.union1d(np.linspace(0.0, 1.0, 33), np.geomspace(1e-5, 1.0, 16))
    return np.minimum(low + (high - low) * shares, high)


@cache
def _dense(nodes: tuple[float, ...]) -> tuple[Array, Array]:
    """Abscissas spread evenly, and the matrix that takes values at the nodes there [1]_."""
    x = np.array(nodes)
    gaps = x[:, np.newaxis] - x
    np.fill_diagonal(gaps, 1.0)
    weights = 1.0 / np.prod(gaps, axis=1)
    at = np.linspace(x[0], x[-1], _DENSE)
    apart = at[:, np.newaxis] - x
    hit = apart == 0.0
    with np.errstate(divide="ignore"):
        terms = weights / apart
    terms[hit.any(axis=1)] = hit[hit.any(axis=1)]  # on a node only its own value counts
    return at, np.asarray(terms / terms.sum(axis=1, keepdims=True)).T


def largest_of_smooth(x: Array, y: Array) -> Peaks:
    """Value of largest modulus of the polynomials through the samples.

    Parameters
    ----------
    x
        Ascending nodes that crowd toward both ends, shape (nodes,), the same for every curve.
    y
        Values there, shape (curves, nodes), of curves that the polynomial follows.
    """
    at, matrix = _dense(tuple(x.tolist()))
    values = np.concatenate([y[i : i + _ROWS] @ matrix for i in range(0, len(y), _ROWS)])
    best = np.argmax(np.abs(values), axis=1)
    rows, inner = np.arange(len(y)), np.clip(best, 1, _DENSE - 2)
    low, middle, high = (values[rows, inner + step] for step in (-1, 0, 1))
    with np.errstate(invalid="ignore", divide="ignore"):
        shift = 0.5 * (low - high) / (low - 2.0 * middle + high)
    # A parabola with its vertex elsewhere is no peak: then one of the ends is the largest.
    shift = np.where((best == inner) & (np.abs(shift) <= 1.0), shift, (best - inner).astype(float))
    peak = middle + 0.5 * shift * (high - low) + 0.5 * shift**2 * (low - 2.0 * middle + high)
    return Peaks(peak, at[inner] + shift * (at[1] - at[0]))


def _finite(values: Array) -> Array:
    """NaN as 0; infinities stay, as a relative error may be one."""
    return np.nan_to_num(values, nan=0.0, posinf=np.inf, neginf=-np.inf)


def _larger(a: Peaks, b: Peaks) -> Peaks:
    b_wins = np.abs(b.value) > np.abs(a.value)
    return Peaks(np.where(b_wins, b.value, a.value), np.where(b_wins, b.at, a.at))


def _vertex(x: Array, y: Array) -> Array:
    """Abscissa of the vertex of the parabola through three points, kept between the outer two."""
    left, right = x[..., 1] - x[..., 0], x[..., 2] - x[..., 1]
    with np.errstate(invalid="ignore", divide="ignore"):
        fall_left, fall_right = (y[..., 1] - y[..., 0]) / left, (y[..., 1] - y[..., 2]) / right
        shift = 0.5 * (left * fall_right - right * fall_left) / (fall_left + fall_right)
    shift = np.where(np.isfinite(shift), shift, 0.0)
    return np.clip(x[..., 1] - shift, x[..., 0], x[..., 2])
