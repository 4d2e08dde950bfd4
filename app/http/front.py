"""What stands in front of routing: answers that are pure functions of their address."""

from __future__ import annotations

import asyncio
from collections.abc import Hashable, Mapping
from typing import Any

from starlette.requests import Request
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api.answers import Large
from app.api.params import QueryModel
from app.api.table import RouteTable
from app.http.body import Headers, ReadyBody, Reply
from app.http.cache import AnswerCache
from app.http.problems import API_HEADERS, PROBLEMS, problem_of
from app.http.route import QueryRoute
from app.server.pool import Pool
from app.settings import Settings


class Front:
    """ASGI middleware that answers GET and HEAD of the API, from a cache where it can.

    Every other request passes to the application. An answer is looked for by the query as it was
    sent, then by what it means: the order of parameters and the spelling of numbers do not matter.

    Parameters
    ----------
    app
        The application.
    table
        The routes to answer.
    prefix
        What their paths start with.
    cache
        Where answers are kept.
    pool
        Where large ones are computed.
    settings
        How long caches elsewhere may keep an answer, and how large one may be.
    """

    def __init__(
        self,
        app: ASGIApp,
        *,
        table: RouteTable,
        prefix: str,
        cache: AnswerCache,
        pool: Pool,
        settings: Settings,
    ) -> None:
        self.app = app
        self._cache = cache
        self._pool = pool
        self._under_way: dict[Hashable, asyncio.Task[ReadyBody]] = {}
        self._prefix = prefix
        self._table = table
        self._max_samples, self._max_cells = settings.max_samples, settings.max_cells
        self._kept: Headers = [
            (b"cache-control", b"public, max-age=%d" % settings.max_age_s),
            *API_HEADERS,
        ]
        self._not_kept: Headers = [(b"cache-control", b"no-store"), *API_HEADERS]

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or pass the request on."""
        if scope["type"] != "http" or scope["method"] not in ("GET", "HEAD"):
            await self.app(scope, receive, send)
            return
        path: str = scope["path"].removeprefix(scope["root_path"])
        route, parts = self._find(path)
        if route is None:
            await self.app(scope, receive, send)
            return
        asked = (path, scope["query_string"])
        ready = self._cache.get(asked)
        found = "miss" if ready is None else "hit"
        scope.update(route=route, path_params=parts)  # for the log, as FastAPI does
        if ready is None:
            try:
                ready = await self._fresh(route, parts, asked)
            except PROBLEMS as error:
                response = problem_of(Request(scope), error)
                reply = Reply(response.status_code, response.raw_headers, bytes(response.body))
                await _send(reply, scope, send)
                return
        if ready.cacheable:
            scope["cache"] = found
        coding = ready.coding(scope["headers"])
        if ready.takes_long(coding):
            await self._pool.run(lambda: ready.encoded(coding))
        more = self._kept if ready.cacheable else self._not_kept
        await _send(ready.reply(scope["headers"], more, coding), scope, send)

    def _find(self, path: str) -> tuple[QueryRoute | None, Mapping[str, str]]:
        """Find the route of a path, and the parts of the path that are its parameters."""
        if not path.startswith(self._prefix):
            return None, {}
        return self._table.find(path.removeprefix(self._prefix))

    async def _fresh(
        self, route: QueryRoute, parts: Mapping[str, str], asked: tuple[str, bytes]
    ) -> ReadyBody:
        """Compute an answer that was not asked for in this spelling."""
        query = route.read(asked[1])
        if query is not None:
            query.refuse_beyond(self._max_samples, self._max_cells)
        meant = (asked[0], _meaning(query))
        ready = self._cache.get(meant)
        if ready is None:
            answer = route.answer(parts, query)
            ready = answer if isinstance(answer, ReadyBody) else await self._large(answer, meant)
            if not ready.cacheable:
                return ready
            key_bytes = len(asked[0]) + len(asked[1])
            ready = self._cache.put(ready, meant, key_bytes)
        return self._cache.put(ready, asked, len(asked[0]) + len(asked[1]))

    async def _large(self, work: Large, meant: Hashable) -> ReadyBody:
        """Compute in a thread, once for all who ask at the same time."""
        task = self._under_way.get(meant)
        if task is None:
            task = asyncio.create_task(self._pool.run(work))
            self._under_way[meant] = task
            task.add_done_callback(lambda _: self._under_way.pop(meant))
        return await asyncio.shield(task)


def _meaning(query: QueryModel | None) -> Hashable:
    """What a query asks for, in any order and spelling of its parameters.

    Which parameters were given belongs to it, for some may not be given beside others, even with
    the value that they have by default.
    """
    if query is None:
        return None
    values: dict[str, Any] = query.__dict__
    return (*values.values(), frozenset(query.model_fields_set))


async def _send(reply: Reply, scope: Scope, send: Send) -> None:
    await send({"type": "http.response.start", "status": reply.status, "headers": reply.headers})
    body = b"" if scope["method"] == "HEAD" else reply.body
    await send({"type": "http.response.body", "body": body})
