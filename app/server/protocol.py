"""HTTP as this program speaks it: uvicorn's, with bounds on what a client sends and how slowly.

What is refused here never reaches the application, and is a problem like every other error.
"""

from __future__ import annotations

import asyncio
from asyncio.events import TimerHandle
from enum import Enum, auto
from http import HTTPStatus
from typing import Any, cast

import uvicorn
from starlette.types import Scope
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol
from uvicorn.server import ServerState

from app.http.problems import MEDIA_TYPE, problem_bytes
from app.server.lingering import LingeringTransport
from app.server.observe.middleware import OBSERVED, Observed, identify
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


_SPARE_CONNECTIONS = 100
"""How many that are one too many may be told so before they are closed without a word."""


class Refused(Exception):
    """Stops the parser."""


class _Came(Enum):
    """What has come of the request that is being read."""

    NOTHING = auto()
    HEAD = auto()
    """A part of it."""
    BODY = auto()
    """The whole head, and perhaps a part of the body."""


class BoundedProtocol(HttpToolsProtocol):
    """One connection.

    A client has `read_timeout_s` for the head of a request and for each further part of it, and has
    to take some of an answer within every `write_timeout_s`; none keeps a connection for longer.
    Every request that came whole is answered, in order, whatever comes after it.
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
        self._came = _Came.NOTHING
        self._began = self.loop.time()
        self._head_bytes = self._header_bytes = self._unsent = 0
        self._read_timer: TimerHandle | None = None
        self._write_timer: TimerHandle | None = None
        self._has_ended = False

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Take a connection, if there is room for one more."""
        patience_s = self._settings.read_timeout_s
        self._lingering = LingeringTransport(transport, self._is_expecting, patience_s)
        super().connection_made(cast("asyncio.Transport", self._lingering))
        most = self._settings.max_connections
        if len(self.connections) > most + _SPARE_CONNECTIONS:
            transport.abort()
        elif len(self.connections) > most:
            self._refuse(503, f"{most} connections are open, and no more are taken", "connections")
        else:
            self._wait_for_more()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget the connection."""
        super().connection_lost(exc)
        self._stop_reading()
        self._stop_writing()
        self._lingering.linger_no_longer()

    def shutdown(self) -> None:
        """Hang up when what is in flight is answered; one that was told all is not waited for."""
        super().shutdown()
        self._lingering.linger_no_longer()

    def eof_received(self) -> bool:  # type: ignore[override]
        """Answer what a client has asked that says no more, then hang up."""
        self._has_ended = True
        if self.transport.is_closing():
            return False
        if self._refusal is not None:  # told when what came before is answered
            return True
        if self._came is not _Came.NOTHING:
            self._refuse(400, "the connection ended before the request did")
            return True
        if self._is_answering():
            self.cycle.keep_alive = False
            return True
        return False

    def _is_refused(self) -> bool:
        return self._refusal is not None

    def _is_answering(self) -> bool:
        return self.cycle is not None and not self.cycle.response_complete

    def _is_expecting(self) -> bool:
        """Whether the client may still be sending what nobody will read."""
        more = self._refusal is not None or self._came is not _Came.NOTHING
        return more and not self._has_ended

    # ---- how much a client sends

    def on_message_begin(self) -> None:
        """Begin to count."""
        super().on_message_begin()
        self._came = _Came.HEAD
        self._began = self.loop.time()
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
        super().on_headers_complete()
        self._came = _Came.BODY

    def on_body(self, body: bytes) -> None:
        """Give the next part of a body as long as the one before."""
        self._stop_reading()
        super().on_body(body)

    def on_message_complete(self) -> None:
        """Note that the client has said all."""
        self._came = _Came.NOTHING
        self._stop_reading()
        super().on_message_complete()

    def data_received(self, data: bytes) -> None:
        """Read on, and wait for the rest of a request, but not for ever."""
        if self._is_refused() or self.transport.is_closing():
            return
        super().data_received(data)
        if self._is_refused():
            return
        if self._came is _Came.NOTHING:
            if not self._is_answering() and self.timeout_keep_alive_task is None:
                # This was the rest of what had been answered before; the next may be long in coming.
                self.timeout_keep_alive_task = self.loop.call_later(
                    self.timeout_keep_alive, self.timeout_keep_alive_handler
                )
            return
        if self._came is _Came.HEAD:  # what the parser still holds: one header may be all of it
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
        elif self._came is _Came.NOTHING:
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
        """Go on with what was asked for next; watch what is left to send."""
        closing = self.transport.is_closing()
        if self._refusal is None or self.pipeline or closing:
            super().on_response_complete()
        else:
            self.server_state.total_requests += 1
            self._write_problem(*self._refusal)
        if closing:
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
        if self._came is not _Came.BODY:
            # What was asked for before is answered first: told now, this would be taken for it.
            if not self._is_answering():
                self._write_problem(status, detail)
        elif self.pipeline:
            self.pipeline.popleft()  # the application has not seen it, and will not
        elif self.cycle.response_complete:
            self._hang_up()
        elif self.cycle.response_started:
            self.cycle.keep_alive = False
        else:
            self._write_problem(status, detail, cast("Scope", self.cycle.scope))
            self.cycle.disconnected = True
            self.cycle.message_event.set()

    def _hang_up(self) -> None:
        self.transport.close()
        self._watch_writing()

    def _write_problem(self, status: int, detail: str, scope: Scope | None = None) -> None:
        body = problem_bytes(status, detail, "")
        asked = self._scope_so_far() if scope is None else scope
        identify(asked)
        observed: Observed | None = self.app_state.get(OBSERVED)
        if scope is not None:  # the application logs and counts it
            scope["refused"] = status, len(body)
        elif observed is not None:
            observed.refused(asked, status, len(body), self.loop.time() - self._began)
        headers = [
            (b"x-request-id", asked["request_id"]),
            *self.server_state.default_headers,
            (b"access-control-allow-origin", b"*"),
            (b"content-type", MEDIA_TYPE.encode()),
            (b"content-length", b"%d" % len(body)),
            (b"connection", b"close"),
        ]
        if status == HTTPStatus.SERVICE_UNAVAILABLE:
            headers.append((b"retry-after", b"1"))
        reason = HTTPStatus(status).phrase.encode()
        lines = [b"HTTP/1.1 %d %s" % (status, reason), *(n + b": " + v for n, v in headers)]
        self.transport.write(b"\r\n".join([*lines, b"", body]))
        self._hang_up()

    def _scope_so_far(self) -> Scope:
        """What is known of a request of which not all came, or of none."""
        url = self.url if self._came is _Came.HEAD else b""
        path, _, query = url.partition(b"?")
        return {
            "type": "http",
            "method": self.parser.get_method().decode() if url else "",
            "raw_path": path,
            "path": path.decode("latin-1"),
            "query_string": query,
            "headers": self.headers if url else [],
            "client": self.client,
        }
