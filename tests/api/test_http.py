"""HTTP itself: caches, compression, CORS, security headers, HEAD, and what a real server refuses."""

import asyncio
import gzip
import json
import time
from collections.abc import Iterator
from typing import Any

import pytest
import zstandard
from fastapi import FastAPI

from app.http.problems import MEDIA_TYPE
from app.main import create_app
from app.page import files
from app.server.observe.metrics import Metrics
from app.settings import Settings
from tests.api.raw import Answer, send
from tests.api.raw import exchange as asked
from tests.api.wire import Address, exchange, get, served

API = b"/api/v1"
CURVES = API + b"/curves?models=exact,schlick"
SNELL = API + b"/snell?n_t=2"
CSV = API + b"/curves?format=csv"
CACHED = [CURVES, SNELL, CSV, API + b"/models", API + b"/models/exact", API + b"/parameters"]


def ask(app: FastAPI, target: bytes, method: str = "GET", **headers: str) -> Answer:
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    return send(app, target, method, named)


class TestCaches:
    @pytest.mark.parametrize("target", CACHED)
    def test_answers_may_be_kept(self, app: FastAPI, target: bytes) -> None:
        answer = ask(app, target)
        assert answer.status == 200
        assert answer.headers["cache-control"] == "public, max-age=3600"
        assert "Accept-Encoding" in answer.headers["vary"].split(", ")
        assert answer.headers["etag"].startswith('W/"')
        assert int(answer.headers["content-length"]) == len(answer.body)

    def test_how_long_is_a_setting(self) -> None:
        short = create_app(Settings(max_age_s=5))
        assert ask(short, SNELL).headers["cache-control"] == "public, max-age=5"

    @pytest.mark.parametrize("target", CACHED)
    def test_what_the_client_has_is_not_sent_again(self, app: FastAPI, target: bytes) -> None:
        first = ask(app, target)
        again = ask(app, target, If_None_Match=first.headers["etag"])
        assert (again.status, again.body) == (304, b"")
        for name in ("etag", "cache-control", "vary"):
            assert again.headers[name] == first.headers[name]
        assert "content-type" not in again.headers

    @pytest.mark.parametrize(
        ("held", "status"),
        [
            ("*", 304),
            ("{etag}", 304),
            ("{strong}", 304),
            ('"other", {etag}', 304),
            ('W/"other"', 200),
            ("", 200),
            ("{bare}", 200),
        ],
    )
    def test_weak_comparison_of_lists(self, app: FastAPI, held: str, status: int) -> None:
        etag = ask(app, SNELL).headers["etag"]
        strong = etag.removeprefix("W/")
        given = held.format(etag=etag, strong=strong, bare=strong.strip('"'))
        assert ask(app, SNELL, If_None_Match=given).status == status

    def test_the_tag_is_that_of_the_content(self, app: FastAPI) -> None:
        tags = {ask(app, target).headers["etag"] for target in CACHED}
        assert len(tags) == len(CACHED)
        same = ask(app, API + b"/snell?n_i=1&n_t=2.0")
        assert same.headers["etag"] == ask(app, SNELL).headers["etag"]
        assert create_app_tag() == same.headers["etag"]

    def test_errors_are_not_kept(self, app: FastAPI) -> None:
        for target in (API + b"/snell?n_t=x", API + b"/nope"):
            answer = ask(app, target)
            assert "etag" not in answer.headers
            assert "cache-control" not in answer.headers


def create_app_tag() -> str:
    """Tag of the same content from another process's application."""
    return ask(create_app(), SNELL).headers["etag"]


class TestCompression:
    @pytest.mark.parametrize(
        ("accepted", "used"),
        [
            ("gzip", "gzip"),
            ("zstd", "zstd"),
            ("gzip, deflate, br, zstd", "zstd"),
            ("gzip;q=1.0, *;q=0", "gzip"),
            ("zstd;q=0, gzip", "gzip"),
            ("GZIP", "gzip"),
            ("*", "zstd"),
            ("br", None),
            ("identity", None),
            ("gzip;q=0", None),
            ("gzip;q=lots", None),
            ("", None),
        ],
    )
    @pytest.mark.parametrize("target", [CURVES, CSV])
    def test_as_the_client_asks(
        self, app: FastAPI, target: bytes, accepted: str, used: str | None
    ) -> None:
        plain, answer = ask(app, target), ask(app, target, Accept_Encoding=accepted)
        assert "content-encoding" not in plain.headers
        assert answer.headers.get("content-encoding") == used
        assert decoded(answer) == plain.body
        assert answer.headers["content-type"] == plain.headers["content-type"]
        assert int(answer.headers["content-length"]) == len(answer.body)
        if used:
            assert len(answer.body) < 0.6 * len(plain.body)

    def test_short_answers_are_sent_as_they_are(self, app: FastAPI) -> None:
        answer = ask(app, API + b"/health", Accept_Encoding="gzip, zstd")
        assert len(answer.body) < 1024
        assert "content-encoding" not in answer.headers

    def test_one_tag_for_all_encodings(self, app: FastAPI) -> None:
        packed = ask(app, CURVES, Accept_Encoding="zstd")
        again = ask(app, CURVES, Accept_Encoding="gzip", If_None_Match=packed.headers["etag"])
        assert again.status == 304


