"""The Engines view: what an engine reflects, beside the exact curve."""

import re

import pytest
from playwright.sync_api import Page, expect


def test_an_engine_and_a_medium_are_chosen_and_stand_in_the_link(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=engines")
    rows = page.locator(".ways tbody tr")
    expect(rows).to_have_count(1)
    page.get_by_label("Engine", exact=True).select_option("cycles")
    page.get_by_label("Medium", exact=True).select_option("chromium")
    expect(rows).to_have_count(3)
    expect(rows.filter(has_text="Physical Conductor")).to_contain_text("Fresnel")
    expect(page).to_have_url(re.compile("engine=cycles&measured=chromium"))
    page.reload()
    expect(rows).to_have_count(3)


def test_departures_are_told_with_what_was_measured(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=engines&engine=playcanvas")
    expect(page.locator(".departures")).to_contain_text("0.040 at 85 degrees")
    page.get_by_label("Engine", exact=True).select_option("mitsuba")
    expect(page.locator(".departures")).to_contain_text("Nowhere by more than the noise")


def test_the_table_of_curves_holds_what_the_server_told(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=engines&engine=three&measured=glass")
    told = page.request.get("/api/v1/engines/three").json()
    (curve,) = (c for c in told["curves"] if (c["medium"], c["light"]) == ("glass", "environment"))
    page.locator("summary", has_text="Curves and errors as tables").click()
    expect(page.locator(".curve-table")).to_have_count(2)  # it is filled as it opens
    last = page.locator(".curve-table").first.locator("tbody tr").last
    cells = last.locator("th, td").all_text_contents()
    assert float(cells[0].rstrip("°")) == told["theta_i_deg"][-1]
    assert float(cells[2]) == pytest.approx(curve["reflectance"][-1][0], rel=1e-4)


def test_an_engine_that_was_not_measured_is_named(page: Page) -> None:
    page.goto("/?view=engines&engine=threee")
    alert = page.get_by_role("alert").filter(has_text="nearest: three")
    expect(alert).to_be_visible()
    alert.get_by_role("button", name="Back to three.js").click()
    expect(page.locator(".ways tbody tr")).to_have_count(1)


def test_a_medium_that_an_engine_was_not_measured_with_is_told(page: Page) -> None:
    page.goto("/?view=engines&measured=jelly")
    alert = page.locator(".view-engines .trouble")
    expect(alert).to_contain_text("jelly was not measured in three.js; glass is shown.")
    page.goto("/?view=engines&measured=gold")
    expect(page.locator(".view-engines .claims")).to_be_visible()
    expect(alert.locator(".row-error")).to_be_empty()
