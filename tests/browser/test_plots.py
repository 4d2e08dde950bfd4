"""The plots: the fast path beside Plotly's own drawing, exports, picking, and what readers get."""

import csv
import json
import struct
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.browser.explore_page import link, number, opened, type_into

SVG = "{http://www.w3.org/2000/svg}"
PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"

SCRATCH = """async ([from, to]) => {
  const { createPlot } = await import('/js/plot/plot.js');
  const host = document.createElement('div');
  host.style.cssText = 'position: fixed; inset: 0 auto auto 0; width: 700px; height: 420px';
  document.body.append(host);
  const ask = async (query) => (await fetch(`/api/v1/curves?${query}`)).json();
  const quantities = ['R', 'Rs', 'Rp', 'T', 'theta_t_deg', 'phase_s_deg'];
  const traces = ({theta_i_deg, curves}) => quantities.map((quantity) => ({
    id: quantity,
    label: quantity,
    color: '--R',
    x: theta_i_deg,
    y: curves.find((curve) => curve.quantity === quantity).values,
    axis: quantity.endsWith('_deg') ? 'y2' : 'y',
  }));
  const plot = createPlot(host, {
    name: 'scratch',
    x: {title: 'angle', range: [0, 90], unit: '°'},
    y: {title: 'share', range: [0, 1]},
    y2: {title: 'degrees', range: [-180, 180]},
  });
  // the pieces of a curve between gaps, joined as one path
  const paths = () => [...host.querySelectorAll('.scatterlayer .trace')].map((trace) =>
    [...trace.querySelectorAll('path.js-line')].map((p) => p.getAttribute('d') ?? '').join(''));
  const [a, b] = [traces(await ask(from)), traces(await ask(to))];
  await plot.draw(a);
  const before = paths();
  plot.fast(b);
  const written = {fast: host.dataset.fast !== undefined, paths: paths()};
  await plot.draw(b);
  const drawn = paths();
  plot.destroy();
  host.remove();
  return {before, written, drawn};
}"""


def saved(page: Page, kind: str, folder: Path) -> Path:
    """Save the plot and return the file."""
    with page.expect_download() as download:
        page.get_by_role("button", name=f"Save the plot as {kind.upper()}").click()
    path = folder / download.value.suggested_filename
    download.value.save_as(path)
    assert path.suffix == f".{kind}"
    return path


def handle(page: Page) -> Any:
    """Find the slider on the plot's axis."""
    return page.locator(".plot-host [role=slider]")


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("n_t=1.5", "n_t=1.9"),
        ("n_t=1.5", "n_t=0.27&k_t=2.9"),
        ("n_i=1.5&n_t=1.4", "n_i=1.5&n_t=1"),
        ("n_i=1.5&n_t=1", "n_t=2.42"),
    ],
)
def test_fast_path_writes_what_plotly_draws(quiet_page: Page, before: str, after: str) -> None:
    opened(quiet_page)
    shared = "&landmarks=true&refraction=true&phase=true"
    seen = quiet_page.evaluate(SCRATCH, [before + shared, after + shared])
    assert seen["written"]["fast"]
    assert seen["written"]["paths"] == seen["drawn"]
    assert all(path.startswith("M") for path in seen["drawn"])
    assert seen["before"] != seen["drawn"]


def test_settling_after_a_drag_changes_no_curve(quiet_page: Page) -> None:
    page = opened(quiet_page)
    paths = "() => [...document.querySelectorAll('path.js-line')].map((p) => p.getAttribute('d'))"
    first = page.evaluate(paths)
    track = page.locator("#n_t-slider").bounding_box()
    assert track is not None
    middle = track["y"] + track["height"] / 2
    page.mouse.move(track["x"] + track["width"] * 0.27, middle)
    page.mouse.down()
    page.mouse.move(track["x"] + track["width"] * 0.6, middle, steps=6)
    page.wait_for_function("() => document.querySelector('.plot').dataset.fast !== undefined")
    page.wait_for_timeout(400)  # the last answer of the drag
    moving = page.evaluate(paths)
    page.mouse.up()
    page.wait_for_function("() => document.querySelector('.plot').dataset.fast === undefined")
    assert page.evaluate(paths) == moving
    assert moving != first


