"""The first thirty seconds: what a newcomer is told, where to start, and how far the picture is."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.explore_page import number, opened, settled_link

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
MOST_STOPS = 12


def test_one_sentence_and_four_starters(quiet_page: Page) -> None:
    page = opened(quiet_page)
    intro = page.get_by_role("region", name="Where to start")
    expect(intro).to_contain_text("How much light does a surface reflect")
    for name, key, value in (
        ("Water", "material", "water-shirley"),
        ("Glass", "material", "window-glass-shirley"),
        ("Gold", "material", "Au"),
        ("From below the water", "incident", "water-shirley"),
    ):
        intro.get_by_role("link", name=name, exact=True).click()
        settled_link(page, key, value)
    # 64 degrees are beyond the critical angle of water, 48.6
    expect(number(page, "R")).to_have_text("1")
    intro.get_by_role("link", name=re.compile("first path", re.IGNORECASE)).click()
    expect(page.locator(".view-theory")).to_be_visible()
    expect(intro).to_be_hidden()


def test_it_starts_from_air_to_glass(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(page.get_by_role("combobox", name="Incident medium")).to_have_value(re.compile("^Air"))
    expect(page.get_by_role("combobox", name="Second medium")).to_have_value(re.compile("^Glass"))
    opened(page, "?material=default-shirley")  # links to it still work
    expect(page.locator('[data-notice="link"]')).to_have_count(0)


@pytest.mark.parametrize("width", [390, 1440])
def test_the_picture_is_near_for_the_tab_key(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    opened(page)
    for stops in range(MOST_STOPS + 1):
        page.keyboard.press("Tab")
        if page.evaluate("() => document.activeElement.matches('.diagram-handle')"):
            assert stops <= MOST_STOPS
            return
    pytest.fail(f"after {MOST_STOPS} stops the ray is not reached")


def test_arrows_move_between_the_views(quiet_page: Page) -> None:
    page = opened(quiet_page)
    tab = page.locator('.views [data-view="explore"]')
    tab.focus()
    page.keyboard.press("ArrowRight")
    expect(page.locator('.views [data-view="compare"]')).to_be_focused()
    page.keyboard.press("End")
    page.keyboard.press("Enter")
    expect(page.locator(".view-theory")).to_be_visible()
    page.keyboard.press("ArrowRight")  # there is none behind it
    expect(page.locator('.views [data-view="theory"]')).to_be_focused()
    assert page.locator(".views a[tabindex='0']").count() == 1


def test_arrows_move_between_the_starters(quiet_page: Page) -> None:
    page = opened(quiet_page)
    intro = page.get_by_role("region", name="Where to start")
    intro.get_by_role("link", name="Water", exact=True).focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    settled_link(page, "material", "Au")


@pytest.mark.parametrize("width", [390, 768, 1000, 1024])
def test_all_views_are_shown_at_every_width(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 844})
    opened(page)
    assert page.locator(".views").evaluate("(nav) => nav.scrollWidth <= nav.clientWidth")
    for box in [tab.bounding_box() for tab in page.locator(".views a").all()]:
        assert box
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= width
        assert box["height"] >= 24


def test_a_tap_explains_a_number(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_role("button", name="F0, explained").click()
    meaning = page.locator("#meaning")
    expect(meaning).to_be_visible()
    expect(meaning).to_contain_text("Reflectance head on")
    page.keyboard.press("Escape")
    expect(meaning).to_be_hidden()
    names = page.locator(".term").count()
    assert names == 25
    for name in page.locator(".term").all():
        name.click()
        expect(meaning).not_to_be_empty()


def test_names_are_reached_by_the_arrows(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_role("button", name="R, explained", exact=True).focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_role("button", name="Rs, explained", exact=True)).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("#meaning")).to_contain_text("s-polarized")


def test_approximations_are_folded_with_schlick_first_and_traps_last(quiet_page: Page) -> None:
    page = opened(quiet_page)
    fold = page.locator("details.forms", has_text="Approximations")
    expect(fold).not_to_have_attribute("open", "")
    fold.locator("summary").click()
    titles = fold.locator("label").all_inner_texts()
    assert titles[0] == "Schlick"
    traps = ["(trap)" in title for title in titles]
    assert any(traps)
    assert traps == sorted(traps)


def test_what_plays_is_where_the_pointer_is(quiet_page: Page) -> None:
    page = opened(quiet_page)
    row = page.locator('.row[data-parameter="n_t"]')
    other = page.locator('.row[data-parameter="n_i"]')
    page.mouse.move(0, 0)
    for hidden in (row, other):
        expect(hidden.locator(".play")).to_have_css("opacity", "0")
    row.hover()
    expect(row.locator(".play")).to_have_css("opacity", "1")
    expect(row.locator(".steps")).to_have_css("opacity", "1")
    expect(other.locator(".play")).to_have_css("opacity", "0")
    page.mouse.move(0, 0)
    row.locator(".box").focus()
    expect(row.locator(".play")).to_have_css("opacity", "1")


@pytest.mark.parametrize("width", [390, 1440])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_nothing_in_what_explains(page: Page, theme: str, width: int) -> None:
    page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    page.set_viewport_size({"width": width, "height": 900})
    opened(page)
    page.get_by_role("button", name="F0, explained").click()
    expect(page.locator("#meaning")).to_be_visible()
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("() => axe.run()")
    assert [(v["id"], v["nodes"][0]["html"]) for v in found["violations"]] == []
