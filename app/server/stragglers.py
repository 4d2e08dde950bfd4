"""Connections that were hung up on do not wait for ever for what their client has yet to read."""

import asyncio
from collections.abc import Iterable
from time import monotonic


class Stragglers:
    """Ends connections that have been closed for some time and are still there.

    A transport that is closed first sends what it holds. A client that keeps its end open and reads
    nothing, or a byte now and then, would have it so without end.

    Parameters
    ----------
    allowed_s
        How long a client may take over what is left.
    """

    def __init__(self, allowed_s: float) -> None:
        self._allowed_s = allowed_s
        self._since: dict[asyncio.Transport, float] = {}

    def end(self, open_: Iterable[asyncio.Transport]) -> None:
        """Look at all connections, as is done every second."""
        now = monotonic()
        self._since = {one: self._since.get(one, now) for one in open_ if one.is_closing()}
        for transport, since in self._since.items():
            if now - since > self._allowed_s:
                transport.abort()
