"""Large arrays, evaluated a piece at a time.

An expression over arrays holds an intermediate result of every step. Over millions of values those
leave the processor's cache and cost more time than the arithmetic, and many times the memory of
the answer; over pieces of `VALUES` they are made in the cache and forgotten there.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import product
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from app.optics.parameters import Array

VALUES = 16384
"""Values of a piece: 128 kB an array, so that those in use lie in a core's second-level cache."""

# Where the media vary, each piece takes hundreds of short calls around Brewster's and the critical
# angle, which costs more than what leaves the cache of larger pieces.
_OF_MANY_MEDIA = 4

# glibc gives back what is freed at the top of its heap, to fetch it again page by page for the next
# intermediate result, unless it has seen larger arrays come and go: let it see one.
np.empty(32 * VALUES)

Block = tuple[slice, ...]
Function = Callable[..., Sequence[NDArray[Any]]]


class Shaped(Protocol):
    """What has a shape."""

    @property
    def shape(self) -> tuple[int, ...]:
        """Lengths along the axes."""


class Arrays(Shaped, Protocol):
    """Arrays that belong together, from each of which the same piece can be picked."""

    def map(self, pick: Callable[[Array], Array]) -> Self:
        """Pick from every array."""


def broadcast(*shaped: Shaped) -> tuple[int, ...]:
    """`np.broadcast_shapes`, at once where no more than one shape is there beside single numbers."""
    shapes = {each.shape for each in shaped} - {()}
    return np.broadcast_shapes(*shapes) if len(shapes) > 1 else next(iter(shapes), ())


def blocks(shape: tuple[int, ...], size: int) -> Iterator[Block]:
    """Cut an array of `shape` into pieces of at most `size`, along its last axes the longest."""
    left, cuts = size, []
    for length in reversed(shape):
        step = max(1, min(length, left))
        cuts.append([slice(start, start + step) for start in range(0, length, step)])
        left //= step
    return product(*reversed(cuts))


def part(block: Block, array: Array) -> Array:
    """The piece of an array that broadcasts to the shape that was cut."""
    own = block[len(block) - array.ndim :]
    return array[
        tuple(s if size > 1 else slice(None) for s, size in zip(own, array.shape, strict=True))
    ]


def in_blocks(
    function: Function,
    media: Arrays,
    directions: Arrays,
    arguments: Mapping[str, Array] | None = None,
    size: int | None = None,
) -> tuple[NDArray[Any], ...]:
    """Evaluate `function(media, directions, **arguments)`, in pieces where it is large.

    Parameters
    ----------
    function
        Works value by value and returns arrays that broadcast against its arguments.
    media, directions, arguments
        They broadcast against each other.
    size
        Values of a piece, where it matters to the function.

    Returns
    -------
    tuple of arrays
        What `function` returns; of the broadcast shape where there was more than one piece.
    """
    arguments = arguments or {}
    shape = broadcast(directions, media, *arguments.values())
    size = size or (VALUES * _OF_MANY_MEDIA if media.shape else VALUES)
    if math.prod(shape) <= size:
        return tuple(function(media, directions, **arguments))
    results: tuple[NDArray[Any], ...] = ()
    for block in blocks(shape, size):
        pick = partial(part, block)
        pieces = function(
            media.map(pick),
            directions.map(pick),
            **{name: pick(array) for name, array in arguments.items()},
        )
        results = results or tuple(np.empty(shape, piece.dtype) for piece in pieces)
        for result, piece in zip(results, pieces, strict=True):
            result[block] = piece
    return results
