"""The page in another page: one view, no frame around it, no way for it to act as the whole page."""

import threading
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import FrameLocator, Page, expect

from tests.browser.explore_page import READY_MS
from tests.browser.test_accessible import PLACES


class Quiet(SimpleHTTPRequestHandler):
    """Files, and no word about it."""

    def log_message(self, format: str, *args: Any) -> None:  # noqa: A002 (its name there)
        pass


@pytest.fixture
def lecture(tmp_path: Path) -> Iterator[Path]:
    """Serve a folder as another site; its address is in `url`."""
    handler = partial(Quiet, directory=str(tmp_path))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        (tmp_path / "url").write_text(f"http://127.0.0.1:{server.server_port}")
        yield tmp_path
        server.shutdown()


def embedded(page: Page, lecture: Path, address: str, width: int = 1000) -> FrameLocator:
    """Show an address of the server in an iframe of a page of the other site."""
    frame = f'<iframe src="{address}" title="Reflection" width="{width}" height="640"></iframe>'
    (lecture / "index.html").write_text(f'<!doctype html><link rel="icon" href="data:,">{frame}')
    page.set_viewport_size({"width": width + 40, "height": 720})
    page.goto((lecture / "url").read_text())
    return page.frame_locator("iframe")


def test_a_view_stands_alone_in_another_page(page: Page, lecture: Path, server_url: str) -> None:
    asked: set[str] = set()
    page.on("request", lambda request: asked.add(urlsplit(request.url).netloc))
    frame = embedded(page, lecture, f"{server_url}/?view=explore&n_t=1.7&embed=1")
    curve = frame.locator(".plot-host path.js-line").first
    curve.wait_for(state="attached", timeout=READY_MS)
    for shell in (".top", ".bottom"):
        expect(frame.locator(shell)).to_be_hidden()
    media = frame.locator(".panel .heading").first
    top = media.evaluate("(heading) => heading.getBoundingClientRect().top")
    assert 0 <= top < 40  # nothing is kept free for a header that is not there
    page.wait_for_load_state("networkidle")
    here = (lecture / "url").read_text()
    assert asked == {urlsplit(here).netloc, urlsplit(server_url).netloc}


def test_it_is_moved_there_and_leads_to_the_whole_page(
    page: Page, lecture: Path, server_url: str
) -> None:
    frame = embedded(page, lecture, f"{server_url}/?view=explore&embed=1")
    box = frame.locator("#n_t-box")
    box.fill("1.7", timeout=READY_MS)
    box.press("Enter")
    whole = frame.get_by_role("link", name="Fresnel Explorer", exact=True)
    expect(whole).to_have_attribute("href", "?n_t=1.7")
    with page.context.expect_page() as opening:
        whole.click()
    expect(opening.value.locator("#n_t-box")).to_have_value("1.7", timeout=READY_MS)
    expect(opening.value.locator(".top")).to_be_visible()


def test_nothing_sticks_out_of_a_narrow_frame(page: Page, lecture: Path, server_url: str) -> None:
    frame = embedded(page, lecture, f"{server_url}/?view=compare&embed=1", width=320)
    frame.locator(".js-plotly-plot .main-svg").first.wait_for(timeout=READY_MS)
    wide = frame.locator("html").evaluate("(root) => [root.scrollWidth, root.clientWidth]")
    assert wide[0] <= wide[1]


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_every_link_stays_embedded_or_leaves_the_frame(
    page: Page, lecture: Path, server_url: str, place: str
) -> None:
    at = place + ("&" if "?" in place else "?") + "embed=1"
    frame = embedded(page, lecture, f"{server_url}/{at}")
    frame.locator(".view:not([hidden])").first.wait_for(timeout=READY_MS)
    page.wait_for_load_state("networkidle")
    closed = frame.locator(".view:not([hidden]) details:not([open])")
    closed.evaluate_all("(closed) => closed.forEach((one) => { one.open = true; })")
    page.wait_for_load_state("networkidle")
    astray = frame.locator(".view:not([hidden])").evaluate(
        """(view) => [...view.querySelectorAll("a[href]")]
          .filter((link) => {
            const { pathname, searchParams } = new URL(link.href);
            const stays = pathname === "/" && searchParams.get("embed") === "1";
            return !(stays || link.target === "_blank" || link.hasAttribute("download"));
          })
          .map((link) => link.outerHTML)"""
    )
    assert astray == []


def test_links_of_theory_are_followed_within_the_frame(
    page: Page, lecture: Path, server_url: str
) -> None:
    frame = embedded(page, lecture, f"{server_url}/?view=theory&section=worksheets&embed=1")
    frame.locator(".worksheets .worksheet li a").first.click(timeout=READY_MS)
    frame.locator(".view-explore .plot-host path.js-line").first.wait_for(
        state="attached", timeout=READY_MS
    )
    inner = page.frames[1]
    assert parse_qs(urlsplit(inner.url).query)["embed"] == ["1"]
    inner.evaluate("() => location.reload()")
    expect(frame.locator(".view-explore")).to_be_visible(timeout=READY_MS)
    expect(frame.locator(".top")).to_be_hidden()


def test_the_whole_page_cannot_be_framed(page: Page, lecture: Path, server_url: str) -> None:
    refused: list[str] = []
    page.on("console", lambda message: refused.append(message.text))
    frame = embedded(page, lecture, f"{server_url}/?view=explore")
    page.wait_for_load_state("networkidle")
    assert any("frame-ancestors" in text for text in refused)
    expect(frame.locator(".top")).to_have_count(0)
