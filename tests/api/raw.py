"""Requests as they come over the wire: no client that would tidy up the path or the query."""

import asyncio
import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import unquote

from starlette.types import ASGIApp, Message


@dataclass(frozen=True)
class Answer:
    """Status, headers and body as sent."""

    status: int
    headers: Mapping[str, str]
    body: bytes = field(repr=False)  # asyncio.run writes its result down, whatever that costs

    def json(self) -> Any:
        return json.loads(self.body)


def send(
    app: ASGIApp, target: bytes, method: str = "GET", headers: Mapping[str, str] | None = None
) -> Answer:
    """Ask `app` for `target`, path and query, split and decoded the way uvicorn does it."""
    return asyncio.run(exchange(app, target, method, headers))


async def exchange(
    app: ASGIApp, target: bytes, method: str = "GET", headers: Mapping[str, str] | None = None
) -> Answer:
    """Ask as `send` does, within a loop that runs already."""
    raw_path, _, query = target.partition(b"?")
    named = {"X-Request-ID": "test"} | dict(headers or {})  # so that equal answers are equal
    scope: dict[str, Any] = {
        "type": "http",
        "asgi": {"version": "3.0"},
        "http_version": "1.1",
        "method": method,
        "scheme": "http",
        "path": unquote(raw_path.decode("ascii")),
        "raw_path": raw_path,
        "query_string": query,
        "root_path": "",
        "headers": [(k.lower().encode(), v.encode()) for k, v in named.items()],
        "client": ("127.0.0.1", 1),
        "server": ("test", 80),
    }
    sent: list[Message] = []

    requests: list[Message] = [{"type": "http.request", "body": b"", "more_body": False}]

    async def receive() -> Message:
        if not requests:
            await asyncio.Event().wait()  # a client that stays until it is answered
        return requests.pop()

    async def take(message: Message) -> None:
        sent.append(dict(message))

    # Starlette raises a crash again for the server's log after it was answered.
    with suppress(Exception):
        await app(scope, receive, take)
    start = sent[0]
    return Answer(
        start["status"],
        {k.decode().lower(): v.decode() for k, v in start["headers"]},
        b"".join(message.get("body", b"") for message in sent[1:]),
    )
