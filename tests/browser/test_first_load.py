"""What reaches a new visitor before anything is touched, and in which order it is seen."""

from collections.abc import Mapping
from typing import Any
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.conftest import in_both_forms
from tests.browser.explore_page import opened

browser_context_args = in_both_forms

MOST_BYTES = {"sources": 136_000, "packed": 100_000}  # besides Plotly and KaTeX
MOST_REQUESTS = 12
MOST_LATER = 10_000  # what a gesture is drawn from, fetched a second after the first picture
LATER = ("/kernels.js", "/js/kernels/", "/js/server/fetcher.js", "/packed/answers-")
PRINT = ("/packed/print-", "/css/print.css")  # at once, but no picture waits for it
JUMP = 0.02  # of layout shift, where 0.1 counts as good
NEAR = 1.0  # px

SHIFTS = """() => {
  window.layoutShifts = [];
  new PerformanceObserver((list) => {
    for (const one of list.getEntries())
      if (!one.hadRecentInput)
        window.layoutShifts.push([one.value, ...one.sources.map((s) => s.node?.className ?? "")]);
  }).observe({type: "layout-shift", buffered: true});
}"""
BOXES = """() => Object.fromEntries(
  [".diagram-host", ".split", ".plot-host", ".numbers", ".amplitudes", ".bottom"].map((name) => {
    const {x, y, width, height} = document.querySelector(name).getBoundingClientRect();
    return [name, [x, y + scrollY, width, height]];
  }))"""


def form_of(page: Page, packed_url: str) -> str:
    return "packed" if page.url.startswith(packed_url) else "sources"


def test_it_is_small(page: Page, packed_url: str) -> None:
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
    form = form_of(page, packed_url)
    assert {"/", "/api/v1/curves"} <= sent.keys()
    assert ("/js/main.js" in sent) == (form == "sources")
    later = {path: size for path, size in sent.items() if path.startswith(LATER)}
    assert sum(later.values()) < MOST_LATER, later
    own = {
        path: size
        for path, size in sent.items()
        if not path.startswith(("/vendor/plotly", "/vendor/katex", *LATER))
    }
    total = sum(own.values())
    assert total < MOST_BYTES[form], sorted(own.items(), key=lambda item: -item[1])[:20]


def test_no_other_view_nor_katex_comes_before_the_first_curve(page: Page, packed_url: str) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(urlsplit(request.url).path))
    opened(page)
    before = list(asked)
    views = [path for path in before if path.startswith("/js/views/")]
    if form_of(page, packed_url) == "packed":
        assert views == []
        # Where a machine is slow, what is fetched a second later may come before the numbers.
        needed = [p for p in before if not p.startswith(("/vendor/plotly", *PRINT, *LATER))]
        assert len(needed) <= MOST_REQUESTS, needed
        scripts = [path for path in before if path.startswith("/packed/") and path.endswith(".js")]
        assert len([p for p in scripts if not p.startswith((*PRINT, *LATER))]) == 2, scripts
    else:
        assert views == ["/js/views/explore.js"]
    assert not [path for path in before if "katex" in path]
    other_styles = {f"/css/{view}.css" for view in ("compare", "albedo", "materials")}
    assert other_styles.isdisjoint(before)


def test_nothing_is_asked_twice(page: Page) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    opened(page, "?n_t=1.7&theta_i_deg=30")
    page.wait_for_load_state("networkidle")
    answers = [url for url in asked if "/api/" in url and "/health" not in url]
    assert len(answers) == len(set(answers)), sorted(answers)
    assert len([url for url in answers if "/curves" in url or "/snell" in url]) == 2


@pytest.mark.parametrize("width", [390, 1024, 1440])
@pytest.mark.parametrize("query", ["", "?material=Au&theta_i_deg=40", "?n_i=1.5&n_t=1"])
def test_the_first_picture_stands_where_the_page_draws_it_anew(
    page: Page, width: int, query: str
) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    page.route("**/*main*.js", lambda route: route.abort())
    page.goto(f"/{query}")
    expect(page.locator(".first-curves")).to_be_visible()
    page.evaluate("() => document.fonts.ready.then(() => true)")
    first = page.evaluate(BOXES)
    frame = page.locator(".first-curves").bounding_box()
    assert frame
    split = page.locator(".split-text").inner_text()

    page.unroute("**/*main*.js")
    page.add_init_script(f"({SHIFTS})()")
    opened(page, query)
    expect(page.locator(".first-curves, .first-ray")).to_have_count(0)
    page.wait_for_load_state("networkidle")
    live = page.evaluate(BOXES)
    for name, box in first.items():
        if name == ".bottom":
            continue
        assert box == pytest.approx(live[name], abs=NEAR), name
    plot = page.locator(".plot-canvas .bglayer, .plot-canvas .gridlayer").first.bounding_box()
    assert plot
    assert [frame["x"], frame["x"] + frame["width"]] == pytest.approx(
        [plot["x"], plot["x"] + plot["width"]], abs=3
    )
    assert page.locator(".split-text").inner_text() == split
    shifts = page.evaluate("() => window.layoutShifts")
    assert sum(value for value, *_ in shifts) < JUMP, shifts


