"""The server as the command runs it."""

import contextlib
import ipaddress
import os
import sys
import tempfile
from collections.abc import Callable, Iterator
from typing import Any, Literal

import uvicorn
from uvicorn.supervisors import Multiprocess

from app.server.observe.metrics import SHARED
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
    config = configuration("app.main:create_app", settings, factory=True)
    with contextlib.closing(config.bind_socket()) as bound, contextlib.suppress(KeyboardInterrupt):
        name = f"[{settings.host}]" if ":" in settings.host else settings.host
        announce(f"http://{name}:{bound.getsockname()[1]}")
        if settings.workers == 1:
            uvicorn.Server(config).run(sockets=[bound])
            return
        with _shared_metrics():
            Multiprocess(config, sockets=[bound]).run()


def configuration(app: Any, settings: Settings, **options: Any) -> uvicorn.Config:
    """Describe the server to uvicorn.

    Parameters
    ----------
    app
        The application, or where to import it from.
    settings
        Where to listen and whom to believe, and the bounds that are uvicorn's.
    options
        More options of uvicorn, or others than these.
    """
    of_settings: dict[str, Any] = {
        "host": settings.host,
        "port": settings.port,
        "workers": settings.workers,
        "http": parser(settings),
        # What a client may send before the application sees any of it.
        "h11_max_incomplete_event_size": settings.max_target_bytes + settings.max_header_bytes,
        "ws": "none",
        "limit_concurrency": settings.max_connections + 1,  # the first that is refused
        "timeout_keep_alive": settings.keep_alive_s,
        "timeout_graceful_shutdown": settings.grace_s,
        "timeout_worker_healthcheck": _UNRESPONSIVE_S,
        "proxy_headers": bool(settings.trusted_proxies),
        "forwarded_allow_ips": settings.trusted_proxies,
        "server_header": False,
        "log_level": "warning",
        "access_log": False,  # the application writes its own
    }
    return uvicorn.Config(app, **of_settings | options)


def parser(settings: Settings) -> Literal["h11", "httptools"]:
    """Choose what reads requests: strangers meet h11.

    httptools takes 0.08 ms a request less than h11, of 0.16 for a cached answer, but keeps a head, a
    trailer and requests to come whatever their size: 100 MB of short headers over one connection took
    2 GB and stopped the server for 4 s, one header of 100 MB stopped it for 18 s, 12 MB of pipelined
    requests took 0.8 GB. h11 took 3 MB at most for any of these.
    """
    if settings.http != "auto":
        return settings.http
    try:
        is_local = ipaddress.ip_address(settings.host).is_loopback
    except ValueError:
        is_local = settings.host == "localhost"
    return "httptools" if is_local else "h11"


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
