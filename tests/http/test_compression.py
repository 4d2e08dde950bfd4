"""What takes long to compress holds nobody up."""

import threading

import pytest
from fastapi import FastAPI

from app.http import body
from app.page import files
from app.settings import Settings
from tests.api.raw import send

VENDOR = Settings().static_dir / "vendor"
BUNDLE = next(VENDOR.rglob("plotly-cartesian.min.js")).relative_to(VENDOR).as_posix()


@pytest.mark.parametrize(
    "target", [f"/vendor/{BUNDLE}", "/api/v1/models", "/api/v1/curves?samples=20001"]
)
def test_it_is_done_in_a_thread(app: FastAPI, monkeypatch: pytest.MonkeyPatch, target: str) -> None:
    threads: list[str] = []

    def compress(*_: object) -> bytes:
        threads.append(threading.current_thread().name)
        return b"packed"

    monkeypatch.setattr(body, "_compress", compress)
    files._encoded.cache_clear()
    try:
        answer = send(app, target.encode(), headers={"Accept-Encoding": "gzip"})
    finally:
        files._encoded.cache_clear()
    assert answer.headers["content-encoding"] == "gzip"
    assert threads
    assert threads != [threading.current_thread().name]
