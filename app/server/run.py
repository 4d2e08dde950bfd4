"""The server as the command runs it."""

from __future__ import annotations

import contextlib
import os
import sys
import tempfile
from collections.abc import Callable, Iterator

import uvicorn
from uvicorn.supervisors import Multiprocess

from app.server.observe.metrics import SHARED
from app.server.protocol import Config
from app.settings import Settings

_UNRESPONSIVE_S = 30
"""Time after which a worker that does not even answer its supervisor is replaced."""


def serve(settings: Settings, announce: Callable[[str], None]) -> None:
    """Serve until told to stop; then finish what is in flight.

    Workers are processes that take connections from one socket. One that dies is replaced; how
    they share their metrics, see `app.server.observe.metrics`.

    Parameters
    ----------
    settings
        Where to listen, with how many workers, how to stop. The workers themselves read theirs from
        the environment.
    announce
        Called with the URL once the port is taken.
    """
    allow_open_files(settings.max_connections)
    config = Config(
        "app.main:create_app",
        settings,
        factory=True,
        host=settings.host,
        port=settings.port,
        workers=settings.workers,
        log_level="warning",
        access_log=False,  # the application writes its own
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


def allow_open_files(connections: int) -> None:
    """Let the process open a file a connection, and some more, as far as the system allows."""
    if sys.platform == "win32":
        return  # which has no such limit
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = connections + 200
    if hard != resource.RLIM_INFINITY:
        wanted = min(wanted, hard)
    if soft != resource.RLIM_INFINITY and soft < wanted:
        resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
