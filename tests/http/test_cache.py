"""Finished answers: found again by their address, within a bound of memory."""

import asyncio
import random
import threading
import time
import tracemalloc
from collections.abc import Callable
from contextlib import suppress
from typing import Annotated

import pytest
from fastapi import APIRouter, Depends, FastAPI, Query
from fastapi.routing import APIRoute
from hypothesis import given
from hypothesis import strategies as st
from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Message, Receive, Scope, Send

import app.answers.curves as answered
from app.answers.interface import InterfaceFacts
from app.answers.snell import Ray, ray
from app.api import snell
from app.api.params import InterfaceQuery
from app.http.bounds import Bounded
from app.http.cache import AnswerCache
from app.http.route import QueryRoute
from app.main import create_app
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.server.pool import Overloaded, Pool
from app.settings import Settings
from tests.api.raw import Answer, exchange, send

API = b"/api/v1"


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How often the interface of a `/curves` answer was worked out."""
    calls: list[int] = []
    original = InterfaceFacts.of

    def counting(interface: Interface) -> InterfaceFacts:
        calls.append(1)
        return original(interface)

    monkeypatch.setattr(InterfaceFacts, "of", counting)
    return calls


class TestSameQuestion:
    @pytest.mark.parametrize(
        "again",
        [
            b"n_t=1.5&k_t=2&samples=7",
            b"samples=7&k_t=2&n_t=1.5",
            b"n_t=1.50&k_t=2.0&samples=7",
            b"n_t=15e-1&k_t=%32&samples=07",
            b"n_t=+1.5&k_t=2&samples=7",
        ],
    )
    def test_has_the_same_answer(self, again: bytes) -> None:
        app = create_app()
        first = send(app, API + b"/curves?n_t=1.5&k_t=2&samples=7")
        assert send(app, API + b"/curves?" + again) == first

    def test_in_the_same_words_is_computed_once(self, counted: list[int]) -> None:
        app = create_app()
        asked = [send(app, API + b"/curves?n_t=1.5&k_t=2&samples=7") for _ in range(3)]
        assert asked[0] == asked[1] == asked[2]
        assert len(counted) == 1

    def test_head_and_get_are_the_same_question(self, counted: list[int]) -> None:
        app = create_app()
        assert send(app, API + b"/curves?samples=7", "HEAD").body == b""
        assert send(app, API + b"/curves?samples=7").body
        assert len(counted) == 1

    def test_errors_are_told_again_and_again(self) -> None:
        app = create_app()
        answers = [send(app, API + b"/curves?samples=1") for _ in range(3)]
        assert [answer.status for answer in answers] == [422] * 3

    def test_a_default_that_may_not_be_given_is_refused_after_its_like_was_answered(self) -> None:
        app = create_app()
        assert send(app, API + b"/curves?models=exact").status == 200
        refused = send(app, API + b"/curves?models=exact&lazanyi2005.alpha=1")
        assert refused.status == 422
        assert send(app, API + b"/curves?material=Au").status == 200
        assert send(app, API + b"/curves?material=Au&n_t=1.5").status == 422

    @pytest.mark.parametrize("target", [b"/snell?n_t=2", b"/snell?n_t=2&digits=5"])
    def test_another_path_is_another_question(self, target: bytes) -> None:
        app = create_app()
        other = target.replace(b"snell", b"curves")
        assert send(app, API + target).body != send(app, API + other).body

    def test_minus_zero_is_zero(self, app: FastAPI) -> None:
        plain = send(app, API + b"/snell?k_t=0&theta_i_deg=0")
        for zero in (b"-0", b"-0.0", b"-0e5", b"-.0"):
            assert send(app, API + b"/snell?theta_i_deg=" + zero + b"&k_t=" + zero) == plain
        assert send(app, API + b"/snell?k_t=-").status == 422

    @given(
        n_t=st.floats(1e-3, 100.0),
        k_t=st.floats(0.0, 100.0),
        order=st.permutations(["n_t", "k_t", "samples"]),
    )
    def test_any_spelling_gives_the_answer_of_a_server_without_a_cache(
        self, app: FastAPI, n_t: float, k_t: float, order: list[str]
    ) -> None:
        spelled = {"n_t": f"{n_t:.17e}".replace("e+", "e"), "k_t": repr(k_t), "samples": "5"}
        query = "&".join(f"{name}={spelled[name]}" for name in order).encode()
        plain = f"n_t={n_t!r}&k_t={k_t!r}&samples=5".encode()
        cached = send(app, API + b"/curves?" + query)
        assert cached.body == send(uncached(), API + b"/curves?" + plain).body


UNCACHED: list[FastAPI] = []


def uncached() -> FastAPI:
    """An application that keeps nothing."""
    if not UNCACHED:
        UNCACHED.append(create_app(Settings(cache_bytes=0)))
    return UNCACHED[0]


def test_every_get_of_the_api_is_answered_by_a_query_route(app: FastAPI) -> None:
    paths = {path for path, on in app.openapi()["paths"].items() if "get" in on}
    assert paths
    for route in app.routes:
        if isinstance(route, APIRoute) and route.path.startswith(API.decode()):
            assert isinstance(route, QueryRoute) or route.methods == {"POST"}
    for path in paths:
        answer = send(app, path.replace("{", "").replace("}", "").encode())
        assert answer.status != 500, path


class KeyQuery(InterfaceQuery):
    k: str = ""


def key(k: str = "") -> None:
    if k != "open":
        raise HTTPException(401, "no key")


class TestRoutesAreFastApis:
    def test_they_answer_without_any_middleware(self, app: FastAPI) -> None:
        bare = FastAPI()
        bare.state.serving = app.state.serving
        bare.include_router(snell.router())
        answer = send(bare, b"/snell?n_t=1.5")
        assert answer.body == send(app, API + b"/snell?n_t=1.5").body

    @pytest.mark.parametrize("where", ["application", "inclusion", "router"])
    def test_a_dependency_is_met_before_the_endpoint(self, app: FastAPI, where: str) -> None:
        needed = {where: [Depends(key)]}
        guarded = FastAPI(dependencies=needed.get("application"))
        guarded.state.serving = app.state.serving
        routes = APIRouter(route_class=QueryRoute, dependencies=needed.get("router"))
        asked: list[float] = []

        @routes.get("/snell")
        def ask(query: Annotated[KeyQuery, Query()]) -> Ray:
            asked.append(query.n_t)
            return ray(query.interface(), Incidence.from_degrees(0.0))

        guarded.include_router(routes, dependencies=needed.get("inclusion"))
        assert send(guarded, b"/snell?n_t=2").status == 401
        assert asked == []
        assert send(guarded, b"/snell?n_t=2&k=open").status == 200
        assert asked == [2.0]


def test_the_api_below_another_path_is_found() -> None:
    app = create_app()

    async def below(scope: Scope, receive: Receive, send: Send) -> None:
        moved = {"root_path": "/below", "path": "/below" + scope["path"]}
        await app({**scope, **moved}, receive, send)

    assert send(below, API + b"/snell") == send(app, API + b"/snell")


class Source:
    """An application that answers with what it is told, and counts."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.headers: dict[bytes, bytes] = {b"cache-control": b"public, max-age=60"}
        self.body: Callable[[str], bytes] = lambda path: path.encode() * 1000

    async def __call__(self, scope: Scope, _: Receive, send: Send) -> None:
        path = scope["path"]
        self.asked.append(path)
        scope.update(route=None, path_params={})
        named = {**self.headers, b"content-disposition": path.encode()}
        headers = [(b"content-type", b"text/plain"), *named.items()]
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        await send({"type": "http.response.body", "body": self.body(path)})


