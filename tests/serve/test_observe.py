"""Request ids, the access log and the metrics."""

import json
import logging
import os
import re
from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import pytest
from fastapi import FastAPI
from prometheus_client.parser import text_string_to_metric_families
from starlette.types import Receive, Scope, Send

from app.main import create_app
from app.server.observe.access_log import AccessLog
from app.server.observe.lines import Lines, LinesHandler
from app.server.observe.metrics import Metrics
from app.server.observe.middleware import Observed
from tests.api.raw import Answer, send

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
    (b"/" + b"x" * 20_000, "GET", 414, "/{path}"),
]


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


class TestMetrics:
    @pytest.mark.parametrize(("target", "method", "status", "route"), ROUTES)
    def test_requests_are_counted_by_route_method_and_status(
        self, app: FastAPI, target: bytes, method: str, status: int, route: str
    ) -> None:
        before = samples(app)
        for _ in range(3):
            assert send(app, target, method).status == status
        after = samples(app)
        scraped = route == "/metrics"  # by the first look, too
        for key in (
            ("http_requests_total", method, route, str(status)),
            ("http_request_duration_seconds_count", route),
            ("http_request_duration_seconds_bucket", "+Inf", route),
        ):
            assert after[key] - before.get(key, 0) == 3 + scraped
        seconds = ("http_request_duration_seconds_sum", route)
        assert after[seconds] > before.get(seconds, 0.0)

    def test_the_scrape_itself_is_in_flight(self, app: FastAPI) -> None:
        assert samples(app)["http_requests_in_flight",] == 1

    def test_hostile_requests_make_few_series(self, app: FastAPI) -> None:
        before = samples(app)
        for i in range(200):
            send(app, b"/nope/%d" % i, f"METHOD{i}")
            send(app, API + b"/models/%d" % i)
        counted = samples(app)
        unknown = ("http_requests_total", "GET", "/api/v1/models/{model_id}", "404")
        assert counted[unknown] - before.get(unknown, 0) == 200
        assert sum(v for k, v in counted.items() if k[:2] == ("http_requests_total", "other")) > 0
        made = [key for key in counted.keys() - before.keys() if key[0] == "http_requests_total"]
        assert len(made) < 5

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
        self.lost = 0
        self.log = AccessLog(Lines(writing, self.lose, most=5))
        self._writing = writing

    def lose(self) -> None:
        self.lost += 1

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

    def test_data_of_own_materials_are_not_logged(self, app: FastAPI, pipe: Pipe) -> None:
        for spelled in (b"own:AbcDef-_1", b"own%3AAbcDef-_1"):
            _, line = logged(app, pipe, API + b"/snell?material=" + spelled + b"&n_i=2")
            assert "AbcDef" not in json.dumps(line)
            assert line["target"].endswith("...&n_i=2")
            _, line = logged(app, pipe, API + b"/materials/" + spelled + b"/spectrum")
            assert "AbcDef" not in json.dumps(line)

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
        pipe.log.flush()
        assert pipe.lost == 1


class TestReaders:
    """A pipe that nobody reads takes 64 kB; here it is full from the start."""

    @pytest.fixture
    def full(self) -> Iterator[tuple[int, int]]:
        reading, writing = os.pipe()
        os.set_blocking(writing, False)
        with suppress(BlockingIOError):
            while True:
                os.write(writing, b"x" * 4096)
        os.set_blocking(writing, True)
        yield reading, writing
        os.close(reading)

    def test_lines_that_nobody_reads_are_dropped_and_counted(self, full: tuple[int, int]) -> None:
        metrics = Metrics()
        lines = Lines(full[1], metrics.dropped, most=5)
        for _ in range(20):
            lines.write(b"a line\n")
        lines.flush(0.01)  # which does not wait for ever
        (dropped,) = re.findall(
            rb"^fresnel_access_log_lines_dropped_total (\d+)", metrics.text(), re.M
        )
        assert int(dropped) in (14, 15)  # one more may be under way

    def test_the_log_of_errors_says_how_many_were_lost(self, full: tuple[int, int]) -> None:
        logger = logging.Logger("test")
        handler = LinesHandler(full[1], most=5)
        logger.addHandler(handler)
        for number in range(20):
            logger.error("before %d", number)
        reader = os.fdopen(full[0], "rb", closefd=False)
        while reader.read1(65536).startswith(b"x"):
            pass
        handler.flush()
        logger.error("after")
        handler.flush()
        told = reader.read1(65536)
        while b"after" not in told:
            told += reader.read1(65536)
        (lost,) = re.findall(rb"(\d+) records before this one were lost\nafter\n", told)
        assert int(lost) in (14, 15)
