"""How the server stops: ready no more, everything in flight answered, nothing lost."""

from __future__ import annotations

import os
import signal
import socket
import threading
import time
from pathlib import Path

import pytest

from tests.serve.command import API, PATIENCE_S, Answer, Load, Served, answers, serving, wait_for

SLOW = f"{API}/errors/map?model=schlick&x=theta_i_deg&y=n_t&x_steps=500&y_steps=500"
"""A quarter of a million cells: long enough to be in flight when the signal comes."""


def readiness(served: Served) -> int:
    return served.ask(f"{API}/health/ready").status


@pytest.mark.parametrize("workers", ["1", "2"])
def test_what_is_in_flight_is_answered(tmp_path: Path, workers: str) -> None:
    with serving(tmp_path, "--workers", workers) as served:
        whole = served.ask(SLOW)
        assert whole.status == 200
        got: list[Answer] = []
        threads = [
            threading.Thread(target=lambda: got.append(served.ask(SLOW, Cache_Control="no-cache")))
            for _ in range(6)
        ]
        for thread in threads:
            thread.start()
        time.sleep(0.3)  # all are sent, the last wait for the first
        served.process.send_signal(signal.SIGTERM)
        for thread in threads:
            thread.join(PATIENCE_S)
        served.process.wait(PATIENCE_S)
        assert [(answer.status, answer.body) for answer in got] == [(200, whole.body)] * 6
    assert served.process.returncode in (0, -signal.SIGTERM)


@pytest.mark.parametrize("workers", ["1", "2"])
def test_no_request_is_lost_under_load_when_a_drain_is_set(tmp_path: Path, workers: str) -> None:
    targets = [f"{API}/curves?n_t=1.{i}" for i in range(100, 999)] + ["/", f"{API}/models"]
    with serving(tmp_path, "--workers", workers, FRESNEL_DRAIN_S="1.5") as served:
        with Load(served, targets) as load:
            wait_for(lambda: len(load.statuses) > 200)
            served.process.send_signal(signal.SIGTERM)
            wait_for(lambda: readiness(served) == 503, seconds=1.4)
            # A load balancer has seen it; until it acts on it, requests still come and are answered.
            before = len(load.statuses)
            wait_for(lambda: len(load.statuses) > before + 50, seconds=1.4)
        served.process.wait(PATIENCE_S)
        assert load.failures == []
        assert set(load.statuses) == {200}
    refused = [line for line in served.logged() if line["status"] == 503]
    assert {line["route"] for line in refused} == {f"{API}/health/ready"}


def test_while_draining_answers_close_and_liveness_stays(tmp_path: Path) -> None:
    with serving(tmp_path, FRESNEL_DRAIN_S="60") as served:
        kept = served.connect()
        kept.request("GET", f"{API}/health")
        first = kept.getresponse()
        first.read()
        assert first.headers["Connection"] is None
        served.process.send_signal(signal.SIGTERM)
        wait_for(lambda: readiness(served) == 503)
        kept.request("GET", f"{API}/health/live")
        last = kept.getresponse()
        assert (last.status, last.headers["Connection"]) == (200, "close")
        kept.close()
        # Whoever does not want to wait says so again.
        served.process.send_signal(signal.SIGTERM)
        served.process.wait(PATIENCE_S)


def test_a_client_that_reads_nothing_does_not_hold_the_server_for_ever(tmp_path: Path) -> None:
    with serving(tmp_path, FRESNEL_GRACE_S="1") as served:
        assert served.host is not None
        with socket.create_connection((served.host, served.port or 0)) as stalled:
            stalled.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            stalled.sendall(f"GET {SLOW} HTTP/1.1\r\nHost: x\r\n\r\n".encode())
            time.sleep(1.0)
            began = time.monotonic()
            served.process.send_signal(signal.SIGTERM)
            served.process.wait(PATIENCE_S)
            assert time.monotonic() - began < 20.0


def test_a_killed_worker_is_replaced_and_its_counts_stay(tmp_path: Path) -> None:
    with serving(tmp_path, "--workers", "2") as served:
        for _ in range(50):
            assert served.ask(f"{API}/models/exact").status == 200
        told = '{method="GET",route="/api/v1/models/{model_id}",status="200"} 50.0'
        wait_for(lambda: f"http_requests_total{told}" in served.ask("/metrics").body.decode())

        victim = served.logged()[-1]["pid"]
        assert isinstance(victim, int)
        assert victim != served.process.pid
        os.kill(victim, signal.SIGKILL)

        def two_others_answer() -> bool:
            answers(served, f"{API}/health/live")  # one that the killed worker held gets nothing
            return len({line["pid"] for line in served.logged()} - {victim}) == 2

        wait_for(two_others_answer)
        assert f"http_requests_total{told}" in served.ask("/metrics").body.decode()
        wait_for(lambda: "in_flight 1.0" in served.ask("/metrics").body.decode())
