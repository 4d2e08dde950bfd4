"""What systems and search engines ask of the page: manifest, icons, robots.txt, a description."""

import json
import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import urljoin

import png
import pytest
from fastapi import FastAPI

from app.settings import Settings
from tests.api.raw import send

STATIC = Settings().static_dir
PAGES = ("/", "/docs/")
SAFE_SHARE = 0.8  # of a maskable icon, in diameter: a mask may cut off the rest


class Head(HTMLParser):
    """The attributes of a page's links and meta elements."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str]]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, {name: value or "" for name, value in attrs}))

    def all(self, tag: str, **wanted: str) -> Iterator[dict[str, str]]:
        for found, attributes in self.found:
            if found == tag and wanted.items() <= attributes.items():
                yield attributes


def head(app: FastAPI, path: str) -> Head:
    return Head(send(app, path.encode()).body.decode())


def pixels(path: Path) -> tuple[int, int, list[list[int]], int]:
    width, height, rows, info = png.Reader(bytes=path.read_bytes()).read()
    return width, height, [list(row) for row in rows], info["planes"]


def manifest() -> dict[str, Any]:
    read: dict[str, Any] = json.loads((STATIC / "manifest.webmanifest").read_text("utf-8"))
    return read


@pytest.mark.parametrize("path", PAGES)
def test_a_page_says_what_it_is_and_links_only_to_what_is_there(app: FastAPI, path: str) -> None:
    page = head(app, path)
    (description,) = page.all("meta", name="description")
    assert 50 <= len(description["content"]) <= 160  # search engines cut off more
    for link in page.all("link"):
        answer = send(app, urljoin(path, link["href"]).encode())
        assert answer.status == 200, link["href"]
        assert "type" not in link or answer.headers["content-type"].startswith(link["type"])


@pytest.mark.parametrize("path", PAGES)
def test_the_color_around_a_page_is_that_of_its_paper(app: FastAPI, path: str) -> None:
    style = (STATIC / "css" / "base.css").read_text("utf-8")
    for scheme in ("light", "dark"):
        found = re.search(rf'data-theme="{scheme}"\][^}}]*--paper: (#\w+);', style)
        (meta,) = head(app, path).all("meta", **{"name": "theme-color", "data-of": scheme})
        assert found
        assert meta["content"] == found[1]
        assert meta["media"] == f"(prefers-color-scheme: {scheme})"


def test_the_manifest_is_complete(app: FastAPI) -> None:
    answer = send(app, b"/manifest.webmanifest")
    assert answer.headers["content-type"] == "application/manifest+json"
    said = json.loads(answer.body)
    (link,) = head(app, "/").all("link", rel="manifest")
    assert link["href"] == "manifest.webmanifest"
    (description,) = head(app, "/").all("meta", name="description")
    assert said["description"] == description["content"]
    (color,) = head(app, "/").all("meta", **{"name": "theme-color", "data-of": "light"})
    assert {said["theme_color"], said["background_color"]} == {color["content"]}
    # Relative, so that the page can be installed from below any path.
    assert {said["id"], said["start_url"], said["scope"]} == {"./"}
    plain = {icon["sizes"] for icon in said["icons"] if "purpose" not in icon}
    assert plain >= {"192x192", "512x512"}
    assert [icon["sizes"] for icon in said["icons"] if icon.get("purpose") == "maskable"]


def test_each_icon_is_as_large_as_is_said(app: FastAPI) -> None:
    (touch,) = head(app, "/").all("link", rel="apple-touch-icon")
    icons = [(icon["src"], icon["sizes"], icon["type"]) for icon in manifest()["icons"]]
    for name, sizes, kind in [*icons, (touch["href"], "180x180", "image/png")]:
        answer = send(app, f"/{name}".encode())
        assert answer.status == 200
        assert answer.headers["content-type"] == kind
        if kind == "image/png":
            width, height, *_ = pixels(STATIC / name)
            assert f"{width}x{height}" == sizes


def test_an_icon_is_where_browsers_look_that_read_no_page(app: FastAPI) -> None:
    answer = send(app, b"/favicon.ico")
    assert answer.status == 200
    assert answer.headers["content-type"].startswith("image/")
    assert answer.body.endswith((STATIC / "icons" / "icon-192.png").read_bytes())


def test_no_mask_cuts_off_any_of_the_mark() -> None:
    (name,) = [icon["src"] for icon in manifest()["icons"] if icon.get("purpose") == "maskable"]
    side, _, rows, planes = pixels(STATIC / name)
    ground = rows[0][:planes]
    drawn = [
        (x - side / 2, y - side / 2)
        for y, row in enumerate(rows)
        for x in range(side)
        if row[x * planes : (x + 1) * planes] != ground
    ]
    reach = max(x * x + y * y for x, y in drawn) ** 0.5
    assert 0.25 * side < reach < SAFE_SHARE * side / 2


def test_robots_may_read_the_page(app: FastAPI) -> None:
    answer = send(app, b"/robots.txt")
    assert answer.status == 200
    assert answer.headers["content-type"].startswith("text/plain")
    lines = answer.body.decode().split("\n")
    assert lines[:2] == ["User-agent: *", "Disallow:"]
