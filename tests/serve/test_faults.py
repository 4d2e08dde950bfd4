"""What is lost when a part of the server fails or is killed, as the README's table says."""

import json
import os
import signal
import socket
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing, suppress
from http.client import HTTPConnection, HTTPException
from pathlib import Path
from uuid import uuid4

import pytest

from tests.browser.conftest import find_browser
from tests.serve.command import (
    API,
    PATIENCE_S,
    Answer,
    Served,
    answers,
    children,
    running,
    serving,
    wait_for,
)
from tests.serve.nginx import find_nginx, in_front_of
from tests.serve.test_stop import SLOW, folders_in_memory, in_flight

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="/proc says which processes run")

PICTURE = f"{API}/figures/sweep?model=schlick&minimum=1.1&maximum=4&steps=11&format=png&width={{}}"
GRACE = "5"
MOST_S = 10.0
ITEMS = {"items": [{"n_t": 1.5, "theta_i_deg": [0, 45, 80], "model": "schlick"}]}


def evaluated(served: Served) -> int:
    """Status of a small call for which the pool has to have a thread."""
    with closing(served.connect()) as connection:
        connection.request("POST", f"{API}/evaluate", json.dumps(ITEMS))
        answer = connection.getresponse()
        answer.read()
        return answer.status


def stops(served: Served, number: int = signal.SIGTERM) -> float:
    """Tell a server to stop, and return the seconds until it has."""
    began = time.monotonic()
    served.process.send_signal(number)
    served.process.wait(PATIENCE_S)
    return time.monotonic() - began


class Fake:
    """A browser that hangs: it starts, and says nothing."""

    def __init__(self, folder: Path) -> None:
        self.mark = f"sleep 86400.{uuid4().int % 10**12}"
        self.path = folder / "browser"
        self.path.write_text(f"#!/bin/sh\nexec {self.mark}\n", "utf-8")
        self.path.chmod(self.path.stat().st_mode | stat.S_IXUSR)

    def processes(self) -> list[int]:
        return running(self.mark)


@pytest.fixture
def fake(tmp_path: Path) -> Iterator[Fake]:
    browser = Fake(tmp_path)
    yield browser
    wait_for(lambda: not browser.processes())


def test_a_browser_that_hangs_costs_no_more_than_its_pictures(tmp_path: Path, fake: Fake) -> None:
    with serving(tmp_path, BROWSER_PATH=str(fake.path), FRESNEL_PICTURE_TIMEOUT_S="3") as served:
        with ThreadPoolExecutor(4) as clients:
            asked = [clients.submit(served.ask, PICTURE.format(240 + i)) for i in range(4)]
            wait_for(lambda: bool(fake.processes()))
            assert served.ask(f"{API}/health/ready").status == 200
            assert evaluated(served) == 200
            assert served.ask(SLOW.format(20)).status == 200
            failed: list[Answer] = [one.result() for one in asked]
        assert [answer.status for answer in failed] == [503] * 4
        assert all(int(answer.headers["Retry-After"]) > 0 for answer in failed)
        assert "3 s" in json.loads(failed[0].body)["detail"]
        assert fake.processes() == []


def test_a_browser_that_ends_is_a_passing_fault(tmp_path: Path, fake: Fake) -> None:
    with serving(tmp_path, BROWSER_PATH=str(fake.path)) as served, ThreadPoolExecutor(1) as client:
        asked = client.submit(served.ask, PICTURE.format(240))
        wait_for(lambda: bool(fake.processes()))
        os.kill(fake.processes()[0], signal.SIGKILL)
        failed = asked.result()
        assert failed.status == 503
        assert failed.headers["Retry-After"]


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGKILL])
def test_a_browser_that_hangs_goes_with_the_server(
    tmp_path: Path, fake: Fake, number: signal.Signals
) -> None:
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    with (
        ThreadPoolExecutor(1) as client,
        serving(
            tmp_path, BROWSER_PATH=str(fake.path), TMPDIR=str(scratch), FRESNEL_GRACE_S=GRACE
        ) as served,
    ):
        client.submit(served.ask, PICTURE.format(240))
        wait_for(lambda: bool(fake.processes()))
        assert any(scratch.iterdir())
        assert stops(served, number) < MOST_S
        wait_for(lambda: not fake.processes())
        wait_for(lambda: not any(scratch.iterdir()))


