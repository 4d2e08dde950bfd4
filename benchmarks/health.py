"""How soon `/health` answers while others hold the server: slow connections, large computations."""

from __future__ import annotations

import http.client
import itertools
import socket
import statistics
import time
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack

from app.server.run import allow_open_files
from benchmarks.evaluate import json_items, seconds
from benchmarks.load import OURS, Server, served

CONNECTIONS = 2000
ASKED = 50
BAR_MS = 100.0
HALF = b"GET /api/v1/health HTTP/1.1\r\nHost: test\r\nX-Slow: "
MAP = "/api/v1/errors/map?x=n_t&y=k_t&metric=rms&x_steps=400&y_steps={}"
VALUES = 500_000


def ask(server: Server, path: str) -> float:
    """Ask over a connection of its own; ms to the whole answer."""
    begin = time.perf_counter()
    connection = http.client.HTTPConnection("127.0.0.1", server.port)
    connection.request("GET", path)
    answer = connection.getresponse()
    answer.read()
    connection.close()
    if answer.status != 200:
        raise SystemExit(f"{answer.status} for {path}")
    return 1e3 * (time.perf_counter() - begin)


def during(server: Server, *calls: Callable[[], object]) -> list[float]:
    """Ask for `/health` until these calls are done; ms of each answer."""
    with ThreadPoolExecutor(len(calls)) as clients:
        under_way: list[Future[object]] = [clients.submit(call) for call in calls]
        times = []
        while not all(call.done() for call in under_way):
            times.append(ask(server, "/api/v1/health"))
        for call in under_way:
            call.result()
    return times


def row(name: str, times: list[float], note: str = "") -> None:
    """Print a line."""
    middle, worst = statistics.median(times), max(times)
    print(f"{name:44}{len(times):7}{middle:11.1f}{worst:10.1f}{note}")


def main() -> None:
    """Print median and longest time to an answer."""
    steps = itertools.count(390)
    print(f"{'while the server':44}{'asked':>7}{'median ms':>11}{'worst ms':>10}")
    with served(*OURS) as server:
        row("has nothing else to do", [ask(server, "/api/v1/health") for _ in range(ASKED)])
        maps = [lambda: ask(server, MAP.format(next(steps))) for _ in range(3)]
        row("computes three maps of 160,000 cells", during(server, *maps))
        body = json_items(VALUES)
        evaluate = during(server, lambda: seconds(server.port, body, "application/json"))
        row(f"evaluates {VALUES} JSON items", evaluate)
        allow_open_files(2 * CONNECTIONS)
        with ExitStack() as held:
            for _ in range(CONNECTIONS):
                slow = held.enter_context(socket.create_connection(("127.0.0.1", server.port)))
                slow.sendall(HALF)
            times = [ask(server, "/api/v1/health") for _ in range(ASKED)]
        row(f"holds {CONNECTIONS} slow connections", times, f"  (bar: median {BAR_MS:g})")


if __name__ == "__main__":
    main()
