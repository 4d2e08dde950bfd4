"""The page's files are sent as they are, compressed once."""

from pathlib import Path

import brotli
import pytest
from fastapi import FastAPI

from app.settings import Settings
from tests.api.raw import send

STATIC = Settings().static_dir


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
