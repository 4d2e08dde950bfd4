"""Two servers behind nginx as `deploy/` configures it: cached, and one may die."""

import gzip
import json
import signal
import socket
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from http import HTTPStatus
from http.client import HTTPConnection, HTTPResponse
from pathlib import Path

import pytest
import zstandard

from app.http.problems import MEDIA_TYPE, Problem
from tests.serve.command import API, PATIENCE_S, Answer, Load, Served, answers, serving, wait_for
from tests.serve.nginx import find_nginx, in_front_of

CURVES = f"{API}/curves?models=exact,schlick&n_t=1.{{}}"


@dataclass
class Site:
    """nginx and the servers behind it."""

    front: Served
    servers: list[Served]

    def logged(self, request_id: str) -> list[dict[str, object]]:
        """What the servers logged of a request."""
        lines = [line for server in self.servers for line in server.logged()]
        return [line for line in lines if line["request_id"] == request_id]

    def reached(self, target: str, at_least: int = 0) -> int:
        """How many requests for an address came to the servers.

        They are logged once their answer is on its way, so the last line may be late.
        """
        patience = time.monotonic() + 10.0
        while True:
            lines = [line for server in self.servers for line in server.logged()]
            count = sum(line["target"] == target for line in lines)
            if count >= at_least or time.monotonic() > patience:
                return count
            time.sleep(0.05)


REFUSED = (400, 404, 405, 413, 414, 416, 494, 500, 501, 502, 503, 504, 505)
TESTED = "".join(f"location = /refused/{status} {{ return {status}; }}\n" for status in REFUSED)


