"""Every view on paper: light, nothing to press, figures that fit the sheet, and its address."""

import pytest
from playwright.sync_api import Page, expect

from tests.browser.test_accessible import PLACES, opened

SHEET_PX = 703  # of A4 between margins of 12 mm, at 96 px to the inch
CONTROLS = ".top, .exports, .track, .play, .strip, .hint, .tries, [role=slider], input[type=range]"


@pytest.fixture
def dark_page(page: Page) -> Page:
    page.emulate_media(color_scheme="dark")
    return page


def on_paper(page: Page, place: str) -> Page:
    """Open a place and see it as it is printed."""
    opened(page, place)
    page.wait_for_function("() => document.adoptedStyleSheets.length > 0")
    page.evaluate("() => window.dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print", color_scheme="dark")
    page.set_viewport_size({"width": SHEET_PX, "height": 1000})
    return page


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_a_view_is_figures_tables_and_its_address(dark_page: Page, place: str) -> None:
    page = on_paper(dark_page, place)
    shown = page.locator(CONTROLS).filter(visible=True)
    assert shown.count() == 0, shown.first.evaluate("(element) => element.outerHTML")
    assert page.locator(".view:not([hidden])").inner_text().strip()
    assert page.url in page.locator(".printed").inner_text()
    assert page.evaluate("() => getComputedStyle(document.body).color") == "rgb(20, 24, 31)"
    paper = page.evaluate("() => getComputedStyle(document.documentElement).backgroundColor")
    assert paper == "rgb(255, 255, 255)"
    assert page.evaluate("() => document.documentElement.scrollWidth") <= SHEET_PX
    figures = page.locator("[data-printed]").filter(visible=True)
    for figure in figures.all():
        box = figure.bounding_box()
        assert box
        assert box["x"] + box["width"] <= SHEET_PX


def test_figures_are_drawn_in_light_colors_and_as_before_afterwards(dark_page: Page) -> None:
    curve = dark_page.locator(".plot-host path.js-line").first
    stroke = "(path) => getComputedStyle(path).stroke"
    opened(dark_page, "?view=explore")
    before = curve.evaluate(stroke)
    width = dark_page.locator(".curves .plot-area").evaluate("(area) => area.clientWidth")
    page = on_paper(dark_page, "?view=explore")
    assert before == "rgb(86, 180, 233)"
    expect(curve).to_have_css("stroke", "rgb(0, 114, 178)")
    page.set_viewport_size({"width": 1280, "height": 720})
    page.emulate_media(media="screen", color_scheme="dark")
    page.evaluate("() => window.dispatchEvent(new Event('afterprint'))")
    expect(curve).to_have_css("stroke", before)
    expect(page.locator(".printed")).to_have_count(0)
    expect(page.locator(".curves .plot-area")).to_have_js_property("clientWidth", width)


def test_films_are_on_the_paper_with_what_they_were_worked_out_for(dark_page: Page) -> None:
    page = on_paper(dark_page, "?view=films&layers=1.38:100,2.3:50")
    drawing = page.locator(".film-drawing")
    fills = (
        "(frame) => frame.querySelector('svg').getBoundingClientRect().width / frame.clientWidth"
    )
    expect(drawing).to_have_attribute("data-printed", "")
    assert drawing.evaluate(fills) == pytest.approx(1.0, abs=0.01)
    expect(page.locator(".film-list")).to_contain_text("2.3 50 nm")
    expect(page.get_by_text("At 587.6 nm and 64.00°")).to_be_visible()
    expect(page.get_by_text("from the whole spectrum")).to_be_visible()
    expect(page.get_by_text("thick: no interference")).to_be_hidden()


def test_numbers_have_their_names_and_are_whole(dark_page: Page) -> None:
    page = on_paper(dark_page, "?view=explore&material=Au")
    for name in page.locator(".numbers dt").all():
        expect(name).not_to_have_text("")
        expect(name.locator("*").first).to_be_visible()
    boxes = page.locator(".row .box").filter(visible=True)
    assert boxes.count() >= 4
    cut = "(box) => box.scrollWidth > box.clientWidth"
    assert not [box.input_value() for box in boxes.all() if box.evaluate(cut)]


def test_curves_that_were_not_seen_yet_are_printed_with_their_names(dark_page: Page) -> None:
    dark_page.set_viewport_size({"width": 390, "height": 780})
    page = on_paper(dark_page, "?view=explore&models=schlick")
    expect(page.locator(".first-curves path")).to_have_count(4)
    expect(page.locator(".first-key")).to_be_visible()
    expect(page.locator(".first-key")).to_have_text("R Rs Rp schlick", use_inner_text=True)


def test_the_scene_of_the_preview_is_on_the_paper(dark_page: Page) -> None:
    page = on_paper(dark_page, "?view=preview")
    colors = page.evaluate(
        """async () => {
          const scene = document.querySelector("canvas.scene");
          const copy = new OffscreenCanvas(64, 36);
          const context = copy.getContext("2d");
          context.drawImage(scene, 0, 0, 64, 36);
          const { data } = context.getImageData(0, 0, 64, 36);
          return new Set(new Uint32Array(data.buffer)).size;
        }"""
    )
    assert colors > 100


def test_a_sheet_comes_out(dark_page: Page) -> None:
    opened(dark_page, "?view=explore")
    dark_page.wait_for_function("() => document.adoptedStyleSheets.length > 0")
    assert dark_page.pdf(format="A4").startswith(b"%PDF")
    expect(dark_page.locator(".printed")).to_have_count(0)
    expect(dark_page.locator("html")).to_have_attribute("data-theme", "dark")
    curve = dark_page.locator(".plot-host path.js-line").first
    expect(curve).to_have_css("stroke", "rgb(86, 180, 233)")


def test_a_page_that_cannot_fetch_it_says_nothing(page: Page) -> None:
    """As when it is left, or its server is gone, in the moment after it has rested."""
    uncaught: list[str] = []
    page.on("pageerror", lambda error: uncaught.append(str(error)))
    page.route("**/js/page/print.js", lambda route: route.abort())
    page.route("**/api/v1/health", lambda route: route.abort())
    with page.expect_event("requestfailed", lambda request: "print.js" in request.url):
        page.goto("/")
    page.evaluate("() => new Promise((done) => setTimeout(done, 500))")
    assert uncaught == []