def decoded(answer: Answer) -> bytes:
    match answer.headers.get("content-encoding"):
        case "gzip":
            return gzip.decompress(answer.body)
        case "zstd":
            return bytes(zstandard.decompress(answer.body, max_output_size=10_000_000))
        case _:
            return answer.body


class TestOtherOrigins:
    @pytest.mark.parametrize(
        "target", [*CACHED, API + b"/health", API + b"/nope", b"/openapi.json"]
    )
    def test_any_page_may_read(self, app: FastAPI, target: bytes) -> None:
        answer = ask(app, target, Origin="https://example.org")
        assert answer.headers["access-control-allow-origin"] == "*"
        assert "access-control-allow-credentials" not in answer.headers
        exposed = answer.headers["access-control-expose-headers"]
        assert exposed == "ETag, Interpolation-Error, X-Request-ID"

    @pytest.mark.parametrize("target", [b"/", b"/js/main.js", b"/css/base.css"])
    def test_files_of_the_page_are_its_own(self, app: FastAPI, target: bytes) -> None:
        answer = ask(app, target, Origin="https://example.org")
        assert not [name for name in answer.headers if name.startswith("access-control")]

    def test_preflight_of_get_and_post_passes_and_of_others_does_not(self, app: FastAPI) -> None:
        origin = "https://example.org"
        allowed = ask(app, SNELL, "OPTIONS", Origin=origin, Access_Control_Request_Method="GET")
        assert allowed.status == 200
        assert allowed.headers["access-control-allow-methods"] == "GET, HEAD, POST"
        refused = ask(app, SNELL, "OPTIONS", Origin=origin, Access_Control_Request_Method="DELETE")
        assert refused.status == 400
        assert refused.headers["content-type"] == MEDIA_TYPE
        assert "GET, HEAD, POST" in refused.json()["detail"]
        assert refused.json()["instance"] == "/api/v1/snell"

    @pytest.mark.parametrize(
        ("method", "header"),
        [
            ("POST", "content-type"),
            ("GET", "if-none-match"),
            ("HEAD", "if-none-match"),
            ("GET", "x-request-id"),
        ],
    )
    def test_preflight_with_a_header_passes(self, app: FastAPI, method: str, header: str) -> None:
        wanted = {"Method": method, "Headers": header}
        named = {f"Access_Control_Request_{name}": value for name, value in wanted.items()}
        target = API + (b"/evaluate" if method == "POST" else b"/snell")
        allowed = ask(app, target, "OPTIONS", Origin="https://example.org", **named)
        assert allowed.status == 200
        assert allowed.headers["access-control-allow-origin"] == "*"
        assert header in allowed.headers["access-control-allow-headers"].lower()

    def test_a_cache_may_hand_any_answer_to_any_page(self, app: FastAPI) -> None:
        """What is kept from a request without an origin serves one that has it."""
        for target in CACHED:
            assert ask(app, target).headers["access-control-allow-origin"] == "*"


class TestSecurity:
    @pytest.mark.parametrize(
        "target", [*CACHED, API + b"/health", API + b"/nope", b"/", b"/nope", b"/openapi.json"]
    )
    def test_types_are_not_guessed(self, app: FastAPI, target: bytes) -> None:
        assert ask(app, target).headers["x-content-type-options"] == "nosniff"

    def test_the_page_loads_nothing_from_elsewhere(self, app: FastAPI) -> None:
        answer = ask(app, b"/")
        assert answer.status == 200
        policy = answer.headers["content-security-policy"]
        directives = dict(part.split(" ", 1) for part in policy.split("; "))
        assert directives["default-src"] == "'none'"
        assert directives["script-src"] == directives["connect-src"] == "'self'"
        assert directives["frame-ancestors"] == "'none'"
        assert "http" not in policy
        assert answer.headers["referrer-policy"] == "no-referrer"
        assert answer.headers["cross-origin-opener-policy"] == "same-origin"
        assert "camera=()" in answer.headers["permissions-policy"]

    def test_only_the_page_without_its_shell_stands_in_other_pages(self, app: FastAPI) -> None:
        def ancestors(target: bytes) -> str:
            policy = ask(app, target).headers["content-security-policy"]
            return dict(part.split(" ", 1) for part in policy.split("; "))["frame-ancestors"]

        assert ancestors(b"/?embed=1") == ancestors(b"/?view=albedo&embed=1&n_i=1") == "*"
        for target in (b"/", b"/?embed=0", b"/?embed=", b"/?embed=10", b"/?x=embed=1", b"/docs/"):
            assert ancestors(target) == "'none'"
        strict, embedded = (
            ask(app, t).headers["content-security-policy"].split("; ") for t in (b"/", b"/?embed=1")
        )
        assert set(strict) ^ set(embedded) == {"frame-ancestors 'none'", "frame-ancestors *"}

    @pytest.mark.parametrize("target", [*CACHED, API + b"/health", API + b"/nope", b"/", b"/docs/"])
    def test_no_cookies(self, app: FastAPI, target: bytes) -> None:
        assert "set-cookie" not in ask(app, target).headers