def test_a_browser_is_started_anew_after_it_was_killed(tmp_path: Path) -> None:
    if find_browser() is None:
        pytest.skip("no browser")
    with serving(tmp_path, FRESNEL_PICTURE_TIMEOUT_S="60", FRESNEL_TIMEOUT_S="60") as served:
        before = children(served.process.pid)
        assert served.ask(PICTURE.format(240)).status == 200
        started = children(served.process.pid) - before
        assert len(started) > 2  # the process that draws, the browser, and what that started
        for pid in sorted(started):
            os.kill(pid, signal.SIGSTOP)  # so that none cleans up after another
        for pid in sorted(started):
            os.kill(pid, signal.SIGKILL)
        assert served.ask(PICTURE.format(241)).status == 200


def test_a_log_that_nobody_reads_holds_no_answer_and_no_stop(tmp_path: Path) -> None:
    with serving(tmp_path, stdout=subprocess.PIPE, FRESNEL_GRACE_S=GRACE) as served:
        connection = served.connect()
        for _ in range(600):
            connection.request("GET", f"{API}/health")
            assert connection.getresponse().read()
        connection.close()
        assert stops(served) < MOST_S


def test_errors_that_nobody_reads_hold_no_answer_and_no_stop(tmp_path: Path) -> None:
    with serving(
        tmp_path, stderr=subprocess.PIPE, FRESNEL_ACCESS_LOG="false", FRESNEL_GRACE_S=GRACE
    ) as served:
        for _ in range(2000):  # each is a warning of uvicorn's
            with socket.create_connection(served.address, PATIENCE_S) as connection:
                connection.sendall(b"no HTTP\r\n\r\n")
                assert connection.recv(100).startswith(b"HTTP/1.1 400")
        assert served.ask(f"{API}/health").status == 200
        assert stops(served) < MOST_S


def test_workers_and_what_they_hold_go_with_their_supervisor(tmp_path: Path) -> None:
    before = folders_in_memory()
    with serving(tmp_path, "--workers", "2", FRESNEL_DRAIN_S="60") as served:
        workers = children(served.process.pid)
        served.process.kill()
        served.process.wait()
        wait_for(lambda: not served.listens(), 20.0)
        with socket.socket() as next_one:
            next_one.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            next_one.bind(served.address)
        wait_for(lambda: not workers & {pid for pid in workers if Path(f"/proc/{pid}").exists()})
    assert folders_in_memory() <= before


def test_what_a_worker_holds_as_the_supervisor_is_killed_is_counted_and_logged(
    tmp_path: Path,
) -> None:
    before = folders_in_memory()
    with serving(tmp_path, "--workers", "2") as served, ThreadPoolExecutor(1) as client:
        asked = client.submit(served.ask, SLOW.format(500))
        time.sleep(0.1)
        workers = children(served.process.pid)
        served.process.kill()
        assert asked.result().status == 200
        wait_for(lambda: not workers & {pid for pid in workers if Path(f"/proc/{pid}").exists()})
        assert [line for line in served.logged() if "/errors/map" in str(line["target"])]
        assert "Traceback" not in (tmp_path / "stderr").read_text("utf-8")
    assert folders_in_memory() <= before


@pytest.mark.parametrize("parser", ["h11", "httptools"])
def test_an_answer_that_is_not_read_gives_its_connection_back(tmp_path: Path, parser: str) -> None:
    with (
        serving(
            tmp_path,
            FRESNEL_HTTP=parser,
            FRESNEL_WRITE_TIMEOUT_S="1",
            FRESNEL_MAX_CONNECTIONS="1",
        ) as served,
        socket.socket() as client,
    ):
        client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        client.connect(served.address)
        client.sendall(f"GET {SLOW.format(500)} HTTP/1.1\r\nHost: x\r\n\r\n".encode())
        wait_for(lambda: not answers(served, f"{API}/health/live"))
        wait_for(lambda: answers(served, f"{API}/health/live"), 30.0)