def test_nothing_of_a_plot_can_be_sent_away(quiet_page: Page) -> None:
    page = opened(quiet_page)
    context = page.evaluate(
        """() => {
          const {showSendToCloud, plotlyServerURL, displaylogo} =
            document.querySelector('.plot-canvas')._context;
          return {showSendToCloud, plotlyServerURL, displaylogo};
        }"""
    )
    assert context == {"showSendToCloud": False, "plotlyServerURL": "", "displaylogo": False}
    page.locator(".plot-area").hover()
    assert page.locator(".modebar-btn").count() == 0


def test_png_is_twice_the_size_of_the_svg(quiet_page: Page, tmp_path: Path) -> None:
    page = opened(quiet_page)
    root = ET.parse(saved(page, "svg", tmp_path)).getroot()  # noqa: S314 (made by the page)
    assert root.tag == f"{SVG}svg"
    words = "".join(root.itertext())
    assert "Reflectance against the angle of incidence" in words
    assert "Brewster 56.31°" in words
    assert "@font-face" in words
    assert len([path for path in root.iter(f"{SVG}path") if path.get("class") == "js-line"]) == 3

    picture = saved(page, "png", tmp_path).read_bytes()
    assert picture.startswith(PNG_SIGNATURE)
    width, height = struct.unpack(">II", picture[16:24])
    assert (width, height) == (2 * int(root.attrib["width"]), 2 * int(root.attrib["height"]))
    assert len(picture) > 20_000


def test_csv_has_every_digit_that_the_server_sent(quiet_page: Page, tmp_path: Path) -> None:
    page = opened(quiet_page, "?n_t=1.33&show=T")
    with saved(page, "csv", tmp_path).open(encoding="utf-8", newline="") as file:
        header, *rows = list(csv.reader(file))
    answer = page.request.get("/api/v1/curves?n_t=1.33&landmarks=true").json()
    sent = {curve["quantity"]: curve["values"] for curve in answer["curves"]}
    assert len(rows) == len(answer["theta_i_deg"])
    columns = list(zip(*rows, strict=True))
    assert [float(cell) for cell in columns[0]] == answer["theta_i_deg"]
    assert set(header[1:]) == {"R", "Rs", "Rp", "T"}
    for name, cells in zip(header[1:], columns[1:], strict=True):
        assert [float(cell) for cell in cells] == sent[name], name


