"""What holds in every view: rules of accessibility, names, room from a phone to a wall, paper."""

from pathlib import Path

import pytest
from playwright.sync_api import Page

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"

# Every view, and every section of those that have sections.
PLACES = {
    "explore": "?view=explore",
    "metal": "?view=explore&material=cu-johnson-christy",
    "compare": "?view=compare",
    "albedo": "?view=albedo",
    "materials": "?view=materials",
    "preview": "?view=preview",
    "path": "?view=theory",
    "formulas": "?view=theory&section=formulas",
    "claims": "?view=theory&section=claims",
    "traps": "?view=theory&section=traps",
    "mystery": "?view=theory&section=mystery",
    "worksheets": "?view=theory&section=worksheets",
}
everywhere = pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())


def opened(page: Page, place: str) -> Page:
    """Open a place and wait until nothing is on its way any more."""
    page.goto(f"/{place}")
    page.locator(".view:not([hidden])").wait_for()
    page.wait_for_load_state("networkidle")
    page.wait_for_function("() => !document.querySelector('.starting, [data-busy]')")
    return page


@pytest.mark.parametrize("theme", ["light", "dark"])
@everywhere
def test_axe_finds_nothing(page: Page, place: str, theme: str) -> None:
    page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    page.set_viewport_size({"width": 1280, "height": 900})
    opened(page, place)
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("() => axe.run()")
    assert [(v["id"], v["nodes"][0]["html"]) for v in found["violations"]] == []


@everywhere
def test_every_plot_has_a_name_and_its_numbers(page: Page, place: str) -> None:
    opened(page, place)
    nameless = page.evaluate(
        """() => [...document.querySelectorAll(".view:not([hidden]) .plot")]
          .filter((plot) => plot.checkVisibility())
          .filter((plot) => plot.getAttribute("role") !== "figure"
            || !plot.getAttribute("aria-label")
            || [...plot.querySelectorAll("svg.main-svg")]
              .some((svg) => !svg.closest('[aria-hidden="true"]')))
          .map((plot) => plot.outerHTML.slice(0, 200))"""
    )
    assert nameless == []


@pytest.mark.parametrize("width", [320, 3840])
@everywhere
def test_nothing_is_wider_than_the_window(page: Page, place: str, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 568 if width == 320 else 2160})
    opened(page, place)
    wide = page.evaluate("() => document.documentElement.scrollWidth")
    assert wide <= width


@everywhere
def test_targets_are_large_enough_for_a_finger(page: Page, place: str) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    opened(page, place)
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("() => axe.run({ runOnly: { type: 'rule', values: ['target-size'] } })")
    assert [n["html"] for v in found["violations"] for n in v["nodes"]] == []
