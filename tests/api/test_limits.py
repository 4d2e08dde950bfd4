"""What a client may send, and how much of the server it may have."""

import asyncio
import json
import re
import resource
import socket
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, suppress
from http.client import HTTPConnection
from typing import Any, Literal

import pytest
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.http.bounds import Bounded
from app.http.problems import MEDIA_TYPE
from app.main import create_app
from app.server.pool import Pool
from app.server.run import allow_open_files, parser
from app.settings import Settings
from tests.api.raw import Answer, send
from tests.api.wire import Address, exchange, get, received, served
from tests.serve.command import wait_for

API = b"/api/v1"
HEALTH = API + b"/health"
HOST = b" HTTP/1.1\r\nHost: test\r\n"
CLOSE = b"Connection: close\r\n"
MAP = API + b"/errors/map?x=n_t&y=k_t&metric=rms&x_steps=90&y_steps=%d"
PATIENCE_S = 30.0
APP = create_app()
PARSERS = ("h11", "httptools")
Parser = Literal["h11", "httptools"]


@pytest.fixture(scope="module", params=PARSERS)
def tight(request: pytest.FixtureRequest) -> Iterator[Address]:
    settings = Settings(
        http=request.param, max_target_bytes=200, max_header_bytes=1000, max_body_bytes=1000
    )
    with served(settings=settings) as address:
        yield address


def refused(answer: Answer, status: int, setting: str) -> None:
    """Assert that this is a problem which names the setting."""
    assert answer.status == status
    assert answer.headers["content-type"] == MEDIA_TYPE
    assert answer.headers["access-control-allow-origin"] == "*"
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

    def test_headers_together(self, tight: Address) -> None:
        def with_headers(count: int) -> Answer:
            more = b"".join(b"X%03d: " % i + b"v" * 90 + b"\r\n" for i in range(count))
            return exchange(tight, b"GET " + HEALTH + HOST + CLOSE + more + b"\r\n")

        assert with_headers(9).status == 200
        refused(with_headers(11), 431, "FRESNEL_MAX_HEADER_BYTES")

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


class TestBody:
    @staticmethod
    def post(address: Address, headers: bytes, body: bytes) -> Answer:
        return exchange(address, b"POST /api/v1/evaluate" + HOST + CLOSE + headers + b"\r\n" + body)

    def test_the_longest_is_taken(self, tight: Address) -> None:
        answer = self.post(tight, b"Content-Length: 1000\r\n", b"x" * 1000)
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
    def test_a_longer_one_is_not(self, tight: Address, headers: bytes, body: bytes) -> None:
        refused(self.post(tight, headers, body), 413, "FRESNEL_MAX_BODY_BYTES")

    @pytest.mark.parametrize("is_chunked", [False, True])
    def test_a_client_that_sends_all_of_it_is_told_so(
        self, tight: Address, is_chunked: bool
    ) -> None:
        """Hung up on while it sends, a client would see a broken connection instead."""
        connection = HTTPConnection(*tight, timeout=PATIENCE_S)
        body = b"x" * 10_000_000
        sent = iter([body[:5_000_000], body[5_000_000:]]) if is_chunked else body
        connection.request("POST", "/api/v1/evaluate", sent)
        answer = connection.getresponse()
        assert answer.status == 413
        answer.read()
        connection.request("GET", "/api/v1/health")
        assert connection.getresponse().read()
        connection.close()


class TestProxies:
    """Who the client is, only trusted proxies may say."""

    TARGET = (
        b"GET / HTTP/1.1\r\nHost: test\r\nConnection: close\r\n"
        b"X-Forwarded-Proto: https\r\nX-Forwarded-For: 203.0.113.7\r\n\r\n"
    )

    @pytest.mark.parametrize(
        ("trusted", "scheme"),
        [("", "http"), ("192.0.2.1", "http"), ("127.0.0.1", "https"), ("127.0.0.0/8", "https")],
    )
    def test_only_trusted_ones(self, trusted: str, scheme: str) -> None:
        seen: list[tuple[str, str]] = []

        async def app(scope: Scope, _: Receive, send: Send) -> None:
            if scope["type"] == "http":
                seen.append((scope["scheme"], scope["client"][0]))
                await send({"type": "http.response.start", "status": 204, "headers": []})
                await send({"type": "http.response.body", "body": b""})

        with served(app, Settings(trusted_proxies=trusted)) as address:
            assert exchange(address, self.TARGET).status == 204
        client = "203.0.113.7" if scheme == "https" else "127.0.0.1"
        assert seen == [(scheme, client)]


async def no_body() -> Message:
    return {"type": "http.disconnect"}


def bounded(app: ASGIApp, write_timeout_s: float) -> Bounded:
    return Bounded(
        app,
        target_bytes=200,
        header_bytes=1000,
        read_timeout_s=30.0,
        write_timeout_s=write_timeout_s,
    )


