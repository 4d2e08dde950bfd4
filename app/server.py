"""uvicorn as this program runs it: what it refuses itself is a problem too."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Callable, Iterator

import uvicorn
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol
from uvicorn.supervisors import Multiprocess

from app.api.problems import MEDIA_TYPE, problem_bytes
from app.observe.metrics import SHARED
from app.settings import Settings

_UNRESPONSIVE_S = 30
"""Time after which a worker that does not even answer its supervisor is replaced."""


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


def serve(settings: Settings, announce: Callable[[str], None]) -> None:
    """Serve until told to stop; then finish what is in flight.

    Workers are processes that take connections from one socket. One that dies is replaced; how
    they share their metrics, see `app.observe.metrics`.

    Parameters
    ----------
    settings
        Where to listen, with how many workers, how to stop. The workers themselves read theirs from
        the environment.
    announce
        Called with the URL once the port is taken.
    """
    config = uvicorn.Config(
        "app.main:create_app",
        factory=True,
        host=settings.host,
        port=settings.port,
        workers=settings.workers,
        http=ProblemProtocol,
        log_level="warning",
        access_log=False,  # the application writes its own
        server_header=False,
        timeout_graceful_shutdown=settings.grace_s,
        timeout_worker_healthcheck=_UNRESPONSIVE_S,
    )
    with contextlib.closing(config.bind_socket()) as bound, contextlib.suppress(KeyboardInterrupt):
        name = f"[{settings.host}]" if ":" in settings.host else settings.host
        announce(f"http://{name}:{bound.getsockname()[1]}")
        if settings.workers == 1:
            uvicorn.Server(config).run(sockets=[bound])
            return
        with _shared_metrics():
            Multiprocess(config, sockets=[bound]).run()


@contextlib.contextmanager
def _shared_metrics() -> Iterator[None]:
    """Give the workers a folder to count in, in memory where the system has one for that.

    A container whose file system is read-only has /dev/shm to write to.
    """
    if os.environ.get(SHARED):
        yield
        return
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # noqa: S108
    with tempfile.TemporaryDirectory(prefix="fresnel-explorer-", dir=memory) as folder:
        os.environ[SHARED] = folder
        try:
            yield
        finally:
            del os.environ[SHARED]
