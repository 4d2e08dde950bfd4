"""How the server stops: ready no more, everything in flight answered, nothing lost."""

import json
import os
import re
import signal
import socket
import time
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.serve.command import API, PATIENCE_S, Answer, Load, Served, answers, serving, wait_for

SLOW = f"{API}/errors/map?model=schlick&x=theta_i_deg&y=n_t&x_steps=500&y_steps={{}}"
"""Up to a quarter of a million cells: long enough to be in flight when the signal comes."""


def in_flight(served: Served) -> int:
    """Requests being answered, the one that asks for it included."""
    (count,) = re.findall(r"^http_requests_in_flight (\d+)", scraped(served), re.MULTILINE)
    return int(count)


def scraped(served: Served) -> str:
    return served.ask("/metrics").body.decode()


def stopped_while_asked(served: Served) -> None:
    """Stop a server while it computes, and check that it answers all the same."""
    with ThreadPoolExecutor(6) as clients:
        asked: list[Future[Answer]] = [
            clients.submit(served.ask, SLOW.format(steps)) for steps in range(495, 501)
        ]
        wait_for(lambda: in_flight(served) > 3)
        served.process.send_signal(signal.SIGTERM)
        for steps, answer in zip(range(495, 501), (one.result() for one in asked), strict=True):
            assert answer.status == 200
            assert len(json.loads(answer.body)["y"]["values"]) == steps
    assert served.process.wait(PATIENCE_S) in (0, -signal.SIGTERM)


def test_what_is_in_flight_is_answered(tmp_path: Path) -> None:
    with serving(tmp_path) as served:
        stopped_while_asked(served)


@pytest.mark.parametrize(("workers", "drain_s"), [("1", "60"), ("2", "3")])
def test_no_request_is_lost_under_load_when_a_drain_is_set(
    tmp_path: Path, workers: str, drain_s: str
) -> None:
    targets = [f"{API}/curves?n_t=1.{i}" for i in range(100, 999)] + ["/", f"{API}/models"]
    with serving(tmp_path, "--workers", workers, FRESNEL_DRAIN_S=drain_s) as served:
        kept = served.connect()
        kept.request("GET", f"{API}/health")
        first = kept.getresponse()
        first.read()
        assert first.headers["Connection"] is None
        with Load(served, targets) as load:
            load.wait_for(200)
            served.process.send_signal(signal.SIGTERM)
            wait_for(lambda: served.ask(f"{API}/health/ready").status == 503)
            kept.request("GET", f"{API}/health/live")
            last = kept.getresponse()
            assert (last.status, last.headers["Connection"]) == (200, "close")
            kept.close()
            # A load balancer has seen it; until it acts on it, requests still come and are answered.
            load.wait_for(len(load.statuses) + 50)
        if workers == "1":  # who does not want to wait says so again
            served.process.send_signal(signal.SIGTERM)
        served.process.wait(PATIENCE_S)
        assert load.failures == []
        assert set(load.statuses) == {200}
    refused = [line for line in served.logged() if line["status"] == 503]
    assert {line["route"] for line in refused} == {f"{API}/health/ready"}


def test_a_client_that_reads_nothing_does_not_hold_the_server_for_ever(tmp_path: Path) -> None:
    with (
        serving(tmp_path, FRESNEL_GRACE_S="1") as served,
        socket.create_connection(served.address) as stalled,
    ):
        stalled.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        stalled.sendall(f"GET {SLOW.format(500)} HTTP/1.1\r\nHost: x\r\n\r\n".encode())
        stalled.recv(1)  # the answer has begun
        began = time.monotonic()
        served.process.send_signal(signal.SIGTERM)
        served.process.wait(PATIENCE_S)
        assert time.monotonic() - began < 20.0


def folders_in_memory() -> set[Path]:
    return set(Path("/dev/shm").glob("fresnel-explorer-*"))  # noqa: S108


def test_workers_count_and_log_together_and_one_that_is_killed_is_replaced(tmp_path: Path) -> None:
    before = folders_in_memory()
    with serving(tmp_path, "--workers", "2") as served:
        for _ in range(50):
            assert served.ask(f"{API}/models/exact").status == 200
        told = '{method="GET",route="/api/v1/models/{model_id}",status="200"} 50.0'
        for _ in range(6):  # whichever worker is asked; the other may be at the end of a request
            wait_for(lambda: f"http_requests_total{told}" in scraped(served))
            wait_for(lambda: in_flight(served) == 1)

        assert served.ask(f"{API}/models", X_Request_ID="found-again").status == 200
        wait_for(lambda: any(line["request_id"] == "found-again" for line in served.logged()))
        (line,) = (line for line in served.logged() if line["request_id"] == "found-again")
        assert (line["method"], line["route"], line["status"]) == ("GET", f"{API}/models", 200)

        victim = line["pid"]
        assert isinstance(victim, int)
        assert victim != served.process.pid
        os.kill(victim, signal.SIGKILL)

        def two_others_answer() -> bool:
            answers(served, f"{API}/health/live")  # one that the killed worker held gets nothing
            return len({line["pid"] for line in served.logged()} - {victim}) == 2

        wait_for(two_others_answer)
        assert f"http_requests_total{told}" in scraped(served)
        wait_for(lambda: in_flight(served) == 1)
        stopped_while_asked(served)
    assert folders_in_memory() <= before
