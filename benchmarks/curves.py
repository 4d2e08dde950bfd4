"""`/curves` beside a bare ASGI application and the plain service: one worker each, in turns.

Set PLAIN_PYTHON to the Python of an environment with another FastAPI to compare with that too.
"""

from __future__ import annotations

import itertools
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from urllib.request import urlopen

from benchmarks.load import OURS, rate, served, under_uvicorn

ROUNDS = 7
REQUESTS = 400
TARGET = "/api/v1/curves?models=exact,schlick,lagarde_gc&samples=181&n_t={n_t:.9f}"
BARE = "/curves?n_t={n_t:.9f}"
PLAIN = "/curves?samples=181&n_t={n_t:.9f}"
PLAIN_DICT = "/curves/dict?samples=181&n_t={n_t:.9f}"
CACHED_BAR, FRESH_BAR = 0.6, 4.0


def different(target: str) -> Iterator[str]:
    """Targets of which no two are alike."""
    return (target.format(n_t=1.2 + 1e-6 * i) for i in itertools.count())


def fastapi_of(python: str) -> str:
    """Version of FastAPI that a Python has."""
    told = "from importlib.metadata import version; print(version('fastapi'))"
    return subprocess.check_output([python, "-c", told], text=True).strip()


def main() -> None:
    """Print the rates and their ratios, medians of the rounds."""
    pythons = [sys.executable, *filter(None, [os.environ.get("PLAIN_PYTHON")])]
    same = TARGET.format(n_t=1.5)
    with ExitStack() as stack:
        ours = stack.enter_context(served(*OURS)).port
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        body = Path(folder) / "body"
        body.write_bytes(urlopen(f"http://127.0.0.1:{ours}{same}").read())
        bare = stack.enter_context(
            served(*under_uvicorn("benchmarks.bare_service:app"), BENCHMARK_BODY=str(body))
        ).port
        asked: dict[str, tuple[int, Iterator[str]]] = {
            "ours, cached": (ours, itertools.repeat(same)),
            "bare ASGI": (bare, itertools.repeat("/")),
            "ours, fresh": (ours, different(TARGET)),
            "bare ASGI, NumPy, orjson": (bare, different(BARE)),
        }
        for python in pythons:
            port = stack.enter_context(
                served(*under_uvicorn("benchmarks.plain_service:app"), python=python)
            ).port
            version = fastapi_of(python)
            asked[f"plain, FastAPI {version}, model"] = port, different(PLAIN)
            asked[f"plain, FastAPI {version}, dict"] = port, different(PLAIN_DICT)
        for port, targets in asked.values():
            rate(port, targets, REQUESTS)
        rounds = [
            {name: rate(port, targets, REQUESTS) for name, (port, targets) in asked.items()}
            for _ in range(ROUNDS)
        ]

    def row(name: str, over: str = "", bar: str = "") -> None:
        text = f"  {name:36s}{statistics.median(found[name] for found in rounds):8.0f}"
        if over:
            ratio = statistics.median(found[over] / found[name] for found in rounds)
            text += f"   {over} / this: {ratio:.2f}{bar}"
        print(text)

    print("/curves, 181 samples, six curves, answers a second:")
    row("ours, cached")
    row("bare ASGI", "ours, cached", f" (bar: {CACHED_BAR:g})")
    row("ours, fresh")
    row("bare ASGI, NumPy, orjson", "ours, fresh")
    for name in asked:
        if name.startswith("plain"):
            row(name, "ours, fresh", f" (bar: {FRESH_BAR:g})")


if __name__ == "__main__":
    main()
