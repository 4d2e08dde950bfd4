"""A plain server and clients that send without end: little is kept, and others are answered."""

import re
import resource
import socket
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from app.server.run import allow_open_files
from tests.serve.command import API, PATIENCE_S, Served, serving

HEAD = b"GET /api/v1/health HTTP/1.1\r\nHost: test\r\n"
CHUNKED = b"POST /api/v1/evaluate HTTP/1.1\r\nHost: test\r\nTransfer-Encoding: chunked\r\n\r\n"
PIECE = 65_536
MOST_SENT = 50_000_000
MOST_KEPT_MB = 25.0

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="/proc says how much memory")


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """What strangers may reach: a server as it listens on all addresses."""
    with serving(tmp_path_factory.mktemp("floods"), FRESNEL_HTTP="h11") as running:
        yield running


def peak_mb(served: Served) -> float:
    status = Path(f"/proc/{served.process.pid}/status").read_text("utf-8")
    (kilobytes,) = re.findall(r"^VmHWM:\s+(\d+) kB", status, re.MULTILINE)
    return int(kilobytes) / 1e3


def poured(connection: socket.socket, start: bytes, piece: bytes) -> int:
    """Send until the server hangs up, or takes no more for a while."""
    connection.settimeout(0.5)
    sent = 0
    try:
        connection.sendall(start)
        while sent < MOST_SENT:
            connection.sendall(piece)
            sent += len(piece)
    except OSError:
        pass
    return sent


@pytest.mark.parametrize(
    ("start", "piece"),
    [
        (b"", b"G" * PIECE),
        (b"GET /", b"x" * PIECE),
        (HEAD + b"X: ", b"x" * PIECE),
        (HEAD, b"X: y\r\n" * (PIECE // 6)),
        (CHUNKED + b"1;", b"x" * PIECE),
        (CHUNKED + b"0\r\n", b"X: y\r\n" * (PIECE // 6)),
        (b"", (HEAD + b"\r\n") * (PIECE // len(HEAD))),
    ],
    ids=["method", "address", "header", "headers", "chunk", "trailer", "requests"],
)
def test_what_never_ends_is_not_kept(served: Served, start: bytes, piece: bytes) -> None:
    before = peak_mb(served)
    with socket.create_connection(served.address, PATIENCE_S) as connection:
        assert poured(connection, start, piece) < MOST_SENT
        assert peak_mb(served) - before < MOST_KEPT_MB
        assert served.ask(f"{API}/health").status == 200


@pytest.mark.parametrize("said", [b"", HEAD + b"X-Slow: " + b"x" * 1000], ids=["nothing", "half"])
def test_two_thousand_idle_connections_do_not_starve_others(served: Served, said: bytes) -> None:
    """How soon `/health` answers then, `python -m benchmarks health` measures."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    allow_open_files(2000)
    if resource.getrlimit(resource.RLIMIT_NOFILE)[0] < 2100:
        pytest.skip("this system does not let a process open so many files")
    before = peak_mb(served)
    try:
        with ExitStack() as held:
            for _ in range(2000):
                idle = held.enter_context(socket.create_connection(served.address, PATIENCE_S))
                idle.sendall(said)
            for _ in range(50):
                assert served.ask(f"{API}/health").status == 200
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
    assert peak_mb(served) - before < MOST_KEPT_MB
