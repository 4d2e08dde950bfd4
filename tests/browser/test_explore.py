"""The Explore view, used as people use it: pointer, keys, links, and a server that fails."""

import json
import math
import re
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.conftest import in_both_forms
from tests.browser.explore_page import (
    READY_MS,
    at_rest,
    box,
    link,
    number,
    opened,
    settled_link,
    type_into,
)

browser_context_args = in_both_forms


def test_starts_with_the_exact_numbers_of_glass(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(number(page, "R")).to_have_text("0.113001")
    expect(number(page, "F0")).to_have_text("0.0400000")
    expect(number(page, "brewster")).to_have_text("56.31°")
    expect(number(page, "critical")).to_have_text("none")
    expect(number(page, "r_s.re")).to_have_text("−0.465164")
    expect(page.locator(".split-text")).to_contain_text("11.3")
    assert link(page) == {}


def test_first_curve_comes_before_katex(page: Page) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    opened(page)
    assert not [url for url in asked if "katex" in url]
    page.locator("summary", has_text="Formulas").click()
    page.locator(".definitions .katex").first.wait_for(timeout=READY_MS)
    assert any("katex.min.js" in url for url in asked)


def test_dragging_the_ray_moves_everything_and_makes_one_entry(quiet_page: Page) -> None:
    page = opened(quiet_page)
    entries = page.evaluate("() => history.length")
    grip = page.locator(".diagram-host [role=slider]")
    start = grip.bounding_box()
    assert start is not None
    x, y = start["x"] + start["width"] / 2, start["y"] + start["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for step in range(1, 9):
        page.mouse.move(x + 12 * step, y - 5 * step)
    page.mouse.up()
    angle = float(at_rest(page)["theta_i_deg"])
    assert 5 < angle < 55
    expect(box(page, "theta_i_deg")).to_have_value(f"{angle:.6g}°")
    expect(page.locator(".plot-handle")).to_have_text(f"{angle:.2f}°")
    assert page.evaluate("() => history.length") == entries + 1


def test_dragging_the_ray_snaps_to_brewster_and_alt_frees_it(quiet_page: Page) -> None:
    page = opened(quiet_page, "?theta_i_deg=57.5")
    grip = page.locator(".diagram-host [role=slider]")
    for held in (None, "Alt"):
        start = grip.bounding_box()
        assert start is not None
        x, y = start["x"] + start["width"] / 2, start["y"] + start["height"] / 2
        if held:
            page.keyboard.down(held)
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + 2, y - 2)
        page.mouse.move(x + 3, y - 3)
        page.mouse.up()
        if held:
            page.keyboard.up(held)
            assert float(at_rest(page)["theta_i_deg"]) != pytest.approx(56.309932474020215)
        else:
            settled_link(page, "theta_i_deg", r"56\.3099\d+")
            expect(number(page, "Rp")).to_have_text(re.compile(r"^0$|10⁻³.$"))


def test_dragging_a_slider_follows_with_fresh_curves(quiet_page: Page) -> None:
    page = opened(quiet_page)
    before = page.locator(".plot-host path.js-line").first.get_attribute("d")
    slider = page.locator("#n_t-slider")
    area = slider.bounding_box()
    assert area is not None
    y = area["y"] + area["height"] / 2
    page.mouse.move(area["x"] + area["width"] * 0.27, y)
    page.mouse.down()
    for step in range(12):
        page.mouse.move(area["x"] + area["width"] * (0.27 + 0.04 * step), y)
    page.mouse.up()
    n_t = at_rest(page)["n_t"]
    assert 2 < float(n_t) < 3
    expect(page.locator(".amplitudes")).not_to_have_attribute("data-stale", "")
    f0 = ((float(n_t) - 1) / (float(n_t) + 1)) ** 2
    expect(number(page, "F0")).to_have_text(f"{f0:.6f}")
    assert page.locator(".plot-host path.js-line").first.get_attribute("d") != before


def test_keys_step_and_stop_at_landmarks(quiet_page: Page) -> None:
    page = opened(quiet_page, "?theta_i_deg=56")
    slider = page.locator("#theta_i_deg-slider")
    slider.focus()
    slider.press("ArrowRight")
    settled_link(page, "theta_i_deg", r"56\.3099\d+")
    slider.press("ArrowRight")
    settled_link(page, "theta_i_deg", r"56\.5")
    slider.press("Shift+ArrowRight")
    settled_link(page, "theta_i_deg", r"56\.55")
    slider.press("PageUp")
    settled_link(page, "theta_i_deg", r"60")
    slider.press("End")
    settled_link(page, "theta_i_deg", r"90")
    expect(number(page, "R")).to_have_text("1")
    grip = page.locator(".diagram-host [role=slider]")
    grip.focus()
    grip.press("Home")
    settled_link(page, "theta_i_deg", r"0")
    grip.press("ArrowUp")
    settled_link(page, "theta_i_deg", r"0\.5")
    slider.dblclick()
    expect(box(page, "theta_i_deg")).to_have_value("64°")


@pytest.mark.parametrize(
    ("parameter", "text", "value"),
    [
        ("n_t", "1/1.5", 1 / 1.5),
        ("n_t", "sqrt(2)", 2**0.5),
        ("n_i", "2*1.33", 2.66),
        ("n_t", "42", 42.0),
        ("k_t", "3e-2", 0.03),
        ("theta_i_deg", "0.5 rad", 28.64788975654116),
    ],
)
def test_number_boxes_take_expressions(
    quiet_page: Page, parameter: str, text: str, value: float
) -> None:
    page = opened(quiet_page)
    type_into(page, parameter, text)
    page.wait_for_url(f"**{parameter}=*")
    assert float(link(page)[parameter]) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(
    ("parameter", "text"),
    [
        ("n_t", "glass"),
        ("n_t", "0"),
        ("n_t", "101"),
        ("n_t", "100.0001"),
        ("n_t", "1,5,2"),
        ("k_t", "-1"),
        ("n_i", "1/0"),
        ("n_i", ""),
        ("theta_i_deg", "91"),
        ("theta_i_deg", "<img src=x onerror=alert(1)>"),
    ],
)
def test_nonsense_in_a_number_box_is_explained_in_place(
    quiet_page: Page, parameter: str, text: str
) -> None:
    page = opened(quiet_page)
    type_into(page, parameter, text)
    message = page.locator(f"#{parameter}-error")
    expect(message).to_contain_text(parameter)
    expect(message).to_contain_text("k >= 0" if parameter == "k_t" else " to ")
    expect(box(page, parameter)).to_have_attribute("aria-invalid", "")
    expect(number(page, "R")).to_have_text("0.113001")
    assert link(page) == {}
    box(page, parameter).press("Escape")
    expect(message).to_have_text("")


def test_a_link_reproduces_the_view(quiet_page: Page) -> None:
    page = opened(quiet_page)
    type_into(page, "n_i", "1.5")
    type_into(page, "n_t", "1.1")
    type_into(page, "theta_i_deg", "50")
    page.get_by_role("radio", name="radians").check()
    page.get_by_role("checkbox", name="phases").check()
    page.locator("summary", has_text="Approximations").click()
    page.get_by_role("checkbox", name="Schlick", exact=True).check()
    page.get_by_role("radio", name="p", exact=True).check()
    expect(page.locator(".plot-legend")).to_contain_text("Schlick")
    expect(number(page, "theta_t")).to_have_text("none")
    expect(number(page, "critical")).to_have_text("0.8232 rad")
    shown = page.locator(".number").all_inner_texts()
    other = opened(page.context.new_page(), f"?{urlsplit(page.url).query}")
    expect(other.locator(".plot-legend")).to_contain_text("Schlick")
    expect(other.locator(".amplitudes")).not_to_have_attribute("data-stale", "")
    assert other.locator(".number").all_inner_texts() == shown
    assert link(other) == link(page)


def test_back_and_forward(quiet_page: Page) -> None:
    page = opened(quiet_page)
    type_into(page, "n_t", "2")
    page.wait_for_url("**n_t=2*")
    type_into(page, "theta_i_deg", "10")
    page.wait_for_url("**theta_i_deg=10*")
    page.go_back()
    expect(box(page, "theta_i_deg")).to_have_value("64°")
    expect(box(page, "n_t")).to_have_value("2")
    page.go_back()
    expect(box(page, "n_t")).to_have_value("1.5")
    expect(number(page, "R")).to_have_text("0.113001")
    page.go_forward()
    expect(box(page, "n_t")).to_have_value("2")


def test_what_a_link_may_not_say_is_reported(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_t=400&colour=red&models=schlick,nonsense&theta_i_deg=30")
    notice = page.locator(".notice")
    for words in ("n_t = 400", "0.001 to 100", "colour", "nonsense"):
        expect(notice).to_contain_text(words)
    expect(box(page, "theta_i_deg")).to_have_value("30°")
    notice.get_by_role("button", name="Dismiss").click()
    expect(notice).to_have_count(0)


def test_a_failing_server_is_told_and_made_up_for(page: Page) -> None:
    opened(page)
    body = {"title": "Internal Server Error", "status": 500, "detail": "It broke.", "errors": []}

    def fail(route: Route) -> None:
        route.fulfill(status=500, content_type="application/problem+json", body=json.dumps(body))

    page.route("**/api/v1/curves*", fail)
    page.route("**/api/v1/snell*", fail)
    picture = page.locator(".plot-host path.js-line").first.get_attribute("d")
    type_into(page, "n_t", "2")
    notice = page.locator(".notice")
    expect(notice).to_contain_text("Internal Server Error")
    expect(notice).to_contain_text("worked out here")
    expect(number(page, "F0")).to_have_text("0.111111")
    assert page.locator(".plot-host path.js-line").first.get_attribute("d") != picture
    page.unroute_all()
    notice.get_by_role("button", name="Try again").click()
    expect(notice).to_have_count(0)
    expect(number(page, "F0")).to_have_text("0.111111")


def test_a_server_that_is_gone_at_the_start_is_told(page: Page) -> None:
    page.route("**/api/v1/parameters", lambda route: route.abort())
    page.goto("/")
    expect(page.locator("main")).to_contain_text("does not answer")
    expect(page.get_by_role("navigation", name="Views")).to_be_visible()
    again = page.get_by_role("button", name="Try again")
    again.click()
    expect(again).to_be_visible()  # it failed again
    page.unroute_all()
    again.click()
    expect(number(page, "F0")).to_have_text("0.0400000", timeout=READY_MS)
    expect(page.locator(".failure, .starting")).to_have_count(0)


def test_a_notice_goes_with_the_view_it_is_about(page: Page) -> None:
    opened(page)
    page.route("**/api/v1/snell*", lambda route: route.fulfill(status=500, body="{}"))
    type_into(page, "n_t", "2")
    expect(page.locator(".notice")).to_contain_text("500")
    page.get_by_role("link", name="Compare").click()
    expect(page.locator("#compare-n_t-box")).to_have_value("2", timeout=READY_MS)
    expect(page.locator(".notice")).to_have_count(0)


def test_a_box_forgets_the_nonsense_that_was_in_it(quiet_page: Page) -> None:
    page = opened(quiet_page)
    type_into(page, "n_t", "abc")
    expect(page.locator("#n_t-error")).to_contain_text("abc")
    type_into(page, "n_t", "2^-1")
    expect(page.locator("#n_t-error")).to_be_empty()
    expect(box(page, "n_t")).to_have_value("0.5")
    settled_link(page, "n_t", r"0\.5")


def test_radians_end_at_a_right_angle(quiet_page: Page) -> None:
    page = opened(quiet_page, "?angle=rad")
    type_into(page, "theta_i_deg", "2")
    expect(page.locator("#theta_i_deg-error")).not_to_be_empty()
    assert "theta_i_deg" not in link(page)
    type_into(page, "theta_i_deg", "1.5708")
    expect(page.locator("#theta_i_deg-error")).to_be_empty()
    settled_link(page, "theta_i_deg", "90")


def test_dozens_of_curves_leave_the_picture_its_height(quiet_page: Page) -> None:
    page = quiet_page
    models = page.request.get("/api/v1/models?fields=id").json()["models"]
    ids = ",".join(model["id"] for model in models if model["id"] != "exact")
    opened(page, f"?models={ids}")
    legend = page.locator(".plot-legend")
    expect(legend.locator("li")).to_have_count(len(models) + 2)
    expect(legend).to_have_attribute("tabindex", "0")
    area = page.locator(".curves .plot-area").bounding_box()
    below = legend.bounding_box()
    assert area is not None
    assert below is not None
    assert area["height"] > 250
    assert below["height"] < 100
    assert below["y"] >= area["y"] + area["height"]


def test_what_a_link_may_not_say_is_reported_shortly(quiet_page: Page) -> None:
    page = opened(quiet_page, f"?models=schlik,{'x' * 500}&material=glod&a=1&b=2&c=3&d=4")
    notice = page.locator(".notice")
    expect(notice).to_contain_text("the nearest are schlick")
    expect(notice).to_contain_text("and 2 more")
    shown = notice.bounding_box()
    assert shown is not None
    assert shown["height"] < 180


def test_the_critical_angle_is_reached_exactly_and_drawn(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_i=1.5&n_t=1&theta_i_deg=41.5")
    page.locator("#theta_i_deg-slider").focus()
    page.keyboard.press("ArrowRight")
    expect(number(page, "theta_t")).to_have_text("90.00°")
    expect(page.locator(".diagram-host")).to_contain_text("90.00°")
    expected = math.degrees(math.asin(1.0 / 1.5))
    assert float(at_rest(page)["theta_i_deg"]) == pytest.approx(expected, abs=1e-12)
    page.keyboard.press("ArrowRight")
    expect(page.locator(".diagram-host")).to_contain_text("total internal reflection")


def test_total_internal_reflection_needs_no_swap(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_i=1.5&n_t=1&theta_i_deg=60")
    expect(number(page, "R")).to_have_text("1")
    expect(number(page, "theta_t")).to_have_text("none")
    expect(number(page, "critical")).to_have_text("41.81°")
    expect(page.locator(".diagram-host")).to_contain_text("total internal reflection")


def test_presets_and_swap(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_label("Second medium").fill("diamond")
    page.get_by_label("Second medium").press("Enter")
    settled_link(page, "material", "diamond-shirley")
    expect(box(page, "n_t")).to_have_value("2.42")
    page.get_by_role("button", name="Swap the media").click()
    expect(box(page, "n_i")).to_have_value("2.42")
    assert link(page) == {"incident": "diamond-shirley", "n_t": "1"}
    type_into(page, "n_i", "2.4")
    settled_link(page, "n_i", "2.4")
    assert link(page) == {"n_i": "2.4", "n_t": "1"}
    type_into(page, "k_t", "1")
    swap = page.get_by_role("button", name="Swap the media")
    expect(swap).to_have_attribute("aria-disabled", "true")
    swap.click(force=True)
    expect(page.locator("#swap-reason")).to_contain_text("n_i is real")
    expect(box(page, "n_i")).to_have_value("2.4")


@pytest.mark.parametrize("kind", ["PNG", "SVG", "CSV"])
def test_exports(quiet_page: Page, kind: str) -> None:
    page = opened(quiet_page)
    with page.expect_download(timeout=READY_MS) as waiting:
        page.get_by_role("button", name=f"Save the plot as {kind}").click()
    content = waiting.value.path().read_bytes()
    assert waiting.value.suggested_filename == f"fresnel-curves.{kind.lower()}"
    start = {"PNG": b"\x89PNG", "SVG": b"<svg", "CSV": b"theta_i_deg,"}[kind]
    assert content.lstrip().startswith(start)
    if kind == "CSV":
        rows = content.decode().strip().splitlines()
        assert len(rows) == 183  # heading, 181 samples, Brewster's angle
        assert len(rows[-1].split(",")) == len(rows[0].split(",")) == 4


def test_numbers_are_copied_in_full(quiet_page: Page) -> None:
    page = quiet_page
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    opened(page)
    expect(page.locator(".amplitudes")).not_to_have_attribute("data-stale", "")
    expect(page.locator("#said")).to_contain_text("At 64")  # which would speak over what is copied
    number(page, "R").click()
    copied = page.evaluate("() => navigator.clipboard.readText()")
    assert re.fullmatch(r"0\.11300\d{10,}", copied)
    page.get_by_role("button", name="copy all").click()
    expect(page.locator("#said")).to_contain_text("numbers copied")
    table = page.evaluate("() => navigator.clipboard.readText()")
    rows = dict(line.split("\t") for line in table.strip().splitlines())
    assert rows["critical_deg"] == "none"
    assert rows["R"] == copied
    assert float(rows["r_s.phase_deg"]) == 180.0


def test_play_sweeps_and_stops(quiet_page: Page) -> None:
    page = opened(quiet_page)
    play = page.get_by_role("button", name="Play extinction")
    play.click()
    expect(box(page, "k_t")).to_have_value(re.compile(r"^0\.[2-9]"))
    play.click()
    expect(play).to_have_attribute("aria-pressed", "false")
    k_t = float(at_rest(page)["k_t"])
    assert 0 < k_t < 5
    expect(box(page, "k_t")).to_have_value(f"{k_t:.6g}")


def test_more_widens_the_slider(quiet_page: Page) -> None:
    page = opened(quiet_page)
    row = page.locator('[data-parameter="n_t"]')
    assert page.locator("#n_t-slider").get_attribute("max") == "3"
    row.get_by_role("button", name="more").click()
    assert float(page.locator("#n_t-slider").get_attribute("max") or 0) == 10


def test_the_boundary_is_taken_to_an_engine(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_t=1.6")
    fold = page.locator("details.definitions", has_text="Use it in").first
    fold.locator("summary").first.click()
    panel = fold.locator(".take")
    expect(panel.locator(".parameters")).to_contain_text("1.6")
    panel.get_by_label("Mitsuba", exact=True).click()
    expect(panel).to_contain_text("int_ior")
    with page.expect_download() as waiting:
        panel.get_by_role("button", name="save").click()
    assert waiting.value.suggested_filename == "own_n_1_6_mitsuba.json"


def test_an_export_that_did_not_come_is_asked_for_again(page: Page) -> None:
    opened(page, "?n_t=1.6")
    page.route("**/api/v1/export?**", lambda route: route.abort())
    fold = page.locator("details.definitions", has_text="Use it in").first
    summary = fold.locator("summary").first
    summary.click()
    expect(fold.locator(".take .row-error")).to_contain_text("Is it running")
    page.unroute("**/api/v1/export?**")
    summary.click()
    summary.click()
    expect(fold.locator(".take .parameters")).to_contain_text("1.6")
    expect(fold.locator(".take .row-error")).to_be_empty()
