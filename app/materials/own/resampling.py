"""As few points as keep a curve: those of the curve itself between which a line is close enough."""

import numpy as np
from numpy.typing import NDArray

from app.optics.parameters import Array

_ONE_BY_ONE = 32
"""Points that are looked at one by one before NumPy looks at many: most lines end sooner."""


def kept(x: Array, curves: Array, tolerance: Array, most: int) -> NDArray[np.intp] | None:
    """Choose points that linear interpolation leads through all others within a tolerance.

    From each point the farthest one is taken to which a line passes all points between. What the
    lines miss is largest at a point of the curve, as both are straight between.

    Parameters
    ----------
    x
        Rising strictly, shape (n,).
    curves
        One row a curve, shape (m, n).
    tolerance
        How far a line may be from each point, of the shape of `curves`.
    most
        Points beyond which it is given up.

    Returns
    -------
    NDArray
        Indices of the points, both ends among them; None if they are more than `most`.
    """
    reach = _Reach(x, curves, tolerance)
    chosen = [0]
    while chosen[-1] < x.size - 1:
        if len(chosen) >= most:
            return None
        chosen.append(reach.of(chosen[-1]))
    return np.array(chosen, dtype=np.intp)


class _Reach:
    """Curves, and how far a line from a point of them reaches past all points between."""

    def __init__(self, x: Array, curves: Array, tolerance: Array) -> None:
        self._x = x
        self._arrays = curves, curves - tolerance, curves + tolerance
        self._xs = x.tolist()
        self._rows = [
            tuple(array[row].tolist() for array in self._arrays) for row in range(len(curves))
        ]

    def of(self, start: int) -> int:
        """The farthest point that lines of all curves reach."""
        xs, origin = self._xs, self._xs[start]
        near = min(start + 1 + _ONE_BY_ONE, len(xs))
        bounds = [(-np.inf, np.inf)] * len(self._rows)
        end = start + 1
        for index in range(start + 1, near):
            distance = xs[index] - origin
            met = True
            for row, (values, lows, highs) in enumerate(self._rows):
                at = values[start]
                lowest, highest = bounds[row]
                met = met and lowest <= (values[index] - at) / distance <= highest
                lowest = max(lowest, (lows[index] - at) / distance)
                highest = min(highest, (highs[index] - at) / distance)
                if lowest > highest:
                    return index if met else end
                bounds[row] = lowest, highest
            if met:
                end = index
        return self._of_many(start, near, end, np.array(bounds).T[:, :, np.newaxis])

    def _of_many(self, start: int, near: int, end: int, bounds: Array) -> int:
        """The same from the point `near` on, for growing numbers of points at a time."""
        size = 4 * _ONE_BY_ONE
        lowest, highest = bounds
        while near < self._x.size:
            part = slice(near, near + size)
            distances = self._x[part] - self._x[start]
            at = self._arrays[0][:, start, np.newaxis]
            slopes, low, high = ((array[:, part] - at) / distances for array in self._arrays)
            # The bounds that a point meets are those of all before it.
            lower = np.maximum.accumulate(np.concatenate([lowest, low], axis=1), axis=1)
            upper = np.minimum.accumulate(np.concatenate([highest, high], axis=1), axis=1)
            is_open = np.all(lower <= upper, axis=0)
            met = np.all((lower[:, :-1] <= slopes) & (slopes <= upper[:, :-1]), axis=0)
            reached = np.flatnonzero(met & is_open[:-1])
            if reached.size:
                end = near + int(reached[-1])
            if not is_open[-1]:
                return end
            lowest, highest = lower[:, -1:], upper[:, -1:]
            near, size = near + size, 4 * size
        return end


def means(x: Array, curves: Array, count: int) -> tuple[Array, Array]:
    """Means of neighbors, where there are too many points and too noisy ones; both ends stay.

    Returns
    -------
    tuple
        About `count` abscissae and the curves there.
    """
    edges = np.unique(np.linspace(0, x.size, count + 1).astype(np.intp))[:-1]
    sizes = np.diff(edges, append=x.size)
    nodes = np.add.reduceat(x, edges) / sizes
    averaged = np.add.reduceat(curves, edges, axis=1) / sizes
    inside = (nodes > x[0]) & (nodes < x[-1])
    nodes = np.concatenate([x[:1], nodes[inside], x[-1:]])
    ends = curves[:, :1], curves[:, -1:]
    return nodes, np.concatenate([ends[0], averaged[:, inside], ends[1]], axis=1)
