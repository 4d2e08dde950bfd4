"""Every request that came whole is answered, and every refusal arrives, however a client sends."""

from __future__ import annotations

import json
import re
import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from http.client import HTTPResponse
from typing import Any

import pytest

from app.server.pool import Pool
from app.server.protocol import BoundedProtocol
from app.settings import Settings
from tests.api.wire import Address, exchange, received, served

HOST = b" HTTP/1.1\r\nHost: test\r\n"
HEALTH = b"GET /api/v1/health" + HOST
LARGE = b"GET /api/v1/errors/map?x=n_t&y=k_t&metric=rms&x_steps=90&y_steps=%d" + HOST + b"\r\n"
PATIENCE_S = 30.0


@pytest.fixture(scope="module")
def address() -> Iterator[Address]:
    with served(settings=Settings(max_target_bytes=200, keep_alive_s=1)) as running:
        yield running


@pytest.fixture
def connection(address: Address) -> Iterator[socket.socket]:
    with socket.create_connection(address, timeout=PATIENCE_S) as connected:
        yield connected


def statuses(connection: socket.socket) -> list[int]:
    """The statuses of all answers up to the end of the connection."""
    data = b"".join(iter(lambda: connection.recv(65536), b""))
    return [int(status) for status in re.findall(rb"HTTP/1\.1 (\d{3}) ", data)]


@pytest.mark.parametrize(
    ("after", "status"),
    [
        (b"\x00 nonsense\r\n\r\n", 400),
        (b"GET /" + b"x" * 70_000 + HOST + b"\r\n", 414),
        (b"GET /" + HOST + b"X: " + b"v" * 70_000 + b"\r\n\r\n", 431),
        (b"POST /api/v1/evaluate" + HOST + b"Transfer-Encoding: chunked\r\n\r\nnonsense\r\n", 400),
    ],
    ids=["no HTTP", "target", "header", "chunk"],
)
@pytest.mark.parametrize("before", [1, 3])
def test_what_came_before_a_refusal_is_answered(
    connection: socket.socket, after: bytes, status: int, before: int
) -> None:
    large = b"".join(LARGE % (100 + turn) for turn in range(before))
    connection.sendall(large + after)
    assert statuses(connection) == [200] * before + [status]


def test_a_client_that_says_no_more_is_answered(
    connection: socket.socket, monkeypatch: pytest.MonkeyPatch
) -> None:
    ended = threading.Event()
    run, eof_received = Pool.run, BoundedProtocol.eof_received

    def noted(protocol: BoundedProtocol) -> bool:
        kept = eof_received(protocol)
        ended.set()
        return kept

    def held(pool: Pool, function: Callable[[], Any]) -> Any:
        def wait() -> Any:
            assert ended.wait(PATIENCE_S)
            return function()

        return run(pool, wait)

    monkeypatch.setattr(BoundedProtocol, "eof_received", noted)
    monkeypatch.setattr(Pool, "run", held)
    connection.sendall(LARGE % 110)
    connection.shutdown(socket.SHUT_WR)
    assert statuses(connection) == [200]


@pytest.mark.parametrize(
    "start",
    [
        b"GET /api/v1/hea",
        HEALTH + b"X-Odd: ",
        b"POST /api/v1/evaluate" + HOST + b"Content-Length: 100\r\n\r\n{",
        b"POST /api/v1/evaluate" + HOST + b"Transfer-Encoding: chunked\r\n\r\n9\r\n{",
    ],
)
def test_a_request_that_ends_early_is_told_so(connection: socket.socket, start: bytes) -> None:
    connection.sendall(start)
    connection.shutdown(socket.SHUT_WR)
    answer = received(connection)
    assert answer.status == 400
    assert "ended before the request" in json.loads(answer.body)["detail"]


@pytest.mark.parametrize(
    ("start", "status"),
    [
        (b"GET /" + b"x" * 1000, 414),
        (b"GET /" + HOST + b"X: " + b"x" * 40_000, 431),
        (b"POST /api/v1/snell" + HOST + b"Connection: close\r\nContent-Length: 9999999\r\n\r\n", 405),
        (b"POST /api/v1/evaluate" + HOST + b"Content-Length: 999999999\r\n\r\n", 413),
    ],
)  # fmt: skip
def test_a_client_may_go_on_sending_what_nobody_reads(
    connection: socket.socket, start: bytes, status: int
) -> None:
    """Without a reset, which would take the answer away before it is read."""
    connection.sendall(start)
    connection.recv(1, socket.MSG_PEEK)  # it was refused
    for _ in range(50):
        connection.sendall(b"x" * 100_000)
    assert received(connection).status == status


def test_one_too_many_may_send_its_request() -> None:
    settings = Settings(max_connections=3, keep_alive_s=600)
    with served(settings=settings) as tight, ExitStack() as held:
        for _ in range(3):
            kept = held.enter_context(socket.create_connection(tight, timeout=PATIENCE_S))
            kept.sendall(HEALTH + b"\r\n")
            assert kept.recv(1, socket.MSG_PEEK)  # it is among the connections
        refused = held.enter_context(socket.create_connection(tight, timeout=PATIENCE_S))
        refused.recv(1, socket.MSG_PEEK)
        for _ in range(20):
            refused.sendall(HEALTH + b"\r\n")
        assert received(refused).status == 503
        for _ in range(100):  # these lived on as well, but for so many there is no time
            held.enter_context(socket.create_connection(tight, timeout=PATIENCE_S))
        last = held.enter_context(socket.create_connection(tight, timeout=PATIENCE_S))
        assert hung_up_without_a_word(last)


def test_a_server_that_stops_waits_for_nobody_who_was_told_all() -> None:
    """The client was refused and neither reads on nor hangs up: that may take its whole patience."""
    settings = Settings(max_target_bytes=200, read_timeout_s=600)
    with ExitStack() as held:
        with served(settings=settings) as patient:
            told = held.enter_context(socket.create_connection(patient, timeout=PATIENCE_S))
            told.sendall(b"GET /" + b"x" * 1000)
            assert told.recv(1, socket.MSG_PEEK)
            timer = threading.Timer(PATIENCE_S, told.close)  # or this test would take as long
            timer.start()
        stopped_by_itself = timer.is_alive()
        timer.cancel()
        assert stopped_by_itself


def hung_up_without_a_word(connection: socket.socket) -> bool:
    try:
        return connection.recv(1) == b""
    except ConnectionResetError:
        return True


def test_an_unread_body_does_not_keep_a_connection(connection: socket.socket) -> None:
    """The wait for the next request begins again when the rest of the last one has come."""
    connection.sendall(b"POST /api/v1/snell" + HOST + b"Content-Length: 10\r\n\r\n")
    answer = HTTPResponse(connection)
    answer.begin()
    assert (answer.status, answer.will_close) == (405, False)
    answer.read()
    connection.sendall(b"0123456789")
    assert connection.recv(1) == b""


def test_a_connection_goes_on_after_an_unread_body(address: Address) -> None:
    unread = b"POST /api/v1/snell" + HOST + b"Content-Length: 10\r\n\r\n0123456789"
    with socket.create_connection(address, timeout=PATIENCE_S) as connection:
        connection.sendall(unread + HEALTH + b"Connection: close\r\n\r\n")
        assert statuses(connection) == [405, 200]


def test_asking_to_be_connected_elsewhere_is_refused(address: Address) -> None:
    assert exchange(address, b"CONNECT elsewhere:80" + HOST + b"\r\n").status == 400
