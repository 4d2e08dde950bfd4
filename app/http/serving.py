"""What the routes of one server share: its bounds, its threads, how long answers may be kept."""

import asyncio
from collections.abc import Awaitable, Callable, Hashable
from dataclasses import dataclass
from typing import TypeVar

from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from app.server.pool import Pool

T = TypeVar("T")


class ClientGone(Exception):
    """Nobody is there any more who would read the answer."""


class Unsent(Response):
    """What is answered to nobody."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send nothing."""


async def unless_gone(receive: Receive, work: Awaitable[T]) -> T:
    """Wait for work as long as the client does; if it hangs up, the work is cancelled.

    Parameters
    ----------
    receive
        Of a request whose body has been read; what else still comes is dropped.
    work
        What is waited for.

    Raises
    ------
    ClientGone
        If the client has hung up before the work was done.
    """
    task = asyncio.ensure_future(work)
    gone = asyncio.create_task(_hung_up(receive))
    try:
        await asyncio.wait({task, gone}, return_when=asyncio.FIRST_COMPLETED)
        if not task.done():
            raise ClientGone
        return task.result()
    finally:
        gone.cancel()
        task.cancel()


async def _hung_up(receive: Receive) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass


@dataclass(slots=True)
class _Shared:
    """A computation and how many wait for it."""

    task: asyncio.Task[Response]
    waiting: int = 0


class Serving:
    """The state of a server that its routes use.

    Parameters
    ----------
    pool
        Where large answers are computed.
    drawing
        Where pictures are drawn, one after the other.
    max_samples, max_cells
        Most angles of a curve and cells of a map.
    max_age_s
        How long caches elsewhere may keep an answer.
    """

    def __init__(
        self, pool: Pool, drawing: Pool, *, max_samples: int, max_cells: int, max_age_s: int
    ) -> None:
        self.max_samples = max_samples
        self.max_cells = max_cells
        self._pool = pool
        self._drawing = drawing
        self.lifetime = b"public, max-age=%d" % max_age_s
        self._under_way: dict[Hashable, _Shared] = {}

    async def shared(
        self, key: Hashable, work: Callable[[], Response], receive: Receive, *, is_picture: bool
    ) -> Response:
        """Compute in a thread, once for all who ask for the same at the same time.

        What nobody waits for any more leaves the queue.

        Raises
        ------
        ClientGone
            If this client has hung up.
        """
        shared = self._under_way.get(key)
        if shared is None:
            pool = self._drawing if is_picture else self._pool
            task = asyncio.create_task(pool.run(work))
            shared = self._under_way[key] = _Shared(task)
            task.add_done_callback(lambda _: self._forget(key, shared))
        shared.waiting += 1
        try:
            return await unless_gone(receive, asyncio.shield(shared.task))
        finally:
            shared.waiting -= 1
            if shared.waiting == 0:
                self._forget(key, shared)
                shared.task.cancel()

    def _forget(self, key: Hashable, shared: _Shared) -> None:
        if self._under_way.get(key) is shared:
            del self._under_way[key]
