"""The process that draws pictures: Kaleido and its browser, run by `app.figures.pictures` as a script.

A line of JSON with a figure, its format and its size comes in; a line of JSON with what became of it
goes out, before the picture if there is one. It has a group of processes and a folder, TMPDIR, to
itself, which it ends when its parent or its browser has ended, and imports nothing of the application.
"""

import asyncio
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import Any, BinaryIO

import kaleido
from choreographer.browsers import ChromeNotFoundError, Chromium

IDLE_S = 60.0
"""After so long without a picture the browser is closed, which has some 300 MB."""


class Grouped(Chromium):
    """Chromium in the group of this process, not in one of its own."""

    def get_popen_args(self) -> dict[str, Any]:
        """Arguments for `subprocess.Popen`."""
        return {**super().get_popen_args(), "start_new_session": False}


async def draw(asked: BinaryIO, drawn: BinaryIO, script: str) -> None:
    """Draw what is asked for until nothing is for a while."""

    def tell(outcome: str, reason: str = "", picture: bytes = b"") -> None:
        head = {"outcome": outcome, "reason": reason, "bytes": len(picture)}
        drawn.write(json.dumps(head).encode() + b"\n" + picture)
        drawn.flush()

    loop, waiting = asyncio.get_running_loop(), asyncio.Queue[bytes]()

    def listen() -> None:
        for line in asked:
            loop.call_soon_threadsafe(waiting.put_nowait, line)

    in_thread(listen)
    try:
        browser = kaleido.Kaleido(plotlyjs=script, mathjax=False, timeout=None, browser_cls=Grouped)
    except ChromeNotFoundError:
        tell("missing", "no browser was found")
        return
    async with browser:
        running: subprocess.Popen[bytes] = browser.subprocess
        in_thread(running.wait)  # one that was killed would be waited for in vain
        while True:
            job = json.loads(await asyncio.wait_for(waiting.get(), IDLE_S))
            try:
                picture: bytes = await browser.calc_fig(job["figure"], opts=job["options"])
            except Exception as error:  # whatever a browser that fails makes it raise
                tell("failed", type(error).__name__)
                return
            tell("drawn", picture=picture)


def in_thread(wait: Callable[[], object]) -> None:
    """End the whole group once a function has returned."""

    def end() -> None:
        wait()
        shutil.rmtree(os.environ["TMPDIR"], ignore_errors=True)
        os.killpg(0, signal.SIGKILL)

    threading.Thread(target=end, daemon=True).start()


if __name__ == "__main__":
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what libraries print is no picture
    asyncio.run(draw(sys.stdin.buffer, answers, sys.argv[1]))
