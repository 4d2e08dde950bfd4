"""Replays faults against one running server: `python -m tests.serve.replay --minutes 10`.

Faults come round after round while `/health` and large answers are asked for from another process;
then a worker is killed, and the server told to stop. What is printed at the end has to hold; where it
does not, the exit status is 1. To add a fault, write a function that takes a `Stage` and put it
into `FAULTS`: it provokes the fault, and returns what came of it in a few words.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import random
import shutil
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, closing, suppress
from dataclasses import dataclass, field
from http.client import HTTPConnection, HTTPException
from multiprocessing.connection import Connection
from pathlib import Path
from uuid import uuid4

from tests.browser.conftest import find_browser
from tests.serve.command import API, Served, answers, children, serving, wait_for

GRACE_S = 10
PICTURE_S = 15
HEALTH_MS = 100.0
GROWTH = 1.1
PICTURE = f"{API}/figures/sweep?model=schlick&minimum=1.1&maximum=4&steps=11"
LARGE = f"{API}/errors/map?model=schlick&x=theta_i_deg&y=n_t&x_steps=100&y_steps={{}}&n_i=1.{{}}"


@dataclass
class Stage:
    """A server, and what its faults need."""

    served: Served
    mark: str
    """In the environment of every process of the server, so that an orphan is known."""
    hangs: Path
    """While it exists, a browser that is started hangs."""
    found: dict[str, Counter[str]] = field(default_factory=dict)

    def ask(self, target: str) -> str:
        """Status of a GET, or what kept it from being answered."""
        try:
            return str(self.served.ask(target).status)
        except (OSError, HTTPException) as error:
            return type(error).__name__

    def together(self, targets: list[str]) -> str:
        """Statuses of requests at the same time."""
        with ThreadPoolExecutor(len(targets)) as clients:
            statuses = Counter(clients.map(self.ask, targets))
        return ", ".join(f"{count} x {status}" for status, count in sorted(statuses.items()))

    def marked(self) -> set[int]:
        """Every process that the server, or what it started, has started."""
        found = set()
        for folder in Path("/proc").glob("[0-9]*"):
            with suppress(OSError):
                if f"FRESNEL_REPLAY={self.mark}".encode() in (folder / "environ").read_bytes():
                    found.add(int(folder.name))
        return found

    def memory_mb(self) -> float:
        """What the server's own processes hold, without browsers."""
        total = 0.0
        for pid in self.marked():
            with suppress(OSError):
                folder = Path(f"/proc/{pid}")
                command = (folder / "cmdline").read_bytes()
                if b"chrom" not in command and b"studio" not in command:
                    rollup = (folder / "smaps_rollup").read_text("utf-8").splitlines()
                    total += next(int(line.split()[1]) for line in rollup if line[:4] == "Pss:")
        return total / 1e3


def pictures_at_once(stage: Stage) -> str:
    """More pictures than the browser draws at a time."""
    widths = [random.randint(240, 2000) for _ in range(6)]  # noqa: S311
    return stage.together([f"{PICTURE}&format=png&width={width}" for width in widths])


def a_browser_that_hangs(stage: Stage) -> str:
    """A browser that is started and says nothing."""
    kill_browsers(stage)
    stage.hangs.touch()
    try:
        return stage.together([f"{PICTURE}&format=svg&width={width}" for width in (311, 312)])
    finally:
        stage.hangs.unlink()


def a_browser_that_is_killed(stage: Stage) -> str:
    """A browser that ends while it has nothing to do."""
    first = stage.ask(f"{PICTURE}&format=svg&width={random.randint(240, 4000)}")  # noqa: S311
    kill_browsers(stage)
    then = stage.ask(f"{PICTURE}&format=svg&width={random.randint(240, 4000)}")  # noqa: S311
    return f"{first}, then {then}"


def a_picture_that_is_too_large(stage: Stage) -> str:
    """More dots than a PNG may have."""
    return stage.ask(f"{PICTURE}&format=png&width=4000&height=4000")


def what_is_no_http(stage: Stage) -> str:
    """Requests that nobody understands, each of which is logged."""
    refused = 0
    for _ in range(200):
        with socket.create_connection(stage.served.address, 10.0) as connection:
            connection.sendall(b"no HTTP\r\n\r\n")
            refused += connection.recv(100).startswith(b"HTTP/1.1 400")
    return f"{refused} of 200 refused"


def idle_connections(stage: Stage) -> str:
    """Connections that say nothing, or half of a request."""
    with ExitStack() as held:
        for number in range(500):
            idle = held.enter_context(socket.create_connection(stage.served.address, 10.0))
            idle.sendall(b"GET / HTTP/1.1\r\nX-Slow: "[: number % 24])
        return stage.ask(f"{API}/health")


