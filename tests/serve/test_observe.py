"""Request ids, the access log and the metrics."""

from __future__ import annotations

import json
import os
import re
import socket
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any, ClassVar

import pytest
from fastapi import FastAPI
from prometheus_client.parser import text_string_to_metric_families
from starlette.types import Receive, Scope, Send

from app.main import create_app
from app.server.observe.access_log import AccessLog
from app.server.observe.metrics import Metrics
from app.server.observe.middleware import Observed
from tests.api.raw import Answer, send
from tests.api.wire import exchange, received
from tests.serve.command import PATIENCE_S, Served, answers, serving, wait_for

API = b"/api/v1"
MADE = re.compile(r"[0-9a-f]{16}-[0-9]+")
ROUTES = [
    (API + b"/models/exact", "GET", 200, "/api/v1/models/{model_id}"),
    (API + b"/models/exact", "HEAD", 200, "/api/v1/models/{model_id}"),
    (API + b"/models/nope", "GET", 404, "/api/v1/models/{model_id}"),
    (API + b"/snell?n_t=1.5", "GET", 200, "/api/v1/snell"),
    (API + b"/snell?n_t=x", "GET", 422, "/api/v1/snell"),
    (API + b"/snell", "DELETE", 405, "/api/v1/snell"),
    (API + b"/nope", "GET", 404, "/{path}"),
    (b"/", "GET", 200, "/{path}"),
    (b"/metrics", "GET", 200, "/metrics"),
]


@pytest.fixture
def app() -> FastAPI:
    return create_app()


def samples(app: FastAPI) -> dict[tuple[str, ...], float]:
    """Scrape: the value of every sample by its name and labels' values."""
    answer = send(app, b"/metrics")
    assert answer.status == 200
    assert answer.headers["content-type"].startswith("text/plain; version=")
    assert answer.headers["cache-control"] == "no-store"
    return {
        (sample.name, *(value for _, value in sorted(sample.labels.items()))): sample.value
        for family in text_string_to_metric_families(answer.body.decode())
        for sample in family.samples
    }


class TestRequestId:
    @pytest.mark.parametrize("given", ["a", "7f3c-9.x_Y", "0" * 64])
    @pytest.mark.parametrize("target", [API + b"/models", API + b"/nope", b"/", API + b"/snell?x"])
    def test_a_valid_one_is_kept(self, app: FastAPI, target: bytes, given: str) -> None:
        assert send(app, target, headers={"X-Request-ID": given}).headers["x-request-id"] == given

    @pytest.mark.parametrize("given", ["", "0" * 65, "a b", "a\tb", "<script>", "ü", "a;b", '"'])
    def test_others_are_replaced(self, app: FastAPI, given: str) -> None:
        answer = send(app, API + b"/models", headers={"X-Request-ID": given})
        assert MADE.fullmatch(answer.headers["x-request-id"])

    def made(self, app: FastAPI) -> str:
        return send(app, API + b"/models", headers={"X-Request-ID": ""}).headers["x-request-id"]

    def test_two_requests_have_two(self, app: FastAPI) -> None:
        ids = {self.made(app) for _ in range(50)}
        assert len(ids) == 50

    def test_pages_elsewhere_may_send_and_read_it(self, app: FastAPI) -> None:
        origin = {"Origin": "https://example.org"}
        read = send(app, API + b"/models", headers=origin)
        assert "X-Request-ID" in read.headers["access-control-expose-headers"]
        asked = {
            "Access-Control-Request-Method": "GET",
            "Access-Control-Request-Headers": "x-request-id",
        }
        assert send(app, API + b"/models", "OPTIONS", origin | asked).status == 200


