"""What is for a lesson: the ray as a file and a slide, light from below, worksheets and answers."""

import re
import struct
from pathlib import Path
from urllib.parse import parse_qs, urlsplit
from xml.etree import ElementTree as ET

import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.compare_page import AXE
from tests.browser.explore_page import READY_MS, box, number, opened

SVG = "{http://www.w3.org/2000/svg}"
BREWSTER = "?n_t=1.5&theta_i_deg=56.309932474020215"


def saved(page: Page, name: str) -> bytes:
    with page.expect_download(timeout=READY_MS) as waiting:
        page.get_by_role("button", name=name, exact=True).click()
    return Path(waiting.value.path()).read_bytes()


def pixels(png: bytes) -> tuple[int, int]:
    """Width and height, as a PNG says them."""
    assert png.startswith(b"\x89PNG")
    width, height = struct.unpack(">II", png[16:24])
    return width, height


def test_the_ray_is_saved_alone_and_beside_its_curve(quiet_page: Page) -> None:
    page = opened(quiet_page, BREWSTER)
    alone = ET.fromstring(saved(page, "Save the ray as SVG"))  # noqa: S314 - a file of our own
    words = "".join(alone.itertext())
    assert "Brewster" in words
    assert "56.31°" in words
    painted = [node.get("fill", "") + node.get("stroke", "") for node in alone.iter()]
    # Programs other than browsers read these colors, and nothing is left to this page's style sheets.
    assert not [paint for paint in painted if re.search(r"var\(|oklab|color-mix|color\(", paint)]
    assert not [node for node in alone.iter() if node.get("class") or node.get("style")]
    width, height = pixels(saved(page, "Save the ray as PNG"))
    assert (width, height) == (2 * int(alone.get("width", "")), 2 * int(alone.get("height", "")))
    page.get_by_label("with its curve").check()
    assert pixels(saved(page, "Save the ray as PNG"))[0] > 1.5 * width
    beside = ET.fromstring(saved(page, "Save the ray as SVG"))  # noqa: S314
    assert "Brewster" in "".join(beside.itertext())
    assert "Reflectance against" in "".join(beside.itertext())
    page.get_by_role("button", name="For print… (ray)").click()
    caption = page.locator("dialog textarea").first
    expect(caption).to_have_value(re.compile("^Ray at the surface; reflectance against"))
    file = ET.fromstring(saved(page, "Save as SVG"))  # noqa: S314
    assert file.get("width") == "170mm"
    assert len(list(file.iter(f"{SVG}svg"))) > 2  # both, in one
    assert "Fresnel Explorer" in "".join(file.itertext())


def test_the_right_angle_is_marked_at_brewsters_angle_alone(quiet_page: Page) -> None:
    page = opened(quiet_page, BREWSTER)
    mark = page.locator(".ray-right")
    expect(mark).to_be_visible()
    expect(page.locator(".diagram-said")).to_contain_text("right angles")
    page.locator(".diagram-handle").press("ArrowRight")
    expect(mark).to_be_hidden()


