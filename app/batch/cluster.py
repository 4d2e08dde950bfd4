"""Batches evaluated by the workers of a Dask cluster."""

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import distributed
import pyarrow as pa

from app.batch.files import evaluated

# Batches under way for each thread of the workers: one computed, one on the way to it.
_FOR_EACH_THREAD = 2


def on_cluster(
    address: str, batches: Iterable[pa.RecordBatch], keep: Sequence[str]
) -> Iterator[pa.RecordBatch]:
    """Evaluate batches on a cluster whose workers have this program, and yield them in order.

    Parameters
    ----------
    address
        Of the scheduler, as `tcp://host:8786`.
    batches
        Read no further ahead than the workers can take.
    keep
        As in `evaluated`.

    Raises
    ------
    OSError
        If no scheduler answers there.
    """
    with distributed.Client(address, timeout=10) as client:
        threads = max(1, sum(client.nthreads().values()))
        under_way: deque[Any] = deque()
        for batch in batches:
            if len(under_way) >= _FOR_EACH_THREAD * threads:
                yield under_way.popleft().result()
            under_way.append(client.submit(evaluated, batch, keep, pure=False))
        while under_way:
            yield under_way.popleft().result()