class TestMetrics:
    @pytest.mark.parametrize(("target", "method", "status", "route"), ROUTES)
    def test_requests_are_counted_by_route_method_and_status(
        self, app: FastAPI, target: bytes, method: str, status: int, route: str
    ) -> None:
        for _ in range(3):
            assert send(app, target, method).status == status
        counted = samples(app)
        assert counted["http_requests_total", method, route, str(status)] == 3
        assert counted["http_request_duration_seconds_count", route] == 3
        assert counted["http_request_duration_seconds_bucket", "+Inf", route] == 3
        assert counted["http_request_duration_seconds_sum", route] > 0.0

    def test_the_scrape_itself_is_in_flight(self, app: FastAPI) -> None:
        assert samples(app)["http_requests_in_flight",] == 1

    def test_hostile_requests_make_few_series(self, app: FastAPI) -> None:
        for i in range(200):
            send(app, b"/nope/%d" % i, f"METHOD{i}")
            send(app, API + b"/models/%d" % i)
        counted = samples(app)
        assert counted["http_requests_total", "GET", "/api/v1/models/{model_id}", "404"] == 200
        assert sum(v for k, v in counted.items() if k[:2] == ("http_requests_total", "other")) > 0
        assert len([key for key in counted if key[0] == "http_requests_total"]) < 10

    def test_two_applications_do_not_mix(self, app: FastAPI) -> None:
        send(app, API + b"/models")
        assert not any(key[0] == "http_requests_total" for key in samples(create_app()))

    def test_lookups_in_the_cache(self) -> None:
        async def cached(scope: Scope, _: Receive, send: Send) -> None:
            scope["cache"] = scope["path"].strip("/")
            await send({"type": "http.response.start", "status": 200, "headers": []})
            await send({"type": "http.response.body", "body": b"x"})

        metrics = Metrics()
        observed = Observed(cached, metrics, None)
        for target in (b"/hit", b"/hit", b"/miss"):
            send(observed, target)
        text = metrics.text().decode()
        assert 'fresnel_cache_lookups_total{result="hit"} 2.0' in text
        assert 'fresnel_cache_lookups_total{result="miss"} 1.0' in text


class Pipe:
    """An access log that a test reads."""

    def __init__(self) -> None:
        self.reading, writing = os.pipe()
        self.log = AccessLog(writing)
        self._writing = writing

    def line(self) -> bytes:
        """Take what one write put into the pipe; two lines would be too many."""
        line = os.read(self.reading, 65536)
        assert line.endswith(b"\n")
        assert line.count(b"\n") == 1
        return line

    def close(self) -> None:
        os.close(self._writing)


@pytest.fixture
def pipe() -> Iterator[Pipe]:
    made = Pipe()
    yield made
    made.close()


def logged(app: FastAPI, pipe: Pipe, target: bytes, **headers: str) -> tuple[Answer, Any]:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    answer = send(Observed(app, Metrics(), pipe.log), target, headers=named)
    return answer, json.loads(pipe.line())


class TestAccessLog:
    def test_says_what_was_asked_and_answered(self, app: FastAPI, pipe: Pipe) -> None:
        target = API + b"/models/exact?a=%C3%BC"
        answer, line = logged(app, pipe, target, X_Request_ID="mine", User_Agent="test/1")
        assert answer.status == 422
        assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d+Z", line.pop("time"))
        assert 0.0 < line.pop("duration_ms") < 60_000.0
        assert line == {
            "request_id": "mine",
            "client": "127.0.0.1",
            "method": "GET",
            "target": target.decode(),
            "route": "/api/v1/models/{model_id}",
            "status": 422,
            "bytes": len(answer.body),
            "cache": None,
            "user_agent": "test/1",
            "pid": os.getpid(),
        }

    def test_a_crash_is_named_beside_its_id(self, pipe: Pipe) -> None:
        app = create_app()

        @app.get("/crash")
        async def crash() -> None:
            raise ZeroDivisionError("by nought")

        app.router.routes.insert(0, app.router.routes.pop())
        answer, line = logged(app, pipe, b"/crash")
        assert (answer.status, line["status"]) == (500, 500)
        assert line["error"] == "ZeroDivisionError: by nought"
        assert b"nought" not in answer.body

    @pytest.mark.parametrize("character", ["a", '"', "\\", "ÿ"])
    def test_a_line_is_short_enough_to_be_written_at_once(
        self, app: FastAPI, pipe: Pipe, character: str
    ) -> None:
        target = b"/" + character.encode("latin-1") * 60_000
        scope_target = target if character.isascii() else target.replace(b"\xff", b"%FF")
        _, line = logged(app, pipe, scope_target, User_Agent=character * 8_000, X_Request_ID="-")
        assert len(json.dumps(line, ensure_ascii=False).encode()) < 4096

    def test_a_reader_that_is_gone_fails_no_request(self, app: FastAPI, pipe: Pipe) -> None:
        os.close(pipe.reading)
        assert send(Observed(app, Metrics(), pipe.log), API + b"/models").status == 200


def folders_in_memory() -> set[Path]:
    return set(Path("/dev/shm").glob("fresnel-explorer-*"))  # noqa: S108