class TestHosts:
    APP = create_app(Settings(allowed_hosts="fresnel.example, *.below.example, ::1"))

    @pytest.mark.parametrize(
        "host",
        ["fresnel.example", "FRESNEL.example:8000", "a.below.example", "a.b.below.example:1"],
    )
    @pytest.mark.parametrize("target", [SNELL, b"/", API + b"/health"])
    def test_known_ones_are_answered_for(self, host: str, target: bytes) -> None:
        assert ask(self.APP, target, Host=host).status == 200

    @pytest.mark.parametrize(
        "host",
        ["", "other.example", "below.example", "fresnel.example.evil", "xfresnel.example", "\0"],
    )
    @pytest.mark.parametrize("target", [SNELL, b"/", b"/nope"])
    def test_others_are_not(self, host: str, target: bytes) -> None:
        answer = ask(self.APP, target, Host=host)
        assert answer.status == 421
        assert answer.headers["content-type"] == MEDIA_TYPE
        assert "FRESNEL_ALLOWED_HOSTS" in answer.json()["detail"]

    @pytest.mark.parametrize("target", [API + b"/health", b"/metrics"])
    def test_probes_ask_by_address(self, target: bytes) -> None:
        assert ask(self.APP, target, Host="10.0.0.7:8000").status == 200

    @pytest.mark.parametrize("hosts", ["*", "fresnel.example,*", " * , fresnel.example"])
    def test_a_star_stands_for_all(self, hosts: str) -> None:
        app = create_app(Settings(allowed_hosts=hosts))
        assert ask(app, SNELL, Host="anything.example").status == 200


class TestHead:
    @pytest.mark.parametrize("target", [*CACHED, API + b"/health", b"/", API + b"/nope"])
    def test_is_get_without_the_body(self, app: FastAPI, target: bytes) -> None:
        head, get = ask(app, target, "HEAD"), ask(app, target)
        assert head.body == b""
        assert head.status == get.status
        assert head.headers == get.headers


# ---- a server as the command runs it


@pytest.fixture(scope="module", params=["h11", "httptools"])
def address(app: FastAPI, request: pytest.FixtureRequest) -> Iterator[Address]:
    with served(app, Settings(http=request.param)) as where:
        yield where


def test_a_served_answer_is_that_of_the_application(app: FastAPI, address: Address) -> None:
    served = get(address, SNELL)
    assert (served.status, served.body) == (200, ask(app, SNELL).body)
    assert "server" not in served.headers


def test_a_served_head_has_no_body(address: Address) -> None:
    served = get(address, SNELL, b"HEAD")
    assert (served.status, served.body) == (200, b"")
    assert int(served.headers["content-length"]) == len(get(address, SNELL).body)


@pytest.mark.parametrize(
    "request_",
    [
        b"GET " + API + b"/snell?n_t=\xff HTTP/1.1\r\nHost: x\r\n\r\n",
        b"GET " + API + b"/\xff HTTP/1.1\r\nHost: x\r\n\r\n",
        b"GET " + API + b"/snell?n_t=\x00 HTTP/1.1\r\nHost: x\r\n\r\n",
        b"GET " + API + b"/snell?n_t=1 5 HTTP/1.1\r\nHost: x\r\n\r\n",
        b"GET HTTP/1.1\r\n\r\n",
        b"what is this\r\n\r\n",
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n",
    ],
    ids=lambda request: repr(request[:30]),
)
def test_what_is_no_request_is_refused(address: Address, request_: bytes) -> None:
    assert exchange(address, request_).status == 400


