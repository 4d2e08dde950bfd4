"""Finished answers by their address, within a bound on the bytes they take."""

from dataclasses import dataclass, field
from typing import Any

from cachetools import LRUCache
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.http.body import EncodedBody, Headers
from app.server.pool import Overloaded, Pool

# What Python's objects add to the bytes of an answer and of its address.
_OVERHEAD = 3000

Key = tuple[str, bytes]


@dataclass(slots=True)
class _Collected:
    """An answer as the application sent it."""

    status: int | None = None
    """None until the answer begins."""
    headers: Headers = field(default_factory=list)
    body: bytes = b""

    async def take(self, message: Message) -> None:
        if message["type"] == "http.response.start":
            self.status, self.headers = message["status"], list(message["headers"])
        else:
            self.body += message.get("body", b"")


@dataclass(frozen=True, slots=True)
class _Kept:
    """An answer with what the log wants to know of its request."""

    body: EncodedBody
    observed: dict[str, Any]
    key_bytes: int

    @property
    def size(self) -> int:
        return self.body.size + self.key_bytes + _OVERHEAD


class AnswerCache:
    """ASGI middleware that keeps what the application calls public, and knows no routes.

    Every answer 200 to GET is tagged, compressed for who asks for that, and 304 for who
    has it. One with ``Cache-Control: public`` is kept, by path and query as they were sent.

    Parameters
    ----------
    app
        The application.
    prefix
        What the paths start with whose answers are read at once and kept.
    limit
        Bytes that the answers, in all encodings made so far, may take together with their keys.
    pool
        Where large answers are compressed; where it is full, they are sent as they are.
    """

    def __init__(self, app: ASGIApp, *, prefix: str, limit: int, pool: Pool) -> None:
        self.app = app
        self._prefix = prefix
        self._pool = pool
        self._kept: LRUCache[Key, _Kept] = LRUCache(limit, getsizeof=lambda kept: kept.size)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer from the cache, or pass the request on and keep the answer."""
        if (
            scope["type"] != "http"
            or scope["method"] != "GET"
            or not scope["path"].removeprefix(scope["root_path"]).startswith(self._prefix)
        ):
            await self.app(scope, receive, send)
            return
        key = scope["path"], scope["query_string"]
        kept = self._kept.get(key)
        if kept is not None:
            scope.update(kept.observed, cache="hit")
            await self._send(kept.body, key, scope, send)
            return
        collected = _Collected()
        try:
            await self.app(scope, receive, collected.take)
        finally:  # what is said of a crash is sent before the crash goes on to the log
            if collected.status is not None and collected.status != 200:
                await _send(collected.status, collected.headers, collected.body, send)
        if collected.status == 200:
            headers = [h for h in collected.headers if h[0] != b"content-length"]
            body = EncodedBody(collected.body, headers, scope.get("effort", "quick"))
            if dict(headers).get(b"cache-control", b"").startswith(b"public"):
                observed = {name: scope[name] for name in ("route", "path_params")}
                scope["cache"] = "miss"
                self._keep(key, _Kept(body, observed, len(key[0]) + len(key[1])))
            await self._send(body, key, scope, send)

    async def _send(self, body: EncodedBody, key: Key, scope: Scope, send: Send) -> None:
        coding = body.coding(scope["headers"])
        made = body.is_made(coding)
        if body.takes_long(coding):
            try:
                await self._pool.run(lambda: body.encoded(coding))
            except Overloaded:
                coding = None
        reply = body.reply(scope["headers"], coding)
        if not made and (kept := self._kept.get(key)):
            self._keep(key, kept)  # it has grown by an encoding
        await _send(*reply, send)

    def _keep(self, key: Key, kept: _Kept) -> None:
        self._kept.pop(key, None)
        if kept.size <= self._kept.maxsize:
            self._kept[key] = kept


async def _send(status: int, headers: Headers, body: bytes, send: Send) -> None:
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": body})
