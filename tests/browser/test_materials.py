"""The Materials view: the catalog is searched and walked through, a preset is read and taken away."""

import csv
import io
import json
import re
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Locator, Page, expect

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
READY_MS = 15_000


def opened(page: Page, query: str = "") -> Page:
    """Open the view and wait for its table, its numbers and its curves."""
    page.goto(f"/?view=materials{query}")
    page.locator(".presets tbody tr").first.wait_for(timeout=READY_MS)
    expect(number(page, "n")).not_to_be_empty()
    page.locator(".two-schlicks path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    return page


def number(page: Page, name: str) -> Locator:
    """Find the button that shows a number and copies it."""
    return page.locator(f'.view-materials .number[aria-label^="{name}:"]')


def names(page: Page) -> list[str]:
    """Read the names in the table, from above."""
    return page.locator(".presets .entry-name").all_text_contents()


def link(page: Page) -> dict[str, str]:
    """Read what the address says."""
    return {key: values[0] for key, values in parse_qs(urlsplit(page.url).query).items()}


def lines(page: Page, figure: str) -> Locator:
    """Find the curves of a figure."""
    return page.locator(f".sheet.{figure} path.js-line")


def choose(page: Page, scope: str, label: str) -> None:
    """Click a word of a row of choices."""
    page.locator(scope).get_by_label(label, exact=True).click()


def saved(page: Page, figure: str, kind: str) -> tuple[str, bytes]:
    """Save a figure."""
    with page.expect_download() as waiting:
        page.locator(f".sheet.{figure} .exports button", has_text=kind).click()
    return waiting.value.suggested_filename, Path(waiting.value.path()).read_bytes()


def test_shows_the_catalog_and_gold(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(page.locator(".browser .count")).to_have_text(re.compile(r"^1\d\d presets$"))
    assert len(names(page)) >= 75
    expect(page.locator(".material-name")).to_have_text("Gold")
    expect(number(page, "n")).to_have_text("0.224436")
    expect(number(page, "k")).to_have_text("2.98068")
    expect(page.locator(".origin")).to_contain_text("Olmon")
    expect(
        page.locator('.origin a[href="https://doi.org/10.1103/PhysRevB.86.235147"]')
    ).to_be_visible()
    expect(page.locator(".origin")).to_contain_text("CC0-1.0")
    assert link(page) == {"view": "materials"}


def test_glass_has_an_index_in_air_and_one_in_vacuum(quiet_page: Page) -> None:
    page = opened(quiet_page, "&preset=BK7")
    expect(number(page, "n")).to_have_text("1.51680")
    expect(number(page, "n_absolute")).to_have_text("1.51722")
    expect(number(page, "F0")).to_have_text("0.0422189")
    expect(page.locator(".constants dt").nth(0)).to_contain_text("in air")
    expect(page.locator(".constants dt").nth(1)).to_contain_text("in vacuum")
    expect(page.locator(".two-schlicks h3").first).to_contain_text("1.51722 in vacuum")
    expect(page.locator(".origin")).to_contain_text("wavelengths in air")
    page.goto("/?view=materials&preset=Au")
    expect(page.locator(".origin")).to_contain_text("not stated: n counts as absolute")
    expect(number(page, "n_absolute")).to_have_count(0)


def test_swatches_are_those_of_the_policy_that_is_named(quiet_page: Page) -> None:
    page = opened(quiet_page)
    gold = page.locator('tr[data-id="Au"] .swatch')
    assert gold.evaluate("e => getComputedStyle(e).backgroundColor") == "rgb(255, 224, 154)"
    expect(page.locator(".browser > .hint")).to_contain_text(
        "scaled: divided by the largest channel"
    )
    choose(page, ".color-choices", "clamped")
    expect(page.locator(".browser > .hint")).to_contain_text("clamped: each channel cut")
    expect(number(page, "sRGB")).to_have_text("#ffe49c")
    choose(page, ".color-choices", "unclamped")
    expect(number(page, "sRGB")).to_have_text("outside sRGB")
    expect(number(page, "F0 R")).to_have_text("1.04276")
    assert link(page)["gamut"] == "unclamped"


@pytest.mark.parametrize(("text", "first"), [("au", "Gold"), ("gold", "Gold"), ("Aurum", "Gold")])
def test_search_finds_gold(quiet_page: Page, text: str, first: str) -> None:
    page = opened(quiet_page)
    page.get_by_label("Catalog", exact=True).locator("visible=true")
    page.locator("#find").fill(text)
    expect(page.locator(".presets .entry-name").first).to_have_text(first)
    counted = re.compile(r"^\d+ of 1\d\d presets, \d+ pages?$")
    expect(page.locator(".browser .count")).to_have_text(counted)
    expect(page).to_have_url(re.compile(rf"find={text}"))


def test_a_typo_is_answered_with_suggestions(quiet_page: Page) -> None:
    page = opened(quiet_page, "&preset=Cu")
    page.locator("#find").fill("Aurm")
    expect(page.locator(".suggestions")).to_contain_text("No match for “Aurm”")
    page.locator(".suggestion", has_text="Gold").click()
    expect(page.locator(".material-name")).to_have_text("Gold")
    expect(page.locator(".presets .entry-name").first).to_have_text("Gold")


def test_filters_and_sorting(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_label("Category").select_option("liquid")
    expect(page.locator(".presets .entry-about").first).to_contain_text("liquid")
    page.get_by_label("Kind of data").select_option("spectrum")
    expect(page.locator(".presets tbody tr").first).to_be_visible()
    page.locator(".presets .sort", has_text=re.compile("^n$")).click()
    expect(page.locator("th.c-n")).to_have_attribute("aria-sort", "ascending")
    read = "cells => cells.map(c => parseFloat(c.textContent))"
    values = page.locator(".presets td.c-n").evaluate_all(read)
    assert values == sorted(values)
    page.locator(".presets .sort", has_text=re.compile("^n$")).click()
    expect(page.locator("th.c-n")).to_have_attribute("aria-sort", "descending")
    values = page.locator(".presets td.c-n").evaluate_all(read)
    assert values == sorted(values, reverse=True)
    assert link(page) == {
        "view": "materials",
        "category": "liquid",
        "of_kind": "spectrum",
        "list_by": "n",
        "list_order": "down",
    }


def test_arrow_keys_walk_through_the_table(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.locator("#find").focus()
    page.keyboard.press("ArrowDown")
    expect(page.locator('tr[data-id="Au"] .entry')).to_be_focused()
    page.keyboard.press("ArrowDown")
    expect(page.locator(".material-name")).to_have_text("Copper")
    expect(page.locator('tr[data-id="Cu"] .entry')).to_be_focused()
    page.keyboard.press("End")
    expect(page.locator(".presets tbody tr").last).to_have_attribute("data-chosen", "")
    expect(page.locator(".presets tbody tr").last).to_be_in_viewport()
    page.keyboard.press("Home")
    expect(page.locator(".material-name")).to_have_text("Silver")
    page.keyboard.press("ArrowUp")
    expect(page.locator("#find")).to_be_focused()
    assert page.locator('.presets .entry[tabindex="0"]').count() == 1
    assert link(page)["preset"] == "Ag"


def test_copper_of_shirley_is_one_click_away(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_role("button", name="Copper at 400 to 800 nm").click()
    expect(page.locator(".material-name")).to_have_text("Copper")
    expect(page.locator("#nm")).to_have_value("400, 500, 600, 700, 800")
    expect(lines(page, "angles")).to_have_count(5)
    expect(page.locator(".angles .plot")).to_have_attribute("aria-label", re.compile("Copper"))
    for nm in (400, 500, 600, 700, 800):
        expect(page.locator(".angles .plot-label", has_text=f"{nm} nm")).to_be_attached()
    strokes = lines(page, "angles").evaluate_all("all => all.map(e => e.style.stroke)")
    assert len(set(strokes)) == 5
    name, data = saved(page, "angles", "CSV")
    assert name == "Cu-R-theta.csv"
    table = list(csv.reader(io.StringIO(data.decode())))
    assert table[0] == ["theta_i_deg", *(f"R_{nm}nm" for nm in (400, 500, 600, 700, 800))]
    normal = [float(value) for value in table[1][1:]]
    assert normal == sorted(normal)
    assert 0.4 < normal[0] < 0.55
    assert normal[-1] > 0.95


@pytest.mark.parametrize(
    ("example", "name", "value"),
    [
        ("Glass: one float will do", "N-BK7 (Schott)", "1.5168"),
        ("Gold: it takes RGB", "Gold", "0.224436"),
    ],
)
def test_two_schlicks_stand_side_by_side(
    quiet_page: Page, example: str, name: str, value: str
) -> None:
    page = opened(quiet_page, "&preset=Cu")
    page.get_by_role("button", name=example).click()
    expect(page.locator(".material-name")).to_have_text(name)
    halves = page.locator(".two-schlicks .half")
    expect(halves.nth(0).locator("h3")).to_contain_text(f"n = {value}")
    expect(halves.nth(0).locator("path.js-line")).to_have_count(4)
    expect(halves.nth(1).locator("path.js-line")).to_have_count(6)
    expect(page.locator(".two-schlicks")).to_be_in_viewport()
    expect(page.locator(".color-errors tbody tr")).to_have_count(3)


def test_rivals_are_a_band_with_names(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(
        page.locator(".spectrum .shapelayer path, .spectrum .layer-below path").first
    ).to_be_attached()
    expect(page.locator(".spectrum .hint")).to_contain_text(
        "Johnson, McPeak, Babar, Olmon-sc, Hagemann"
    )
    expect(page.locator(".rival-list .rivals tbody tr")).to_have_count(6)
    choose(page, ".spectrum", "R at 0°")
    expect(lines(page, "spectrum")).to_have_count(6)
    expect(page.locator(".spectrum .plot-legend")).to_contain_text("Johnson")
    choose(page, ".spectrum .several", "rivals")
    expect(lines(page, "spectrum")).to_have_count(1)
    page.locator(".rival", has_text="Gold (Johnson)").click()
    expect(page.locator(".material-name")).to_have_text("Gold (Johnson)")


def test_the_wavelength_axis_is_linear_or_logarithmic(quiet_page: Page) -> None:
    page = opened(quiet_page, "&reach=all")
    before = lines(page, "spectrum").first.get_attribute("d")
    choose(page, ".spectrum", "log")
    page.wait_for_function(
        "before => document.querySelector('.spectrum path.js-line').getAttribute('d') !== before",
        arg=before,
    )
    expect(page.locator(".spectrum .xtick text", has_text="1000").first).to_be_attached()
    expect(page.locator(".spectrum .plot-mark-name", has_text="24.9").first).to_be_attached()
    assert link(page)["lambda_axis"] == "log"


def test_a_wavelength_out_of_range_is_answered_in_place(page: Page) -> None:
    opened(page, "&preset=diamond")
    page.locator("#at-nm").fill("900")
    page.locator("#at-nm").press("Enter")
    expect(page.locator("#at-nm-error")).to_contain_text(re.compile(r"900.*to 760 nm"))
    expect(number(page, "n")).to_have_text("2.41748")
    page.locator("#nm").fill("500, 5000")
    page.locator("#nm").press("Enter")
    expect(page.locator(".angles [role=alert]").last).to_contain_text(
        re.compile(r"5000.*to 760 nm")
    )
    assert lines(page, "angles").count() == 4
    assert page.locator(".notice").count() == 0
    page.locator("#nm").fill("blue")
    page.locator("#nm").press("Enter")
    expect(page.locator("#nm-error")).to_contain_text("blue")
    # What the next material is not known at is let go.
    page.locator('tr[data-id="Au"]').click()
    expect(page.locator("#at-nm-error")).to_be_empty()
    assert "nm" not in link(page) or link(page)["nm"] == "500,5000"


def test_reading_at_another_wavelength(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.locator("#at-nm").fill("450")
    page.locator("#at-nm").press("Enter")
    answer = page.request.get("/api/v1/materials/Au?wavelength_nm=450").json()["constants"]
    expect(number(page, "k")).to_have_text(f"{answer['k']:.5f}")
    handle = page.locator(".spectrum .plot-handle")
    expect(handle).to_have_text("450 nm")
    handle.focus()
    page.keyboard.press("ArrowRight")
    expect(page.locator("#at-nm")).to_have_value("455")
    assert link(page)["at_nm"] == "455"


def test_map_goes_to_an_angle_and_a_wavelength(quiet_page: Page) -> None:
    page = opened(quiet_page)
    cross = page.locator(".lambda-map [role=slider]")
    cross.focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("ArrowRight")
    expect(cross).to_have_attribute("aria-valuetext", re.compile("λ 588 nm|λ 590 nm"))
    page.keyboard.press("Enter")
    expect(page).to_have_url(re.compile(r"at_nm=\d+"))
    choose(page, ".lambda-map", "p")
    expect(page.locator(".lambda-map .plot")).to_have_attribute(
        "aria-label", re.compile("^Rₚ of Gold")
    )


def test_a_single_index_shows_what_it_has(quiet_page: Page) -> None:
    page = opened(quiet_page, "&preset=garnet-wloka")
    expect(page.locator(".material-name")).to_have_text("Garnet")
    expect(number(page, "k")).to_have_text("not given")
    expect(page.locator('tr[data-id="garnet-wloka"] .c-n')).to_have_text("1.73–1.89")
    expect(page.locator(".sheet.angles")).to_be_hidden()
    expect(page.locator(".two-schlicks .half").nth(1)).to_be_hidden()
    expect(page.locator(".origin .warning").first).to_be_visible()


def test_a_link_reproduces_the_view(quiet_page: Page) -> None:
    query = (
        "&preset=Cu&find=copper&list_by=k&list_order=down&at_nm=500&nm=450,650&plot_of=F0"
        "&reach=all&lambda_axis=log&map_of=Rp&gamut=clamped&illuminant=E&theta_i_deg=70"
    )
    page = opened(quiet_page, query)
    expect(page.locator(".material-name")).to_have_text("Copper")
    expect(page.locator("#find")).to_have_value("copper")
    expect(page.locator("#at-nm")).to_have_value("500")
    expect(page.locator("#nm")).to_have_value("450, 650")
    expect(lines(page, "angles")).to_have_count(2)
    expect(page.locator("#calls")).to_contain_text("illuminant=E")
    expect(page.locator(".angles .plot-handle")).to_have_text("70.00°")
    expect(page.locator("th.c-k")).to_have_attribute("aria-sort", "descending")
    expect(page.locator(".notice")).to_have_count(0)


def test_a_link_to_an_unknown_preset_says_so(quiet_page: Page) -> None:
    page = opened(quiet_page, "&preset=unobtainium")
    expect(page.locator(".notice")).to_contain_text("preset = unobtainium: it is none of the")
    expect(page.locator(".material-name")).to_have_text("Gold")


def test_the_material_of_the_other_views_is_shown_until_one_is_chosen(quiet_page: Page) -> None:
    page = opened(quiet_page, "&material=Cu")
    name = page.locator(".material-name")
    expect(name).to_have_text("Copper")
    expect(page.locator('.presets [aria-pressed="true"]')).to_contain_text("Copper")
    page.get_by_role("button", name="Gold: it takes RGB").click()
    expect(name).to_have_text("Gold")
    assert link(page) == {"view": "materials", "material": "Cu", "preset": "Au"}


def test_numbers_are_copied_in_full(quiet_page: Page) -> None:
    quiet_page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page = opened(quiet_page)
    number(page, "n").click()
    assert page.evaluate("() => navigator.clipboard.readText()") == "0.22443599999999997"
    number(page, "sRGB").click()
    assert page.evaluate("() => navigator.clipboard.readText()") == "#ffe09a"
    page.get_by_role("button", name="Copy F0, three numbers").click()
    copied = page.evaluate("() => navigator.clipboard.readText()")
    assert float(copied.split(", ")[0]) == 1.0
    page.get_by_role("button", name="copy citation").click()
    assert "10.1103/PhysRevB.86.235147" in page.evaluate("() => navigator.clipboard.readText()")


@pytest.mark.parametrize("view", ["explore", "compare"])
def test_goes_to_other_views_with_the_material(quiet_page: Page, view: str) -> None:
    page = opened(quiet_page, "&preset=Ti")
    page.locator(".uses").get_by_text(view.capitalize(), exact=True).click()
    page.locator(f".view-{view} path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    assert link(page).get("material") == "Ti"
    page.go_back()
    expect(page.locator(".material-name")).to_have_text("Titanium")


@pytest.mark.parametrize(
    ("figure", "start"), [("spectrum", b"wavelength_nm,n,k"), ("lambda-map", b"theta_i_deg")]
)
def test_figures_are_saved(quiet_page: Page, figure: str, start: bytes) -> None:
    page = opened(quiet_page)
    expect(page.locator(f".{figure} .plot-area svg.main-svg").first).to_be_attached()
    _, data = saved(page, figure, "CSV")
    assert data.startswith(start)
    _, data = saved(page, figure, "SVG")
    assert b"<svg" in data
    _, data = saved(page, figure, "PNG")
    assert data.startswith(b"\x89PNG")
    page.locator(f".{figure} summary").click()
    expect(page.locator(f".{figure} .curve-table tbody tr").nth(5)).to_be_visible()


@pytest.mark.parametrize("width", [390, 641, 901, 1000, 1179, 1180, 1440])
def test_no_column_of_the_catalog_covers_another(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 800})
    opened(page)
    covered = page.evaluate(
        """() => {
          const range = document.createRange();
          const drawn = (cell) => {
            range.selectNodeContents(cell);
            return { words: cell.textContent, ...range.getBoundingClientRect().toJSON() };
          };
          return [...document.querySelectorAll(".presets tr")].flatMap((row) => {
            const cells = [...row.querySelectorAll(".sort, .entry-name, td")].map(drawn);
            const shown = cells.filter(({ width }) => width > 0);
            return shown
              .slice(1)
              .map((cell, i) => [shown[i], cell])
              .filter(([left, right]) => left.right > right.left)
              .map(([left, right]) => `${left.words} | ${right.words}`);
          });
        }"""
    )
    assert covered == []


def test_loads_when_it_is_asked_for(page: Page) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.goto("/")
    page.locator(".view-explore path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    assert not [url for url in asked if "/materials/" in url or "materials.css" in url]
    page.get_by_role("link", name="Materials").click()
    page.locator(".presets tbody tr").first.wait_for(timeout=READY_MS)
    assert any("materials.css" in url for url in asked)


def test_a_failing_server_keeps_the_last_picture(page: Page) -> None:
    opened(page)

    def fail(route: Any) -> None:
        problem = {
            "title": "Internal Server Error",
            "status": 500,
            "detail": "try later",
            "errors": [],
        }
        route.fulfill(status=500, content_type="application/problem+json", body=json.dumps(problem))

    page.route("**/api/v1/materials/Cu/map*", fail)
    page.locator('tr[data-id="Cu"]').click()
    expect(page.locator(".lambda-map [role=alert]")).to_have_text("try later")
    expect(page.locator(".material-name")).to_have_text("Copper")
    expect(page.locator(".lambda-map svg.main-svg").first).to_be_attached()


@pytest.mark.parametrize("width", [320, 390, 768, 1024, 1440])
def test_no_horizontal_scroll(quiet_page: Page, width: int) -> None:
    quiet_page.set_viewport_size({"width": width, "height": 844})
    page = opened(quiet_page)
    expect(lines(page, "angles")).to_have_count(5)
    assert page.evaluate("() => document.documentElement.scrollWidth") == width


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1440])
def test_axe_finds_nothing(quiet_page: Page, theme: str, width: int) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    quiet_page.set_viewport_size({"width": width, "height": 900})
    page = opened(quiet_page, "&preset=Cu&find=c")
    expect(lines(page, "angles")).to_have_count(5)
    for summary in page.locator(".sheet summary").all():
        summary.click()
    page.evaluate(AXE.read_text(encoding="utf-8"))
    result = page.evaluate("() => axe.run(document)")
    found = [(v["id"], [node["target"] for node in v["nodes"]][:5]) for v in result["violations"]]
    assert found == []


def test_a_material_is_taken_to_an_engine(quiet_page: Page) -> None:
    page = opened(quiet_page, "&preset=Cr")
    panel = page.locator(".sheet.take")
    expect(panel).to_contain_text("Metallic BSDF, Physical Conductor")
    expect(panel.locator(".parameters th")).to_have_text(["IOR", "Extinction", "Roughness"])
    choose(page, ".sheet.take", "F82 tint")
    expect(panel).to_contain_text("by the model f82_tint, as measured in cycles")
    choose(page, ".sheet.take", "glTF")
    expect(panel).to_contain_text(re.compile(r"Largest error 0\.2\d* at 83"))
    assert link(page)["use_in"] == "gltf"
    assert "use_mode" not in link(page)
    with page.expect_download() as waiting:
        panel.get_by_role("button", name="save Cr.gltf").click()
    document = json.loads(Path(waiting.value.path()).read_bytes())
    assert document["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] == 1


def test_what_an_engine_cannot_take_is_said(page: Page) -> None:
    opened(page, "&preset=Au&use_in=gltf&gamut=unclamped")
    panel = page.locator(".sheet.take")
    expect(panel.get_by_role("alert")).to_contain_text("clamped or scaled for to = gltf")
    choose(page, ".sheet.take", "OpenPBR")
    expect(panel.locator(".row-error")).to_be_empty()
    expect(panel).to_contain_text("open_pbr_surface, metal")


def test_gold_under_a_coat_and_under_water(quiet_page: Page) -> None:
    page = opened(quiet_page, "&preset=Au")
    panel = page.locator(".sheet.covered")
    expect(panel.get_by_role("row", name="coat and material together")).to_be_visible()
    told = page.request.get("/api/v1/materials/Au/covered?gamut=scaled").json()
    shortcuts = panel.get_by_role("region", name="Shortcuts for a coat").locator("tbody tr")
    expect(shortcuts).to_have_count(len(told["shortcuts"]))
    index = panel.get_by_role("textbox")
    index.fill("1.33")
    index.press("Enter")
    choose(page, ".sheet.covered", "a medium")
    expect(panel.get_by_role("row", name="seen from the medium")).to_be_visible()
    expect(shortcuts).to_have_count(0)
    assert (link(page)["cover"], link(page)["cover_n"]) == ("medium", "1.33")
    index.fill("0.5")
    index.press("Enter")
    expect(index).to_have_attribute("aria-invalid", "true")
    expect(panel.get_by_text("“0.5”: allowed is 1 to 4")).to_be_visible()
    index.fill("1,4")
    index.press("Enter")
    choose(page, ".sheet.covered", "a coat")
    assert link(page)["cover_n"] == "1.4"
    index.fill("1")
    index.press("Enter")
    expect(panel).to_contain_text("A coat of index 1 is none")
