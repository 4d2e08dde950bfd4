"""What reaches a new visitor before anything is touched."""

from collections.abc import Mapping
from typing import Any
from urllib.parse import urlsplit

from playwright.sync_api import Page

from tests.browser.explore_page import opened

MOST_BYTES = 124_000  # with their headers, besides Plotly and KaTeX
MOST_LATER = 10_000  # what a gesture is drawn from, fetched a second after the first picture
LATER = ("/kernels.js", "/js/kernels/")


def test_it_is_small(page: Page) -> None:
    paths: dict[str, str] = {}
    sizes: dict[str, int] = {}

    def note_path(event: Mapping[str, Any]) -> None:
        paths[event["requestId"]] = urlsplit(event["response"]["url"]).path

    def note_size(event: Mapping[str, Any]) -> None:
        sizes[event["requestId"]] = int(event["encodedDataLength"])

    devtools = page.context.new_cdp_session(page)
    devtools.send("Network.enable")
    devtools.on("Network.responseReceived", note_path)
    devtools.on("Network.loadingFinished", note_size)
    opened(page)
    page.wait_for_load_state("networkidle")

    sent = {paths[request]: size for request, size in sizes.items()}
    assert {"/", "/js/main.js", "/css/base.css", "/api/v1/curves"} <= sent.keys()
    later = {path: size for path, size in sent.items() if path.startswith(LATER)}
    assert sum(later.values()) < MOST_LATER, later
    own = {
        path: size
        for path, size in sent.items()
        if not path.startswith(("/vendor/plotly", "/vendor/katex", *LATER))
    }
    total = sum(own.values())
    assert total < MOST_BYTES, sorted(own.items(), key=lambda item: -item[1])[:20]


def test_no_other_view_nor_katex_comes_before_the_first_curve(page: Page) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(urlsplit(request.url).path))
    opened(page)
    before = list(asked)
    views = [path for path in before if path.startswith("/js/views/")]
    assert views == ["/js/views/explore.js"]
    assert not [path for path in before if "katex" in path]
    other_styles = {f"/css/{view}.css" for view in ("compare", "albedo", "materials")}
    assert other_styles.isdisjoint(before)
