"""How long the server takes to start, and the memory it holds before and after some questions."""

from __future__ import annotations

import http.client
import statistics
import time

from app.materials.catalog import load_catalog
from benchmarks.load import OURS, served

ROUNDS = 5
CATALOG_BAR_MS = 150
QUESTIONS = (
    "/api/v1/curves?models=exact,schlick",
    "/api/v1/materials/Au/curves",
    "/api/v1/errors/map?x_steps=200&y_steps=200",
    "/api/v1/albedo/sweep?steps=200",
)


def ask(port: int, path: str) -> None:
    """Ask once."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    connection.request("GET", path)
    answer = connection.getresponse()
    body = answer.read()
    connection.close()
    if answer.status != 200:
        raise SystemExit(body[:500])


def main() -> None:
    """Print the medians."""
    catalogs = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        load_catalog()
        catalogs.append(time.perf_counter() - begin)
    print(
        f"catalog of materials {1e3 * statistics.median(catalogs):.1f} ms (bar: {CATALOG_BAR_MS})"
    )
    starts, idle, used = [], [], []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        with served(*OURS) as server:
            ask(server.port, "/api/v1/health")
            starts.append(time.perf_counter() - begin)
            idle.append(server.memory_mb("VmRSS"))
            for path in QUESTIONS:
                ask(server.port, path)
            used.append(server.memory_mb("VmRSS"))
    print(f"first answer after {statistics.median(starts):.2f} s")
    print(
        f"idle {statistics.median(idle):.0f} MB, after some questions {statistics.median(used):.0f} MB"
    )


if __name__ == "__main__":
    main()