def test_a_worker_that_is_killed_loses_what_it_held_and_no_more(tmp_path: Path) -> None:
    with serving(tmp_path, "--workers", "2") as served:
        connections = {f"c-{i}": served.connect() for i in range(24)}
        for name, connection in connections.items():
            connection.request("GET", f"{API}/health", headers={"X-Request-ID": name})
            connection.getresponse().read()
        holder: dict[object, object] = {}

        def all_are_logged() -> bool:
            holder.update({line["request_id"]: line["pid"] for line in served.logged()})
            return connections.keys() <= holder.keys()

        wait_for(all_are_logged)
        victim = holder["c-0"]
        assert isinstance(victim, int)
        os.kill(victim, signal.SIGKILL)
        for name, connection in connections.items():
            if holder[name] != victim:
                assert asked_again(connection) == 200
                continue
            with pytest.raises((OSError, HTTPException)):
                asked_again(connection)
            # Whoever comes again is answered at once, while the other is still being started.
            assert served.ask(f"{API}/health").status == 200
        for connection in connections.values():
            connection.close()


def asked_again(connection: HTTPConnection) -> int:
    connection.auto_open = 0
    connection.request("GET", f"{API}/health")
    answer = connection.getresponse()
    answer.read()
    return answer.status


def test_a_worker_that_is_killed_while_another_boots_is_replaced_at_once(tmp_path: Path) -> None:
    with serving(tmp_path, "--workers", "2") as served:
        first = children(served.process.pid)
        (victim, *_) = workers_of(served)
        os.kill(victim, signal.SIGKILL)
        wait_for(lambda: bool(children(served.process.pid) - first))
        (booting,) = children(served.process.pid) - first
        os.kill(booting, signal.SIGSTOP)  # it takes its time
        time.sleep(1.5)
        survivors = {pid for pid in first - {victim} if b"spawn_main" in command_of(pid)}
        os.kill(survivors.pop(), signal.SIGKILL)
        wait_for(lambda: bool(children(served.process.pid) - first - {booting}), 10.0)
        wait_for(lambda: answers(served, f"{API}/health"))
        os.kill(booting, signal.SIGCONT)


def command_of(pid: int) -> bytes:
    return Path(f"/proc/{pid}/cmdline").read_bytes()


def workers_of(served: Served) -> list[int]:
    """The processes that answer, told by the access log."""
    wait_for(lambda: bool(served.logged()))
    return [int(str(line["pid"])) for line in served.logged()]


def test_workers_are_replaced_one_by_one_on_sighup(tmp_path: Path) -> None:
    with serving(tmp_path, "--workers", "2") as served:
        before = children(served.process.pid)
        answering = set(workers_of(served))
        served.process.send_signal(signal.SIGHUP)

        def all_are_new() -> bool:
            assert answers(served, f"{API}/health")
            return not answering & children(served.process.pid) and len(before) == len(
                children(served.process.pid)
            )

        wait_for(all_are_new)


def test_a_proxy_that_is_killed_costs_what_went_through_it(tmp_path: Path) -> None:
    """What it asked for and nobody waits for any more leaves the queue; one that is started answers."""
    nginx = find_nginx(tmp_path)
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    second.mkdir()
    with serving(tmp_path, FRESNEL_THREADS="1") as served, ThreadPoolExecutor(8) as clients:
        address = [f"127.0.0.1:{served.port}"]
        with in_front_of(nginx, first, address) as front:
            asked = [clients.submit(front.ask, SLOW.format(400 + i)) for i in range(8)]
            wait_for(lambda: in_flight(served) > 4)
            for pid in [front.process.pid, *children(front.process.pid)]:
                with suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            lost = [one for one in asked if isinstance(one.exception(), OSError | HTTPException)]
            assert {one.result().status for one in asked if one not in lost} <= {200}
        assert len(lost) > 2
        wait_for(lambda: in_flight(served) == 1, 10.0)
        assert evaluated(served) == 200
        with in_front_of(nginx, second, address) as front:
            assert front.ask(SLOW.format(20)).status == 200
