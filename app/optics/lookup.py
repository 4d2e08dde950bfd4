r"""Lookup tables: texels of some depth, and how far linear interpolation between them is off.

A table of N texels holds a function at N equally spaced points, both ends included. What a renderer
reads between two of them differs from the function by the bend of the curve over one texel, which
falls by four when N doubles, and by the rounding of the texels. Both are measured together here, not
estimated.
"""

from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.optics.errors import NotAllowed
from app.optics.parameters import Array, Number

Depth = Literal["unorm8", "unorm16", "half", "float"]
"""Integers from 0 to 1 in 8 or 16 bits, or floats of 16 or 32."""

_CANDIDATES = 64
"""Cells with the largest errors that are looked at closely."""

_ROUNDS = 3
_SLACK = 1e-3
_BLOCK = 1 << 19
"""Values in memory together."""


class TableError(NamedTuple):
    """The largest error between the texels, and the coordinates where it is reached.

    `max_abs` is rounded up to three digits, after a thousandth was added for what lies between the
    points that were looked at.
    """

    max_abs: float
    at: tuple[float, ...]


def quantize(values: Array, depth: Depth) -> Array:
    """Round to what a texel of that depth holds.

    Raises
    ------
    NotAllowed
        If an integer texel cannot hold a value: nothing is clamped.
    """
    if depth == "float":
        return values.astype(np.float32).astype(np.float64)
    if depth == "half":
        return values.astype(np.float16).astype(np.float64)
    bits = int(depth.removeprefix("unorm"))
    steps = 2.0**bits - 1.0
    whole = np.rint(values * steps)
    outside = values[(whole < 0.0) | (whole > steps)]
    if outside.size:
        raise NotAllowed("bits", bits, f"32 for values beyond 0 to 1, such as {outside[0]:.6g}")
    return np.asarray(whole / steps)


def texel_coordinate(mu: Number, texels: Number) -> Array:
    """Where a texture over mu is to be sampled, the middles of its outer texels at 0 and 1."""
    return np.asarray((mu * (texels - 1.0) + 0.5) / texels)