def answers_that_nobody_reads(stage: Stage) -> str:
    """Clients that ask for much and read nothing, and hang up."""
    with ExitStack() as held:
        for number in range(8):
            connection = held.enter_context(socket.create_connection(stage.served.address, 10.0))
            target = LARGE.format(100, number + 100)
            connection.sendall(f"GET {target} HTTP/1.1\r\nHost: x\r\n\r\n".encode())
        return stage.ask(LARGE.format(50, random.randint(10, 10**6)))  # noqa: S311


def posted(stage: Stage, body: bytes, kind: str = "application/json") -> str:
    """Status of a call of `/evaluate` whose answer is read."""
    try:
        with closing(stage.served.connect()) as connection:
            connection.request("POST", f"{API}/evaluate", body, {"Content-Type": kind})
            answer = connection.getresponse()
            while answer.read(1_000_000):
                pass
            return str(answer.status)
    except (OSError, HTTPException) as error:
        return type(error).__name__


def half_a_million_wrong_items(stage: Stage) -> str:
    """Four megabytes of items that are no items."""
    return posted(stage, b'{"items":[' + b",".join([b'{"a":1}'] * 500_000) + b"]}")


def a_body_of_nothing_but_separators(stage: Stage) -> str:
    """Two bodies of millions of items at a time."""
    body = b'{"items":[' + b",".join([b"1"] * 15_000_000) + b"]}"
    with ThreadPoolExecutor(2) as clients:
        statuses = Counter(clients.map(lambda _: posted(stage, body), range(2)))
    return ", ".join(f"{count} x {status}" for status, count in sorted(statuses.items()))


def batches_that_nobody_reads(stage: Stage) -> str:
    """Clients that have a million values computed, read nothing and hang up."""
    body = b'{"items":[{"theta_i_deg":[' + b",".join([b"45.5"] * 1_000_000) + b"]}]}"
    head = f"POST {API}/evaluate HTTP/1.1\r\nHost: x\r\nContent-Length: {len(body)}\r\n\r\n"
    with ExitStack() as held:
        for _ in range(4):
            reader = held.enter_context(socket.create_connection(stage.served.address, 60.0))
            with suppress(OSError):
                reader.sendall(head.encode() + body)
        return posted(stage, b'{"items":[{"n_t":1.5}]}')


def maps_that_nobody_waits_for(stage: Stage) -> str:
    """Clients that hang up before their maps are computed, and one that waits."""
    with ExitStack() as held:
        for number in range(20):
            gone = held.enter_context(socket.create_connection(stage.served.address, 10.0))
            target = LARGE.format(200, random.randint(10, 10**6) + number)  # noqa: S311
            gone.sendall(f"GET {target} HTTP/1.1\r\nHost: x\r\n\r\n".encode())
    return posted(stage, b'{"items":[{"n_t":1.5}]}')


def offers_of_another_protocol(stage: Stage) -> str:
    """A call as Java's client sends it."""
    body = b'{"items":[{"n_t":1.5}]}'
    head = (
        f"POST {API}/evaluate HTTP/1.1\r\nHost: x\r\nConnection: Upgrade, HTTP2-Settings\r\n"
        f"Upgrade: h2c\r\nHTTP2-Settings: AAEAAEAA\r\nContent-Length: {len(body)}\r\n\r\n"
    )
    with socket.create_connection(stage.served.address, 60.0) as connection:
        connection.sendall(head.encode() + body)
        return connection.recv(12)[-3:].decode()


FAULTS: list[Callable[[Stage], str]] = [
    pictures_at_once,
    a_browser_that_hangs,
    a_browser_that_is_killed,
    a_picture_that_is_too_large,
    what_is_no_http,
    idle_connections,
    answers_that_nobody_reads,
    half_a_million_wrong_items,
    a_body_of_nothing_but_separators,
    batches_that_nobody_reads,
    maps_that_nobody_waits_for,
    offers_of_another_protocol,
]


def kill_browsers(stage: Stage) -> None:
    """Kill every browser of the server, and what it started."""
    for pid in stage.marked():
        with suppress(OSError):
            if b"chrom" in Path(f"/proc/{pid}/cmdline").read_bytes():
                os.kill(pid, signal.SIGKILL)


def probe(address: tuple[str, int], told: Connection) -> None:
    """Ask for `/health` and for large answers until told to stop; send what became of them."""
    times: list[float] = []
    statuses: Counter[str] = Counter()
    number = 0
    while not told.poll(0.05):
        number += 1
        for target in [f"{API}/health", LARGE.format(40, number)][: 1 + (number % 20 == 0)]:
            began = time.perf_counter()
            connection = HTTPConnection(*address, timeout=60.0)
            try:
                connection.request("GET", target)
                answer = connection.getresponse()
                answer.read()
                status = str(answer.status)
            except (OSError, HTTPException) as error:
                status = type(error).__name__
            connection.close()
            if target.endswith("health"):
                times.append(1e3 * (time.perf_counter() - began))
            statuses[f"{'health' if target.endswith('health') else 'large'} {status}"] += 1
    told.send((times, statuses))


