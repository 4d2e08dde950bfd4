"""Two servers behind nginx as `deploy/` configures it: cached, and one may die."""

from __future__ import annotations

import gzip
import json
import signal
import time
from collections.abc import Iterator
from dataclasses import dataclass
from http.client import HTTPConnection

import pytest
import zstandard

from app.http.problems import MEDIA_TYPE, Problem
from tests.serve.command import API, Answer, Load, Served, serving, wait_for
from tests.serve.nginx import find_nginx, in_front_of

CURVES = f"{API}/curves?models=exact,schlick&n_t=1.{{}}"


@dataclass
class Site:
    """nginx and the servers behind it."""

    front: Served
    servers: list[Served]

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


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Site]:
    nginx = find_nginx(tmp_path_factory.mktemp("package"))
    folders = [tmp_path_factory.mktemp(name) for name in ("first", "second", "nginx")]
    with (
        serving(folders[0], FRESNEL_TRUSTED_PROXIES="127.0.0.1") as first,
        serving(folders[1], FRESNEL_TRUSTED_PROXIES="127.0.0.1") as second,
        in_front_of(nginx, folders[2], [first, second]) as front,
    ):
        yield Site(front, [first, second])


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
    assert any(line["request_id"] == own for server in site.servers for line in server.logged())


def test_the_servers_know_the_client_from_nginx_and_not_from_itself(site: Site) -> None:
    port = site.front.port
    connection = HTTPConnection("127.0.0.1", port, source_address=("127.0.0.9", 0))
    spoofed = {"X-Forwarded-For": "203.0.113.7", "X-Request-ID": "from-nine"}
    connection.request("GET", f"{API}/health", headers=spoofed)
    assert connection.getresponse().read()
    connection.close()

    def lines() -> list[dict[str, object]]:
        logged = [line for server in site.servers for line in server.logged()]
        return [line for line in logged if line["request_id"] == "from-nine"]

    wait_for(lambda: bool(lines()))
    assert [line["client"] for line in lines()] == ["127.0.0.9"]


def test_metrics_are_not_for_everybody_and_refusals_are_problems(site: Site) -> None:
    assert site.servers[0].ask("/metrics").status == 200
    for target, status in (("/metrics", 404), (f"{API}/{'x' * 40_000}", 414)):
        answer = site.front.ask(target)
        assert answer.status == status
        assert answer.headers["Content-Type"] == MEDIA_TYPE
        assert Problem.model_validate_json(answer.body, strict=True).status == status


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
