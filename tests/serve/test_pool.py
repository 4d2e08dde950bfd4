"""The pool of computations, and whether the server says that it is ready for more."""

import asyncio
import threading
from collections.abc import Callable

import pytest
from starlette.types import ASGIApp

from app.main import create_app
from app.server import pool as pool_module
from app.server.pool import Overloaded, Pool
from app.settings import Settings
from tests.api.raw import send

READY = b"/api/v1/health/ready"


def held(pool: Pool, count: int, meanwhile: Callable[[], None]) -> None:
    """Call a function while so many computations are under way that do not end."""
    over = threading.Event()

    async def run() -> None:
        tasks = [asyncio.create_task(pool.run(over.wait)) for _ in range(count)]
        await asyncio.sleep(0.05)
        await asyncio.to_thread(meanwhile)
        over.set()
        await asyncio.gather(*tasks, return_exceptions=True)

    asyncio.run(run())


def test_a_server_whose_queue_is_full_is_not_ready() -> None:
    app = create_app(Settings(threads=1, max_waiting=1))

    def meanwhile() -> None:
        answer = send(app, READY)
        assert answer.status == 503
        assert answer.headers["retry-after"]
        assert "FRESNEL_MAX_WAITING" in answer.json()["detail"]

    held(app.state.pool, 1, lambda: ready(app))
    held(app.state.pool, 2, meanwhile)
    ready(app)


def ready(app: ASGIApp) -> None:
    assert send(app, READY).status == 200


def test_a_server_whose_threads_hang_is_not_ready(monkeypatch: pytest.MonkeyPatch) -> None:
    app, now = create_app(Settings(threads=2, timeout_s=60.0)), [0.0]
    monkeypatch.setattr(pool_module, "monotonic", lambda: now[0])

    def meanwhile() -> None:
        ready(app)
        now[0] += 61.0
        assert "FRESNEL_TIMEOUT_S" in send(app, READY).json()["detail"]

    def with_a_thread_left() -> None:
        now[0] += 61.0
        ready(app)

    held(app.state.pool, 2, meanwhile)
    held(app.state.pool, 1, with_a_thread_left)


def test_a_pool_that_is_closed_drops_what_waits() -> None:
    async def run() -> None:
        pool, over = Pool(1, 5, timeout_s=60.0), threading.Event()
        runs = asyncio.create_task(pool.run(over.wait))
        waits = asyncio.create_task(pool.run(over.wait))
        await asyncio.sleep(0.05)
        pool.close()
        with pytest.raises(asyncio.CancelledError):
            await waits
        over.set()
        assert await runs

    asyncio.run(run())


def test_who_is_refused_is_told_what_there_is_too_much_of() -> None:
    pool = Pool(1, 0, 60.0, name="pictures", settings="FRESNEL_MAX_WAITING")

    def meanwhile() -> None:
        with pytest.raises(Overloaded, match=r"1 pictures run or wait \(FRESNEL_MAX_WAITING\)"):
            asyncio.run(pool.run(lambda: None))

    held(pool, 1, meanwhile)