def cached(source: Source, limit: int = 10**6, pool: Pool | None = None) -> AnswerCache:
    return AnswerCache(source, prefix="/", limit=limit, pool=pool or Pool(1, 4, 10.0))


class TestCache:
    def test_answers_with_equal_bodies_keep_their_own_headers(self) -> None:
        source = Source()
        source.body = lambda _: b"the same" * 1000
        cache = cached(source)
        for path in (b"/a", b"/b", b"/a", b"/b"):
            assert send(cache, path).headers["content-disposition"] == path.decode()
        assert source.asked == ["/a", "/b"]

    def test_the_longest_unused_goes_first(self) -> None:
        source = Source()
        source.body = lambda path: path.encode() * 12_500
        cache = cached(source, 100_000)
        for path in (b"/a", b"/b", b"/c", b"/a", b"/d"):
            send(cache, path)
        source.asked.clear()
        for path in (b"/a", b"/c", b"/d", b"/b"):
            send(cache, path)
        assert source.asked == ["/b"]

    def test_compressed_forms_count(self) -> None:
        source = Source()
        noise = random.Random(1).randbytes(20_000)  # noqa: S311 - which no compression makes smaller
        source.body = lambda path: path.encode() + noise
        cache = cached(source, 60_000)
        for _ in range(2):
            send(cache, b"/a")
            send(cache, b"/b")
        assert source.asked == ["/a", "/b"]  # there is room for both
        send(cache, b"/a", headers={"Accept-Encoding": "gzip"})
        send(cache, b"/b")
        assert source.asked == ["/a", "/b", "/b"]

    def test_what_is_larger_than_all_room_is_not_kept(self) -> None:
        source = Source()
        cache = cached(source, 10_000)
        source.body = lambda _: b"x" * 20_000
        assert send(cache, b"/a").body == send(cache, b"/a").body
        assert source.asked == ["/a", "/a"]

    def test_what_is_not_public_is_not_kept(self) -> None:
        source = Source()
        source.headers = {b"cache-control": b"no-store"}
        cache = cached(source)
        send(cache, b"/a")
        send(cache, b"/a")
        assert source.asked == ["/a", "/a"]

    def test_where_no_thread_is_free_an_answer_goes_uncompressed(self) -> None:
        source = Source()
        source.body = lambda _: b"x" * 2_000_000

        async def ask() -> Answer:
            pool, go = Pool(1, 0, 60.0), threading.Event()
            busy = asyncio.create_task(pool.run(go.wait))
            await asyncio.sleep(0)
            try:
                zipped = {"Accept-Encoding": "gzip"}
                return await exchange(cached(source, pool=pool), b"/a", headers=zipped)
            finally:
                go.set()
                await busy

        answer = asyncio.run(ask())
        assert (answer.status, len(answer.body)) == (200, 2_000_000)
        assert "content-encoding" not in answer.headers

    def test_memory_stays_within_the_bound(self) -> None:
        limit = 2_000_000
        app = create_app(Settings(cache_bytes=limit))
        send(app, API + b"/curves?models=exact,schlick")  # what is made once a process
        tracemalloc.start()
        try:
            for i in range(400):  # 400 answers of some 20 kB, four times what there is room for
                target = API + b"/curves?models=exact,schlick&n_t=1.%d" % (500 + i)
                assert send(app, target).status == 200
            held, _ = tracemalloc.get_traced_memory()
        finally:
            tracemalloc.stop()
        assert limit / 2 < held < 1.6 * limit


