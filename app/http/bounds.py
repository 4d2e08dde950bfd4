"""Bounds on what a request may bring along, and on how long a client may leave an answer unread."""

import asyncio
from collections.abc import Iterator

from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.http.problems import problem_response

_PIECE = 262_144
"""Bytes that are handed to the server at a time; it keeps what a client has not read yet."""


class Bounded:
    """ASGI middleware that answers what is too long by a problem, and gives up who reads nothing.

    The body of a request is bounded where it is read, see `app.api.evaluate.body`.

    Parameters
    ----------
    app
        The application.
    target_bytes
        Longest path with its query.
    header_bytes
        Longest headers together.
    write_timeout_s
        How long a client may read nothing of a large answer.
    """

    def __init__(
        self, app: ASGIApp, *, target_bytes: int, header_bytes: int, write_timeout_s: float
    ) -> None:
        self.app = app
        self._target_bytes = target_bytes
        self._header_bytes = header_bytes
        self._write_timeout_s = write_timeout_s

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on if it is within bounds."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        too_long = self._too_long(scope)
        if too_long is not None:
            asked = Request({**scope, "path": ""})  # which may be what is too long
            await problem_response(asked, *too_long)(scope, receive, send)
            return

        is_large = False

        async def send_in_pieces(message: Message) -> None:
            nonlocal is_large
            if message["type"] == "http.response.start":
                is_large = _is_large(message)
            if not is_large:  # and leaves at once, which needs no timer
                await send(message)
                return
            for piece in _pieces(message):
                await self._send_in_time(piece, send)

        try:
            await self.app(scope, receive, send_in_pieces)
        except _Unread:
            return  # the server hangs up on an answer without an end

    def _too_long(self, scope: Scope) -> tuple[int, str] | None:
        query: bytes = scope["query_string"]
        if len(scope["raw_path"]) + bool(query) + len(query) > (most := self._target_bytes):
            detail = f"path and query may have {most} bytes together (FRESNEL_MAX_TARGET_BYTES)"
            return 414, detail
        headers = sum(len(name) + len(value) for name, value in scope["headers"])
        if headers > (most := self._header_bytes):
            return 431, f"the headers may have {most} bytes together (FRESNEL_MAX_HEADER_BYTES)"
        return None

    async def _send_in_time(self, message: Message, send: Send) -> None:
        try:
            async with asyncio.timeout(self._write_timeout_s):
                await send(message)
        except TimeoutError:
            raise _Unread from None


class _Unread(Exception):
    """A client reads nothing of its answer."""


def _is_large(start: Message) -> bool:
    """Whether an answer is larger than a piece, or may be: it does not say how large it is."""
    headers = start.get("headers", ())
    return next((int(v) > _PIECE for name, v in headers if name == b"content-length"), True)


def _pieces(message: Message) -> Iterator[Message]:
    """Cut a part of a body, so that no more than a piece waits in the server for a client."""
    body = memoryview(message.get("body", b""))
    if len(body) <= _PIECE:
        yield message
        return
    for start in range(0, len(body), _PIECE):
        more = start + _PIECE < len(body) or message.get("more_body", False)
        yield {**message, "body": body[start : start + _PIECE], "more_body": more}
