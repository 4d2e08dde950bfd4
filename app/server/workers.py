"""Several processes that answer at one port: one that dies or hangs is replaced."""

import logging
import os
import signal
import socket
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import Pipe, get_context
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from time import monotonic
from types import FrameType

logger = logging.getLogger(__name__)

_SPAWN = get_context("spawn")
_SILENT_S = 30.0
"""After so long without a word, which its event loop sends every second, a worker is replaced."""
_BOOT_S = 120.0
"""How long a worker may take until its first word, on a machine with much else to do."""
_PAUSE_S = 1.0
"""Time between a worker that ended before it served and the next attempt."""
_LATE_S = 5.0
"""What a worker may take beyond the time it has to stop in, before it is killed."""

Work = Callable[[socket.socket, Callable[[], None]], None]
"""What a worker does: it answers at a socket, and sends word by the function all along."""


@dataclass(eq=False)
class _Worker:
    """A process, as its supervisor sees it."""

    process: SpawnProcess
    words: Connection
    heard: float = field(default_factory=monotonic)
    serves: bool = False
    replaces: "_Worker | None" = None
    is_leaving: bool = False

    def signal(self, number: int) -> None:
        """Send a signal, unless it has ended."""
        if self.process.pid is not None:
            with suppress(ProcessLookupError):
                os.kill(self.process.pid, number)


class Supervisor:
    """Keeps a number of workers at work.

    SIGTERM and SIGINT are passed on, each time they come. SIGHUP has every worker replaced by one
    that starts anew, and stop once that one serves.

    Parameters
    ----------
    work
        What each of them does.
    bound
        The socket that they share.
    number
        How many there are.
    stop_s
        How long they have to stop.
    """

    def __init__(self, work: Work, bound: socket.socket, number: int, stop_s: float) -> None:
        self._work = work
        self._bound = bound
        self._number = number
        self._stop_s = stop_s
        self._workers: list[_Worker] = []
        self._start_at: list[float] = [0.0] * number
        self._stop_by: float | None = None
        self._signals, self._signalled = Pipe(duplex=False)

    def run(self, announce: Callable[[], None]) -> int:
        """Supervise until told to stop; return the exit status of a worker that cannot start.

        Parameters
        ----------
        announce
            Called once the first worker serves.
        """
        for name in ("SIGTERM", "SIGINT", "SIGHUP"):
            if hasattr(signal, name):
                signal.signal(getattr(signal, name), self._on_signal)
        was_announced = False
        while self._workers or self._stop_by is None:
            self._start_those_due()
            self._look()
            self._kill_those_that_hang()
            status = self._bury(has_served=was_announced)
            if status:
                return status
            if not was_announced and any(worker.serves for worker in self._workers):
                was_announced = True
                announce()
        return 0

    def _on_signal(self, number: int, _: FrameType | None) -> None:
        # A handler may interrupt anything: it only leaves word.
        self._signalled.send_bytes(bytes([number]))

    def _start(self, replaces: _Worker | None = None) -> None:
        words, theirs = Pipe(duplex=False)
        process = _SPAWN.Process(target=_run, args=(self._work, self._bound, theirs))
        process.start()
        theirs.close()
        self._workers.append(_Worker(process, words, replaces=replaces))

    def _start_those_due(self) -> None:
        now = monotonic()
        for _ in [at for at in self._start_at if at <= now and self._stop_by is None]:
            self._start()
        self._start_at = [at for at in self._start_at if at > now]

    def _look(self) -> None:
        """Wait for a signal, a word or the end of a worker, a second at most."""
        words = {worker.words: worker for worker in self._workers if not worker.words.closed}
        ends = [worker.process.sentinel for worker in self._workers]
        for ready in wait([self._signals, *words, *ends], timeout=1.0):
            if ready is self._signals:
                self._obey(self._signals.recv_bytes()[0])
            elif isinstance(ready, Connection):
                self._hear(words[ready])

    def _hear(self, worker: _Worker) -> None:
        try:
            worker.words.recv_bytes()
        except EOFError:
            worker.words.close()
            return
        worker.heard, worker.serves = monotonic(), True
        if worker.replaces is not None:
            worker.replaces.signal(signal.SIGTERM)
            worker.replaces.is_leaving, worker.replaces = True, None

    def _obey(self, number: int) -> None:
        if number not in (signal.SIGTERM, signal.SIGINT):
            for worker in self._workers[:]:
                if worker.serves and not worker.is_leaving:
                    self._start(replaces=worker)
            return
        if self._stop_by is None:
            self._stop_by = monotonic() + self._stop_s + _LATE_S
        for worker in self._workers:
            worker.signal(number)

    def _kill_those_that_hang(self) -> None:
        now = monotonic()
        for worker in self._workers:
            hangs = now - worker.heard > (_SILENT_S if worker.serves else _BOOT_S)
            if (hangs and not worker.is_leaving) or (
                self._stop_by is not None and now > self._stop_by
            ):
                worker.process.kill()

    def _bury(self, *, has_served: bool) -> int:
        """Replace those that have ended; return the status of one that no other could do better."""
        for worker in [worker for worker in self._workers if not worker.process.is_alive()]:
            self._workers.remove(worker)
            worker.words.close()
            status = worker.process.exitcode or 0
            if self._stop_by is not None or worker.is_leaving:
                continue
            logger.error("worker %s ended with status %s", worker.process.pid, status)
            if status > 0 and not has_served:
                for other in self._workers:
                    other.process.kill()
                return status
            if worker.replaces is None:
                self._start_at.append(monotonic() + (0.0 if worker.serves else _PAUSE_S))
        return 0


def _run(work: Work, bound: socket.socket, words: Connection) -> None:
    """Work; runs in the process of a worker."""
    if hasattr(os, "setpgrp"):
        os.setpgrp()  # a terminal's Ctrl+C is for the supervisor, who passes it on
        os.set_blocking(words.fileno(), False)

    def send_word() -> None:
        with suppress(OSError):  # a supervisor that was stopped reads none
            words.send_bytes(b".")

    work(bound, send_word)
