"""What a client may send, how slowly, and how much of the server it may have."""

from __future__ import annotations

import json
import resource
import select
import socket
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, suppress
from typing import Any
from unittest.mock import Mock

import pytest

from app.http.problems import MEDIA_TYPE
from app.main import create_app
from app.server.pool import Pool
from app.server.protocol import BoundedProtocol
from app.server.run import allow_open_files
from app.settings import Settings
from tests.api.raw import Answer, send
from tests.api.wire import Address, exchange, get, received, served

API = b"/api/v1"
HEALTH = API + b"/health"
PATIENCE_S = 30.0
TIGHT = Settings(
    max_target_bytes=200,
    max_header_bytes=1000,
    max_connections=50,
)
HASTY = Settings(read_timeout_s=0.3, write_timeout_s=0.3)


@pytest.fixture(scope="module")
def tight() -> Iterator[Address]:
    with served(settings=TIGHT) as address:
        yield address


@pytest.fixture(scope="module")
def hasty() -> Iterator[Address]:
    with served(settings=HASTY) as address:
        yield address


def refused(answer: Answer, status: int, setting: str) -> None:
    """Assert that this is a problem which names the setting."""
    assert answer.status == status
    assert answer.headers["content-type"] == MEDIA_TYPE
    assert answer.headers["access-control-allow-origin"] == "*"
    assert answer.headers["connection"] == "close"
    assert int(answer.headers["content-length"]) == len(answer.body)
    told = json.loads(answer.body)
    assert told["status"] == status
    assert setting in told["detail"]
    assert setting.removeprefix("FRESNEL_").lower() in Settings.model_fields


class TestSize:
    def test_a_target_may_be_as_long_as_the_limit(self, tight: Address) -> None:
        path = API + b"/snell?n_t="
        longest = path + b"1" * (200 - len(path))
        assert get(tight, longest).status == 422
        refused(get(tight, longest + b"1"), 414, "FRESNEL_MAX_TARGET_BYTES")

    def test_a_refusal_arrives_though_more_is_sent(self, tight: Address) -> None:
        """Closing at once would reset the connection, and the answer with it."""
        for _ in range(20):
            answer = get(tight, API + b"/snell?n_t=" + b"1" * 400_000)
            refused(answer, 414, "FRESNEL_MAX_TARGET_BYTES")

    def test_headers_together(self, tight: Address) -> None:
        def with_headers(count: int) -> Answer:
            more = b"".join(b"X%03d: " % i + b"v" * 90 + b"\r\n" for i in range(count))
            head = b"GET " + HEALTH + b" HTTP/1.1\r\nHost: test\r\nConnection: close\r\n"
            return exchange(tight, head + more + b"\r\n")

        assert with_headers(9).status == 200
        refused(with_headers(11), 431, "FRESNEL_MAX_HEADER_BYTES")

    @pytest.mark.parametrize("start", [b"GET " + HEALTH + b" HTTP/1.1\r\nX: ", b"GET "])
    def test_what_never_ends_is_not_read_for_ever(self, tight: Address, start: bytes) -> None:
        with socket.create_connection(tight, timeout=10) as connection:
            connection.sendall(start)
            answer = None
            for _ in range(100):
                connection.sendall(b"/" * 100)
                time.sleep(0.001)
                connection.settimeout(0.001)
                try:
                    if connection.recv(1, socket.MSG_PEEK):
                        connection.settimeout(10)
                        answer = received(connection)
                        break
                except TimeoutError:
                    continue
        assert answer is not None
        setting = "HEADER" if b"HTTP" in start else "TARGET"
        refused(answer, 431 if b"HTTP" in start else 414, f"FRESNEL_MAX_{setting}_BYTES")

    @pytest.mark.parametrize("target", [b"/curves?samples=12", b"/curves?samples=12&format=csv"])
    def test_samples(self, target: bytes) -> None:
        app = create_app(Settings(max_samples=11))
        assert send(app, API + b"/curves?samples=11").status == 200
        (error,) = send(app, API + target).json()["errors"]
        assert (error["parameter"], error["value"]) == ("samples", 12)
        assert "11 (FRESNEL_MAX_SAMPLES)" in error["message"]

    @pytest.mark.parametrize(
        ("target", "parameter"),
        [
            (b"/errors/map?x_steps=11&y_steps=10", "x_steps"),
            (b"/albedo/map?n_steps=11&k_steps=10", "n_steps"),
            (b"/materials/Au/map?steps=11&samples=10", "steps"),
        ],
    )
    def test_cells(self, target: bytes, parameter: str) -> None:
        app = create_app(Settings(max_cells=100))
        assert send(app, API + target.replace(b"11", b"10")).status == 200
        (error,) = send(app, API + target).json()["errors"]
        assert error["parameter"] == parameter
        assert "100 (FRESNEL_MAX_CELLS)" in error["message"]

    def test_limits_above_the_contract_do_not_widen_it(self) -> None:
        app = create_app(Settings(max_samples=10**6, max_cells=10**7))
        assert send(app, API + b"/curves?samples=20002").status == 422
        assert send(app, API + b"/errors/map?x_steps=501&y_steps=501").status == 422


