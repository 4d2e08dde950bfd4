"""The supervisor with workers that fail: one that cannot start, and one that hangs."""

import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from app.server import workers
from app.server.workers import Supervisor
from tests.serve.command import wait_for

STARTS = "STARTS_OF_WORKERS"


@pytest.fixture
def bound() -> Iterator[socket.socket]:
    numbers = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
    handlers = {number: signal.getsignal(number) for number in numbers}
    with socket.create_server(("127.0.0.1", 0)) as taken:
        yield taken
    for number, handler in handlers.items():
        signal.signal(number, handler)


def fails(_: socket.socket, send_word: Callable[[], None]) -> None:  # noqa: ARG001
    sys.exit(3)


def hangs_at_first(_: socket.socket, send_word: Callable[[], None]) -> None:
    starts = Path(os.environ[STARTS])
    is_first = not any(starts.iterdir())
    (starts / str(os.getpid())).touch()
    send_word()
    while True:
        time.sleep(0.1)
        if not is_first:
            send_word()


def test_one_that_cannot_start_ends_the_server_instead_of_a_loop(bound: socket.socket) -> None:
    def announce() -> None:
        pytest.fail("nobody serves")

    assert Supervisor(fails, bound, 2, stop_s=1.0).run(announce) == 3


def test_one_that_hangs_is_replaced(
    bound: socket.socket, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(STARTS, str(tmp_path))
    monkeypatch.setattr(workers, "_SILENT_S", 2.0)
    told: list[str] = []

    def stop_after_the_second() -> None:
        wait_for(lambda: len(list(tmp_path.iterdir())) == 2)
        os.kill(os.getpid(), signal.SIGTERM)

    threading.Thread(target=stop_after_the_second).start()
    assert Supervisor(hangs_at_first, bound, 1, stop_s=1.0).run(lambda: told.append("x")) == 0
    assert told == ["x"]