def test_the_name_of_an_angle_leads_to_it(quiet_page: Page) -> None:
    page = opened(quiet_page)
    name = page.locator(".diagram").get_by_text("Brewster", exact=True)
    place = name.bounding_box()
    assert place
    page.mouse.click(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
    expect(page.locator(".ray-right")).to_be_visible()
    expect(page).to_have_url(re.compile(r"theta_i_deg=56\.3099324740202"))


def test_light_from_the_denser_side_comes_from_below(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_i=1.333&n_t=1&theta_i_deg=60")
    frame = page.locator(".diagram").bounding_box()
    assert frame
    middle = frame["y"] + frame["height"] / 2
    handle = page.locator(".diagram-handle")

    def place() -> tuple[float, float]:
        bounds = handle.bounding_box()
        assert bounds
        return bounds["x"] + bounds["width"] / 2, bounds["y"] + bounds["height"] / 2

    x, y = place()
    assert y > middle + 20
    glow = page.locator(".ray-glow").bounding_box()
    assert glow
    assert glow["y"] + glow["height"] <= middle + 1
    said = page.locator(".ray-total").first.bounding_box()
    assert said
    assert said["y"] < middle
    # The handle follows the pointer there, too.
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y + 30, steps=4)
    page.mouse.up()
    angle = parse_qs(urlsplit(page.url).query)["theta_i_deg"][0]
    assert 20 < float(angle) < 55
    assert place()[1] > y
    # A slider turns nothing over before it is let go.
    slider = page.locator("#n_t-slider")
    slider.focus()
    for value in ("1.1", "1.2", "1.3", "1.333"):
        page.keyboard.down("PageUp")
        expect(box(page, "n_t")).to_have_value(value)  # a step counts from what is shown
    assert place()[1] > middle
    page.keyboard.up("PageUp")
    page.wait_for_function(
        "(middle) => document.querySelector('.diagram-handle').getBoundingClientRect().y < middle",
        arg=middle,
    )


def test_a_view_is_presented_by_a_link_and_left_by_a_key(quiet_page: Page) -> None:
    quiet_page.set_viewport_size({"width": 1280, "height": 720})
    page = quiet_page
    page.goto(f"/{BREWSTER}&present=1")
    page.locator(".plot-host path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    leave = page.get_by_role("button", name="Leave")
    expect(leave).to_be_visible()
    for gone in (".top", ".bottom", ".panel", ".numbers"):
        expect(page.locator(gone).first).to_be_hidden()
    ray, curves = (page.locator(one).bounding_box() for one in (".diagram", ".plot-host"))
    assert ray
    assert curves
    assert curves["x"] >= ray["x"] + ray["width"]  # two columns
    assert max(ray["y"] + ray["height"], curves["y"] + curves["height"]) <= 720
    letters = float(page.evaluate("() => parseFloat(getComputedStyle(document.body).fontSize)"))
    assert letters >= 18
    page.evaluate(AXE.read_text("utf-8"))
    assert page.evaluate("async () => (await axe.run()).violations.map((v) => v.id)") == []
    page.keyboard.press("Escape")
    expect(page.locator(".top")).to_be_visible()
    assert "present" not in page.url
    page.get_by_role("button", name="Present").click()
    expect(page.locator(".top")).to_be_hidden()
    expect(page).to_have_url(re.compile("present=1"))


def test_plots_drawn_before_the_large_type_came_grow_with_it(page: Page) -> None:
    held: list[Route] = []
    page.route("**/css/present.css", lambda route: held.append(route))
    page.goto("/?view=compare&present=1")
    ticks = page.locator(".view-compare .xtick text")
    ticks.first.wait_for(state="attached", timeout=READY_MS)
    held[0].continue_()
    page.wait_for_function(
        """() => [...document.querySelectorAll(".view-compare .xtick text")]
          .every((text) => parseFloat(getComputedStyle(text).fontSize) > 14)"""
    )


def test_a_material_is_presented_without_the_catalog(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=materials&present=1&preset=Cu")
    expect(page.get_by_role("heading", name="Copper")).to_be_visible(timeout=READY_MS)
    for gone in (".browser", ".example-row", ".uses"):
        expect(page.locator(f".view-materials {gone}").first).to_be_hidden()


@pytest.mark.parametrize("width", [390, 1440])
def test_what_is_wrong_with_a_presented_link_can_be_closed(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    page.goto("/?n_t=abc&present=1")
    close = page.get_by_role("button", name="Dismiss")
    leave = page.get_by_role("button", name="Leave")
    expect(leave).to_be_visible(timeout=READY_MS)
    here, there = close.bounding_box(), leave.bounding_box()
    assert here
    assert there
    assert here["x"] + here["width"] <= there["x"]
    close.click()
    expect(page.locator(".notice")).to_have_count(0)
    expect(leave).to_be_visible()


def test_at_brewsters_angle_nothing_is_written_of_p(quiet_page: Page) -> None:
    page = quiet_page
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    opened(page, BREWSTER)
    for name, text in (("Rp", "0"), ("r_p.re", "0"), ("r_p.abs", "0"), ("r_p.phase", "none")):
        expect(number(page, name)).to_have_text(text)
    number(page, "Rp").click()  # what is copied is the double
    assert 0 < float(page.evaluate("() => navigator.clipboard.readText()")) < 1e-30
    # A millionth of a degree beside it there is something: r_p grows by (n⁴ − 1) / 2n³ per radian.
    opened(page, "?n_t=1.5&theta_i_deg=56.309933474020215")
    expect(number(page, "Rp")).to_have_text(re.compile(r"× 10⁻¹⁶$"))
    expect(number(page, "r_p.phase")).to_have_text(re.compile("°$"))


def test_a_worksheet_has_its_link_its_answers_and_addresses_on_paper(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=theory&section=worksheets")
    page.get_by_role("link", name="Caught light").click(timeout=READY_MS)
    expect(page).to_have_url(re.compile("sheet=caught"), timeout=READY_MS)
    expect(page.locator(".worksheet")).to_have_count(1)
    expect(page.get_by_role("link", name="All worksheets")).to_be_visible()
    expect(page.locator(".answer-key")).to_have_count(0)
    page.get_by_role("link", name="With the answer key").click()
    answers = page.locator(".answer-key li")
    expect(answers).to_have_count(4, timeout=READY_MS)
    # D. Halliday and Fresnel's own: 45.94 degrees at most for n = 1.51, 45 at 48.6 and at 54.6.
    expect(answers.nth(2)).to_contain_text("45.94°")
    expect(answers.nth(2)).to_contain_text("48.6°")
    expect(answers.nth(2)).to_contain_text("54.6°")
    page.emulate_media(media="print")
    after = """(link) => getComputedStyle(link, "::after").content"""
    printed = page.locator(".worksheet a").first.evaluate(after)
    assert "theta_i_deg=41.81" in printed
    assert printed.strip('" ').startswith("http")


@pytest.mark.parametrize(
    "sheet", ["pond", "brewster", "caught", "renderer", "metals", "paint", "guess"]
)
def test_every_key_is_complete(quiet_page: Page, sheet: str) -> None:
    page = quiet_page
    page.goto(f"/?view=theory&section=worksheets&sheet={sheet}&answers=open")
    answers = page.locator(".answer-key li")
    expect(answers.first).to_be_visible(timeout=2 * READY_MS)
    expect(answers).to_have_count(page.locator(".worksheet li").count())
    for text in answers.all_inner_texts():
        assert text.strip().endswith(".")
        assert not re.search(r"NaN|undefined|\bnull\b", text)


def test_the_lesson_on_metals_starts_from_a_metal_of_the_catalog(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=theory&step=metals")
    iron = page.get_by_role("button", name="Iron")
    expect(iron).to_have_attribute("aria-pressed", "true", timeout=READY_MS)
    page.get_by_role("button", name="Silver").click()
    expect(page.locator(".lesson-live")).to_contain_text("F0 is 98.7 %")
