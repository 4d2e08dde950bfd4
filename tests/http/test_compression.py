"""What takes long to compress holds nobody up, and the page's files are sent as they are."""

import threading
from pathlib import Path

import brotli
import pytest
from fastapi import FastAPI

from app.http import body
from app.page import files
from app.settings import Settings
from tests.api.raw import send

STATIC = Settings().static_dir
VENDOR = STATIC / "vendor"
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


@pytest.mark.parametrize(
    "path",
    [STATIC / "js" / "main.js", STATIC / "css" / "base.css", *STATIC.rglob("plotly.css")],
    ids=lambda path: path.name,
)
def test_scripts_and_styles_are_sent_as_they_are(app: FastAPI, path: Path) -> None:
    target = "/" + path.relative_to(STATIC).as_posix()
    assert send(app, target.encode()).body == path.read_bytes()
    compressed = send(app, target.encode(), headers={"Accept-Encoding": "br"}).body
    assert brotli.decompress(compressed) == path.read_bytes()
    assert len(compressed) < path.stat().st_size / 3
