"""A connection that is hung up without cutting short what was said last."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any


class LingeringTransport:
    """A transport that goes on reading, for a while, when it is closed before a client has said all.

    Closed at once, with bytes that nobody read, a connection is reset, and the client may never see
    the answer. So the end of the answers is told, and what still comes is read and forgotten.

    Parameters
    ----------
    transport
        What it stands for; all that is not told here is passed on.
    is_expecting
        Whether more may come that belongs to what was said before.
    patience_s
        How long the client may take to notice, and to hang up as well.
    """

    def __init__(
        self, transport: asyncio.Transport, is_expecting: Callable[[], bool], patience_s: float
    ) -> None:
        self._transport = transport
        self._is_expecting = is_expecting
        self._patience_s = patience_s
        self._lingers: asyncio.TimerHandle | None = None
        self.write = transport.write  # for every answer: not looked up again

    def __getattr__(self, name: str) -> Any:
        """Pass on."""
        return getattr(self._transport, name)

    def is_closing(self) -> bool:
        """Whether nothing will be written any more."""
        return self._lingers is not None or self._transport.is_closing()

    def close(self) -> None:
        """Send what was written, then hang up."""
        if self.is_closing():
            return
        if not self._is_expecting():
            self._transport.close()
            return
        later = asyncio.get_running_loop().call_later
        self._lingers = later(self._patience_s, self._transport.close)
        self._transport.write_eof()
        self._transport.resume_reading()

    def linger_no_longer(self) -> None:
        """Hang up if that is all that is left to do."""
        if self._lingers is not None:
            self._lingers.cancel()
            self._transport.close()
