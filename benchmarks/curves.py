"""Fresh `/curves` answers per second beside the plain service, one worker each, in turns."""

from __future__ import annotations

import contextlib
import http.client
import itertools
import socket
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator

ROUNDS = 7
REQUESTS = 300
OURS = "/api/v1/curves?models=exact,schlick,lagarde_gc&samples=181&n_t={n_t:.9f}"
PLAIN = {
    "pydantic model": "/curves?samples=181&n_t={n_t:.9f}",
    "dict": "/curves/dict?samples=181&n_t={n_t:.9f}",
}


@contextlib.contextmanager
def served(application: str, *options: str) -> Iterator[int]:
    """Run an application with one worker and yield its port."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
    command = [sys.executable, "-m", "uvicorn", application, *options, "--port", str(port)]
    server = subprocess.Popen([*command, "--log-level", "warning"])
    try:
        for _ in range(100):
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port)):
                break
            time.sleep(0.1)
        yield port
    finally:
        server.terminate()
        server.wait()


def rate(port: int, path: str, numbers: Iterator[float]) -> float:
    """Requests per second over one kept-alive connection, no two alike."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    start = time.perf_counter()
    for _ in range(REQUESTS):
        connection.request("GET", path.format(n_t=next(numbers)))
        answer = connection.getresponse()
        body = answer.read()
        if answer.status != 200:
            raise RuntimeError(body)
    elapsed = time.perf_counter() - start
    connection.close()
    return REQUESTS / elapsed


def main() -> None:
    """Print the rates and their ratios, medians of the rounds."""
    numbers = (1.2 + 1e-6 * i for i in itertools.count())
    with (
        served("app.main:create_app", "--factory") as ours,
        served("benchmarks.plain_service:app") as plain,
    ):
        rate(ours, OURS, numbers)
        rounds = [
            {"ours": rate(ours, OURS, numbers)}
            | {name: rate(plain, path, numbers) for name, path in PLAIN.items()}
            for _ in range(ROUNDS)
        ]
    print("fresh /curves, 181 samples, six curves, requests per second and ratio to ours:")
    for name in rounds[0]:
        ratio = statistics.median(found["ours"] / found[name] for found in rounds)
        print(f"  {name:16s}{statistics.median(f[name] for f in rounds):8.0f}{ratio:8.2f}")


if __name__ == "__main__":
    main()
