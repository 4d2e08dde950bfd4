"""The way out: a server told to stop says so first, and goes on answering until nobody asks."""

import asyncio
import signal
import threading
from types import FrameType

from starlette.types import ASGIApp, Message, Receive, Scope, Send


class Drain:
    """A delay between SIGTERM and the server's own way of stopping.

    Meanwhile readiness is denied, so that load balancers send nothing new, and every answer closes
    its connection, so that clients open their next one elsewhere. A second SIGTERM ends the delay.
    The server itself then finishes what is in flight.

    Parameters
    ----------
    seconds
        How long to go on; with 0 nothing is changed.
    """

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self.draining = False

    def around(self, app: ASGIApp) -> ASGIApp:
        """Make an application listen to SIGTERM, and close connections afterwards."""

        async def drained(scope: Scope, receive: Receive, send: Send) -> None:
            if scope["type"] == "lifespan":
                self._listen()
            closes = self.draining and scope["type"] == "http"
            await app(scope, receive, _closing(send) if closes else send)

        return drained

    def _listen(self) -> None:
        """Take SIGTERM over from the server, which listens to it before it starts the application."""
        stop = signal.getsignal(signal.SIGTERM)
        if (
            self._seconds <= 0.0
            or not callable(stop)
            or threading.current_thread() is not threading.main_thread()
        ):
            return
        loop = asyncio.get_running_loop()

        def begin(number: int, frame: FrameType | None) -> None:
            if self.draining:
                stop(number, frame)
                return
            self.draining = True
            # A signal handler may interrupt the loop anywhere: it only leaves word.
            loop.call_soon_threadsafe(loop.call_later, self._seconds, stop, number, None)

        signal.signal(signal.SIGTERM, begin)


def _closing(send: Send) -> Send:
    async def closing_send(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = [*message.get("headers", ()), (b"connection", b"close")]
            message = {**message, "headers": headers}
        await send(message)

    return closing_send
