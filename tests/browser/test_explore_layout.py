"""The Explore view on every screen, in both themes, and for everybody."""

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.explore_page import READY_MS, opened

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"


@pytest.mark.parametrize("width", [320, 390, 768, 1440])
def test_no_horizontal_scroll(quiet_page: Page, width: int) -> None:
    quiet_page.set_viewport_size({"width": width, "height": 844})
    page = opened(quiet_page, "?models=schlick&show=T,phase")
    assert page.evaluate("() => document.documentElement.scrollWidth") == width


def test_on_a_phone_the_controls_stay_in_reach(quiet_page: Page) -> None:
    quiet_page.set_viewport_size({"width": 390, "height": 844})
    page = opened(quiet_page)
    page.evaluate("() => scrollTo(0, document.body.scrollHeight)")
    slider = page.locator("#theta_i_deg-slider")
    area = slider.bounding_box()
    assert area is not None
    assert 600 < area["y"] < 844
    assert area["height"] >= 24
    expect(page.locator("#n_t-slider")).to_be_hidden()
    page.locator(".opener").click()
    expect(page.locator("#n_t-slider")).to_be_visible()
    expect(page.get_by_label("Second medium")).to_be_visible()


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1440])
def test_axe_finds_nothing(quiet_page: Page, theme: str, width: int) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    quiet_page.set_viewport_size({"width": width, "height": 900})
    page = opened(quiet_page, "?models=schlick,cos_form&show=T,phase&n_t=2&k_t=1")
    assert page.evaluate("() => document.documentElement.dataset.theme") == theme
    page.locator("summary", has_text="Formulas").click()
    page.locator(".definitions .katex").first.wait_for(timeout=READY_MS)
    page.evaluate(AXE.read_text(encoding="utf-8"))
    result = page.evaluate("() => axe.run(document)")
    found = [(v["id"], [node["target"] for node in v["nodes"]][:5]) for v in result["violations"]]
    assert found == []


def test_theme_is_chosen_and_kept(quiet_page: Page) -> None:
    page = opened(quiet_page)
    toggle = page.locator("#theme")
    expect(toggle).to_have_text("Auto")
    toggle.click()
    toggle.click()
    expect(toggle).to_have_text("Dark")
    page.reload()
    assert page.evaluate("() => document.documentElement.dataset.theme") == "dark"


def test_a_phone_on_its_side_shows_the_ray_and_the_plot(page: Page) -> None:
    page.set_viewport_size({"width": 667, "height": 375})
    opened(page)
    sheet = page.locator(".panel").bounding_box()
    assert sheet
    for name in (".diagram-host", ".plot-host"):
        page.locator(name).evaluate("(part) => part.scrollIntoView()")
        part, top = page.locator(name).bounding_box(), page.locator(".top").bounding_box()
        assert part
        assert top
        shown = min(sheet["y"], part["y"] + part["height"]) - max(
            0, part["y"], top["y"] + top["height"]
        )
        assert shown > 200
