"""How the server starts where something is missing, and what it says when it cannot."""

import os
import socket
import subprocess
import tempfile
from pathlib import Path

import pytest

from app.server.run import CannotServe, serve
from app.settings import Settings
from tests.serve.command import API, COMMAND, PATIENCE_S, ROOT, Served, answers, wait_for

WITHOUT_OUTPUT = ["sh", "-c", 'exec "$@" >&-', "sh", *COMMAND, "serve"]


def test_it_serves_without_a_standard_output() -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    with subprocess.Popen([*WITHOUT_OUTPUT, "--port", str(port)], cwd=ROOT) as process:
        try:
            served = Served(process, f"http://127.0.0.1:{port}", Path(os.devnull))
            wait_for(lambda: process.poll() is not None or answers(served, f"{API}/health/ready"))
            assert process.poll() is None
        finally:
            process.kill()


def test_a_log_that_has_no_output_is_refused() -> None:
    ended = subprocess.run(
        [*WITHOUT_OUTPUT, "--port", "0"],
        cwd=ROOT,
        env=os.environ | {"FRESNEL_ACCESS_LOG": "true"},
        stderr=subprocess.PIPE,
        text=True,
        timeout=PATIENCE_S,
        check=False,
    )
    assert ended.returncode == 1
    assert ended.stderr.startswith("Error: FRESNEL_ACCESS_LOG: ")
    assert "Traceback" not in ended.stderr


def test_workers_that_have_nowhere_to_count_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(**_: object) -> None:
        raise FileNotFoundError("No usable temporary directory found")

    monkeypatch.setattr(tempfile, "TemporaryDirectory", refuse)
    with pytest.raises(CannotServe, match="PROMETHEUS_MULTIPROC_DIR, or run a single worker"):
        serve(Settings(port=0, workers=2), lambda url: pytest.fail(url))


def test_a_name_that_is_no_address_is_told() -> None:
    with pytest.raises(CannotServe, match=r"FRESNEL_HOST = nowhere\.invalid, FRESNEL_PORT = 0: "):
        serve(Settings(port=0, host="nowhere.invalid"), lambda url: pytest.fail(url))
