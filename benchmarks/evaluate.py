"""`POST /evaluate`: values per second on loopback and the server's peak memory, by kind and size."""

from __future__ import annotations

import http.client
import io
import json
import statistics
import time
from collections.abc import Callable

import numpy as np
import pyarrow as pa

from benchmarks.load import OURS, served

SIZES = (10_000, 100_000, 1_000_000)
ROUNDS = 5
ARROW = "application/vnd.apache.arrow.stream"
BARS = {"JSON": 1.5e6, "Arrow": 8e6}
MEMORY_BAR_MB = 400.0


def rays(count: int) -> dict[str, np.ndarray]:
    """Dielectrics and conductors in turn, every index and angle another."""
    rng = np.random.default_rng(count)
    k_t = rng.uniform(0.0, 5.0, count)
    k_t[::2] = 0.0
    return {
        "n_t": rng.uniform(1.0, 3.0, count),
        "k_t": k_t,
        "theta_i_deg": rng.uniform(0.0, 90.0, count),
    }


def json_lists(count: int) -> bytes:
    """Items of a thousand angles each."""
    columns = rays(count)
    theta = columns["theta_i_deg"].reshape(-1, 1000)
    items = [
        {"n_t": n_t, "k_t": k_t, "theta_i_deg": angles}
        for n_t, k_t, angles in zip(
            columns["n_t"].tolist(), columns["k_t"].tolist(), theta.tolist(), strict=False
        )
    ]
    return json.dumps({"items": items}).encode()


def json_items(count: int) -> bytes:
    """One item a value."""
    columns = {name: column.tolist() for name, column in rays(count).items()}
    rows = zip(*columns.values(), strict=True)
    return json.dumps({"items": [dict(zip(columns, row, strict=True)) for row in rows]}).encode()


def arrow(count: int) -> bytes:
    """Three columns."""
    table = pa.table(rays(count))
    sink = io.BytesIO()
    with pa.ipc.new_stream(sink, table.schema) as stream:
        stream.write_table(table)
    return sink.getvalue()


CASES: dict[str, tuple[Callable[[int], bytes], str]] = {
    "Arrow, a row a value": (arrow, ARROW),
    "JSON, 1000 angles an item": (json_lists, "application/json"),
    "JSON, an item a value": (json_items, "application/json"),
}


def seconds(port: int, body: bytes, kind: str) -> float:
    """Time from sending a body to the last byte of the answer."""
    connection = http.client.HTTPConnection("127.0.0.1", port)
    start = time.perf_counter()
    connection.request("POST", "/api/v1/evaluate", body, {"Content-Type": kind})
    answer = connection.getresponse()
    received = answer.read()
    elapsed = time.perf_counter() - start
    connection.close()
    if answer.status != 200:
        raise SystemExit(received[:500])
    return elapsed


def main() -> None:
    """Print the rates and the memory, each size and kind with a server of its own."""
    print(f"{'':28}{'values':>10}{'values/s':>12}{'peak MB':>9}")
    for name, (make, kind) in CASES.items():
        for size in SIZES:
            body = make(size)
            with served(*OURS) as server:
                seconds(server.port, make(1000), kind)
                times = [seconds(server.port, body, kind) for _ in range(ROUNDS)]
                peak = server.memory_mb("VmHWM")
            bar = BARS.get(name.partition(",")[0]) if size == SIZES[-1] else None
            note = f"  (bars: {bar / 1e6:g} million, {MEMORY_BAR_MB:g} MB)" if bar else ""
            print(f"{name:28}{size:10}{size / statistics.median(times):12.0f}{peak:9.0f}{note}")


if __name__ == "__main__":
    main()
