"""Pictures of figures, drawn by a browser in a process of their own.

A browser may hang, grow or be killed. What waits for it waits a bounded time, then the process and
all that it started are killed, and the next picture starts another one.
"""

from __future__ import annotations

import atexit
import importlib.util
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from contextlib import suppress
from pathlib import Path
from time import monotonic
from typing import NamedTuple

from app.figures.render import bundle

_STUDIO = Path(__file__).with_name("studio.py")


class NoPictures(Exception):
    """Pictures cannot be made here; the message says what is missing."""


class PictureFailed(Exception):
    """A picture was not made, and may well be the next time; the message says why."""


class Size(NamedTuple):
    """How large a picture is."""

    width: int
    height: int
    scale: int
    """Dots a px."""


class Pictures:
    """Draws one picture at a time; threads wait for one another.

    Parameters
    ----------
    static_dir
        Folder of the page's files, Plotly's script among them.
    timeout_s
        How long a picture may take, the start of the browser included.
    """

    def __init__(self, static_dir: Path, timeout_s: float) -> None:
        self._static_dir = static_dir
        self._timeout_s = timeout_s
        self._lock = threading.Lock()
        self._studio: _Studio | None = None
        self._closed = 0

    def draw(self, figure: str, form: str, size: Size) -> bytes:
        """Draw a figure, given as Plotly's JSON, as "png", "svg" or "pdf".

        Raises
        ------
        NoPictures
            If Kaleido or a browser is missing.
        PictureFailed
            If the browser failed, ended or took too long.
        """
        if importlib.util.find_spec("kaleido") is None:
            raise NoPictures("the package kaleido is not installed (extra `figures`)")
        options = json.dumps({"format": form, **size._asdict()})
        job = f'{{"figure":{figure},"options":{options}}}\n'.encode()
        closed = self._closed
        with self._lock:
            until = monotonic() + self._timeout_s
            kept = self._studio
            picture = kept.drawn(job, self._timeout_s) if kept else None
            left = until - monotonic()
            if picture is None and left > 0.0 and closed == self._closed:
                # None is kept, or it ended while nobody looked.
                self._end()
                self._studio = _Studio(bundle(self._static_dir))
                atexit.register(self.close)
                picture = self._studio.drawn(job, left)
            if picture is None:
                self._end()
                late = monotonic() >= until
                reason = f"took longer than {self._timeout_s:g} s" if late else "ended"
                raise PictureFailed(f"the browser {reason}, and is started anew")
        return picture

    def close(self) -> None:
        """End the browser, whoever waits for it."""
        self._closed += 1
        self._end()

    def _end(self) -> None:
        studio, self._studio = self._studio, None
        if studio is not None:
            studio.kill()
            atexit.unregister(self.close)


class _Studio:
    """The process, as its parent sees it."""

    def __init__(self, script: Path) -> None:
        try:
            self._scratch = tempfile.mkdtemp(prefix="fresnel-pictures-")
        except OSError:
            raise NoPictures("a browser needs a folder to write to, as TMPDIR names it") from None
        self._process = subprocess.Popen(  # noqa: S603 - our own script
            [sys.executable, "-P", _STUDIO, script],
            env=os.environ | {"TMPDIR": self._scratch},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
        )

    def drawn(self, job: bytes, seconds: float) -> bytes | None:
        """A picture; None if the process ends before it is there, or is ended after some seconds."""
        assert self._process.stdin is not None  # noqa: S101 - both are pipes
        assert self._process.stdout is not None  # noqa: S101
        timer = threading.Timer(seconds, self.kill)
        timer.start()
        try:
            self._process.stdin.write(job)
            self._process.stdin.flush()
            told = json.loads(self._process.stdout.readline())
            picture = self._process.stdout.read(told["bytes"])
        except (OSError, ValueError):  # it ended: there is no line, a part of one, or no pipe
            return None
        finally:
            timer.cancel()
        if told["outcome"] == "missing":
            raise NoPictures(told["reason"])
        if told["outcome"] == "failed":
            raise PictureFailed(f"the browser did not draw it: {told['reason']}")
        return picture if len(picture) == told["bytes"] else None

    def kill(self) -> None:
        """End the process with all that it started, and take away what they wrote."""
        with suppress(ProcessLookupError, PermissionError):
            if sys.platform == "win32":
                self._process.kill()
            else:
                os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            with suppress(OSError):  # what was not sent yet goes nowhere
                if pipe is not None:
                    pipe.close()
        shutil.rmtree(self._scratch, ignore_errors=True)