def line_error(
    texels: Array, ends: tuple[float, float], function: Callable[[Array], Array]
) -> TableError:
    """Measure the largest error of a table over one coordinate.

    Parameters
    ----------
    texels
        Shape (N, channels), quantized.
    ends
        Coordinates of the first and the last texel.
    function
        What the table stands for: coordinates of any shape to values of that shape and channels.
    """
    low, high = ends
    cells = len(texels) - 1
    per_cell = int(np.clip(16384 // cells, 4, 16))
    fraction = (np.arange(per_cell) + 0.5) / per_cell

    def error(cell: Array, fraction: Array) -> Array:
        at = cell.astype(np.intp)
        left, right = texels[at], texels[at + 1]
        weight = fraction[..., np.newaxis]
        read = (1.0 - weight) * left + weight * right
        true = function(low + (high - low) * (cell + fraction) / cells)
        return np.asarray(np.max(np.abs(read - true), axis=-1))

    number = np.arange(cells, dtype=np.float64)[:, np.newaxis]
    worst = np.max(error(number, np.broadcast_to(fraction, (cells, per_cell))), axis=1)
    cell = _largest(worst)[:, np.newaxis].astype(np.float64)
    start, width = np.zeros_like(cell), np.ones_like(cell)
    steps = np.linspace(0.0, 1.0, 33)
    for _ in range(_ROUNDS):
        inner = start + width * steps
        found = error(np.broadcast_to(cell, inner.shape), inner)
        best = np.argmax(found, axis=1)[:, np.newaxis]
        centre = np.take_along_axis(inner, best, axis=1)
        start, end = _around(centre, width / 32.0)
        width = end - start
    top = int(np.argmax(np.max(found, axis=1)))
    place = low + (high - low) * float(cell[top, 0] + centre[top, 0]) / cells
    return TableError(_rounded_up(float(np.max(found))), (place,))


def sheet_error(
    texels: Array,
    ends: tuple[tuple[float, float], tuple[float, float]],
    function: Callable[[Array, Array], Array],
) -> TableError:
    """Measure the largest error of a table over two coordinates, read bilinearly.

    Parameters
    ----------
    texels
        Shape (rows, N, channels), quantized; y runs over the rows, x along them.
    ends
        First and last x, first and last y.
    function
        What the table stands for: `function(x, y)`, which broadcast, with channels as a last axis.
    """
    rows, columns = texels.shape[0] - 1, texels.shape[1] - 1
    (x_low, x_high), (y_low, y_high) = ends
    fraction = (np.arange(4) + 0.5) / 4
    x_cell, x_fraction = np.repeat(np.arange(columns), 4), np.tile(fraction, columns)
    along = _mixed(texels[:, x_cell], texels[:, x_cell + 1], x_fraction)
    x = x_low + (x_high - x_low) * (x_cell + x_fraction) / columns
    worst = np.empty((rows, columns))
    at_once = max(1, _BLOCK // along[0].size // 4)
    for first in range(0, rows, at_once):
        some = np.arange(first, min(first + at_once, rows))
        y_cell, y_fraction = np.repeat(some, 4), np.tile(fraction, some.size)
        read = _mixed(along[y_cell], along[y_cell + 1], y_fraction[:, np.newaxis])
        y = y_low + (y_high - y_low) * (y_cell + y_fraction) / rows
        off = np.max(np.abs(read - function(x, y[:, np.newaxis])), axis=-1)
        worst[some] = off.reshape(some.size, 4, columns, 4).max(axis=(1, 3))
    best = _largest(worst.ravel())
    j, i = (part[:, np.newaxis, np.newaxis] for part in np.unravel_index(best, worst.shape))
    x_start, y_start = np.zeros(i.shape), np.zeros(j.shape)
    x_width, y_width = np.ones(i.shape), np.ones(j.shape)
    steps = np.linspace(0.0, 1.0, 9)
    for _ in range(_ROUNDS):
        u, v = x_start + x_width * steps, y_start + y_width * steps[:, np.newaxis]
        below = _mixed(texels[j, i], texels[j, i + 1], u)
        above = _mixed(texels[j + 1, i], texels[j + 1, i + 1], u)
        read = _mixed(below, above, v)
        true = function(
            x_low + (x_high - x_low) * (i + u) / columns, y_low + (y_high - y_low) * (j + v) / rows
        )
        found = np.max(np.abs(read - true), axis=-1).reshape(best.size, -1)
        at_v, at_u = np.divmod(np.argmax(found, axis=1), 9)
        centre_u = np.take_along_axis(u[:, 0], at_u[:, np.newaxis], axis=1)[..., np.newaxis]
        centre_v = np.take_along_axis(v[..., 0], at_v[:, np.newaxis], axis=1)[..., np.newaxis]
        x_start, x_end = _around(centre_u, x_width / 8.0)
        y_start, y_end = _around(centre_v, y_width / 8.0)
        x_width, y_width = x_end - x_start, y_end - y_start
    top = int(np.argmax(np.max(found, axis=1)))
    place = (
        x_low + (x_high - x_low) * float(i[top, 0, 0] + centre_u[top, 0, 0]) / columns,
        y_low + (y_high - y_low) * float(j[top, 0, 0] + centre_v[top, 0, 0]) / rows,
    )
    return TableError(_rounded_up(float(np.max(found))), place)


def _mixed(left: Array, right: Array, fraction: Array) -> Array:
    """Interpolate linearly; channels are the last axis of the texels."""
    weight = fraction[..., np.newaxis]
    return np.asarray((1.0 - weight) * left + weight * right)


def _largest(worst: Array) -> NDArray[np.intp]:
    """Indices of the largest few."""
    count = min(_CANDIDATES, worst.size)
    return np.argpartition(worst, worst.size - count)[worst.size - count :]


def _around(centre: Array, step: Array) -> tuple[Array, Array]:
    """Ends of the interval between the neighbors of a point, kept inside the cell."""
    return np.maximum(centre - step, 0.0), np.minimum(centre + step, 1.0)


def _rounded_up(value: float) -> float:
    """Three digits, never less than the value and a thousandth."""
    if value == 0.0:
        return 0.0
    value *= 1.0 + _SLACK
    unit = 10.0 ** (np.floor(np.log10(value)) - 2.0)
    return float(f"{np.ceil(value / unit) * unit:.3g}")
