"""Batches and parts worked out by the workers of a Dask cluster, whose workers have this program."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any, TypeVar

import distributed
import pyarrow as pa

from app.batch.csv_blocks import Block
from app.batch.files import evaluated

T = TypeVar("T")
R = TypeVar("R")

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
        asked = ((b, (b.batch, keep, b.faults, digits)) for b in blocks)
        yield from in_turn(client, evaluated, asked)


def in_turn(
    client: distributed.Client,
    function: Callable[..., R],
    asked: Iterable[tuple[T, tuple[Any, ...]]],
) -> Iterator[tuple[T, R]]:
    """Have a function called by the workers, and yield what it returned, in order.

    Parameters
    ----------
    client
        Of the cluster.
    function
        Of this program.
    asked
        What is yielded beside each result, and the function's arguments; read no further ahead than the
        workers can take.
    """
    threads = max(1, sum(client.nthreads().values()))
    under_way: deque[tuple[T, Any]] = deque()
    for item, arguments in asked:
        if len(under_way) >= _FOR_EACH_THREAD * threads:
            yield _done(*under_way.popleft())
        under_way.append((item, client.submit(function, *arguments, pure=False)))
    while under_way:
        yield _done(*under_way.popleft())


@contextmanager
def connected(address: str | None, workers: int) -> Iterator[distributed.Client]:
    """Connect to a cluster, or to one made on this machine for as long.

    Parameters
    ----------
    address
        Of the scheduler, as `tcp://host:8786`; None for one made here.
    workers
        Processes of the one made here, each with a thread.

    Raises
    ------
    OSError
        If no scheduler answers there.
    """
    if address is not None:
        with distributed.Client(address, timeout=10) as client:
            yield client
        return
    # With None it would listen on the port of the dashboard all the same, which two cannot have.
    with (
        distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, dashboard_address="127.0.0.1:0"
        ) as cluster,
        distributed.Client(cluster.scheduler_address, timeout=30) as client,
    ):
        yield client


def _done(item: T, asked: Any) -> tuple[T, Any]:
    return item, asked.result()
