"""Lines of a log, written by a thread of their own, so that no answer waits for who reads them."""

import logging
import os
import sys
import threading
from collections.abc import Callable
from queue import Full, Queue

_MOST = 10_000
"""Lines that wait; a reader that is slow for a moment loses none."""


class Lines:
    """Writes lines to a file, and drops those that there is no room for.

    A pipe that nobody reads takes 64 kB, then who writes waits. `logging.handlers.QueueListener`
    would have its thread wait there too, and whoever stops it; besides, a stream that a thread
    holds at the program's end is a fatal error of Python, which a file descriptor is not.

    Parameters
    ----------
    descriptor
        The file to write to.
    on_drop
        Called for each line that is lost, because too many wait or the reader is gone.
    most
        How many lines may wait.
    """

    def __init__(self, descriptor: int, on_drop: Callable[[], None], *, most: int = _MOST) -> None:
        self._descriptor = descriptor
        self._on_drop = on_drop
        self._queue: Queue[bytes] = Queue(most)
        threading.Thread(target=self._write_all, name="log", daemon=True).start()

    def write(self, line: bytes) -> bool:
        """Have a line written, if there is room for it; return whether there is."""
        try:
            self._queue.put_nowait(line)
        except Full:
            self._on_drop()
            return False
        return True

    def flush(self, seconds: float = 1.0) -> None:
        """Wait until all lines are written, but no longer than some seconds."""
        written = threading.Thread(target=self._queue.join, daemon=True)
        written.start()
        written.join(seconds)

    def _write_all(self) -> None:
        while True:
            left = self._queue.get()
            try:
                while left:  # a line that is longer than a pipe takes at once is written in parts
                    left = left[os.write(self._descriptor, left) :]
            except OSError:
                self._on_drop()
            self._queue.task_done()


class LinesHandler(logging.Handler):
    """Logs to standard error by `Lines`, and says in the next line how many were lost."""

    def __init__(self, descriptor: int, *, most: int = _MOST) -> None:
        super().__init__()
        self._lost = 0
        self._lines = Lines(descriptor, self._lose, most=most)

    def emit(self, record: logging.LogRecord) -> None:
        """Write a record."""
        text, lost = self.format(record), self._lost
        if lost:
            text = f"{lost} records before this one were lost\n{text}"
        if self._lines.write(text.encode(errors="replace") + b"\n"):
            self._lost -= lost

    def flush(self) -> None:
        """Wait a moment until all is written."""
        self._lines.flush()

    def _lose(self) -> None:
        self._lost += 1


def log_errors() -> None:
    """Have warnings and errors of all libraries written to standard error, if there is one."""
    if sys.stderr is not None:
        handler = LinesHandler(sys.stderr.fileno())
        handler.setFormatter(logging.Formatter("%(levelname)s: %(message)s"))
        logging.basicConfig(handlers=[handler], level=logging.WARNING)
