"""Request bodies, read within bounds."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.exceptions import HTTPException
from starlette.requests import Request

from app.server.pool import Overloaded

_AT_A_TIME = 2
_IN_PARTS = " (FRESNEL_MAX_BODY_BYTES); send an Arrow stream, which takes less, or several calls"


class Bodies:
    """Reads bodies, and refuses those that are too large or too many at a time.

    Parameters
    ----------
    limit
        Bytes of the largest body; all that are being read may hold twice as many.
    advice
        What to do with a larger one.
    """

    def __init__(self, limit: int, advice: str = _IN_PARTS) -> None:
        self._limit = limit
        self._advice = advice
        self._held = 0

    @asynccontextmanager
    async def of(self, request: Request) -> AsyncIterator[bytearray]:
        """Read a body, which counts as held until the context ends.

        Raises
        ------
        HTTPException
            413 if it is too large.
        Overloaded
            If too many large ones are held.
        """
        if int(request.headers.get("content-length", "0")) > self._limit:
            raise self._too_large()
        body = bytearray()
        try:
            async for chunk in request.stream():
                self._held += len(chunk)
                body += chunk
                if len(body) > self._limit:
                    raise self._too_large()
                if self._held > _AT_A_TIME * self._limit:
                    raise Overloaded("large bodies are being read, and no more are taken")
            yield body
        finally:
            self._held -= len(body)

    def _too_large(self) -> HTTPException:
        return HTTPException(413, f"the body is larger than {self._limit} bytes{self._advice}")
