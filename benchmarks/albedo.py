"""Albedo sweeps beside `/curves`, and a conductor map on a server that has just started."""

from __future__ import annotations

import http.client
import itertools
import statistics
import time
from collections.abc import Iterator

from benchmarks.load import served, under_uvicorn

ROUNDS = 7
REQUESTS = 100
CURVES = "/api/v1/curves?samples=181&n_t={x:.9f}"
SWEEP = "/api/v1/albedo/sweep?steps=500&maximum={x:.9f}"
FITTED = SWEEP + "&fits=deon_2019_log,deon_irving_2011,kulla_conty_2017,schlick"
MAP = "/api/v1/albedo/map?fit=deon_2019_rg&n_steps=60&k_steps=60&n_minimum=0.1&k_minimum={x:.9f}"


def mean_ms(port: int, path: str, numbers: Iterator[float], requests: int = REQUESTS) -> float:
    """Mean time of an answer over one kept-alive connection, no two requests alike."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    start = time.perf_counter()
    for _ in range(requests):
        connection.request("GET", path.format(x=next(numbers)))
        answer = connection.getresponse()
        body = answer.read()
        if answer.status != 200:
            raise RuntimeError(body)
    elapsed = time.perf_counter() - start
    connection.close()
    return 1e3 * elapsed / requests


def main(application: str = "app.main:create_app") -> None:
    """Print the times and their ratios, medians of the rounds."""
    numbers = (1.2 + 1e-6 * i for i in itertools.count())
    with served(*under_uvicorn(application, "--factory")) as server:
        cold = mean_ms(server.port, MAP, iter([1.7]), requests=1)
        repeated = mean_ms(server.port, MAP, itertools.repeat(1.7))
        rounds = [
            [mean_ms(server.port, path, numbers) for path in (CURVES, SWEEP, FITTED)]
            for _ in range(ROUNDS)
        ]
    curves, sweep, fitted = (statistics.median(column) for column in zip(*rounds, strict=True))
    ratio, fitted_ratio = (
        statistics.median(times[index] / times[0] for times in rounds) for index in (1, 2)
    )
    print(f"fresh /curves, 181 samples:                {curves:.2f} ms")
    print(f"fresh /albedo/sweep, 500 dielectrics:      {sweep:.2f} ms, {ratio:.2f}x (bar: 5x)")
    print(f"the same with four fits and their errors:  {fitted:.2f} ms, {fitted_ratio:.2f}x")
    print(f"first /albedo/map, 60 x 60 conductors:     {cold:.0f} ms (bar: 2000 ms)")
    print(f"the same map again:                        {repeated:.1f} ms")


if __name__ == "__main__":
    main()
