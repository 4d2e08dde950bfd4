"""Media by name, at a wavelength, and in white light: what Explore, Compare and Albedo share."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.explore_page import READY_MS, box, link, number, opened, settled_link

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"


def constants(page: Page, preset: str, wavelength_nm: float) -> tuple[float, float]:
    """Ask the server what a preset is against vacuum at a wavelength."""
    answer = page.request.get(f"/api/v1/materials/{preset}?wavelength_nm={wavelength_nm}").json()
    return answer["constants"]["n_absolute"], answer["constants"]["k"]


def test_media_are_found_by_typing(quiet_page: Page) -> None:
    page = opened(quiet_page)
    field = page.get_by_label("Second medium")
    field.click()
    expect(field).to_have_attribute("aria-expanded", "true")
    expect(page.get_by_role("group", name="Glass")).to_be_attached()
    field.fill("gold")
    options = page.get_by_role("option")
    expect(options.first).to_contain_text("Gold")
    expect(options.first).to_have_attribute("aria-selected", "true")
    field.press("ArrowDown")
    expect(options.nth(1)).to_have_attribute("aria-selected", "true")
    field.press("ArrowUp")
    field.press("Enter")
    expect(page).to_have_url(re.compile("material=Au"))
    expect(page.get_by_role("listbox")).to_have_count(0)
    field.fill("dimond")
    expect(options.first).to_contain_text("Diamond")
    field.press("Escape")
    expect(field).to_have_value(re.compile("^Gold"))


@pytest.mark.parametrize("view", ["explore", "compare", "albedo", "preview"])
@pytest.mark.parametrize("text", ["aurum", "Slovick"])
def test_media_are_found_by_other_names_and_authors(quiet_page: Page, text: str, view: str) -> None:
    page = quiet_page
    page.goto(f"/?view={view}")
    field = page.locator(f".view-{view}").get_by_label("Second medium")
    field.click()
    field.press_sequentially(text)
    expect(page.locator(".media-list [role=option]").first).to_contain_text("Gold")
    field.press("Enter")
    settled_link(page, "material", "Au")


def test_an_absorbing_medium_cannot_be_in_front(quiet_page: Page) -> None:
    page = opened(quiet_page)
    field = page.get_by_label("Incident medium")
    field.fill("gold")
    expect(page.get_by_role("option").first).to_have_attribute("aria-disabled", "true")
    field.press("Enter")
    field.press("Escape")
    assert "incident" not in link(page)


def test_a_wavelength_moves_a_dispersive_medium(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=SF11")
    n, _ = constants(page, "SF11", 450)
    field = box(page, "wavelength_nm")
    field.fill("450")
    field.press("Enter")
    expect(page.locator("#n_t-box")).to_have_value(f"{n:.6g}")
    expect(page.locator("#calls")).to_contain_text(f"n_t={n!r}")
    expect(page.locator(".diagram-host")).to_contain_text("N-SF11")
    assert link(page) == {"material": "SF11", "wavelength_nm": "450"}
    expect(page.get_by_label("Second medium")).to_have_value(re.compile("N-SF11"))


def test_a_link_to_a_wavelength_reproduces_the_numbers(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=Au&wavelength_nm=500&theta_i_deg=0")
    n, k = constants(page, "Au", 500)
    expect(page.locator("#n_t-box")).to_have_value(f"{n:.6g}")
    expect(page.locator("#k_t-box")).to_have_value(f"{k:.6g}")
    expect(page.locator("#calls")).to_contain_text(f"k_t={k!r}")
    expect(page.locator(".notice")).to_have_count(0)


def test_a_wavelength_beyond_the_data_is_answered_in_place(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=diamond")
    field = box(page, "wavelength_nm")
    field.fill("900")
    field.press("Enter")
    expect(page.locator(".wavelength [role=alert]").last).to_have_text(
        re.compile(r"λ = 900.nm: known .*760.nm")
    )
    expect(page.locator(".notice")).to_have_count(0)
    field.fill("")
    field.press("Enter")
    expect(page.locator(".wavelength [role=alert]").last).to_be_empty()


def test_single_indices_have_no_wavelength(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=diamond-shirley")
    expect(page.locator(".wavelength")).to_be_hidden()


def test_faint_absorption_of_glass_is_left_out_and_said(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=BK7")
    expect(page.locator(".media .reason").first).to_have_text("k < 10⁻⁶ is left out.")
    expect(number(page, "brewster")).to_have_text("56.61°")
    expect(page.get_by_role("button", name="Swap the media")).to_have_attribute(
        "aria-disabled", "false"
    )


def test_white_light_is_spread_by_glass(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=SF11")
    page.get_by_label("white light").click()
    rays = page.locator(".ray-fan line")
    expect(rays).to_have_count(7, timeout=READY_MS)
    expect(page.locator(".spread-ray")).to_have_count(7)
    expect(page.locator(".spread-text")).to_have_text(
        re.compile(r"400 nm at 29\.1\d°, 700 nm at 30\.4\d°: 1\.3\d\d° apart")
    )
    strokes = rays.evaluate_all("all => all.map(e => getComputedStyle(e).stroke)")
    assert len(set(strokes)) == 7
    feet = rays.evaluate_all("all => all.map(e => Number(e.getAttribute('x2')))")
    assert feet == sorted(feet)
    expect(page.locator("#calls")).to_contain_text("wavelength_nm=400")
    assert link(page)["light"] == "white"


def test_white_light_from_inside_is_partly_reflected(quiet_page: Page) -> None:
    page = opened(quiet_page, "?incident=SF11&n_t=1&light=white&theta_i_deg=33.6")
    expect(page.locator(".spread-text")).to_contain_text(
        re.compile(r"\d of 7 wavelengths are totally reflected"), timeout=READY_MS
    )


def test_white_light_without_a_spectrum_says_what_to_do(quiet_page: Page) -> None:
    page = opened(quiet_page, "?light=white")
    expect(page.locator(".spread-text")).to_contain_text("name a medium")


@pytest.mark.parametrize("view", ["compare", "albedo"])
def test_other_views_take_the_wavelength_too(quiet_page: Page, view: str) -> None:
    page = quiet_page
    page.goto(f"/?view={view}&material=SF11&wavelength_nm=450")
    n, _ = constants(page, "SF11", 450)
    expect(page.locator(f"#{view}-n_t-box")).to_have_value(f"{n:.6g}", timeout=READY_MS)
    expect(page.locator(f"#{view}-wavelength_nm-box")).to_have_value("450")


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_nothing(quiet_page: Page, theme: str) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    page = opened(quiet_page, "?material=SF11&light=white")
    expect(page.locator(".spread-ray")).to_have_count(7, timeout=READY_MS)
    page.get_by_label("Second medium").click()
    page.evaluate(AXE.read_text(encoding="utf-8"))
    result = page.evaluate("() => axe.run(document)")
    found = [(v["id"], [node["target"] for node in v["nodes"]][:5]) for v in result["violations"]]
    assert found == []
