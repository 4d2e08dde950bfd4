"""Counts and durations of requests in the Prometheus format, over all workers of a server."""

import os
from pathlib import Path
from shutil import rmtree

from prometheus_client import (
    CollectorRegistry,
    Counter,
    Gauge,
    Histogram,
    ProcessCollector,
    generate_latest,
)
from prometheus_client.multiprocess import MultiProcessCollector, mark_process_dead

from app import __version__

SHARED = "PROMETHEUS_MULTIPROC_DIR"
"""Environment variable with the folder in which workers share their counts; unset for a single one."""

_METHODS = frozenset({"GET", "HEAD", "POST", "OPTIONS", "PUT", "DELETE", "PATCH"})

# Seconds: from an answer out of the cache to the largest map on a busy machine.
_BUCKETS = (0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0)


class Metrics:
    """What is counted.

    Labels take few values whatever clients send: a route is its template, a method that nobody
    knows is `other`.
    """

    def __init__(self) -> None:
        self._registry = CollectorRegistry()
        self._requests = Counter(
            "http_requests",
            "Requests answered.",
            ("method", "route", "status"),
            registry=self._registry,
        )
        self._seconds = Histogram(
            "http_request_duration_seconds",
            "Time from a request's head to the last byte handed to the network.",
            ("route",),
            buckets=_BUCKETS,
            registry=self._registry,
        )
        self._in_flight = Gauge(
            "http_requests_in_flight",
            "Requests being answered.",
            multiprocess_mode="livesum",
            registry=self._registry,
        )
        self._lookups = Counter(
            "fresnel_cache_lookups",
            "Answers that the server's own cache had, and those it had not.",
            ("result",),
            registry=self._registry,
        )
        self._dropped = Counter(
            "fresnel_access_log_lines_dropped",
            "Lines of the access log that were lost, for nobody read them.",
            registry=self._registry,
        )
        Gauge(
            "fresnel_build_info",
            "1, labelled with the version.",
            ("version",),
            multiprocess_mode="max",
            registry=self._registry,
        ).labels(__version__).set(1)
        ProcessCollector(registry=self._registry)
        # Looking children up by their labels takes longer than counting.
        self._by_answer: dict[tuple[str, str, int], tuple[Counter, Histogram]] = {}

    def began(self) -> None:
        """Count a request that begins."""
        self._in_flight.inc()

    def ended(
        self, method: str, route: str, status: int, seconds: float, cache: str | None
    ) -> None:
        """Count a request that was answered."""
        self._in_flight.dec()
        key = method if method in _METHODS else "other", route, status
        children = self._by_answer.get(key)
        if children is None:
            children = self._requests.labels(*key), self._seconds.labels(route)
            self._by_answer[key] = children
        children[0].inc()
        children[1].observe(seconds)
        if cache is not None:
            self._lookups.labels(cache).inc()

    def dropped(self) -> None:
        """Count a line of the access log that is lost."""
        self._dropped.inc()

    def text(self) -> bytes:
        """Write all of it in the Prometheus text format: of every worker, where there are several."""
        shared = os.environ.get(SHARED)
        if shared is None:
            return generate_latest(self._registry)
        _forget_dead_workers(Path(shared))
        everyone = CollectorRegistry()
        MultiProcessCollector(everyone, path=shared)  # type: ignore[no-untyped-call]
        return generate_latest(everyone)


def leave(shared: Path) -> None:
    """Count no more in the workers' folder, and remove it if no other worker does.

    Each takes its own files away before it looks for others': the last one finds none.
    """
    for file in shared.glob(f"*_{os.getpid()}.db"):
        file.unlink(missing_ok=True)
    if not any(_runs(_worker(file)) for file in shared.glob("*_*.db")):
        rmtree(shared, ignore_errors=True)


def _worker(file: Path) -> int:
    return int(file.stem.rpartition("_")[2])


def _runs(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass  # it lives, under another user
    return True


def _forget_dead_workers(shared: Path) -> None:
    """Drop what killed workers had in flight; what they counted stays, for counters never fall."""
    for file in shared.glob("gauge_live*_*.db"):
        if not _runs(_worker(file)):
            mark_process_dead(_worker(file), path=str(shared))  # type: ignore[no-untyped-call]
