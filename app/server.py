"""uvicorn as this program runs it: what it refuses itself is a problem too."""

from __future__ import annotations

import contextlib
from collections.abc import Callable

import uvicorn
from starlette.types import ASGIApp
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

from app.api.problems import MEDIA_TYPE, problem_bytes


class ProblemProtocol(HttpToolsProtocol):
    """uvicorn's HTTP, which answers a request that it cannot read before any application."""

    def send_400_response(self, msg: str) -> None:
        """Answer with a problem instead of plain text, and hang up."""
        detail = f"{msg} A method, path and query of at most 65535 plain characters are understood."
        body = problem_bytes(400, detail, "")
        head = [
            b"HTTP/1.1 400 Bad Request",
            *(name + b": " + value for name, value in self.server_state.default_headers),
            b"content-type: " + MEDIA_TYPE.encode(),
            b"content-length: " + str(len(body)).encode(),
            b"connection: close",
        ]
        self.transport.write(b"\r\n".join([*head, b"", body]))
        self.transport.close()


def serve(app: ASGIApp, host: str, port: int, announce: Callable[[str], None]) -> None:
    """Serve until interrupted.

    Parameters
    ----------
    app
        The application.
    host, port
        Where to listen; port 0 takes a free one.
    announce
        Called with the URL once the port is taken.
    """
    config = uvicorn.Config(
        app,
        host=host,
        port=port,
        http=ProblemProtocol,
        log_level="warning",
        server_header=False,
    )
    with contextlib.closing(config.bind_socket()) as bound, contextlib.suppress(KeyboardInterrupt):
        name = f"[{host}]" if ":" in host else host
        announce(f"http://{name}:{bound.getsockname()[1]}")
        uvicorn.Server(config).run(sockets=[bound])
