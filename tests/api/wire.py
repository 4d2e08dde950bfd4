"""A server as the command runs it, in a thread of the tests, and bytes sent to it as they are."""

import socket
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import uvicorn

from app.main import create_app
from app.server.run import configuration
from app.settings import Settings
from tests.api.raw import Answer

Address = tuple[str, int]


@contextmanager
def served(app: Any = None, settings: Settings | None = None) -> Iterator[Address]:
    """Serve an application, or ours with these settings, and yield where."""
    settings = settings or Settings()
    app = app or create_app(settings)
    server = uvicorn.Server(configuration(app, settings, port=0, log_level="critical"))
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        while not server.started:
            time.sleep(0.01)
        host, port = server.servers[0].sockets[0].getsockname()[:2]
        yield host, port
    finally:
        server.should_exit = True
        thread.join()


def exchange(address: Address, request: bytes) -> Answer:
    """Send bytes as they are and read until the server hangs up."""
    with socket.create_connection(address, timeout=10) as connection:
        connection.sendall(request)
        return received(connection)


def received(connection: socket.socket, data: bytes = b"") -> Answer:
    """Read an answer, of which the beginning may have been read, until the server hangs up."""
    data += b"".join(iter(lambda: connection.recv(65536), b""))
    head, _, body = data.partition(b"\r\n\r\n")
    status, *lines = head.decode("latin-1").split("\r\n")
    headers: Mapping[str, str] = {
        name.lower(): value for name, _, value in (line.partition(": ") for line in lines)
    }
    return Answer(int(status.split()[1]), headers, body)


def get(address: Address, target: bytes, method: bytes = b"GET") -> Answer:
    """Ask for a target over a connection of its own."""
    lines = [method + b" " + target + b" HTTP/1.1", b"Host: test", b"Connection: close", b"", b""]
    return exchange(address, b"\r\n".join(lines))
