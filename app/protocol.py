"""HTTP as this program speaks it: uvicorn's, with bounds on what a client sends and how slowly.

What is refused here never reaches the application, and is a problem like every other error.
"""

from __future__ import annotations

import asyncio
from asyncio.events import TimerHandle
from http import HTTPStatus
from typing import Any, cast

import uvicorn
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol
from uvicorn.server import ServerState

from app.api.problems import API_HEADERS, MEDIA_TYPE, problem_bytes
from app.settings import Settings


class Config(uvicorn.Config):
    """uvicorn's configuration with this program's settings.

    Parameters
    ----------
    app
        The application, or where to import it from.
    settings
        The bounds, and whom to believe what they say of a client.
    options
        Those of uvicorn.
    """

    def __init__(self, app: Any, settings: Settings, **options: Any) -> None:
        super().__init__(
            app,
            http=BoundedProtocol,
            ws="none",
            server_header=False,
            proxy_headers=bool(settings.trusted_proxies),
            forwarded_allow_ips=settings.trusted_proxies,
            timeout_keep_alive=settings.keep_alive_s,
            **options,
        )
        self.settings = settings


_LINGER_S = 2.0
"""How long a client that was refused may take to stop sending."""


class Refused(Exception):
    """Stops the parser."""


class BoundedProtocol(HttpToolsProtocol):
    """One connection.

    A client has `read_timeout_s` for the head of a request and for each further part of it, and has
    to take some of an answer within every `write_timeout_s`; none keeps a connection for longer.
    """

    def __init__(
        self,
        config: uvicorn.Config,
        server_state: ServerState,
        app_state: dict[str, Any],
        _loop: asyncio.AbstractEventLoop | None = None,
    ) -> None:
        super().__init__(config, server_state, app_state, _loop)
        self._settings = cast("Config", config).settings
        self._refusal: tuple[int, str] | None = None
        self._in_head = self._in_request = True
        self._head_bytes = self._header_bytes = self._unsent = 0
        self._read_timer: TimerHandle | None = None
        self._write_timer: TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Take a connection, if there is room for one more."""
        super().connection_made(transport)
        most = self._settings.max_connections
        if len(self.connections) > most:
            self._refuse(503, f"{most} connections are open, and no more are taken", "connections")
        else:
            self._wait_for_more()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the connection."""
        super().connection_lost(exc)
        self._stop_reading()
        self._stop_writing()

    # ---- how much a client sends

    def on_message_begin(self) -> None:
        """Begin to count."""
        super().on_message_begin()
        self._in_head = self._in_request = True
        self._head_bytes = self._header_bytes = 0

    def on_url(self, url: bytes) -> None:
        """Bound path and query."""
        super().on_url(url)
        most = self._settings.max_target_bytes
        if len(self.url) > most:
            self._refuse(414, f"path and query may have {most} bytes together", "target_bytes")
            raise Refused

    def on_header(self, name: bytes, value: bytes) -> None:
        """Bound the headers."""
        self._header_bytes += len(name) + len(value)
        self._bound_headers(self._header_bytes)
        if self._refusal is not None:
            raise Refused
        super().on_header(name, value)

    def on_headers_complete(self) -> None:
        """Begin to answer."""
        self._in_head = False
        super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """Give the next part of a body as long as the one before."""
        self._stop_reading()
        super().on_body(body)

    def on_message_complete(self) -> None:
        """Note that the client has said all."""
        self._in_request = False
        self._stop_reading()
        super().on_message_complete()

    def data_received(self, data: bytes) -> None:
        """Read on, and wait for the rest of a request, but not for ever."""
        if self._refusal is not None:
            return
        super().data_received(data)
        if self._in_request and self._refusal is None:
            if self._in_head:  # what the parser still holds: one header may be all of it
                self._head_bytes += len(data)
                self._bound_headers(self._head_bytes - self._settings.max_target_bytes)
            if self._read_timer is None:
                self._wait_for_more()

    def _bound_headers(self, size: int) -> None:
        most = self._settings.max_header_bytes
        if size > most:
            self._refuse(431, f"the headers may have {most} bytes together", "header_bytes")

    # ---- how slowly

    def _wait_for_more(self) -> None:
        self._read_timer = self.loop.call_later(self._settings.read_timeout_s, self._read_too_slow)

    def _stop_reading(self) -> None:
        if self._read_timer is not None:
            self._read_timer.cancel()
            self._read_timer = None

    def _read_too_slow(self) -> None:
        if self.flow.read_paused:  # it is the application that takes its time
            self._wait_for_more()
        elif self._in_head and not self._head_bytes:  # nothing was asked
            self.transport.close()
        else:
            patience = self._settings.read_timeout_s
            self._refuse(408, f"no more of the request came for {patience:g} s", "read_timeout_s")

    def pause_writing(self) -> None:
        """Wait for a client that reads more slowly than it is written to, but not for ever."""
        super().pause_writing()
        self._watch_writing()

    def resume_writing(self) -> None:
        """Write on."""
        super().resume_writing()
        self._stop_writing()

    def on_response_complete(self) -> None:
        """Watch what is left to send on a connection that will be closed."""
        super().on_response_complete()
        if self.transport.is_closing():
            self._watch_writing()

    def timeout_keep_alive_handler(self) -> None:
        """Close an idle connection, even if its client never reads the last answer."""
        super().timeout_keep_alive_handler()
        self._watch_writing()

    def _watch_writing(self) -> None:
        self._stop_writing()
        self._unsent = self.transport.get_write_buffer_size()
        if self._unsent:
            patience = self._settings.write_timeout_s
            self._write_timer = self.loop.call_later(patience, self._write_too_slow)

    def _stop_writing(self) -> None:
        if self._write_timer is not None:
            self._write_timer.cancel()
            self._write_timer = None

    def _write_too_slow(self) -> None:
        if self.transport.get_write_buffer_size() < self._unsent:
            self._watch_writing()
        else:
            self.transport.abort()

    # ---- what is said to a client whose request is not answered

    def send_400_response(self, msg: str) -> None:
        """Answer what is no HTTP; called for what the parser was stopped at, too."""
        if self._refusal is None:
            self._refuse(400, f"{msg} A method, path and query of plain characters are understood.")

    def _refuse(self, status: int, detail: str, limit: str = "") -> None:
        """Answer with a problem that names the limit, and hang up."""
        if self._refusal is not None:
            return
        if limit:
            setting = limit if limit in type(self._settings).model_fields else f"max_{limit}"
            detail += f" (FRESNEL_{setting.upper()})"
        self._refusal = status, detail
        self._stop_reading()
        # Beside an answer that has begun, or that was asked for before, another would be misread.
        cycle = self.cycle
        if (
            cycle is None
            or cycle.response_complete
            or not (self._in_head or cycle.response_started)
        ):
            self._write_problem(status, detail)
        if status == HTTPStatus.SERVICE_UNAVAILABLE:  # before anything was read, to be rid of it
            self.transport.close()
        elif not self.transport.is_closing():
            # Closed at once, with bytes that nobody read, the connection would be reset, and the
            # client might never see the answer. What still comes is read and forgotten.
            self.transport.write_eof()
            self.loop.call_later(_LINGER_S, self.transport.close)
        self._watch_writing()

    def _write_problem(self, status: int, detail: str) -> None:
        body = problem_bytes(status, detail, "")
        headers = [
            *self.server_state.default_headers,
            *API_HEADERS,
            (b"content-type", MEDIA_TYPE.encode()),
            (b"content-length", b"%d" % len(body)),
            (b"connection", b"close"),
        ]
        if status == HTTPStatus.SERVICE_UNAVAILABLE:
            headers.append((b"retry-after", b"1"))
        reason = HTTPStatus(status).phrase.encode()
        lines = [b"HTTP/1.1 %d %s" % (status, reason), *(n + b": " + v for n, v in headers)]
        self.transport.write(b"\r\n".join([*lines, b"", body]))