@pytest.fixture(scope="module")
def batches() -> Iterator[Address]:
    with served(settings=Settings(max_body_bytes=1000)) as address:
        yield address


class TestBody:
    @staticmethod
    def post(address: Address, headers: bytes, body: bytes) -> Answer:
        head = b"POST /api/v1/evaluate HTTP/1.1\r\nHost: test\r\n" + headers
        return exchange(address, head + b"\r\n" + body)

    def test_the_longest_is_taken(self, batches: Address) -> None:
        close = b"Connection: close\r\n"
        answer = self.post(batches, close + b"Content-Length: 1000\r\n", b"x" * 1000)
        assert answer.status == 422  # read, and no JSON

    @pytest.mark.parametrize(
        ("headers", "body"),
        [
            (b"Content-Length: 1001\r\n", b"x" * 1001),
            (b"Content-Length: 1001\r\n", b""),  # refused before it comes
            (b"Content-Length: 10000000000\r\n", b"x"),
            (b"Transfer-Encoding: chunked\r\n", b"3e9\r\n" + b"x" * 1001 + b"\r\n0\r\n\r\n"),
            (b"Transfer-Encoding: chunked\r\n", 1001 * b"1\r\nx\r\n"),
        ],
        ids=["sent", "announced", "huge", "in one chunk", "in many chunks"],
    )
    def test_a_longer_one_is_not(self, batches: Address, headers: bytes, body: bytes) -> None:
        refused(self.post(batches, headers, body), 413, "FRESNEL_MAX_BODY_BYTES")


class TestProxies:
    """Who the client is, only trusted proxies may say; it shows in how the page redirects."""

    TARGET = (
        b"GET /docs HTTP/1.1\r\nHost: test\r\nConnection: close\r\n"
        b"X-Forwarded-Proto: https\r\nX-Forwarded-For: 203.0.113.7\r\n\r\n"
    )

    @pytest.mark.parametrize(
        ("trusted", "scheme"),
        [("", "http"), ("192.0.2.1", "http"), ("127.0.0.1", "https"), ("127.0.0.0/8", "https")],
    )
    def test_only_trusted_ones(self, trusted: str, scheme: str) -> None:
        with served(settings=Settings(trusted_proxies=trusted)) as address:
            answer = exchange(address, self.TARGET)
        assert answer.status == 307
        assert answer.headers["location"] == f"{scheme}://test/docs/"


