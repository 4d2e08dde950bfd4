"""Servers to be measured, and a client that costs so little that it measures the server."""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import cast

CONNECTIONS = 4
"""Enough that the next request waits for the server, and not the server for it."""

OURS = ("-c", "from app.cli.main import main; main()", "serve", "--port")
"""Arguments of Python that serve this program as its command does, on the port that follows."""


@dataclass(frozen=True)
class Server:
    """A server under measurement: the port it listens on and its process."""

    port: int
    process: int

    def memory_mb(self, field: str) -> float:
        """Memory of the process in MB: VmRSS is now, VmHWM the most there was."""
        status = Path(f"/proc/{self.process}/status").read_text("utf-8")
        found = re.search(rf"^{field}:\s+(\d+) kB", status, re.MULTILINE)
        if found is None:
            raise SystemExit(f"no {field} in the status of process {self.process}")
        return int(found[1]) * 1024 / 1e6


def under_uvicorn(application: str, *options: str) -> tuple[str, ...]:
    """Arguments of Python that serve another application, on the port that follows."""
    return ("-m", "uvicorn", application, *options, "--log-level", "warning", "--port")


@contextlib.contextmanager
def served(
    *arguments: str, python: str = sys.executable, folder: Path | None = None, **environment: str
) -> Iterator[Server]:
    """Run a server with one worker, from a folder if it is another build's."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
    command = [python, *arguments, str(port)]
    server = subprocess.Popen(
        command, cwd=folder, env=os.environ | environment, stdout=subprocess.DEVNULL
    )
    try:
        for _ in range(300):
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port)):
                break
            time.sleep(0.1)
        yield Server(port, server.pid)
    finally:
        server.terminate()
        server.wait()


@contextlib.contextmanager
def beside_the_older() -> Iterator[dict[str, int]]:
    """Ports of this build, and of the one whose folder is in FRESNEL_OLDER if there is one."""
    # What any build can be served by.
    serve = under_uvicorn("app.main:create_app", "--factory")
    older = os.environ.get("FRESNEL_OLDER")
    with contextlib.ExitStack() as stack:
        ports = {"this build": stack.enter_context(served(*serve)).port}
        if older:
            other = stack.enter_context(served(*serve, folder=Path(older)))
            ports["the older build"] = other.port
        yield ports


def rate(port: int, targets: Iterator[str], requests: int) -> float:
    """Answers a second over a few kept-alive connections that each ask for one target at a time."""
    return asyncio.run(_rate(port, targets, requests))


async def _rate(port: int, targets: Iterator[str], requests: int) -> float:
    loop = asyncio.get_running_loop()
    asked = iter([next(targets) for _ in range(requests)])
    clients = []
    for _ in range(CONNECTIONS):
        _, client = await loop.create_connection(lambda: _Client(asked), "127.0.0.1", port)
        clients.append(client)
    start = time.perf_counter()
    for client in clients:
        client.ask()
    await asyncio.gather(*(client.done for client in clients))
    return requests / (time.perf_counter() - start)


class _Client(asyncio.Protocol):
    """One connection, which asks until nothing is left to ask."""

    def __init__(self, targets: Iterator[str]) -> None:
        self._targets = targets
        self._left = -1
        self._head = b""
        self.done: asyncio.Future[None] = asyncio.get_running_loop().create_future()

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Note where to write."""
        self._transport = cast("asyncio.Transport", transport)

    def ask(self) -> None:
        """Send the next request, or hang up after the last."""
        target = next(self._targets, None)
        if target is None:
            self.done.set_result(None)
            self._transport.close()
            return
        self._left, self._head = -1, b""
        self._transport.write(f"GET {target} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode())

    def data_received(self, data: bytes) -> None:
        """Count what comes of the answer."""
        if self._left < 0:
            self._head += data
            head, end, data = self._head.partition(b"\r\n\r\n")
            if not end:
                return
            if not head.startswith(b"HTTP/1.1 200 "):
                self.done.set_exception(RuntimeError(self._head.decode()))
                return
            length = head.lower().partition(b"\ncontent-length: ")[2].partition(b"\r")[0]
            self._left = int(length)
        self._left -= len(data)
        if self._left == 0:
            self.ask()