def test_workers_count_and_log_together_and_leave_nothing_behind(tmp_path: Path) -> None:
    before = folders_in_memory()
    with serving(tmp_path, "--workers", "2") as served:
        for _ in range(40):
            assert served.ask("/api/v1/parameters").status == 200
        told = '{method="GET",route="/api/v1/parameters",status="200"} 40.0'
        for _ in range(6):  # whichever worker is asked; the other may be at the end of a request
            wait_for(lambda: f"http_requests_total{told}" in served.ask("/metrics").body.decode())
            wait_for(lambda: "in_flight 1.0" in served.ask("/metrics").body.decode())

        assert served.ask("/api/v1/models", X_Request_ID="found-again").status == 200
        wait_for(lambda: any(line["request_id"] == "found-again" for line in served.logged()))
        (line,) = (line for line in served.logged() if line["request_id"] == "found-again")
        assert (line["method"], line["route"], line["status"]) == ("GET", "/api/v1/models", 200)
    assert folders_in_memory() <= before


class TestRefusedBeforehand:
    """What the application never sees is logged, counted and given an id all the same."""

    TARGET = b"/api/v1/snell?n_t=" + b"1" * 300
    LIMITS: ClassVar = {
        "FRESNEL_MAX_TARGET_BYTES": "200",
        "FRESNEL_MAX_CONNECTIONS": "3",
        "FRESNEL_KEEP_ALIVE_S": "600",
        "FRESNEL_READ_TIMEOUT_S": "2",
    }
    HEAD = b" HTTP/1.1\r\nHost: test\r\nX-Request-ID: mine\r\n"
    REQUESTS = (
        (b"\x00\r\n\r\n", 400, "", ""),
        (b"GET " + TARGET + HEAD + b"\r\n", 414, "GET", TARGET.decode()),
        (b"HEAD /api/v1/models" + HEAD + b"X: y", 408, "HEAD", "/api/v1/models"),
        (
            b"POST /api/v1/evaluate" + HEAD + b"Content-Length: 9\r\n\r\n{",
            408,
            "POST",
            "/api/v1/evaluate",
        ),
    )

    def test_in_the_log_and_the_metrics(self, tmp_path: Path) -> None:
        with serving(tmp_path, **self.LIMITS) as served, ExitStack() as held:
            address = (served.host or "", served.port or 0)
            refused = [exchange(address, request) for request, *_ in self.REQUESTS]
            for answer, (_, status, *_) in zip(refused, self.REQUESTS, strict=True):
                assert answer.status == status
            while len(refused) == len(self.REQUESTS):
                connection = held.enter_context(socket.create_connection(address, PATIENCE_S))
                connection.sendall(b"GET /api/v1/models HTTP/1.1\r\nHost: test\r\n\r\n")
                if connection.recv(12, socket.MSG_PEEK) == b"HTTP/1.1 503":
                    refused.append(received(connection))
            expected = [*self.REQUESTS, (b"", 503, "", "")]
            held.close()
            wait_for(lambda: len(self.refusals(served)) >= len(expected))
            wait_for(lambda: answers(served, "/api/v1/health"))
            scraped = served.ask("/metrics").body.decode()
        for line, answer, (_, status, method, target) in zip(
            self.refusals(served), refused, expected, strict=True
        ):
            assert (line["status"], line["method"], line["target"]) == (status, method, target)
            assert line["request_id"] == answer.headers["x-request-id"]
            assert line["bytes"] == len(answer.body)
            assert line["client"] == "127.0.0.1"
        kept = [line["status"] for line in self.refusals(served) if line["request_id"] == "mine"]
        assert kept == [408, 408]  # the others' ids had not come yet
        for method, route, status, count in (
            ("other", "/{path}", 400, 1),
            ("GET", "/{path}", 414, 1),
            ("HEAD", "/{path}", 408, 1),
            ("POST", "/api/v1/evaluate", 408, 1),
            ("other", "/{path}", 503, 1),
        ):
            labels = f'method="{method}",route="{route}",status="{status}"'
            assert f"http_requests_total{{{labels}}} {count}.0" in scraped
        assert "http_requests_in_flight 1.0" in scraped

    @staticmethod
    def refusals(served: Served) -> list[dict[str, Any]]:
        return [line for line in served.logged() if line["status"] in (400, 408, 414, 503)]
