"""A real server and calls of every kind of wrongness: its memory stays bounded, and it answers."""

from __future__ import annotations

import io
import json
import re
import socket
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest

from tests.serve.command import API, PATIENCE_S, Served, serving, wait_for

MOST_MB = 500.0
ARROW = "application/vnd.apache.arrow.stream"
JSON = "application/json"
CSV = "text/csv"

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="/proc says how much memory")


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    with serving(tmp_path_factory.mktemp("batches"), FRESNEL_READ_TIMEOUT_S="5") as running:
        yield running


def memory_mb(served: Served, what: str) -> float:
    status = Path(f"/proc/{served.process.pid}/status").read_text("utf-8")
    (kilobytes,) = re.findall(rf"^{what}:\s+(\d+) kB", status, re.MULTILINE)
    return int(kilobytes) / 1e3


def forget_the_peak(served: Served) -> None:
    """Have the system measure the most memory from now on."""
    Path(f"/proc/{served.process.pid}/clear_refs").write_text("5", "ascii")


def items(one: bytes, size: int, separator: bytes = b",") -> bytes:
    """A body of about `size` bytes that repeats an item."""
    count = max(1, size // (len(one) + len(separator)))
    return b'{"items":[' + separator.join([one] * count) + b"]}"


def each(count: int, one: Callable[[int], object]) -> bytes:
    """A body of items that differ."""
    return json.dumps({"items": [one(i) for i in range(count)]}).encode()


def sparse() -> bytes:
    """A million empty items, and now and then one that makes the server keep another column."""
    rare = [
        b'{"%s":1}' % name for name in (b"n_i", b"n_t", b"k_t", b"wavelength_nm", b"schlick.F0")
    ]
    return items(b",".join([b"{}"] * 150_000 + rare), 3_000_000)


def stream(*batches: pa.RecordBatch) -> bytes:
    sink = io.BytesIO()
    with pa.ipc.new_stream(sink, batches[0].schema) as writer:
        for batch in batches:
            writer.write_batch(batch)
    return sink.getvalue()


def rows(**columns: object) -> pa.RecordBatch:
    return pa.RecordBatch.from_pydict(columns)


def of_dictionary(size: int) -> pa.RecordBatch:
    names = pa.array([f"name {i}" for i in range(size)])
    return rows(material=pa.DictionaryArray.from_arrays(pa.array([1], pa.int32()), names))


MB = 1_000_000
WRONG: dict[str, tuple[Callable[[], bytes], str, str]] = {
    "unknown field": (lambda: items(b'{"a":1}', 4 * MB), JSON, JSON),
    "unknown field, as rows": (lambda: items(b'{"a":1}', 4 * MB), JSON, CSV),
    "another unknown field each": (lambda: each(200_000, lambda i: {f"a{i}": 1}), JSON, JSON),
    "repeated field": (lambda: items(b'{"n_t":1,"n_t":2}', 4 * MB), JSON, JSON),
    "out of range": (lambda: items(b'{"n_t":-1}', 4 * MB), JSON, JSON),
    "another number each": (lambda: each(300_000, lambda i: {"n_t": -i}), JSON, CSV),
    "unknown model": (lambda: items(b'{"model":"x"}', 4 * MB), JSON, ARROW),
    "another model each": (lambda: each(100_000, lambda i: {"model": f"x{i}"}), JSON, JSON),
    "numbers": (lambda: items(b"1", 98 * MB), JSON, JSON),
    "a million numbers": (lambda: items(b"1", 2 * MB - 2), JSON, JSON),
    "lists": (lambda: items(b"[]", 98 * MB), JSON, JSON),
    "empty items": (lambda: items(b"{}", 98 * MB), JSON, JSON),
    "items without angles": (lambda: items(b'{"theta_i_deg":[]}', 98 * MB), JSON, JSON),
    "few items of each column": (sparse, JSON, JSON),
    "many angles": (
        lambda: items(b'{"theta_i_deg":[' + b",".join([b"0"] * 30 * MB) + b"]}", 1),
        JSON,
        JSON,
    ),
    "a million wrong angles": (
        lambda: items(b'{"n_t":-1,"theta_i_deg":[' + b",".join([b"0"] * MB) + b"]}", 1),
        JSON,
        CSV,
    ),
    "lists in an item": (
        lambda: items(b'{"n_t":[' + b",".join([b"[]"] * 30 * MB) + b"]}", 1),
        JSON,
        JSON,
    ),
    "objects in an item": (
        lambda: items(b'{"n_t":[' + b",".join([b"{}"] * 30 * MB) + b"]}", 1),
        JSON,
        JSON,
    ),
    "a long name": (lambda: items(b'{"model":"' + b"x" * 98 * MB + b'"}', 1), JSON, JSON),
    "what looks like items in a name": (
        lambda: items(b'{"model":"' + b"},{" * 30 * MB + b'"}', 1),
        JSON,
        JSON,
    ),
    "no end": (lambda: items(b"{}", 98 * MB)[:-2], JSON, JSON),
    "nested": (lambda: b'{"items":' + b"[" * 60 * MB, JSON, JSON),
    "spaces": (lambda: b'{"items":[' + b" " * 98 * MB + b"]}", JSON, JSON),
    "no JSON": (lambda: b"x" * 60 * MB, JSON, JSON),
    "no Arrow": (lambda: b"x" * 98 * MB, ARROW, ARROW),
    "rows out of range": (lambda: stream(rows(n_t=np.full(MB, -1.0))), ARROW, ARROW),
    "rows out of range, as items": (lambda: stream(rows(n_t=np.full(MB, -1.0))), ARROW, JSON),
    "another material each": (
        lambda: stream(rows(material=[f"x{i}" for i in range(MB // 4)])),
        ARROW,
        CSV,
    ),
    "batches of a row": (lambda: stream(*[rows(n_t=[1.5])] * 20_000), ARROW, ARROW),
    "a dictionary in each batch": (lambda: stream(*[of_dictionary(300_000)] * 100), ARROW, ARROW),
    "another dictionary in each batch": (
        lambda: stream(*[of_dictionary(10_000 + i) for i in range(100)]),
        ARROW,
        ARROW,
    ),
    "a row of a long name": (lambda: stream(rows(material=["x" * 98 * MB])), ARROW, ARROW),
}


def posted(served: Served, body: bytes, kind: str, accept: str) -> tuple[int, int]:
    """Send a body, and return the status of the answer and its bytes."""
    connection = served.connect()
    connection.request("POST", f"{API}/evaluate", body, {"Content-Type": kind, "Accept": accept})
    answer = connection.getresponse()
    size = 0
    while part := answer.read(MB):
        size += len(part)
    connection.close()
    return answer.status, size


@pytest.mark.parametrize("kind", WRONG)
def test_what_is_wrong_takes_little_whatever_it_is(served: Served, kind: str) -> None:
    made, sent, accepted = WRONG[kind]
    body = made()
    forget_the_peak(served)
    status, size = posted(served, body, sent, accepted)
    assert status in (200, 413, 422)
    assert size < max(60 * MB, 3 * len(body))
    assert memory_mb(served, "VmHWM") < MOST_MB


def test_two_of_the_largest_at_a_time(served: Served) -> None:
    """One is read, the other told to come again; both would take too much."""
    head = (
        f"POST {API}/evaluate HTTP/1.1\r\nHost: x\r\nContent-Type: {ARROW}\r\n"
        f"Content-Length: {98 * MB}\r\n\r\n"
    ).encode()
    with ExitStack() as held:
        first, second = (
            held.enter_context(socket.create_connection(served.address, PATIENCE_S))
            for _ in range(2)
        )
        first.sendall(head + b"x" * (97 * MB))
        wait_for(lambda: memory_mb(served, "VmRSS") > 97)
        second.sendall(head)
        sent = 0
        second.settimeout(0.05)
        answer = b""
        while not answer and sent < 98 * MB:
            second.settimeout(PATIENCE_S)
            second.sendall(b"x" * MB)
            sent += MB
            second.settimeout(0.001)
            try:
                answer = second.recv(1000)
            except TimeoutError:
                continue
        assert answer.startswith(b"HTTP/1.1 503")
        assert b"retry-after: 1" in answer.lower()
        first.sendall(b"x" * MB)
        assert first.recv(12) == b"HTTP/1.1 422"
    assert memory_mb(served, "VmHWM") < MOST_MB


def test_slow_readers_hold_no_more_than_all_may(served: Served) -> None:
    """Twelve who read nothing: some are answered, the others told to come again."""
    count = MB
    body = stream(rows(n_t=np.full(count, 1.5), k_t=np.zeros(count), theta_i_deg=np.zeros(count)))
    head = (
        f"POST {API}/evaluate HTTP/1.1\r\nHost: x\r\nContent-Type: {ARROW}\r\n"
        f"Content-Length: {len(body)}\r\n\r\n"
    ).encode()
    with ExitStack() as held:
        statuses = []
        for _ in range(12):
            one = held.enter_context(socket.create_connection(served.address, PATIENCE_S))
            one.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            one.sendall(head + body)
            statuses.append(int(one.recv(12).split()[1]))
        assert set(statuses) == {200, 503}
        assert statuses.count(200) >= 4
        assert memory_mb(served, "VmHWM") < MOST_MB
        assert served.ask(f"{API}/health").status == 200
    # They have gone; what they held is free.
    small = b'{"items":[' + b",".join([b'{"n_t":1.5}'] * 200_000) + b"]}"
    wait_for(lambda: posted(served, small, JSON, JSON)[0] == 200)