class TestPool:
    def test_no_more_wait_than_can_be_answered(self) -> None:
        async def flood() -> list[object]:
            pool, go = Pool(1, 16, 60.0), threading.Event()
            asked = [asyncio.create_task(pool.run(go.wait)) for _ in range(40)]
            await asyncio.sleep(0.01)
            go.set()
            return await asyncio.gather(*asked, return_exceptions=True)

        answers = asyncio.run(flood())
        assert sum(answer is True for answer in answers) == 17
        assert all(a is True or isinstance(a, Overloaded) for a in answers)

    def test_what_takes_too_long_is_given_up(self) -> None:
        async def wait() -> None:
            pool, go = Pool(1, 1, 0.05), threading.Event()
            with pytest.raises(Overloaded, match="FRESNEL_TIMEOUT_S"):
                await pool.run(go.wait)
            go.set()
            assert await pool.run(lambda: "again") == "again"

        asyncio.run(wait())

    def test_a_failure_is_passed_on(self) -> None:
        async def fail() -> None:
            with pytest.raises(ZeroDivisionError):
                await Pool(1, 0, 1.0).run(lambda: 1 // 0)

        asyncio.run(fail())


def test_a_computation_that_takes_too_long_is_a_problem_with_retry_after() -> None:
    app = create_app(Settings(timeout_s=1e-6))
    answer = send(app, API + b"/errors/map?x_steps=300&y_steps=300&x=n_t&y=k_t")
    assert answer.status == 503
    assert answer.headers["content-type"] == "application/problem+json"
    assert int(answer.headers["retry-after"]) > 0
    assert "FRESNEL_TIMEOUT_S" in answer.json()["detail"]


def test_equal_large_questions_at_a_time_are_computed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[int] = []
    original = answered.sampled_incidence

    def slow(interface: Interface, samples: int, landmarks: bool) -> Incidence:
        calls.append(1)
        time.sleep(0.1)
        return original(interface, samples, landmarks)

    monkeypatch.setattr(answered, "sampled_incidence", slow)
    app = create_app()
    target = API + b"/curves?samples=20001&models=exact,schlick"
    answers: list[Answer] = asyncio.run(together(app, target, 5))
    assert len({answer.body for answer in answers}) == 1
    assert len(calls) == 1
    assert len(answers[0].body) > 100_000


async def together(app: FastAPI, target: bytes, times: int) -> list[Answer]:
    """Ask the same several times at once."""
    return await asyncio.gather(*(exchange(app, target) for _ in range(times)))


class TestCancelled:
    """A request that is cancelled before its answer began; there is none to send."""

    @staticmethod
    async def cancelled(app: ASGIApp) -> list[Message]:
        sent: list[Message] = []

        async def take(message: Message) -> None:
            sent.append(message)

        scope = {
            "type": "http",
            "method": "GET",
            "path": "/api/v1/x",
            "raw_path": b"/api/v1/x",
            "root_path": "",
            "query_string": b"",
            "headers": [],
        }
        task = asyncio.ensure_future(app(scope, no_more, take))
        await asyncio.sleep(0.01)
        task.cancel()
        with suppress(asyncio.CancelledError):
            await task
        return sent

    @staticmethod
    async def waits(_: Scope, __: Receive, ___: Send) -> None:
        await asyncio.Event().wait()

    def test_the_cache_sends_nothing(self) -> None:
        cache = AnswerCache(self.waits, prefix="/api/v1/", limit=1000, pool=Pool(1, 1, 1.0))
        assert asyncio.run(self.cancelled(cache)) == []

    def test_a_server_that_stops_says_so(self) -> None:
        bounds = {"target_bytes": 200, "header_bytes": 1000}
        app = Bounded(self.waits, **bounds, read_timeout_s=1.0, write_timeout_s=1.0)
        start, body = asyncio.run(self.cancelled(app))
        headers = dict(start["headers"])
        assert start["status"] == 503
        assert headers[b"retry-after"] == b"1"
        assert headers[b"content-type"] == b"application/problem+json"
        assert b"stops" in body["body"]


async def no_more() -> Message:
    return {"type": "http.disconnect"}


def test_a_begun_answer_is_not_cut_because_the_pool_is_busy() -> None:
    async def both() -> str:
        pool = Pool(1, 1, 0.05)
        busy = asyncio.create_task(pool.run(lambda: time.sleep(0.3)))
        await asyncio.sleep(0)
        part = await pool.run(lambda: "a part", let_in=True)
        with pytest.raises(Overloaded):
            await busy
        return part

    assert asyncio.run(both()) == "a part"
