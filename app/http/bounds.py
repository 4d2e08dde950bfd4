"""Bounds on what a request may bring along, and on how long a client may take over it."""

import asyncio
from collections.abc import Iterator

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.http.problems import problem_response

_PIECE = 262_144
"""Bytes that are handed to the server at a time; it keeps what a client has not read yet."""


_SLOWEST = 100_000
"""Bytes a second that a client has to send of a body and to read of an answer, in the long run."""


class Bounded:
    """ASGI middleware that answers what is too long by a problem, and gives up on who is too slow.

    How long a body may be is seen to where it is read, see `app.api.evaluate.body`. Times are those of
    a whole body or answer: a client that moves a byte now and then is as slow as one that does nothing.

    Parameters
    ----------
    app
        The application.
    target_bytes
        Longest path with its query.
    header_bytes
        Longest headers together.
    read_timeout_s
        How far a client may fall behind 100 kB a second in sending a body.
    write_timeout_s
        How far in reading a large answer.
    """

    def __init__(
        self,
        app: ASGIApp,
        *,
        target_bytes: int,
        header_bytes: int,
        read_timeout_s: float,
        write_timeout_s: float,
    ) -> None:
        self.app = app
        self._target_bytes = target_bytes
        self._header_bytes = header_bytes
        self._read_timeout_s = read_timeout_s
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

        is_large = has_begun = False
        reading = _Clock(self._read_timeout_s)
        writing = _Clock(self._write_timeout_s)
        is_read = has_body = False

        async def receive_in_time() -> Message:
            nonlocal is_read, has_body
            if is_read:
                return await receive()
            try:
                with reading:
                    async with asyncio.timeout(reading.left()):
                        message = await receive()
            except TimeoutError:
                detail = (
                    f"the body fell more than {self._read_timeout_s:g} s behind "
                    f"{_SLOWEST // 1000} kB a second (FRESNEL_READ_TIMEOUT_S)"
                )
                raise HTTPException(408, detail, {"Connection": "close"}) from None
            size = len(message.get("body", b""))
            reading.moved(size)
            is_read = not message.get("more_body", False)
            if is_read and size == 0 and not has_body and _announces_body(scope):
                detail = "the body did not come in step with its request; send both again"
                raise HTTPException(503, detail, {"Retry-After": "1", "Connection": "close"})
            has_body = has_body or size > 0
            return message

        async def send_in_pieces(message: Message) -> None:
            nonlocal is_large, has_begun
            if message["type"] == "http.response.start":
                is_large, has_begun = _is_large(message), True
            if not is_large:  # and leaves at once, which needs no timer
                await send(message)
                return
            for piece in _pieces(message):
                try:
                    with writing:
                        async with asyncio.timeout(writing.left()):
                            await send(piece)
                except TimeoutError:
                    raise _Unread from None
                writing.moved(len(piece.get("body", b"")))

        try:
            await self.app(scope, receive_in_time, send_in_pieces)
        except _Unread:
            return  # the server hangs up on an answer without an end
        except asyncio.CancelledError:
            # The time to stop is over. The server would say 500 of what it had no time for, and log it.
            if not has_begun:
                detail = "the server stops and had no time for this; try again"
                headers = {"Retry-After": "1", "Connection": "close"}
                answer = problem_response(Request(scope), 503, detail, headers=headers)
                await answer(scope, receive, send)

    def _too_long(self, scope: Scope) -> tuple[int, str] | None:
        query: bytes = scope["query_string"]
        if len(scope["raw_path"]) + bool(query) + len(query) > (most := self._target_bytes):
            detail = f"path and query may have {most} bytes together (FRESNEL_MAX_TARGET_BYTES)"
            return 414, detail
        headers = sum(len(name) + len(value) for name, value in scope["headers"])
        if headers > (most := self._header_bytes):
            return 431, f"the headers may have {most} bytes together (FRESNEL_MAX_HEADER_BYTES)"
        return None


class _Clock:
    """Counts the time that is spent waiting for a client, against what it moved meanwhile."""

    def __init__(self, allowed_s: float) -> None:
        self._most_s = self._allowed_s = allowed_s
        self._since = 0.0

    def __enter__(self) -> None:
        self._since = asyncio.get_running_loop().time()

    def __exit__(self, *_: object) -> None:
        self._allowed_s -= asyncio.get_running_loop().time() - self._since

    def moved(self, size: int) -> None:
        """Give time for so many bytes; none is saved up by having been fast."""
        self._allowed_s = min(self._allowed_s + size / _SLOWEST, self._most_s)

    def left(self) -> float:
        """How long one may still wait."""
        return max(self._allowed_s, 0.0)


class _Unread(Exception):
    """A client reads nothing of its answer."""


def _announces_body(scope: Scope) -> bool:
    """Whether a request says that it has a body; an offer of another protocol may have cost it."""
    headers = dict(scope["headers"])
    in_chunks = b"transfer-encoding" in headers and b"upgrade" in headers
    return in_chunks or headers.get(b"content-length", b"0") != b"0"


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
