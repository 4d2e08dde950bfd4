"""Request bodies, read within bounds."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from traceback import clear_frames
from typing import TypeVar

from starlette.exceptions import HTTPException
from starlette.requests import Request

from app.server.memory import give_back
from app.server.pool import Overloaded

_IN_PARTS = " (FRESNEL_MAX_BODY_BYTES); send an Arrow stream, which takes less, or several calls"
T = TypeVar("T")

_LARGE = 1_000_000
"""Bytes from which on memory is given back once a call is answered."""

_SMALL = 65_536
"""Bytes of a body that is always taken; the server keeps as many of each connection anyway."""


class Held:
    """What one request takes of the memory that all have together, until it is answered."""

    def __init__(self, bodies: Bodies) -> None:
        self._bodies = bodies
        self._size = 0
        self._most = 0
        self.body = bytearray()

    def __enter__(self) -> Held:
        return self

    def __exit__(self, *_: object) -> None:
        self.body = bytearray()
        self.becomes(0)
        if self._most > _LARGE:
            give_back()

    def parsed(self, read: Callable[[bytearray], T]) -> T:
        """Read the body, which is kept no longer.

        An error would hold it, by the frames it came through, until Python looks for cycles.
        """
        body, self.body = self.body, bytearray()
        try:
            return read(body)
        except Exception as error:
            clear_frames(error.__traceback__)
            raise
        finally:
            del body

    def becomes(self, size: int) -> None:
        """Hold so many bytes from now on."""
        self._bodies.held += size - self._size
        self._size = size
        self._most = max(self._most, size)


class Bodies:
    """Reads bodies, and refuses those that are too large or too many at a time.

    Parameters
    ----------
    limit
        Bytes of the largest body; all that are read or being answered may take a quarter more.
    advice
        What to do with a larger one.
    """

    def __init__(self, limit: int, advice: str = _IN_PARTS) -> None:
        self._limit = limit
        self._advice = advice
        self.held = 0

    async def read(self, request: Request, held: Held) -> None:
        """Read a body.

        Raises
        ------
        HTTPException
            413 if it is too large.
        Overloaded
            If it is large, and what is being answered takes too much already.
        """
        if int(request.headers.get("content-length", "0")) > self._limit:
            raise self._too_large()
        size = 0
        async for chunk in request.stream():
            held.body += chunk
            size += len(chunk)
            held.becomes(size)
            if size > self._limit:
                raise self._too_large()
            if size > _SMALL and self.held > self._limit + self._limit // 4:
                raise Overloaded("large calls are being answered, and no more are taken")

    @asynccontextmanager
    async def of(self, request: Request) -> AsyncIterator[bytearray]:
        """Read a body, as `read` does, which counts as held until the context ends."""
        with Held(self) as held:
            await self.read(request, held)
            yield held.body

    def _too_large(self) -> HTTPException:
        return HTTPException(413, f"the body is larger than {self._limit} bytes{self._advice}")
