"""Generated requests over the wire: no 5xx, every error a problem, memory flat.

`make fuzz` sends 100,000 of them, to the server and through nginx, and prints what came back.
"""

import json
import os
import socket
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from http.client import HTTPException, HTTPMessage, HTTPResponse
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings

from app.http.problems import MEDIA_TYPE, Problem
from app.main import create_app
from app.optics.registry import default_registry
from tests.fuzz.strategies import Request, operations, requests
from tests.serve.command import Served, serving
from tests.serve.nginx import find_nginx, in_front_of

REQUESTS = int(os.environ.get("FUZZ_REQUESTS", "600"))
THROUGH_NGINX = bool(os.environ.get("FUZZ_THROUGH_NGINX"))
SEED = int(os.environ.get("FUZZ_SEED", "7"))
KNOWN = operations(create_app().openapi())
IDS = [*default_registry(), "Au", "water", "BK7", "vacuum", "nope"]
PATIENCE_S = 60.0


class Client:
    """Sends bytes and reads answers, over one connection as long as that lives."""

    def __init__(self, served: Served) -> None:
        self._address = (served.host or "", served.port or 0)
        self._socket: socket.socket | None = None
        self.statuses: Counter[str] = Counter()
        self.memory: list[int] = []
        self.sent = 0

    def close(self) -> None:
        if self._socket is not None:
            self._socket.close()
        self._socket = None

    def exchange(self, request: Request) -> tuple[int, HTTPMessage, bytes] | None:
        """Send a request; nothing if the server hung up on it without an answer."""
        if self._socket is None:
            self._socket = socket.create_connection(self._address, PATIENCE_S)
        try:
            self._socket.sendall(request.wire())
            if request.broken:  # whatever was announced, no more will come
                with suppress(OSError):  # it has hung up already
                    self._socket.shutdown(socket.SHUT_WR)
            answer = HTTPResponse(self._socket, method=request.method.decode())
            answer.begin()
            body = answer.read()
        except (ConnectionError, BrokenPipeError, HTTPException):
            self.close()
            return None
        if answer.will_close or request.broken:
            self.close()
        return answer.status, answer.headers, body


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    # A small cache hides no growth; a connection kept long is not closed while a request sets out.
    folder = tmp_path_factory.mktemp("fuzz")
    with serving(folder, FRESNEL_CACHE_BYTES="8000000", FRESNEL_KEEP_ALIVE_S="600") as running:
        yield running


@pytest.fixture(scope="module")
def front(served: Served, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """What is asked: the server, or nginx before it."""
    if not THROUGH_NGINX:
        yield served
        return
    nginx = find_nginx(tmp_path_factory.mktemp("unpacked"))
    with in_front_of(nginx, tmp_path_factory.mktemp("nginx"), [f"127.0.0.1:{served.port}"]) as site:
        yield site


@pytest.fixture(scope="module")
def client(front: Served) -> Iterator[Client]:
    client = Client(front)
    yield client
    client.close()


def resident(served: Served) -> int:
    """Memory that the server has, in bytes; 0 where the system does not say."""
    status = Path(f"/proc/{served.process.pid}/status")
    if not status.exists():
        return 0
    line = next(s for s in status.read_text().splitlines() if s.startswith("VmRSS:"))
    return int(line.split()[1]) * 1024


def judge(request: Request, status: int, headers: HTTPMessage, body: bytes) -> None:
    """Check what every answer has to be."""
    if status == 503:
        assert headers["Retry-After"], (request, body[:500])
    else:
        assert status < 500, (request, body[:500])
    media_type = headers["Content-Type"]
    if request.method == b"HEAD" or status in (204, 304):
        assert body == b""
    elif body == b"Invalid HTTP request received.":  # uvicorn's own words
        assert status == 400
    elif status >= 400:
        assert media_type == MEDIA_TYPE, (request, status, media_type, body[:200])
        problem = Problem.model_validate_json(body, strict=True, extra="forbid")
        assert problem.status == status
        assert problem.detail
        assert len(body) < 50_000
    elif media_type == "application/json" and headers["Content-Encoding"] is None:
        json.loads(body)


def test_no_request_breaks_the_server(served: Served, client: Client) -> None:
    began = time.monotonic()

    @seed(SEED)
    @settings(
        max_examples=REQUESTS,
        database=None,
        deadline=None,
        phases=[Phase.generate, Phase.shrink],
        suppress_health_check=list(HealthCheck),
    )
    @given(requests(KNOWN, IDS))
    def run(request: Request) -> None:
        client.sent += 1
        answer = client.exchange(request)
        if client.sent % max(REQUESTS // 20, 1) == 0:
            client.memory.append(resident(served))
            print(f"{client.sent:>9} requests {client.memory[-1] / 1e6:8.1f} MB resident")  # noqa: T201
        if answer is None:
            # nginx answers what ends after the address as HTTP/0.9, without a head.
            headless = THROUGH_NGINX and b"\n" in request.target
            assert request.broken or headless, f"no answer to {request}"
            client.statuses["hung up"] += 1
        else:
            client.statuses[str(answer[0])] += 1
            judge(request, *answer)

    run()
    assert served.ask("/api/v1/health").status == 200
    seconds = time.monotonic() - began
    print(f"\n{client.sent} requests in {seconds:.0f} s: {dict(sorted(client.statuses.items()))}")  # noqa: T201
    second_half = client.memory[len(client.memory) // 2 :]
    assert max(second_half) - min(second_half) < 50e6, "grows"
