"""Batches evaluated by the workers of a Dask cluster."""

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import distributed
import pyarrow as pa

from app.batch.csv_blocks import Block
from app.batch.files import evaluated

# Batches under way for each thread of the workers: one computed, one on the way to it.
_FOR_EACH_THREAD = 2


def on_cluster(
    address: str, blocks: Iterable[Block], keep: Sequence[str], digits: int = 17
) -> Iterator[tuple[Block, pa.RecordBatch]]:
    """Evaluate blocks on a cluster whose workers have this program, and yield them in order.

    Parameters
    ----------
    address
        Of the scheduler, as `tcp://host:8786`.
    blocks
        Read no further ahead than the workers can take.
    keep, digits
        As in `evaluated`.

    Raises
    ------
    OSError
        If no scheduler answers there.
    """
    with distributed.Client(address, timeout=10) as client:
        threads = max(1, sum(client.nthreads().values()))
        under_way: deque[tuple[Block, Any]] = deque()
        for block in blocks:
            if len(under_way) >= _FOR_EACH_THREAD * threads:
                yield _done(*under_way.popleft())
            asked = client.submit(evaluated, block.batch, keep, block.faults, digits, pure=False)
            under_way.append((block, asked))
        while under_way:
            yield _done(*under_way.popleft())


def _done(block: Block, asked: Any) -> tuple[Block, pa.RecordBatch]:
    return block, asked.result()
