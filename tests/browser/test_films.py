"""The Films view: layers that are dragged, their curves and their colors."""

import re
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect


def test_a_film_is_dragged_and_stands_in_the_link(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films&layers=water:330&n_t=1")
    slider = page.get_by_role("slider", name="Thickness of layer 1", exact=True)
    expect(slider).to_have_attribute("aria-valuenow", "330")
    box = slider.bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 20)
    page.mouse.move(x, y + 40)
    page.mouse.up()
    expect(page).to_have_url(re.compile(r"layers=water%3A(3[4-9]|[4-9]\d)\d"))
    nm = float(slider.get_attribute("aria-valuenow") or "nan")
    told = page.request.get(
        f"/api/v1/snell?layers=water:{nm}&n_t=1&wavelength_nm=587.6&theta_i_deg=64"
    ).json()
    shown = page.locator(".film-numbers dd").first
    expect(shown).to_have_text(f"{told['R']:#.6g}")


def test_keys_move_a_thickness_and_one_step_undoes_it(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films&layers=2.3:50,1.38:100")
    slider = page.get_by_role("slider", name="Thickness of layer 2", exact=True)
    slider.focus()
    for _ in range(3):
        page.keyboard.press("ArrowDown")
    page.keyboard.press("Shift+ArrowUp")
    expect(slider).to_have_attribute("aria-valuetext", "1.38, 102.9 nm")
    expect(page).to_have_url(re.compile(r"layers=2.3%3A50,1.38%3A102.9&film_layer=2"))


def test_colors_follow_the_light_that_is_asked_for(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films")
    page.get_by_role("button", name="Gold leaf").click()
    place = page.get_by_role("slider", name="Thickness and angle on the map of colors")
    told = page.request.get("/api/v1/films/color?layers=Au&n_t=1&thickness_nm=50&quantity=T").json()
    (color,) = told["colors"][0]["hex"][0]
    red, green, blue = (int(color[at : at + 2], 16) for at in (1, 3, 5))
    assert green > max(red, blue)
    expect(page.locator(".film-swatch", has_text="transmitted")).to_contain_text(color)
    place.focus()
    page.keyboard.press("ArrowRight")
    expect(page).to_have_url(re.compile(r"layers=Au%3A52"))


def test_layers_are_added_named_and_taken_away(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films&layers=1.38:100")
    page.get_by_role("button", name="add below").click()
    medium = page.get_by_label("Medium of the layer: a material or an index")
    medium.fill("0.055+3.32i")
    medium.press("Enter")
    expect(page).to_have_url(re.compile(r"layers=1.38%3A100,0.055%2B3.32i%3A100"))
    expect(page.locator(".film-numbers dl")).to_contain_text("A")
    page.get_by_role("button", name="remove", exact=True).click()
    expect(page).to_have_url(re.compile(r"layers=1.38%3A100(?!,)"))


def test_titanium_is_colored_by_its_voltage(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films")
    page.get_by_role("button", name="Titanium, anodized").click()
    volts = page.get_by_label("volts, 2.4 nm each, value")
    expect(volts).to_have_value("25")
    volts.fill("50")
    volts.press("Enter")
    expect(page).to_have_url(re.compile(r"layers=2.4%3A120"))


def test_the_lesson_shows_soap_go_black_and_gold_green_from_behind(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=theory&step=films")
    swatch = page.locator(".film-lesson .film-swatch")
    expect(swatch).to_contain_text("120 nm of water")
    page.get_by_role("slider", name="Thickness of layer 1", exact=True).focus()
    for _ in range(11):
        page.keyboard.press("PageUp")
    expect(page.locator(".try").first).to_have_attribute("data-done", "")
    expect(swatch).to_contain_text("10 nm of water")
    page.get_by_role("radio", name="gold leaf, from behind").check()
    told = page.request.get("/api/v1/films/color?layers=Au&n_t=1&thickness_nm=10&quantity=T").json()
    expect(swatch).to_contain_text(told["colors"][0]["hex"][0][0])
    expect(page).to_have_url(re.compile("thin_film=gold&thin_nm=10"))


def test_a_shortcut_stands_beside_what_is_exact(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films&layers=1.33:330")
    page.get_by_label("Shortcut of a renderer").select_option("gltf_iridescence")
    expect(page).to_have_url(re.compile("film_model=gltf_iridescence"))
    told = page.request.get(
        "/api/v1/films/color?layers=1.33&thickness_nm=330&theta_i_deg=64&models=gltf_iridescence"
    ).json()
    _, shortcut = told["colors"]
    shown = page.locator(".film-swatch", has_text="by the shortcut")
    expect(shown).to_contain_text(shortcut["hex"][0][0])
    expect(shown).to_contain_text(f"ΔE {shortcut['delta_e'][0][0]:.3g}")
    expect(page.locator(".film-off")).to_contain_text("in the mean")
    expect(page.get_by_role("figure", name=re.compile("color difference"))).to_be_visible()
    page.get_by_role("button", name="Quarter-wave mirror").click()
    expect(page.locator(".film-beside")).to_contain_text("a stack of several")


@pytest.mark.parametrize("layers", ["unobtainium:5", "BK7:5:incoherent,Au:1e6:incoherent"])
def test_a_layer_that_cannot_be_is_told_with_the_way_back(page: Page, layers: str) -> None:
    page.goto(f"/?view=films&layers={layers}")
    alert = page.get_by_role("alert").filter(has_text="layers")
    expect(alert.first).to_be_visible()
    page.get_by_role("button", name="Back to a coating of glass").click()
    expect(page.locator(".film-numbers dd").first).to_be_visible()


def test_a_pane_stands_beside_what_solar_software_makes_of_it(quiet_page: Page) -> None:
    """Clear glass: two faces let through (1 - R) / (1 + R) of each polarization."""
    page = quiet_page
    page.goto("/?view=films&layers=1.5:4000000:incoherent&n_t=1")
    pane = page.get_by_role("region", name="The pane in solar software")
    expect(pane.locator("path.js-line")).to_have_count(5)
    cos = np.cos(np.radians(np.linspace(0.0, 89.95, 1800)))
    cos_t = np.sqrt(1.0 - (1.0 - cos**2) / 1.5**2)
    Rs = ((cos - 1.5 * cos_t) / (cos + 1.5 * cos_t)) ** 2
    Rp = ((1.5 * cos - cos_t) / (1.5 * cos + cos_t)) ** 2
    T = (1.0 - Rs) / (1.0 + Rs) + (1.0 - Rp) / (1.0 + Rp)
    off = float(np.max(np.abs(1.0 - (1.0 - cos) ** 5 - T / T[0])))
    expect(pane.locator("tr", has_text="Schlick")).to_contain_text(f"{off:.3g} at")
    page.get_by_role("button", name="Soap film").click()
    expect(pane).to_be_hidden()


def test_the_map_of_colors_is_saved(quiet_page: Page, tmp_path: Path) -> None:
    page = quiet_page
    page.goto("/?view=films&layers=1.33:330&film_model=cycles_film")
    expect(page.locator(".film-off")).to_contain_text("in the mean")
    for kind in ("csv", "svg", "png"):
        with page.expect_download() as download:
            page.get_by_role("button", name=f"Save the colors as {kind.upper()}").click()
        download.value.save_as(tmp_path / f"map.{kind}")
    lines = (tmp_path / "map.csv").read_text().splitlines()
    query = "layers=1.33&thickness_nm=0..1000:256&samples=91&models=cycles_film&digits=4"
    asked = page.request.get(f"/api/v1/films/color?{query}&format=csv").text().splitlines()
    assert lines[0] == asked[0]
    assert len(lines) == len(asked) == 1 + 256 * 91
    mine, theirs = (
        dict(zip(of[0].split(","), of[5000].split(","), strict=True)) for of in (lines, asked)
    )
    for name, value in theirs.items():
        assert mine[name] == value or float(mine[name]) == pytest.approx(float(value)), name
    assert "thickness of layer 1 (nm)" in (tmp_path / "map.svg").read_text()
    assert (tmp_path / "map.png").read_bytes().startswith(b"\x89PNG")


def test_a_shortcut_that_nobody_knows_is_told_with_the_way_back(page: Page) -> None:
    page.goto("/?view=films&layers=1.5:100&film_model=nonsense")
    alert = page.get_by_role("alert").filter(has_text="models = nonsense")
    expect(alert).to_be_visible()
    page.get_by_role("button", name="Show the exact colors alone").click()
    expect(page.locator(".film-canvas").first).to_be_visible()
    expect(page.locator(".film-swatch", has_text="reflected")).to_be_visible()
    assert "film_model" not in page.url
    expect(alert).to_have_count(0)


def test_a_film_is_taken_to_an_engine(page: Page) -> None:
    page.goto("/?view=films&layers=1.46:250&material=Si&use_in=gltf")
    panel = page.locator(".take")
    expect(panel).to_contain_text("KHR_materials_iridescence.iridescenceThicknessMaximum")
    told = page.request.get("/api/v1/export?to=gltf&material=Si&layers=1.46:250&format=json").json()
    expect(panel).to_contain_text(f"at {told['error']['at_deg']:g}° in {told['error']['channel']}")
    panel.get_by_label("USD", exact=True).click()
    expect(panel.get_by_role("alert")).to_contain_text("which has no film")
    page.goto("/?view=films&layers=1.46:250,2:50&use_in=openpbr")
    expect(panel.get_by_role("alert")).to_contain_text("Renderers know one film")
