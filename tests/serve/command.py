"""The command as a process, and clients that keep count of what they get."""

from __future__ import annotations

import http.client
import json
import os
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from itertools import count
from pathlib import Path
from urllib.parse import urlsplit

ROOT = Path(__file__).parents[2]
COMMAND = [sys.executable, "-c", "from app.cli.main import main; main()"]
"""What `fresnel-explorer` runs, of this checkout whatever is installed."""

PATIENCE_S = 60.0  # starting takes two seconds, and far longer on a machine with much else to do
API = "/api/v1"


@dataclass(frozen=True)
class Answer:
    """What came back."""

    status: int
    headers: http.client.HTTPMessage
    body: bytes


class Served:
    """A running server: its process, its address, what it printed."""

    def __init__(self, process: subprocess.Popen[bytes], url: str, output: Path) -> None:
        self.process = process
        self.host, self.port = urlsplit(url).hostname, urlsplit(url).port
        self.output = output

    def connect(self) -> http.client.HTTPConnection:
        return http.client.HTTPConnection(*self.address, timeout=PATIENCE_S)

    @property
    def address(self) -> tuple[str, int]:
        return self.host or "", self.port or 0

    def listens(self) -> bool:
        with suppress(OSError):
            socket.create_connection(self.address).close()
            return True
        return False

    def ask(self, target: str, method: str = "GET", **headers: str) -> Answer:
        """Send one request over a connection of its own."""
        connection = self.connect()
        try:
            named = {name.replace("_", "-"): value for name, value in headers.items()}
            connection.request(method, target, headers={"Connection": "close", **named})
            answer = connection.getresponse()
            return Answer(answer.status, answer.headers, answer.read())
        finally:
            connection.close()

    def logged(self) -> list[dict[str, object]]:
        """Read the access log: every line of standard output is a JSON object."""
        return [json.loads(line) for line in self.output.read_text("utf-8").splitlines()]


@contextmanager
def serving(
    folder: Path,
    *arguments: str,
    stdout: int | None = None,
    stderr: int | None = None,
    **environment: str,
) -> Iterator[Served]:
    """Start `fresnel-explorer serve` on a free port and wait until it answers.

    What it prints goes into files, unless it is told where to.
    """
    output, errors = folder / "stdout", folder / "stderr"

    def address() -> str | None:
        lines = (output.read_text("utf-8") + errors.read_text("utf-8")).splitlines()
        return next((line.split()[-1] for line in lines if " at http" in line), None)

    with (
        output.open("wb") as out,
        errors.open("wb") as err,
        subprocess.Popen(
            [*COMMAND, "serve", "--port", "0", *arguments],
            cwd=ROOT,
            env=os.environ | {"FRESNEL_ACCESS_LOG": "true"} | environment,
            stdout=out if stdout is None else stdout,
            stderr=err if stderr is None else stderr,
        ) as process,
    ):
        try:
            wait_for(lambda: address() is not None)
            served = Served(process, address() or "", output)
            wait_for(lambda: answers(served, f"{API}/health/ready"))
            yield served
        finally:
            process.terminate()
            try:
                process.wait(PATIENCE_S)
            finally:
                process.kill()


def commands() -> dict[int, str]:
    """The command line of every process on this machine, by its id."""
    told = {}
    for folder in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            command = (
                (folder / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
            )
            told[int(folder.name)] = command
    return told


def running(text: str) -> list[int]:
    """Processes with a text in their command line."""
    return [pid for pid, command in commands().items() if text in command]


def children(pid: int) -> set[int]:
    """Processes that a process started, and those that these started."""
    found: set[int] = set()
    for folder in Path(f"/proc/{pid}/task").glob("*"):
        with suppress(OSError):
            found |= set(map(int, (folder / "children").read_text("utf-8").split()))
    return found.union(*map(children, found))


def answers(served: Served, target: str) -> bool:
    """Whether a GET is answered with 200; a server that does not listen yet answers nothing."""
    try:
        return served.ask(target).status == 200
    except (OSError, http.client.HTTPException):
        return False


def wait_for(condition: Callable[[], bool], seconds: float = PATIENCE_S) -> None:
    """Return once the condition holds."""
    until = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until, "waited in vain"
        time.sleep(0.02)


@dataclass(frozen=True)
class Failure:
    """A request that got no answer, and when it began."""

    began: float
    reason: str


@dataclass
class Load:
    """Clients that ask again and again over connections they keep, until they are told to stop."""

    served: Served
    targets: list[str]
    clients: int = 8
    statuses: list[int] = field(default_factory=list)
    failures: list[Failure] = field(default_factory=list)
    done: threading.Event = field(default_factory=threading.Event)

    def __enter__(self) -> Load:
        self._turns = count()  # every target once before any comes again
        self._threads = [threading.Thread(target=self._run) for _ in range(self.clients)]
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.done.set()
        for thread in self._threads:
            thread.join()

    def wait_for(self, answered: int) -> None:
        """Return once so many requests were answered."""
        wait_for(lambda: len(self.statuses) >= answered)

    def _run(self) -> None:
        connection = self.served.connect()
        while not self.done.is_set():
            turn = next(self._turns)
            began = time.monotonic()
            try:
                connection.request("GET", self.targets[turn % len(self.targets)])
                answer = connection.getresponse()
                answer.read()
                self.statuses.append(answer.status)
            except (OSError, http.client.HTTPException) as error:
                self.failures.append(Failure(began, repr(error)))
                connection.close()
        connection.close()
