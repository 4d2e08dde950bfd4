"""What is chosen stays chosen, from view to view, and what is said of it."""

import re

from playwright.sync_api import Page, expect

from tests.browser.compare_page import link, row
from tests.browser.compare_page import opened as compared
from tests.browser.explore_page import READY_MS, box, type_into
from tests.browser.explore_page import opened as explored
from tests.browser.preview_page import opened as previewed
from tests.browser.preview_page import rested


def test_models_are_carried_from_view_to_view_by_one_key(quiet_page: Page) -> None:
    page = compared(quiet_page, "&against=lazanyi2005,schlick&n_t=2")  # as links once said it
    expect(row(page, "lazanyi2005")).to_be_visible()
    views = page.get_by_role("navigation", name="Views")
    views.get_by_role("link", name="Explore").click()
    expect(page).to_have_url(re.compile("models=lazanyi2005,schlick"))
    assert "against" not in page.url
    expect(page.locator(".view-explore .forms input:checked")).to_have_count(2, timeout=READY_MS)
    views.get_by_role("link", name="Preview").click()
    model = page.get_by_label("Model on the right")
    expect(model).to_have_value("lazanyi2005", timeout=READY_MS)
    model.select_option("hoffman_f82")
    expect(page).to_have_url(re.compile("models=hoffman_f82,lazanyi2005,schlick"))
    views.get_by_role("link", name="Compare").click()
    expect(row(page, "hoffman_f82")).to_be_visible(timeout=READY_MS)
    assert link(page)["models"] == "hoffman_f82,lazanyi2005,schlick"


def test_a_nudged_index_keeps_its_number_and_is_like_a_medium(quiet_page: Page) -> None:
    page = explored(quiet_page, "?material=water")
    second = page.get_by_label("Second medium")
    expect(second).to_have_value(re.compile("^Water"))
    n = page.evaluate(
        """async () => (await (await fetch("/api/v1/materials/BK7")).json()).n_absolute"""
    )
    type_into(page, "n_t", str(n))
    expect(second).to_have_value(re.compile("^like .*BK7"))
    expect(page.locator(".diagram .ray-medium-name").last).to_contain_text("like")
    assert float(link(page)["n_t"]) == n
    assert "material" not in link(page)
    type_into(page, "n_t", "1,7")
    expect(box(page, "n_t")).to_have_value("1.7")
    expect(second).to_have_value("")


def test_a_metals_color_stands_before_its_single_wavelength(quiet_page: Page) -> None:
    page = compared(quiet_page, "&material=Au")
    color = page.locator(".metal-color")
    expect(color).to_contain_text("Gold in linear sRGB")
    display = page.request.get("/api/v1/materials/Au?gamut=scaled").json()["display"]
    expect(color.locator("tr").first).to_contain_text(display["codes"]["F0"])
    expect(page.locator(".convert .at-nm")).to_have_text("at 587.6\u00a0nm")
    expect(page.locator(".metrics .at-nm")).to_have_text("at 587.6\u00a0nm")
    expect(row(page, "f82_tint")).to_be_visible()
    below = color.bounding_box()
    table = page.locator(".conversions:not(.knobs)").bounding_box()
    assert below
    assert table
    assert below["y"] < table["y"]
    # A metal's models begin with it, in the lists too.
    first = page.locator(".chooser .forms label").first
    expect(first).to_contain_text("F82-tint")
    type_into(page, "compare-k_t", "0")
    expect(first).not_to_contain_text("F82-tint")


def test_a_difference_is_amplified_until_it_shows_and_judged(quiet_page: Page) -> None:
    page = previewed(quiet_page, "&material=Au&see=difference&scene=ball&models=f82_tint")
    status = page.locator(".picture [role=status]")
    expect(status).to_contain_text(re.compile(r"amplified \d+ times, so that something shows"))
    rested(page)
    expect(page.locator(".verdict-line")).to_contain_text("visible side by side")
    expect(page.locator(".counted")).to_contain_text("Smooth surfaces only")
    gain = page.locator("#preview-gain-box")
    gain.fill("3")
    gain.press("Enter")
    expect(status).to_have_text(re.compile("amplified 3 times\\.?"))
    page.get_by_role("button", name="amplify by itself").click()
    expect(status).to_contain_text("so that something shows")
    assert "gain" not in link(page)