class TestUnreadAnswers:
    """A large answer is handed to the server in pieces, each when a client has read some of it."""

    BODY = bytes(range(256)) * 4000

    @classmethod
    async def app(cls, scope: Scope, _: Receive, send: Send) -> None:
        headers = [(b"content-length", b"%d" % len(cls.BODY))] if "length" in scope["path"] else []
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        await send({"type": "http.response.body", "body": cls.BODY[:700_000], "more_body": True})
        await send({"type": "http.response.body", "body": cls.BODY[700_000:]})

    def sent_to(self, reads: Callable[[int], bool], path: str) -> list[Message]:
        """What is sent to a client that reads as long as `reads` says of the number of messages."""
        sent: list[Message] = []

        async def take(message: Message) -> None:
            if not reads(len(sent)):
                await asyncio.Event().wait()
            sent.append(message)

        scope = {"type": "http", "path": path, "raw_path": b"", "query_string": b"", "headers": []}
        asyncio.run(bounded(self.app, 0.05)(scope, no_body, take))
        return sent

    @pytest.mark.parametrize("path", ["/with/length", "/streamed"])
    def test_one_who_reads_gets_all(self, path: str) -> None:
        start, *parts = self.sent_to(lambda _: True, path)
        assert start["status"] == 200
        assert b"".join(part["body"] for part in parts) == self.BODY
        assert all(len(part["body"]) <= 300_000 for part in parts)
        assert [part.get("more_body", False) for part in parts] == [True] * (len(parts) - 1) + [
            False
        ]

    @pytest.mark.parametrize("path", ["/with/length", "/streamed"])
    @pytest.mark.parametrize("messages", [0, 1, 3])
    def test_one_who_reads_nothing_more_is_given_up(self, path: str, messages: int) -> None:
        assert len(self.sent_to(lambda sent: sent < messages, path)) == messages

    def test_one_who_reads_a_little_now_and_then_is_given_up(self) -> None:
        """The whole counts, not the pause."""

        async def app(_: Scope, __: Receive, send: Send) -> None:
            await send({"type": "http.response.start", "status": 200, "headers": []})
            for ___ in range(200):
                part = {"type": "http.response.body", "body": b"0123456789", "more_body": True}
                await send(part)

        sent = 0

        async def take(_: Message) -> None:
            nonlocal sent
            await asyncio.sleep(0.01)
            sent += 1

        scope = {"type": "http", "path": "/", "raw_path": b"", "query_string": b"", "headers": []}
        asyncio.run(bounded(app, 0.1)(scope, no_body, take))
        assert 3 < sent < 100

    def test_the_connection_is_closed_then(self) -> None:
        body = bytes(30_000_000)  # more than the system's own buffers hold
        given_up = threading.Event()

        async def app(_: Scope, __: Receive, send: Send) -> None:
            await send({"type": "http.response.start", "status": 200, "headers": []})
            await send({"type": "http.response.body", "body": body})

        async def noted(scope: Scope, receive: Receive, send: Send) -> None:
            if scope["type"] == "http":
                await bounded(app, 0.1)(scope, receive, send)
                given_up.set()

        with (
            served(noted) as address,
            socket.create_connection(address, timeout=PATIENCE_S) as connection,
        ):
            connection.sendall(b"GET /" + HOST + b"\r\n")
            assert given_up.wait(PATIENCE_S)
            taken = sum(len(part) for part in iter(lambda: connection.recv(1_000_000), b""))
        assert taken < len(body)


class TestSlowBodies:
    @pytest.mark.parametrize("http", PARSERS)
    def test_one_that_trickles_is_not_waited_for(self, http: Parser) -> None:
        head = b"POST /api/v1/evaluate" + HOST + b"Content-Length: 1000\r\n\r\n"
        with (
            served(settings=Settings(http=http, read_timeout_s=0.3)) as address,
            socket.create_connection(address, timeout=PATIENCE_S) as connection,
        ):
            connection.sendall(head)
            connection.settimeout(0.05)
            for _ in range(200):
                connection.sendall(b"x")
                with suppress(TimeoutError):
                    assert connection.recv(12) == b"HTTP/1.1 408"
                    break
            connection.settimeout(PATIENCE_S)
            answer = received(connection, b"HTTP/1.1 408")
        refused(answer, 408, "FRESNEL_READ_TIMEOUT_S")

    def test_one_that_comes_is_taken_however_long_it_takes(self) -> None:
        """At 200 kB a second, twice as fast as has to be."""
        body = json.dumps({"items": [{"n_t": 1.5}]}).encode().ljust(100_000)
        head = b"POST /api/v1/evaluate" + HOST + CLOSE + b"Content-Length: 100000\r\n\r\n"
        with (
            served(settings=Settings(read_timeout_s=0.2)) as address,
            socket.create_connection(address, timeout=PATIENCE_S) as connection,
        ):
            connection.sendall(head)
            for start in range(0, 100_000, 10_000):
                time.sleep(0.05)
                connection.sendall(body[start : start + 10_000])
            assert received(connection).status == 200


