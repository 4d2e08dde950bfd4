"""The largest modulus of many curves at once, sought between the nodes they were sampled at."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from app.optics.parameters import Array


class Peaks(NamedTuple):
    """Value of largest modulus of each curve, and where it is."""

    value: Array
    at: Array


def largest(
    function: Callable[[Array], Array], x: Array, y: Array, points: int, rounds: int
) -> Peaks:
    """Find the value of largest modulus of every curve, near its largest sample.

    Parameters
    ----------
    function
        Values at abscissas of shape (curves, any), of the same shape.
    x
        Ascending nodes, shape (nodes,) or (curves, nodes).
    y
        Values there, shape (curves, nodes).
    points, rounds
        The interval between the neighbors of the largest sample is divided so many times by so many
        points; a parabola through the last three has the last word.

    Returns
    -------
    Peaks
        Shape (curves,) each; never less than the samples, NaN counting as 0.
    """
    best = np.argmax(np.abs(y), axis=1)[:, np.newaxis]
    triple = np.clip(best + np.arange(-1, 2), 0, y.shape[1] - 1)
    xs = x[triple] if x.ndim == 1 else np.take_along_axis(x, triple, axis=1)
    ys = np.take_along_axis(y, triple, axis=1)
    top = Peaks(ys[:, 1], xs[:, 1])
    fractions = np.arange(1, points + 1) / (points + 1)
    for _ in range(rounds):
        inner = xs[:, :1] + (xs[:, 2:] - xs[:, :1]) * fractions
        values = _finite(function(inner))
        at = np.argmax(np.abs(values), axis=1)[:, np.newaxis]
        triple = at + np.arange(3)
        xs = np.take_along_axis(np.hstack([xs[:, :1], inner, xs[:, 2:]]), triple, axis=1)
        ys = np.take_along_axis(np.hstack([ys[:, :1], values, ys[:, 2:]]), triple, axis=1)
        top = _larger(top, Peaks(ys[:, 1], xs[:, 1]))
    vertex = _vertex(xs, np.abs(ys))
    return _larger(top, Peaks(_finite(function(vertex[:, np.newaxis]))[:, 0], vertex))


def _finite(values: Array) -> Array:
    """NaN as 0; infinities stay, as a relative error may be one."""
    return np.nan_to_num(values, nan=0.0, posinf=np.inf, neginf=-np.inf)


def _larger(a: Peaks, b: Peaks) -> Peaks:
    b_wins = np.abs(b.value) > np.abs(a.value)
    return Peaks(np.where(b_wins, b.value, a.value), np.where(b_wins, b.at, a.at))


def _vertex(x: Array, y: Array) -> Array:
    """Abscissa of the vertex of the parabola through three points, kept between the outer two."""
    left, right = x[:, 1] - x[:, 0], x[:, 2] - x[:, 1]
    with np.errstate(invalid="ignore", divide="ignore"):
        fall_left, fall_right = (y[:, 1] - y[:, 0]) / left, (y[:, 1] - y[:, 2]) / right
        shift = 0.5 * (left * fall_right - right * fall_left) / (fall_left + fall_right)
    shift = np.where(np.isfinite(shift), shift, 0.0)
    return np.clip(x[:, 1] - shift, x[:, 0], x[:, 2])
