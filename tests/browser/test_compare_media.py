"""The Compare view over the media: sweeps, maps, which model will do, conversions."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.compare_page import (
    READY_MS,
    api,
    link,
    opened,
    shown_number,
)


@pytest.mark.parametrize("over", ["n", "k"])
def test_the_sweep_goes_where_it_is_clicked(quiet_page: Page, over: str) -> None:
    page = opened(quiet_page, f"&over={over}")
    frame = page.locator(".figure-host:not([hidden]) .nsewdrag").first
    frame.wait_for()
    area = frame.bounding_box()
    assert area
    page.mouse.click(area["x"] + area["width"] / 2, area["y"] + area["height"] / 2)
    middle = 2.05 if over == "n" else 2.5
    expect(page).to_have_url(re.compile(rf"{over}_t="))
    assert float(link(page)[f"{over}_t"]) == pytest.approx(middle, abs=0.03)


def test_schlicks_largest_errors_in_the_sweep_are_those_of_the_table_of_the_formulas(
    quiet_page: Page,
) -> None:
    page = opened(quiet_page, "&models=schlick&n_low=1.1&n_high=4")
    page.locator("summary", has_text="This figure as a table").click()
    expect(page.locator(".figure .curve-table caption")).to_contain_text("largest error against n")
    with page.expect_download(timeout=READY_MS) as waiting:
        page.get_by_role("button", name="Save the figure of the error as CSV").click()
    text = Path(waiting.value.path()).read_text("utf-8")
    lines = [line.split(",") for line in text.strip().splitlines()]
    assert lines[0] == ["n_t", "schlick"]
    values = {round(float(n), 4): float(e) for n, e in lines[1:]}
    for n, error in ((1.1, 0.2105), (4.0, 0.2009)):
        assert round(values[n], 4) == error


@pytest.mark.parametrize(("over", "axes"), [("theta-n", "θ"), ("n-k", "n")])
def test_a_map_tells_its_values_and_goes_there(quiet_page: Page, over: str, axes: str) -> None:
    page = opened(quiet_page, f"&over={over}&k_t=1&models=schlick")
    page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    area = page.locator(".heatmap .nsewdrag").first.bounding_box()
    assert area
    x, y = area["x"] + 0.75 * area["width"], area["y"] + 0.5 * area["height"]
    page.mouse.move(x, y)
    tip = page.locator(".map-tip")
    expect(tip).to_be_visible()
    expect(tip).to_contain_text(axes)
    said = tip.inner_text()
    page.mouse.click(x, y)
    expect(page).to_have_url(re.compile("n_t="))
    if over == "theta-n":
        theta, n_t = float(link(page)["theta_i_deg"]), float(link(page)["n_t"])
        assert theta == pytest.approx(67.5, abs=0.6)
        curve = api(page, f"/errors?models=schlick&n_t={n_t}&k_t=1&samples=181")["errors"][0][
            "error"
        ]
        assert shown_number(said.rsplit(":", 1)[1]) == pytest.approx(
            curve[round(2 * theta)], rel=6e-3
        )
    else:
        assert float(link(page)["n_t"]) == pytest.approx(3.775, abs=0.05)
        assert float(link(page)["k_t"]) == pytest.approx(2.5, abs=0.06)


def test_a_map_is_read_by_keyboard(quiet_page: Page) -> None:
    page = opened(quiet_page, "&over=theta-n")
    page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    handle = page.locator(".map-handle")
    handle.focus()
    before = handle.get_attribute("aria-valuetext")
    handle.press("ArrowUp")
    handle.press("Shift+ArrowRight")
    assert handle.get_attribute("aria-valuetext") != before
    assert handle.get_attribute("aria-valuenow") == "69"
    handle.press("Enter")
    expect(page).to_have_url(re.compile("theta_i_deg=69"))


PLOTLYS_OWN = """async () => {
  const plot = document.querySelector('.heatmap .plot-canvas');
  await Plotly.react(plot, plot.data, {...plot.layout, datarevision: -1});
  return plot.querySelector('.heatmaplayer image').getAttribute('href');
}"""
PICTURES_APART = """async ([a, b]) => {
  const [width, height] = [181, 121];
  const pixels = async (url) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext('2d');
    context.imageSmoothingEnabled = false;
    context.drawImage(image, 0, 0, width, height);
    return context.getImageData(0, 0, width, height).data;
  };
  const [p, q] = [await pixels(a), await pixels(b)];
  return p.reduce((sum, value, i) => sum + Math.abs(value - q[i]), 0) / p.length;
}"""


def test_a_map_follows_a_slider_that_is_let_go(quiet_page: Page) -> None:
    page = opened(quiet_page, "&over=theta-n&k_t=1&models=schlick")
    picture = page.locator(".heatmap .heatmaplayer image")
    picture.wait_for(state="attached")
    before = picture.get_attribute("href")
    slider = page.locator("#compare-k_t-slider")
    slider.focus()
    for _ in range(5):
        slider.press("PageUp")
    expect(page).to_have_url(re.compile(r"k_t=1\.5(&|$)"))
    page.wait_for_load_state("networkidle")
    expect(picture).not_to_have_attribute("href", before or "")
    expect(picture).to_have_attribute("style", re.compile("pixelated"))
    in_place = picture.get_attribute("href")
    # What is written in place is what Plotly draws.
    page.reload()
    picture.wait_for(state="attached")
    page.wait_for_load_state("networkidle")
    fresh = page.evaluate(PLOTLYS_OWN)
    assert page.evaluate(PICTURES_APART, [before, fresh]) > 3
    assert page.evaluate(PICTURES_APART, [in_place, fresh]) < 2


def test_which_will_do_is_the_cheapest_within_the_budget(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=0.27&k_t=2.9&budget=0.02")
    wanted = api(page, "/recommend?n_t=0.27&k_t=2.9&max_error=0.02&metric=max_abs")
    names = page.locator(".verdict .picks .pick-name").all_text_contents()
    assert names == [entry["title"] for entry in wanted["models"]]
    refusals = page.locator(".refused li").all_text_contents()
    assert len(refusals) == len(wanted["refused"])
    assert wanted["refused"][0]["reason"] in refusals[0]
    page.locator(".quick .mini", has_text="0.005").click()
    expect(page).to_have_url(re.compile("budget=0.005"))
    expect(page.locator(".refused li")).not_to_have_count(len(refusals))
    name = page.locator(".picks .pick").first
    name.click()
    expect(page).to_have_url(re.compile("models="))
    box = page.get_by_role("textbox", name="Error budget")
    box.fill("7")
    box.press("Enter")
    expect(page.locator("#budget-error")).to_contain_text("up to 1")


@pytest.mark.parametrize(
    ("query", "form", "text", "status"),
    [
        ("", "F0, linear", "0.0400000", "exact"),
        ("&n_t=0.27&k_t=2.9", "Gulbrandsen's r, g", "0.993919", "exact"),
        ("&from=f0&given=1", "Index of refraction", "none", "infeasible"),
        ("&from=hex&given=%23ffe29b", "F0, linear", "1, 0.7605, 0.3278", "exact"),
        ("&from=specular&given=0.5", "Filament reflectance", "0.5", "exact"),
    ],
)
def test_conversions_say_what_is_lost(
    quiet_page: Page, query: str, form: str, text: str, status: str
) -> None:
    page = opened(quiet_page, query)
    line = page.locator(".conversions tr", has=page.get_by_role("rowheader", name=form, exact=True))
    expect(line).to_contain_text(text)
    expect(line).to_have_attribute("data-status", status)


def test_a_conversion_can_be_used_as_the_second_medium(quiet_page: Page) -> None:
    page = opened(quiet_page, "&from=rg&given=0.9;0.5")
    page.get_by_role("button", name="Use Complex index as the second medium").click()
    expect(page).to_have_url(re.compile(r"n_t=[\d.]+&k_t=[\d.]+"))
    answer = api(page, "/convert?from=rg&r=0.9&g=0.5")
    nk = next(r for r in answer["results"] if r["form"] == "nk")["values"]
    assert float(link(page)["k_t"]) == pytest.approx(nk["k_t"], rel=1e-9)


def test_a_refused_conversion_is_told_in_its_panel(page: Page) -> None:
    opened(page, "&from=f0&given=0.04")
    box = page.locator(".given:visible")
    box.fill("four")
    box.press("Enter")
    expect(page.locator("#convert-problem")).to_contain_text("F0")
    expect(page.locator(".notice")).to_have_count(0)
    expect(page.locator(".conversions tr").first).to_be_visible()  # the last good answer
    box.fill("0.05")
    box.press("Enter")
    expect(page.locator("#convert-problem")).to_have_text("")