def test_on_a_phone_plotly_waits_until_its_plot_is_seen(page: Page) -> None:
    page.set_viewport_size({"width": 390, "height": 780})
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto("/?n_t=1.7")
    expect(page.locator('.number[aria-label^="R:"]')).to_be_visible()
    page.wait_for_load_state("networkidle")
    expect(page.locator(".first-curves path")).to_have_count(3)
    assert not [url for url in asked if url.endswith("plotly-cartesian.min.js")]
    page.get_by_role("slider", name="angle of incidence").first.press("ArrowRight")
    page.wait_for_timeout(500)
    page.locator(".plot-host").scroll_into_view_if_needed()
    expect(page.locator(".plot-canvas path.js-line")).to_have_count(3)
    expect(page.locator(".first-curves")).to_have_count(0)


def on_a_phone(page: Page) -> Page:
    """Open the page where its plot is below what is seen."""
    page.set_viewport_size({"width": 390, "height": 780})
    page.goto("/?n_t=1.7")
    expect(page.locator('.number[aria-label^="R:"]')).to_be_visible()
    return page


def test_a_picture_of_another_angle_has_no_marker(page: Page) -> None:
    on_a_phone(page)
    marker = page.locator(".first-marker, .first-point")
    expect(marker).to_have_count(4)
    page.get_by_role("slider", name="Incident ray").press("ArrowRight")
    expect(marker).to_have_count(0)
    expect(page.locator(".first-curves path")).to_have_count(3)


def test_a_sheet_that_is_closed_lets_the_plot_be_seen(page: Page) -> None:
    on_a_phone(page)
    page.get_by_role("button", name="all", exact=True).click()
    page.set_viewport_size({"width": 400, "height": 780})  # the plot looks anew where it is
    page.evaluate("() => scrollTo(0, 250)")
    page.wait_for_timeout(500)
    expect(page.locator(".first-curves")).to_have_count(1)
    page.get_by_role("button", name="close", exact=True).click()
    expect(page.locator(".plot-canvas path.js-line")).to_have_count(3)


def test_plots_that_could_not_be_had_are_told_of_and_asked_for_again(page: Page) -> None:
    uncaught: list[str] = []
    page.on("pageerror", lambda error: uncaught.append(str(error)))
    page.route("**/plotly-cartesian.min.js", lambda route: route.abort())
    on_a_phone(page)
    page.locator(".plot-host").scroll_into_view_if_needed()
    notice = page.locator(".notice", has_text="The plots could not be drawn")
    expect(notice).to_be_visible()
    expect(page.locator(".first-curves path")).to_have_count(3)
    page.unroute("**/plotly-cartesian.min.js")
    notice.get_by_role("button", name="Try again").click()
    expect(page.locator(".plot-canvas path.js-line")).to_have_count(3)
    expect(notice).to_have_count(0)
    assert uncaught == []


def test_what_is_changed_asks_for_missing_plots_again(page: Page) -> None:
    page.route("**/plotly-cartesian.min.js", lambda route: route.abort())
    page.set_viewport_size({"width": 1280, "height": 800})
    page.goto("/")
    expect(page.locator(".notice", has_text="The plots could not be drawn")).to_be_visible()
    page.unroute("**/plotly-cartesian.min.js")
    page.locator("#n_t-box").fill("1.9")
    page.locator("#n_t-box").press("Enter")
    expect(page.locator(".plot-canvas path.js-line")).to_have_count(3)
    expect(page.locator(".notice")).to_have_count(0)


def test_where_scripts_are_forbidden_the_picture_stands_alone(
    browser: Browser, browser_context_args: dict[str, Any]
) -> None:
    context = browser.new_context(**browser_context_args, java_script_enabled=False)
    page = context.new_page()
    page.goto("/?n_t=1.333")
    expect(page.locator(".first-curves path")).to_have_count(3)
    expect(page.get_by_role("img", name="Ray at 64.00°")).to_be_visible()
    context.close()


def test_every_view_opens_in_this_form(quiet_page: Page) -> None:
    page = opened(quiet_page)
    for view in (
        "compare",
        "albedo",
        "materials",
        "films",
        "engines",
        "preview",
        "theory",
        "atlas",
    ):
        page.locator(f'.views [data-view="{view}"]').click()
        expect(page.locator(f".view-{view}")).to_be_visible()
        page.wait_for_load_state("networkidle")
        expect(page.locator("#intro")).to_be_hidden()
    page.locator('.views [data-view="explore"]').click()
    expect(page.locator("#intro")).to_be_visible()
