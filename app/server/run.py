"""The server as the command runs it."""

import contextlib
import ipaddress
import os
import signal
import socket
import sys
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from multiprocessing import parent_process
from pathlib import Path
from typing import Any, Literal, NoReturn

import uvicorn

from app.server.observe.lines import log_errors
from app.server.observe.metrics import SHARED, leave
from app.server.offers import ByOffer, say_nothing_of_offers
from app.server.parent import when_parent_is_gone
from app.server.stragglers import Stragglers
from app.server.workers import Supervisor
from app.settings import Settings

_APP = "app.main:create_app"


class CannotServe(Exception):
    """The server cannot start as it is told to; the message says why."""


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
        Called with the URL once it is answered at.

    Raises
    ------
    CannotServe
        If the address is not to be had, or there is nowhere to write what has to be written.
    """
    if settings.access_log and sys.stdout is None:
        raise CannotServe("FRESNEL_ACCESS_LOG: there is no standard output to write it to")
    allow_open_files(settings.max_connections)
    log_errors()
    with contextlib.closing(_bind(settings)) as bound:
        name = f"[{settings.host}]" if ":" in settings.host else settings.host
        listening = partial(announce, f"http://{name}:{bound.getsockname()[1]}")
        if settings.workers == 1:
            _answer(settings, bound, _once(listening))
            _end()
        with _shared_metrics():
            stop_s = settings.drain_s + settings.grace_s
            work = partial(_work, settings)
            status = Supervisor(work, bound, settings.workers, stop_s).run(listening)
        if status:
            sys.exit(status)


def _bind(settings: Settings) -> socket.socket:
    """Take the port; it is listened on once the application is ready."""
    bound = socket.socket(socket.AF_INET6 if ":" in settings.host else socket.AF_INET)
    bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        bound.bind((settings.host, settings.port))
    except OSError as error:
        bound.close()
        where = f"FRESNEL_HOST = {settings.host}, FRESNEL_PORT = {settings.port}"
        raise CannotServe(f"{where}: {error.strerror or error}") from None
    return bound


def _answer(settings: Settings, bound: socket.socket, tick: Callable[[], None]) -> None:
    """Answer at a socket; `tick` is called every second from when it is listened on."""
    stragglers = Stragglers(settings.write_timeout_s)

    async def notify() -> None:
        tick()
        stragglers.end(one.transport for one in tuple(server.server_state.connections))

    told: dict[str, Any] = {"callback_notify": notify, "timeout_notify": 1}
    server = uvicorn.Server(configuration(_APP, settings, factory=True, **told))
    with contextlib.suppress(KeyboardInterrupt):
        server.run(sockets=[bound])


def _end() -> NoReturn:
    """End the process without waiting for threads that compute what nobody waits for any more."""
    os._exit(0)


def _once(do: Callable[[], None]) -> Callable[[], None]:
    waiting = [do]

    def first() -> None:
        if waiting:
            waiting.pop()()

    return first


def _work(settings: Settings, bound: socket.socket, send_word: Callable[[], None]) -> None:
    """Answer in a worker's process, and stop when its supervisor is gone."""
    log_errors()
    when_parent_is_gone(lambda: os.kill(os.getpid(), signal.SIGINT))
    try:
        _answer(settings, bound, send_word)
    finally:
        supervisor = parent_process()
        if supervisor is not None and not supervisor.is_alive():
            leave(Path(os.environ[SHARED]))  # which nobody else removes then
    _end()


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
    say_nothing_of_offers()
    http = parser(settings)
    of_settings: dict[str, Any] = {
        "host": settings.host,
        "port": settings.port,
        "http": ByOffer if http == "httptools" else http,
        # What a client may send before the application sees any of it.
        "h11_max_incomplete_event_size": settings.max_target_bytes + settings.max_header_bytes,
        "ws": "none",
        "limit_concurrency": settings.max_connections + 1,  # the first that is refused
        "timeout_keep_alive": settings.keep_alive_s,
        "timeout_graceful_shutdown": settings.grace_s,
        "proxy_headers": bool(settings.trusted_proxies),
        "forwarded_allow_ips": settings.trusted_proxies,
        "server_header": False,
        "log_config": None,  # see `app.server.observe.lines`
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
    try:
        made = tempfile.TemporaryDirectory(prefix="fresnel-explorer-", dir=memory)
    except OSError as error:
        reason = f"workers count requests together in a folder, and none could be made: {error}"
        raise CannotServe(f"{reason}; name one by {SHARED}, or run a single worker") from None
    with made as folder:
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
