"""Offers to go on in another protocol, which are not taken: their requests are read as all others.

Java's client makes one with every request unless it is told to speak HTTP/1.1.
"""

import asyncio
import logging
from collections.abc import Callable
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol


class ByOffer(asyncio.Protocol):
    """Has a connection read by httptools, and by h11 if its first request makes an offer.

    httptools takes what follows such a request's head for the other protocol: the body is lost, and
    what comes then is out of step. h11 reads on.

    Parameters
    ----------
    options
        What uvicorn makes a protocol with.
    """

    def __init__(self, **options: Any) -> None:
        self._h11: Callable[[], asyncio.Protocol] = lambda: H11Protocol(**options)
        self._reads: asyncio.Protocol = HttpToolsProtocol(**options)

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Take a connection."""
        self._transport = transport
        self._reads.connection_made(transport)

    def data_received(self, data: bytes) -> None:
        """Look at the first request, and leave the connection to who reads it."""
        head, end, _ = data.partition(b"\r\n\r\n")
        if not end or b"\nupgrade:" in head.lower():
            self._reads.connection_lost(ConnectionAbortedError("handed on"))  # which closes nothing
            self._reads = self._h11()
            self._reads.connection_made(self._transport)
        self._transport.set_protocol(self._reads)
        self._reads.data_received(data)

    def eof_received(self) -> bool | None:
        """A client that says nothing more."""
        return self._reads.eof_received()

    def connection_lost(self, exc: Exception | None) -> None:
        """A client that has gone without a request."""
        self._reads.connection_lost(exc)


def say_nothing_of_offers() -> None:
    """Keep uvicorn from two lines in the log for every request with an offer."""
    logging.getLogger("uvicorn.error").addFilter(_is_of_no_offer)


def _is_of_no_offer(record: logging.LogRecord) -> bool:
    return not str(record.msg).startswith(("Unsupported upgrade", "No supported WebSocket"))