class TestGoneClients:
    """Who has hung up is not computed for."""

    @pytest.mark.parametrize("http", PARSERS)
    @pytest.mark.parametrize("method", ["GET", "HEAD", "POST"])
    def test_what_nobody_waits_for_leaves_the_queue(
        self, http: Parser, method: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        begun, go_on = threading.Semaphore(0), threading.Event()
        run, asked = Pool.run, 0
        computed: list[int] = []

        def held(pool: Pool, function: Callable[[], Any], **how: Any) -> Any:
            nonlocal asked
            asked += 1
            number = asked

            def wait() -> Any:
                computed.append(number)
                begun.release()
                assert go_on.wait(PATIENCE_S)
                return function()

            return run(pool, wait, **how)

        monkeypatch.setattr(Pool, "run", held)
        settings = Settings(http=http, threads=1, max_waiting=3)
        with served(settings=settings) as address, ThreadPoolExecutor() as clients:
            first = clients.submit(get, address, MAP % 70)
            assert begun.acquire(timeout=PATIENCE_S)
            with ExitStack() as leaving:
                for steps in range(71, 74):
                    one = leaving.enter_context(socket.create_connection(address, PATIENCE_S))
                    target = MAP % steps if method != "POST" else b"/api/v1/evaluate"
                    body = b'{"items": []}' if method == "POST" else b""
                    length = b"Content-Length: %d\r\n\r\n" % len(body)
                    one.sendall(method.encode() + b" " + target + HOST + length + body)
                wait_for(lambda: asked == 4)
                assert get(address, MAP % 74).status == 503  # the queue is full

            def is_taken() -> bool:
                try:
                    return clients.submit(get, address, MAP % 75).result(0.3).status == 200
                except TimeoutError:
                    return True  # it waits

            wait_for(is_taken)
            go_on.set()
            assert first.result().status == 200
        assert not {2, 3, 4} & set(computed)


class TestConnections:
    @pytest.mark.parametrize("http", PARSERS)
    def test_every_request_of_a_connection_is_answered_in_order(self, http: Parser) -> None:
        unread = b"POST /api/v1/snell" + HOST + b"Content-Length: 10\r\n\r\n0123456789"
        large = b"".join(b"GET " + MAP % steps + HOST + b"\r\n" for steps in (90, 91))
        last = b"GET " + HEALTH + HOST + CLOSE + b"\r\n"
        with (
            served(APP, Settings(http=http)) as address,
            socket.create_connection(address, timeout=PATIENCE_S) as connection,
        ):
            connection.sendall(unread + large + last)
            data = b"".join(iter(lambda: connection.recv(65536), b""))
        statuses = re.findall(rb"HTTP/1\.1 (\d{3}) ", data)
        assert statuses == [b"405", b"200", b"200", b"200"]

    @pytest.mark.parametrize("http", PARSERS)
    def test_one_more_than_the_most_is_told_so(self, http: Parser) -> None:
        settings = Settings(http=http, max_connections=5, keep_alive_s=600)
        with served(APP, settings) as address, ExitStack() as held:
            for _ in range(5):
                one = held.enter_context(socket.create_connection(address, timeout=PATIENCE_S))
                one.sendall(b"GET " + HEALTH + HOST + b"\r\n")
                assert one.recv(12) == b"HTTP/1.1 200"
            one = held.enter_context(socket.create_connection(address, timeout=PATIENCE_S))
            one.sendall(b"GET " + HEALTH + HOST + b"\r\n")
            assert received(one).status == 503

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
        with served(APP) as address, ThreadPoolExecutor() as clients:
            asked = [
                clients.submit(get, address, MAP % (95 + i)) for i in range(Settings().threads)
            ]
            for _ in asked:
                assert begun.acquire(timeout=10)
            assert get(address, HEALTH).status == 200
            assert not any(one.done() for one in asked)
            go_on.set()
            assert all(one.result().status == 200 for one in asked)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({}, "httptools"),
        ({"host": "127.0.0.2"}, "httptools"),
        ({"host": "::1"}, "httptools"),
        ({"host": "localhost"}, "httptools"),
        ({"host": "0.0.0.0"}, "h11"),  # noqa: S104
        ({"host": "::"}, "h11"),
        ({"host": "fresnel.example"}, "h11"),
        ({"host": "127.0.0.1", "http": "h11"}, "h11"),
        ({"host": "::", "http": "httptools"}, "httptools"),
    ],
)
def test_strangers_meet_the_parser_that_keeps_little(given: dict[str, Any], expected: str) -> None:
    assert parser(Settings(**given)) == expected


def test_files_that_may_be_open_are_never_made_fewer() -> None:
    before = resource.getrlimit(resource.RLIMIT_NOFILE)
    allow_open_files(1)
    assert resource.getrlimit(resource.RLIMIT_NOFILE) == before


@pytest.mark.parametrize("size", [64, 256])
def test_a_sweep_of_a_model_with_many_kinks_is_bounded_by_what_it_takes(
    size: int,
) -> None:
    """Each of its pieces is integrated by itself; twenty thousand steps took more than 30 s."""
    target = API + b"/errors/sweep?model=lut_1d&lut_1d.size=%d&steps=20001" % size
    answer = send(APP, target)
    assert answer.status == 422
    (error,) = answer.json()["errors"]
    assert error["parameter"] == "steps"
    (told,) = re.findall(r"at most (\d+) interfaces", error["message"])
    assert 500_000 < int(told) * size < 1_000_000