def test_angle_is_picked_on_the_plot_by_pointer_and_by_keys(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(handle(page)).to_have_attribute("aria-valuenow", "64")
    expect(handle(page)).to_have_text("64.00°")
    handle(page).focus()
    handle(page).press("ArrowRight")
    expect(handle(page)).to_have_attribute("aria-valuenow", "64.5")
    handle(page).press("Shift+ArrowLeft")
    expect(handle(page)).to_have_attribute("aria-valuenow", "64.45")
    handle(page).press("Home")
    expect(number(page, "R")).to_have_text("0.0400000")

    area = page.locator(".plot-area").bounding_box()
    grid = page.locator(".plot-canvas .nsewdrag").bounding_box()
    assert area is not None
    assert grid is not None
    page.mouse.click(grid["x"] + grid["width"] / 3, grid["y"] + grid["height"] / 2)
    picked = float(handle(page).get_attribute("aria-valuenow"))
    assert picked == pytest.approx(30, abs=0.2)
    expect(page.locator(".diagram-host [role=slider]")).to_have_attribute(
        "aria-valuenow", f"{picked:g}"
    )
    assert float(link(page)["theta_i_deg"]) == picked


def test_readers_get_a_figure_with_a_name_and_a_table(quiet_page: Page) -> None:
    page = opened(quiet_page)
    figure = page.get_by_role("figure", name="Reflectance against the angle of incidence")
    assert figure.locator(".plot-canvas").get_attribute("aria-hidden") == "true"
    page.get_by_text("The curves as a table").click()
    table = page.locator(".curve-table")
    expect(table.locator("caption")).to_contain_text("samples")
    heads = [cell.strip() for cell in table.locator("thead th").all_text_contents()]
    assert heads[1:] == ["Rs", "Rp", "R"]
    first = table.locator("tbody tr").first.locator("td").all_text_contents()
    assert first == ["0.0400000"] * 3


def test_more_than_four_curves_have_a_legend_and_no_names(quiet_page: Page) -> None:
    page = opened(quiet_page)
    names = "() => [...document.querySelectorAll('.plot-label')].map((t) => t.textContent)"
    assert sorted(page.evaluate(names)) == ["R", "Rp", "Rs"]
    assert page.locator(".plot-legend").is_hidden()
    opened(page, "?show=T,phase")
    expect(page.locator(".plot-legend li")).to_have_count(6)
    shown = """() => [...document.querySelectorAll('.plot-label')]
      .filter((label) => label.checkVisibility({visibilityProperty: true})).length"""
    assert page.evaluate(shown) == 0


def test_curves_take_the_colours_of_the_theme(quiet_page: Page) -> None:
    page = opened(quiet_page)
    strokes = """() => [...document.querySelectorAll('path.js-line')]
      .map((path) => getComputedStyle(path).stroke)"""
    light = page.evaluate(strokes)
    page.emulate_media(color_scheme="dark")
    page.wait_for_function(
        "(before) => getComputedStyle(document.querySelector('path.js-line')).stroke !== before",
        arg=light[0],
    )
    dark = page.evaluate(strokes)
    assert all(a != b for a, b in zip(light, dark, strict=True))


@pytest.mark.parametrize("width", [320, 390, 1440, 3840])
def test_ticks_and_names_fit_at_every_width(quiet_page: Page, width: int) -> None:
    quiet_page.set_viewport_size({"width": width, "height": 900})
    page = opened(quiet_page, "?n_i=1.5&n_t=1")
    boxes = page.evaluate(
        """() => {
          const area = document.querySelector('.plot-area').getBoundingClientRect();
          const boxes = (selector) => [...document.querySelectorAll(selector)]
            .filter((node) => node.checkVisibility({visibilityProperty: true}))
            .map((node) => node.getBoundingClientRect())
            .map(({left, right, top, bottom}) => ({left: left - area.left,
              right: right - area.left, top: top - area.top, bottom: bottom - area.top}));
          return {width: area.width, height: area.height, ticks: boxes('.xtick'),
            names: boxes('.plot-label, .plot-mark-name')};
        }"""
    )
    assert len(boxes["ticks"]) >= 4
    for left, right in zip(boxes["ticks"], boxes["ticks"][1:], strict=False):
        assert left["right"] < right["left"], json.dumps(boxes["ticks"])
    assert len(boxes["names"]) == 5
    for index, one in enumerate(boxes["names"]):
        assert one["left"] >= -1
        assert one["right"] <= boxes["width"] + 1
        assert one["top"] >= -1
        for other in boxes["names"][:index]:
            apart = (
                one["right"] <= other["left"] + 1
                or other["right"] <= one["left"] + 1
                or one["bottom"] <= other["top"] + 4
                or other["bottom"] <= one["top"] + 4
            )
            assert apart, (one, other)


def test_an_error_is_said_and_the_curves_follow_all_the_same(page: Page) -> None:
    opened(page)
    paths = "() => [...document.querySelectorAll('path.js-line')].map((p) => p.getAttribute('d'))"
    before = page.evaluate(paths)
    page.wait_for_timeout(2500)  # until a worker asks
    page.route("**/api/v1/**", lambda route: route.fulfill(status=500, body="{}"))
    type_into(page, "n_t", "2")
    expect(page.locator("#notices")).to_contain_text("500")
    expect(page.locator("#notices")).to_contain_text("worked out here")
    assert page.evaluate(paths) != before


@pytest.mark.parametrize("view", ["explore", "compare"])
def test_an_index_that_is_a_range_is_a_band(quiet_page: Page, view: str) -> None:
    page = quiet_page
    page.goto(f"/?view={view}&material=garnet-wloka")
    band = page.locator(".shapelayer path").first
    expect(band).to_be_attached(timeout=45_000)
    # At normal incidence it reaches from R of 1.73 to that of 1.89, as far as the plot's scale says.
    told = page.request.get("/api/v1/curves?material=garnet-wloka&band=true").json()
    low, high = (
        next(c["values"][0] for c in told["curves"] if c["quantity"] == quantity)
        for quantity in ("R_minimum", "R_maximum")
    )
    F0 = [((n - 1) / (n + 1)) ** 2 for n in (1.73, 1.89)]
    assert (low, high) == pytest.approx(F0, rel=1e-12)
    page.goto(f"/?view={view}&n_t=1.81")
    expect(page.locator(".plot-canvas path.js-line").first).to_be_attached(timeout=45_000)
    expect(page.locator(".shapelayer path")).to_have_count(0)