@pytest.mark.parametrize(
    ("target", "status"),
    [
        (SNELL + b"1" * 16_000, 422),
        (API + b"/snell?n_t=%ff", 422),
        (API + b"/snell?n_t=%zz", 422),
        (API + b"/models/%00", 404),
        (API + b"/%2e%2e/%2e%2e/pyproject.toml", 404),
        (b"/../pyproject.toml", 404),
        (b"*", 404),
    ],
    ids=lambda x: repr(x)[:40],
)
def test_hostile_targets_over_the_wire(address: Address, target: bytes, status: int) -> None:
    answer = get(address, target)
    assert answer.status == status
    assert answer.headers["content-type"] == MEDIA_TYPE
    assert json.loads(answer.body)["status"] == status


class TestFiles:
    PICTURE = b"/icons/icon-192.png"

    @pytest.mark.parametrize("said", ["x", "lines=1-2", "x=0-1"])
    def test_a_range_in_an_unknown_unit_is_ignored(self, app: FastAPI, said: str) -> None:
        whole = ask(app, self.PICTURE)
        answer = ask(app, self.PICTURE, Range=said)
        assert (answer.status, answer.body) == (200, whole.body)

    def test_a_range_is_sent(self, app: FastAPI) -> None:
        whole = ask(app, self.PICTURE)
        answer = ask(app, self.PICTURE, Range="bytes=1-3")
        assert (answer.status, answer.body) == (206, whole.body[1:4])
        assert answer.headers["content-range"] == f"bytes 1-3/{len(whole.body)}"

    @pytest.mark.parametrize(
        ("said", "status"), [("bytes=9-1", 400), ("bytes=", 400), ("bytes=9999999-", 416)]
    )
    def test_a_wrong_range_is_a_problem(self, app: FastAPI, said: str, status: int) -> None:
        answer = ask(app, self.PICTURE, Range=said)
        assert answer.status == status
        assert answer.headers["content-type"] == MEDIA_TYPE
        problem = answer.json()
        assert (problem["status"], problem["instance"]) == (status, self.PICTURE.decode())
        assert problem["detail"].startswith("Range: ")
        assert ("content-range" in answer.headers) == (status == 416)

    @pytest.mark.parametrize("query", [b"", b"?embed=1&x=%C3%BC"])
    def test_a_folder_is_found_whatever_scheme_and_host_it_has(
        self, app: FastAPI, query: bytes
    ) -> None:
        answer = ask(app, b"/docs" + query, Host="evil.example")
        assert (answer.status, answer.headers["location"]) == (307, "./docs/" + query.decode())


class TestMadeOnce:
    @pytest.mark.parametrize("target", [b"/openapi.json", b"/sw.js"])
    def test_is_compressed_and_not_sent_to_who_has_it(self, app: FastAPI, target: bytes) -> None:
        first = ask(app, target, Accept_Encoding="gzip")
        assert first.headers["content-encoding"] == "gzip"
        again = ask(app, target, If_None_Match=first.headers["etag"])
        assert (again.status, again.body) == (304, b"")
        assert decoded(first) == ask(app, target).body

    def test_the_list_of_files(self, monkeypatch: pytest.MonkeyPatch) -> None:
        calls = counted(monkeypatch, files, "service_worker")
        app = create_app()
        assert len({ask(app, b"/sw.js").body for _ in range(20)}) == 1
        assert len(calls) < 5  # the list is looked at anew after a second

    def test_the_description(self, monkeypatch: pytest.MonkeyPatch) -> None:
        calls = counted(monkeypatch, type(create_app()), "openapi")
        app = create_app()
        assert len({ask(app, b"/openapi.json").body for _ in range(20)}) == 1
        assert len(calls) == 1

    def test_metrics_of_all_who_ask_together(self, monkeypatch: pytest.MonkeyPatch) -> None:
        calls = counted(monkeypatch, Metrics, "text", 0.05)
        app = create_app()

        async def together() -> list[Answer]:
            return await asyncio.gather(*(asked(app, b"/metrics") for _ in range(50)))

        answers = asyncio.run(together())
        assert {answer.status for answer in answers} == {200}
        assert len(calls) <= 3

    def test_metrics_take_a_part_of_the_time_alone(self, monkeypatch: pytest.MonkeyPatch) -> None:
        calls = counted(monkeypatch, Metrics, "text", 0.05)
        app = create_app()
        began = time.monotonic()
        for _ in range(4):
            ask(app, b"/metrics")
        assert len(calls) == 4
        assert time.monotonic() - began > 3 * 5 * 0.05


def counted(
    monkeypatch: pytest.MonkeyPatch, where: Any, name: str, seconds: float = 0.0
) -> list[None]:
    """Note the calls of a function, and have each take a while."""
    calls: list[None] = []
    original = getattr(where, name)

    def noted(*given: Any) -> Any:
        calls.append(None)
        time.sleep(seconds)
        return original(*given)

    monkeypatch.setattr(where, name, noted)
    return calls