@pytest.fixture(scope="module")
def nginx(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return find_nginx(tmp_path_factory.mktemp("package"))


@pytest.fixture(scope="module")
def site(nginx: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    folders = [tmp_path_factory.mktemp(name) for name in ("first", "second", "nginx")]
    with (
        serving(folders[0], FRESNEL_TRUSTED_PROXIES="127.0.0.1") as first,
        serving(folders[1], FRESNEL_TRUSTED_PROXIES="127.0.0.1") as second,
        in_front_of(nginx, folders[2], [f"127.0.0.1:{s.port}" for s in (first, second)]) as front,
    ):
        wait_for(lambda: answers(front, f"{API}/health/live"))
        yield Site(front, [first, second])


@pytest.fixture(scope="module")
def alone(nginx: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """A hasty nginx before one server that is not there and one that never answers."""
    with socket.create_server(("127.0.0.1", 0)) as late, socket.socket() as closed:
        closed.bind(("127.0.0.1", 0))
        port = late.getsockname()[1]
        slow = f"location = /late {{ proxy_pass http://127.0.0.1:{port}; proxy_read_timeout 1s; }}"
        changed = {
            "location / {": f"{TESTED} {slow} location / {{",
            "client_header_timeout 15s": "client_header_timeout 1s",
        }
        upstream = [f"127.0.0.1:{closed.getsockname()[1]}"]
        with in_front_of(nginx, tmp_path_factory.mktemp("alone"), upstream, changed) as front:
            yield front


def test_an_answer_is_asked_for_once(site: Site) -> None:
    target = CURVES.format(1001)
    first, second = site.front.ask(target), site.front.ask(target)
    assert [a.headers["X-Cache"] for a in (first, second)] == ["MISS", "HIT"]
    assert (second.status, second.body) == (200, first.body)
    assert second.body == site.servers[0].ask(target).body
    assert second.headers["Cache-Control"] == "public, max-age=3600"
    assert site.reached(target, at_least=2) == 2  # by nginx, and by the line before


@pytest.mark.parametrize(
    ("accepted", "spelled_otherwise", "coding"),
    [
        ("gzip", "GZIP;q=1.0, deflate", "gzip"),
        ("gzip, deflate, br, zstd", "zstd,br;q=0.9,gzip", "zstd"),
        ("identity", "br;q=0, gzip;q=0.000, zstd; q=0", None),
        ("gzip, zstd;q=0", "gzip", "gzip"),
        ("gzipped, xbr", "", None),
    ],
)
def test_one_entry_an_encoding_however_it_is_asked_for(
    site: Site, accepted: str, spelled_otherwise: str, coding: str | None
) -> None:
    target = CURVES.format(f"2{abs(hash((accepted, spelled_otherwise))) % 10**6}")
    first = site.front.ask(target, Accept_Encoding=accepted)
    second = site.front.ask(target, Accept_Encoding=spelled_otherwise)
    assert [a.headers["X-Cache"] for a in (first, second)] == ["MISS", "HIT"]
    assert first.headers["Content-Encoding"] == second.headers["Content-Encoding"] == coding
    plain = site.front.ask(target, Accept_Encoding="identity").body
    assert decoded(first) == decoded(second) == plain


def decoded(answer: Answer) -> bytes:
    match answer.headers["Content-Encoding"]:
        case "gzip":
            return gzip.decompress(answer.body)
        case "zstd":
            return bytes(zstandard.decompress(answer.body, max_output_size=10_000_000))
    return answer.body


def test_what_the_client_has_is_not_sent_again(site: Site) -> None:
    target = CURVES.format(3001)
    etag = site.front.ask(target).headers["ETag"]
    assert etag
    again = site.front.ask(target, If_None_Match=etag)
    assert (again.status, again.body, again.headers["X-Cache"]) == (304, b"", "HIT")


def test_what_may_not_be_kept_is_not(site: Site) -> None:
    for target in (f"{API}/health", f"{API}/snell?n_t=x", f"{API}/nope", "/"):
        cached = [site.front.ask(target).headers["X-Cache"] for _ in range(3)]
        assert "HIT" not in cached, target


def test_ids_are_those_of_the_request_though_the_answer_is_cached(site: Site) -> None:
    target = CURVES.format(4001)
    assert site.front.ask(target, X_Request_ID="one").headers["X-Request-ID"] == "one"
    assert site.front.ask(target, X_Request_ID="two").headers["X-Request-ID"] == "two"
    made = site.front.ask(target, X_Request_ID="not one!").headers.get_all("X-Request-ID")
    assert made is not None
    (own,) = made
    assert len(own) == 32
    fresh = f"{API}/health?{own}"
    assert site.front.ask(fresh, X_Request_ID=own).status == 422
    wait_for(lambda: bool(site.logged(own)))


def test_the_servers_know_the_client_from_nginx_and_not_from_itself(site: Site) -> None:
    connection = HTTPConnection(*site.front.address, source_address=("127.0.0.9", 0))
    spoofed = {"X-Forwarded-For": "203.0.113.7", "X-Request-ID": "from-nine"}
    connection.request("GET", f"{API}/health", headers=spoofed)
    assert connection.getresponse().read()
    connection.close()

    wait_for(lambda: bool(site.logged("from-nine")))
    assert [line["client"] for line in site.logged("from-nine")] == ["127.0.0.9"]


@pytest.mark.parametrize(("client", "scheme"), [("127.0.0.7", "https"), ("127.0.0.8", "http")])
def test_a_proxy_before_nginx_says_who_the_client_is_and_how_it_came(
    site: Site, client: str, scheme: str
) -> None:
    connection = HTTPConnection(*site.front.address, source_address=(client, 0))
    said = {"X-Forwarded-Proto": "https", "X-Forwarded-For": "203.0.113.7", "Host": "test"}
    connection.request("GET", "/docs", headers=said | {"X-Request-ID": f"from-{scheme}"})
    assert connection.getresponse().headers["Location"] == "./docs/"
    connection.close()
    wait_for(lambda: bool(site.logged(f"from-{scheme}")))
    (line,) = site.logged(f"from-{scheme}")
    assert line["client"] == ("203.0.113.7" if scheme == "https" else client)


def test_metrics_are_not_for_everybody(site: Site) -> None:
    assert site.servers[0].ask("/metrics").status == 200
    is_problem(site.front.ask("/metrics"), 404)


def is_problem(answer: Answer, status: int) -> None:
    """Assert that this is a problem as the servers would write it."""
    assert answer.status == status
    assert answer.headers["Content-Type"] == MEDIA_TYPE
    assert answer.headers["Access-Control-Allow-Origin"] == "*"
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert answer.headers["X-Request-ID"]
    assert (answer.headers["Retry-After"] is not None) == (status in (502, 503, 504))
    problem = Problem.model_validate_json(answer.body, strict=True, extra="forbid")
    assert (problem.status, problem.errors) == (status, [])
    titles = {
        413: "Content Too Large",
        414: "URI Too Long",
        416: "Range Not Satisfiable",
    }  # older Pythons have older names
    assert problem.title == titles.get(status, HTTPStatus(status).phrase)
    assert problem.detail


@pytest.mark.parametrize("status", REFUSED)
def test_every_refusal_of_nginx_is_a_problem(alone: Served, status: int) -> None:
    is_problem(alone.ask(f"/refused/{status}"), 431 if status == 494 else status)


@pytest.mark.parametrize(
    ("request_", "status"),
    [
        (b"GET / HTTP/1.1\r\n\r\n", 400),
        (b"what is this\r\n\r\n", 400),
        (b"GET /" + b"x" * 40_000 + b" HTTP/1.1\r\nHost: x\r\n\r\n", 414),
        (b"GET / HTTP/1.1\r\nHost: x\r\nX: " + b"x" * 40_000 + b"\r\n\r\n", 431),
        (b"POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 200000000\r\n\r\n", 413),
        (b"GET / HTTP/1.1\r\nHost: x\r\nContent-Length: 1000000000000\r\n\r\nx", 413),
        (b"TRACE / HTTP/1.1\r\nHost: x\r\n\r\n", 405),
        (b"GET / HTTP/3.0\r\nHost: x\r\n\r\n", 505),
        (b"GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n", 502),
        (b"GET /late HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n", 504),
    ],
    ids=lambda x: repr(x)[:30],
)
def test_what_brings_a_refusal_about(alone: Served, request_: bytes, status: int) -> None:
    with socket.create_connection(alone.address, PATIENCE_S) as connection:
        connection.sendall(request_)
        answer = HTTPResponse(connection)
        answer.begin()
        is_problem(Answer(answer.status, answer.headers, answer.read()), status)


@pytest.mark.parametrize("start", [b"", b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: "])
def test_a_request_that_does_not_come_is_not_waited_for(alone: Served, start: bytes) -> None:
    """nginx hangs up without a word, so that there is no 408."""
    with (
        socket.create_connection(alone.address, PATIENCE_S) as connection,
        suppress(ConnectionResetError),
    ):
        connection.sendall(start)
        assert connection.recv(1000) == b""


def test_a_killed_server_costs_no_more_than_what_it_held(site: Site) -> None:
    """Runs last: it leaves one server."""
    clients = 12
    fresh = [CURVES.format(f"5{i}") for i in range(20_000)]
    with Load(site.front, fresh, clients) as load:
        wait_for(lambda: all(len(server.logged()) > 50 for server in site.servers))
        site.servers[0].process.send_signal(signal.SIGKILL)
        killed = time.monotonic()
        load.wait_for(len(load.statuses) + 600)
    assert set(load.statuses) == {200}
    assert len(load.failures) <= clients  # a client holds one at a time
    assert all(failure.began < killed for failure in load.failures)
    line = json.loads(site.front.output.read_text("utf-8").splitlines()[-1])
    assert str(site.servers[1].port) in line["upstream"]