class TestTime:
    @pytest.mark.parametrize(
        "start",
        [
            b"GET " + HEALTH + b" HTTP/1.1\r\nHost: te",
            b"G",
            b"POST " + HEALTH.replace(b"health", b"evaluate")
            + b" HTTP/1.1\r\nHost: test\r\nContent-Length: 100\r\n",
        ],
    )  # fmt: skip
    def test_a_request_that_does_not_go_on(self, hasty: Address, start: bytes) -> None:
        refused(exchange(hasty, start), 408, "FRESNEL_READ_TIMEOUT_S")

    def test_a_request_in_drops_takes_no_longer(self, hasty: Address) -> None:
        """One byte at a time does not count as going on."""
        with socket.create_connection(hasty, timeout=PATIENCE_S) as connection:
            connection.sendall(b"GET " + HEALTH + b" HTTP/1.1\r\nX: ")
            for _ in range(int(PATIENCE_S / 0.05)):
                connection.sendall(b"x")
                if select.select([connection], [], [], 0.05)[0]:
                    break
            refused(received(connection), 408, "FRESNEL_READ_TIMEOUT_S")

    def test_a_connection_that_says_nothing_is_closed_silently(self, hasty: Address) -> None:
        with socket.create_connection(hasty, timeout=PATIENCE_S) as connection:
            assert connection.recv(1000) == b""

    def test_an_answer_that_is_not_read_is_given_up(
        self, tight: Address, hasty: Address, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        lost, connection_lost = threading.Event(), BoundedProtocol.connection_lost

        def noted(protocol: BoundedProtocol, exc: Exception | None) -> None:
            connection_lost(protocol, exc)
            if protocol.client == address:
                lost.set()

        target = API + b"/curves?samples=20001&models=exact,schlick&phase=true&refraction=true"
        expected = len(get(tight, target).body)
        assert expected > 2_000_000
        with socket.socket() as connection:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            connection.connect(hasty)
            address = connection.getsockname()
            monkeypatch.setattr(BoundedProtocol, "connection_lost", noted)
            # Several, as the system's own buffers may hold one.
            connection.sendall(5 * (b"GET " + target + b" HTTP/1.1\r\nHost: test\r\n\r\n"))
            assert lost.wait(PATIENCE_S)
            connection.settimeout(10)
            taken = 0
            with suppress(ConnectionResetError):
                while part := connection.recv(1_000_000):
                    taken += len(part)
        assert taken < 5 * expected

    def test_a_slow_reader_is_waited_for_while_it_reads(self) -> None:
        transport = Mock()
        transport.get_write_buffer_size.return_value = 300
        protocol = BoundedProtocol.__new__(BoundedProtocol)
        protocol.loop, protocol.transport = Mock(), transport
        protocol._settings, protocol._write_timer = HASTY, None
        protocol.flow = Mock()
        protocol.pause_writing()
        for size in (200, 100, 1):
            patience, elapsed = protocol.loop.call_later.call_args.args
            assert patience == HASTY.write_timeout_s
            transport.get_write_buffer_size.return_value = size
            elapsed()
        transport.abort.assert_not_called()
        assert protocol.loop.call_later.call_count == 4
        elapsed()
        transport.abort.assert_called_once()


def slow(address: Address) -> socket.socket:
    """Open a connection and send the beginning of a request."""
    connection = socket.create_connection(address, timeout=10)
    connection.sendall(b"GET " + HEALTH + b" HTTP/1.1\r\nHost: test\r\nX-Slow: ")
    return connection


class TestManyConnections:
    def test_one_more_than_the_most_is_told_so(self) -> None:
        with (
            served(settings=Settings(max_connections=5, keep_alive_s=600)) as address,
            ExitStack() as held,
        ):
            for _ in range(5):
                one = held.enter_context(socket.create_connection(address, timeout=PATIENCE_S))
                one.sendall(b"GET " + HEALTH + b" HTTP/1.1\r\nHost: test\r\n\r\n")
                assert one.recv(1, socket.MSG_PEEK)  # it is among the connections now
            answer = exchange(address, b"")
            refused(answer, 503, "FRESNEL_MAX_CONNECTIONS")
            assert int(answer.headers["retry-after"]) >= 1

    def test_two_thousand_slow_ones_do_not_starve_others(self) -> None:
        """How soon `/health` answers then, `python -m benchmarks health` measures."""
        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        allow_open_files(2 * 2200)
        if resource.getrlimit(resource.RLIMIT_NOFILE)[0] < 2 * 2100:
            pytest.skip("this system does not let a process open so many files")
        try:
            with served() as address, ExitStack() as held:
                for _ in range(2000):
                    held.enter_context(slow(address))
                for _ in range(50):
                    assert get(address, HEALTH).status == 200
        finally:
            resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))

    def test_computations_do_not_hold_up_the_health_check(
        self, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        begun, go_on = threading.Semaphore(0), threading.Event()
        run = Pool.run

        def held(pool: Pool, function: Callable[[], Any]) -> Any:
            def wait() -> Any:
                begun.release()
                assert go_on.wait(10)
                return function()

            return run(pool, wait)

        monkeypatch.setattr(Pool, "run", held)
        target = API + b"/errors/map?x=n_t&y=k_t&metric=rms&x_steps=90&y_steps=%d"
        settings = Settings(threads=3)
        with served(settings=settings) as address, ThreadPoolExecutor(3) as clients:
            asked = [clients.submit(get, address, target % (90 + i)) for i in range(3)]
            for _ in asked:
                assert begun.acquire(timeout=10)
            assert get(address, HEALTH).status == 200
            assert not any(one.done() for one in asked)
            go_on.set()
            assert all(one.result().status == 200 for one in asked)


def test_files_that_may_be_open_are_never_made_fewer() -> None:
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    allow_open_files(1)
    assert resource.getrlimit(resource.RLIMIT_NOFILE) == before
