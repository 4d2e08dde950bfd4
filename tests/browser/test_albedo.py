"""The Albedo view: d'Eon's picture, metals, the map, claims, the paint, links, and refusals."""

import csv
import io
import re
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Page, Route, expect

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
READY_MS = 15_000


def opened(page: Page, query: str = "") -> Page:
    """Open the view and wait for its curves, its map and its paint."""
    page.goto(f"/?view=albedo{query}")
    for host in (".albedos .upper", ".albedos .lower"):
        page.locator(f"{host} path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    page.locator(".map-host .heatmaplayer image").first.wait_for(state="attached", timeout=READY_MS)
    expect(number(page, "surface")).to_be_visible()
    return page


def number(page: Page, name: str) -> Any:
    """Find the button that shows a number and copies it."""
    return page.locator(f'.view-albedo .number[aria-label^="{name}:"]')


def box(page: Page, parameter: str) -> Any:
    """Find the number box of a parameter."""
    return page.locator(f"#albedo-{parameter}-box")


def link(page: Page) -> dict[str, str]:
    """Read what the address says."""
    return {key: values[0] for key, values in parse_qs(urlsplit(page.url).query).items()}


def at(key: str, pattern: str) -> re.Pattern[str]:
    """Match an address that says something of a key."""
    return re.compile(rf"[?&]{re.escape(key)}={pattern}(&|$)")


def surface(page: Page, text: str) -> None:
    """Choose a figure."""
    page.locator(".panel .listed label", has_text=text).click()


def saved(page: Page, label: str) -> bytes:
    """Press a button that saves a file and read the file."""
    with page.expect_download() as download:
        page.get_by_role("button", name=label, exact=True).click()
    return Path(download.value.path()).read_bytes()


def test_starts_with_the_picture_of_the_logarithm_fit(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(page.locator("#calls code").first).to_have_text(
        "GET /api/v1/albedo/sweep?over=eta&minimum=1&maximum=3&steps=401&fits=deon_2019_log"
    )
    expect(number(page, "forward albedo, unpolarized")).to_have_text("0.0917780")
    expect(number(page, "forward albedo, s")).to_have_text("0.146667")
    expect(number(page, "reverse albedo, unpolarized")).to_have_text("0.596346")
    expect(number(page, "flatland albedo")).to_have_text("0.0679765")
    row = page.locator('.fit-values [data-fit="deon_2019_log"] td')
    expect(row.nth(0)).to_have_text("0.0931007")
    expect(row.nth(1)).to_have_text("0.00132")
    expect(page.locator(".exact-albedos")).to_contain_text("internal diffuse reflectance")
    assert link(page) == {"view": "albedo"}


def test_the_view_is_loaded_when_it_is_asked_for(page: Page) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto("/")
    page.locator(".plot-host path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    assert not [url for url in asked if "albedo" in url]
    page.locator(".views a", has_text="Albedo").click()
    page.locator(".albedos path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    assert [url for url in asked if "views/albedo.js" in url]


def test_the_marker_is_the_interface_of_all_views(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=1.6")
    chip = page.locator(".albedos .upper .plot-handle")
    expect(chip).to_have_text("1.6")
    chip.focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("PageUp")
    expect(page).to_have_url(at("n_t", r"1\.71"))
    expect(page.locator(".albedos .lower .plot-handle")).to_have_text("1.71")
    surface(page, "from inside")
    expect(page.locator(".albedos .upper .plot-handle")).to_have_text(re.compile(r"^0\.584795"))
    page.locator(".views a", has_text="Explore").click()
    expect(page.locator("#n_t-box")).to_have_value("1.71")


def test_metals_over_n_and_k_share_the_sliders(quiet_page: Page) -> None:
    page = opened(quiet_page)
    surface(page, "metal at one k")
    expect(page).to_have_url(at("surface", "metal-n"))
    expect(page).to_have_url(at("k_t", "3"))
    rows = page.locator(".fit-values tbody tr")
    expect(rows).to_have_count(3)
    expect(page.locator(".shared-key")).to_contain_text("largest error claimed")
    box(page, "k_t").fill("1")
    box(page, "k_t").press("Enter")
    expect(page.locator("#calls")).to_contain_text("k_t=1")
    expect(rows.first).to_contain_text("outside its domain: made for 0.1 ≤ η ≤ 4, 1.7 ≤ κ ≤ 8")
    surface(page, "metal at one n")
    expect(page.locator("#calls code").first).to_contain_text("over=k_t&minimum=0&maximum=8")
    expect(page.locator(".albedos .upper .plot-handle")).to_have_text("1")
    expect(page.locator(".shared-key")).to_contain_text("outside a fit’s domain")


def test_fits_flatland_and_relative_errors_are_chosen(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.locator(".fit-groups label", has_text="Kulla and Conty 2017, external").click()
    expect(page).to_have_url(at("fits", "deon_2019_log,kulla_conty_2017"))
    page.locator(".choice label", has_text="flatland").click()
    expect(page).to_have_url(at("lights", "s,p,flatland"))
    expect(page.locator(".shared-key")).to_contain_text("flatland")
    page.locator(".error-heading label", has_text="relative").click()
    expect(page.locator(".albedos .lower")).to_contain_text("(fit − exact) / exact (%)")
    page.get_by_role("button", name="Clear the fits").click()
    expect(page.locator(".albedos .figure-note")).to_be_visible()
    assert link(page)["fits"] == "none"


def test_the_map_outlines_a_domain_and_leads_there(quiet_page: Page) -> None:
    page = opened(quiet_page)
    outline = page.locator(".map-region")
    assert outline.get_attribute("d")
    expect(page.locator(".largest")).to_contain_text("in the outlined domain −0.00309")
    expect(page.locator(".map-note")).to_have_text("line at ±0.001")
    page.get_by_label("Fit of the map").select_option("large_k")
    expect(page).to_have_url(at("map_k_high", "100"))
    expect(page.locator(".map-host .heatmap")).to_have_attribute(
        "aria-label", "Asymptote for large k: error"
    )
    page.locator(".map-controls label", has_text="exact").click()
    expect(page.locator(".largest")).to_contain_text("Largest 0.999947 at n = 0.1, k = 100.")
    expect(outline).to_be_hidden()
    handle = page.locator(".map-host .map-handle")
    handle.focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Enter")
    expect(page).to_have_url(at("k_t", r"0\.8\d+"))


def test_claims_stand_beside_measurements_and_sort(quiet_page: Page) -> None:
    page = opened(quiet_page)
    table = page.locator(".claims")
    expect(table.locator("tbody tr").first).to_contain_text("does not hold")
    first = table.locator("tbody tr", has_text="d'Eon 2019, first conductor fit")
    expect(first.locator(".claimed")).to_have_text("0.001")
    expect(first.locator(".measured")).to_have_text("0.00309 at n = 0.5, k = 1.7")
    expect(first.locator(".holds")).to_have_text("does not hold: 3.1 times as large")
    second = table.locator("tbody tr", has_text="second conductor fit")
    expect(second.locator(".claimed")).to_have_text("0.00006")
    expect(second.locator(".measured")).to_contain_text("0.000165")
    table.get_by_role("button", name="measured").click()
    expect(table.locator("th[aria-sort]")).to_have_text("measured")
    expect(table.locator("th[aria-sort]")).to_have_attribute("aria-sort", "ascending")
    table.get_by_role("button", name="measured").click()
    expect(table.locator("tbody tr").first).to_contain_text("6.81")
    assert link(page)["claims_by"] == "measured"
    first.get_by_role("button").click()
    expect(page).to_have_url(at("surface", "metal-n"))
    expect(page).to_have_url(at("fits", "deon_2019_rational"))
    expect(first.get_by_role("button")).to_have_attribute("aria-pressed", "true")


def test_the_paint_splits_the_light_to_scale(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(number(page, "surface")).to_have_text("0.0917780")
    expect(number(page, "body")).to_have_text("0.261181")
    expect(number(page, "absorbed")).to_have_text("0.647041")
    widths = page.evaluate(
        "() => [...document.querySelectorAll('.energy')]"
        ".map(e => e.getBoundingClientRect().width / e.parentElement.clientWidth)"
    )
    assert widths == pytest.approx([0.0918, 0.2612, 0.6470], abs=0.01)
    box(page, "coat_body").fill("1")
    box(page, "coat_body").press("Enter")
    expect(number(page, "absorbed")).to_have_text("0")
    expect(page.locator(".coat-band.absorbed")).to_have_count(0)
    page.locator(".coat-rows label", has_text="a ray").click()
    box(page, "coat_theta").fill("0")
    box(page, "coat_theta").press("Enter")
    expect(number(page, "surface")).to_have_text("0.0400000")
    expect(page.locator(".coat-frame")).to_have_attribute(
        "aria-label", re.compile("a ray at 0.0°.*4.0\u00a0% off the surface")
    )
    expect(page.locator("#calls")).to_contain_text("body_albedo=1&theta_i_deg=0")
    page.locator("#albedo-coat_n-slider").focus()
    page.keyboard.press("ArrowRight")
    expect(page).to_have_url(at("coat_n", r"1\.51"))


def test_a_link_gives_the_same_view(quiet_page: Page) -> None:
    query = (
        "&surface=metal-k&n_t=0.3&k_t=3.5&fits=deon_2019_rg,dunkle_1963_p&lights=flatland"
        "&sweep_high=6&map_show=value&map_fit=dunkle_1963&coat_n=1.6&coat_body=0.9&claims_by=fit"
    )
    page = opened(quiet_page, query)
    said = link(page)
    rows = page.locator(".view-albedo").inner_text()
    page.locator(".views a", has_text="Explore").click()
    page.go_back()
    expect(page.locator(".view-albedo")).to_be_visible()
    assert link(page) == said
    page.reload()
    page.locator(".albedos .lower path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    expect(number(page, "surface")).to_be_visible()
    page.locator(".map-host .heatmaplayer image").first.wait_for(state="attached", timeout=READY_MS)
    assert page.locator(".view-albedo").inner_text() == rows
    expect(page.locator(".notice")).to_have_count(0)


def test_exports_and_tables_hold_the_numbers(quiet_page: Page) -> None:
    page = opened(quiet_page)
    rows = list(csv.DictReader(io.StringIO(saved(page, "Save the albedos as CSV").decode())))
    assert len(rows) == 401
    middle = next(row for row in rows if row["eta"] == "1.5")
    assert float(middle["exact"]) == pytest.approx(0.09177795934235124, abs=1e-15)
    assert float(middle["deon_2019_log"]) == pytest.approx(0.09310073487295728, abs=1e-15)
    errors = saved(page, "Save the errors of the fits as CSV").decode()
    assert "deon_2019_log.error" in errors.splitlines()[0]
    cells = saved(page, "Save the map as CSV").decode().splitlines()
    assert cells[0] == "n_t,k_t,error"
    assert len(cells) == 118 * 121 + 1
    paint = saved(page, "Save the picture of the paint as SVG").decode()
    assert "<svg" in paint
    assert "26.1" in paint
    for what in ("albedos", "errors of the fits", "map", "picture of the paint"):
        assert saved(page, f"Save the {what} as PNG").startswith(b"\x89PNG")
    page.locator("summary", has_text="Albedos and errors as tables").click()
    expect(page.locator(".albedos .curve-table")).to_have_count(2)
    page.locator("summary", has_text="This map as a table").click()
    expect(page.locator(".over-nk .curve-table caption")).to_contain_text("cells")


def test_a_fit_that_there_is_not_is_refused_where_it_stands(page: Page) -> None:
    page.goto("/?view=albedo&fits=deon_2019")
    trouble = page.locator(".albedos .trouble")
    expect(trouble).to_contain_text("fits = deon_2019", timeout=READY_MS)
    trouble.get_by_role("button").click()
    page.locator(".albedos path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    expect(trouble.locator(".row-error")).to_have_text("")
    assert "fits" not in link(page)


def test_a_range_that_is_none_keeps_the_last_good_picture(page: Page) -> None:
    opened(page)
    page.get_by_label("n from").fill("5")
    page.get_by_label("n from").press("Enter")
    trouble = page.locator(".over-nk .trouble")
    expect(trouble).to_contain_text("below n_maximum, 4")
    expect(page.locator(".map-host .heatmaplayer image")).to_have_count(1)
    page.get_by_label("n to").fill("two")
    page.get_by_label("n to").press("Enter")
    expect(page.locator(".over-nk .ends .row-error").first).to_contain_text("“two”")
    trouble.get_by_role("button").click()
    expect(trouble.locator(".row-error")).to_have_text("")


def test_a_server_that_fails_is_said_in_the_paint(page: Page) -> None:
    opened(page)

    def refuse(route: Route) -> None:
        route.fulfill(status=500, content_type="text/plain", body="")

    page.route("**/albedo/coat?*", refuse)
    box(page, "coat_n").fill("1.7")
    box(page, "coat_n").press("Enter")
    expect(page.locator(".coat .trouble")).to_contain_text("The server answered 500")
    expect(number(page, "body")).to_have_text("0.261181")


@pytest.mark.parametrize("width", [320, 390, 768, 1024, 1440])
def test_no_horizontal_scroll(quiet_page: Page, width: int) -> None:
    quiet_page.set_viewport_size({"width": width, "height": 844})
    page = opened(quiet_page, "&surface=metal-n&k_t=3&lights=s,p,flatland")
    assert page.evaluate("() => document.documentElement.scrollWidth") == width


@pytest.mark.parametrize(("theme", "width"), [("light", 1440), ("dark", 1440), ("light", 390)])
def test_axe_finds_nothing(quiet_page: Page, theme: str, width: int) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    quiet_page.set_viewport_size({"width": width, "height": 900})
    page = opened(quiet_page, "&surface=metal-n&k_t=1.2&coat_light=ray")
    assert page.evaluate("() => document.documentElement.dataset.theme") == theme
    for summary in ("Formulas", "Albedos and errors as tables", "This map as a table"):
        page.locator(".view-albedo summary", has_text=summary).click()
    page.locator(".definitions .katex").first.wait_for(timeout=READY_MS)
    page.evaluate(AXE.read_text(encoding="utf-8"))
    result = page.evaluate("() => axe.run(document)")
    found = [(v["id"], [node["target"] for node in v["nodes"]][:5]) for v in result["violations"]]
    assert found == []