def browser_script(folder: Path, hangs: Path) -> Path:
    """A browser that hangs while a file exists."""
    script = folder / "browser"
    script.write_text(
        f'#!/bin/sh\n[ -e {hangs} ] && exec sleep 86400\nexec {find_browser()} "$@"\n', "utf-8"
    )
    script.chmod(0o755)
    return script


def replay(folder: Path, minutes: float) -> bool:
    """Run, print, and say whether everything held."""
    mark, hangs = uuid4().hex, folder / "hangs"
    if find_browser() is None:
        FAULTS[:] = [fault for fault in FAULTS if "browser" not in fault.__name__]
    with serving(
        folder,
        "--workers",
        "2",
        stdout=subprocess.PIPE,  # which nobody reads
        BROWSER_PATH=str(browser_script(folder, hangs)),
        FRESNEL_PICTURE_TIMEOUT_S=str(PICTURE_S),
        FRESNEL_GRACE_S=str(GRACE_S),
        FRESNEL_CACHE_BYTES="8000000",  # which is full after the first round
        FRESNEL_REPLAY=mark,
    ) as served:
        stage = Stage(served, mark, hangs)
        run_round(stage)  # which loads what is loaded once
        memory = [stage.memory_mb()]
        ours, theirs = multiprocessing.Pipe()
        prober = multiprocessing.Process(target=probe, args=(served.address, theirs))
        prober.start()
        until = time.monotonic() + 60.0 * minutes
        while time.monotonic() < until:
            run_round(stage)
            memory.append(stage.memory_mb())
        ours.send(None)
        times, statuses = ours.recv()
        prober.join()
        killed = kill_a_worker(stage)
        began = time.monotonic()
        served.process.send_signal(signal.SIGTERM)
        served.process.wait(60.0)
        stopped = time.monotonic() - began
        with suppress(AssertionError):
            wait_for(lambda: not stage.marked(), 5.0)
        orphans = stage.marked()
    for name, results in stage.found.items():
        print(f"{name:32}{'; '.join(f'{count} times {what}' for what, count in results.items())}")
    print(f"a worker is killed              {killed}")
    print(f"asked meanwhile                 {dict(sorted(statuses.items()))}")
    p99 = statistics.quantiles(times, n=100)[-1]
    held = {
        f"/health: median {statistics.median(times):.1f} ms, 99th percentile {p99:.1f} ms, "
        f"longest {max(times):.1f} ms (bar: 99th {HEALTH_MS:g})": p99 < HEALTH_MS,
        "/health and every large answer was 200": set(statuses) <= {"health 200", "large 200"},
        f"memory after each round {', '.join(f'{mb:.0f}' for mb in memory)} MB "
        f"(bar: last quarter {GROWTH:g} times the second)": is_flat(memory),
        f"orphans: {sorted(orphans)}": not orphans,
        f"stopped in {stopped:.1f} s (bar: {GRACE_S} s of grace)": stopped < GRACE_S + 1,
    }
    for line, holds in held.items():
        print("   " if holds else "NO:", line)
    return all(held.values())


def is_flat(memory: list[float]) -> bool:
    """Whether memory grows no more once each worker has met each fault, which takes some rounds."""
    quarter = -(-len(memory) // 4)
    second, last = memory[quarter : 2 * quarter] or memory, memory[-quarter:]
    return statistics.median(last) < GROWTH * statistics.median(second)


def run_round(stage: Stage) -> None:
    """Run every fault once, and note what came of it."""
    for fault in FAULTS:
        try:
            what = fault(stage)
        except OSError as error:
            what = f"{type(error).__name__}: {error}"
        stage.found.setdefault(fault.__name__.replace("_", " "), Counter())[what] += 1


def kill_a_worker(stage: Stage) -> str:
    """Kill a worker while another answers, and wait for its successor."""
    before = workers(stage)
    os.kill(min(before), signal.SIGKILL)
    lost = sum(not answers(stage.served, f"{API}/health") for _ in range(50))
    began = time.monotonic()
    wait_for(lambda: len(workers(stage)) == len(before) and min(before) not in workers(stage))
    seconds = time.monotonic() - began
    return f"{lost} of the next 50 requests lost, another is started after {seconds:.1f} s"


def workers(stage: Stage) -> set[int]:
    """The processes that the supervisor has started to answer."""
    found = set()
    for pid in children(stage.served.process.pid):
        with suppress(OSError):
            if b"spawn_main" in Path(f"/proc/{pid}/cmdline").read_bytes():
                found.add(pid)
    return found


def main() -> None:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--minutes", type=float, default=10.0)
    minutes = parser.parse_args().minutes
    folder = Path(tempfile.mkdtemp(prefix="fresnel-replay-"))
    try:
        held = replay(folder, minutes)
    finally:
        shutil.rmtree(folder)
    print(f"load of the machine: {json.dumps(os.getloadavg())}")
    sys.exit(not held)


if __name__ == "__main__":
    main()
