"""What both kinds of body are made into: pieces of rows, with the item that each row is of."""

from collections.abc import Callable, Iterator
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from app.batch.rows import Index, Rows

MOST_VALUES = 1_000_000
"""Values that one call may ask for."""


MOST_TOLD = 100
"""Items that are wrong and told in full; the others are counted."""


class TooManyValues(Exception):
    """A body that asks for more than `MOST_VALUES`."""


class Piece(NamedTuple):
    """Some of the items, in order."""

    first: int
    """Number of the first item, from 0."""
    rows: Rows
    """One row a value."""
    counts: Index
    """Values of each item."""
    listed: NDArray[np.bool_]
    """Whether its angle came as a list."""


class Questions(Protocol):
    """A body that has been read."""

    @property
    def size(self) -> int:
        """Bytes that it takes until all is answered."""

    def pieces(self, size: int) -> Iterator[Callable[[], Piece]]:
        """Part it into pieces of about `size` values, each to be made when it is its turn."""
