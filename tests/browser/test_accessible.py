"""What holds in every view: rules of accessibility, names, room from a phone to a wall, paper."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"

# Every view, and every section of those that have sections.
PLACES = {
    "explore": "?view=explore",
    "metal": "?view=explore&material=cu-johnson-christy",
    "compare": "?view=compare",
    "albedo": "?view=albedo",
    "materials": "?view=materials",
    "films": "?view=films&film_model=cycles_film",
    "pane": "?view=films&layers=soda-lime:4000000:incoherent&n_t=1&film_to=10000000",
    "atlas": "?view=atlas&atlas_model=f82_tint&atlas_at=Au",
    "engines": "?view=engines&engine=babylon&measured=gold",
    "preview": "?view=preview",
    "path": "?view=theory",
    "leaf": "?view=theory&step=films&thin_film=gold&thin_nm=50",
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


# All that moves, or would once it were touched.
MOVING = """() => {
  const still = (times) => times.split(",").every((time) => Number.parseFloat(time) === 0);
  const styled = (element) => ["", "::before", "::after"].map((part) =>
    getComputedStyle(element, part || null));
  return [
    ...document.getAnimations().map((animation) => String(animation.effect?.target?.outerHTML)),
    ...[...document.querySelectorAll("*")].filter((element) => styled(element).some((style) =>
      style.animationName !== "none" || !still(style.transitionDuration)
        || style.scrollBehavior === "smooth")).map((element) => element.outerHTML),
  ].map((html) => html.slice(0, 120));
}"""


@everywhere
def test_nothing_moves_by_itself_where_that_is_not_wanted(page: Page, place: str) -> None:
    page.emulate_media(reduced_motion="reduce")
    opened(page, place)
    assert page.evaluate(MOVING) == []


def test_where_it_is_wanted_something_does(page: Page) -> None:
    page.emulate_media(reduced_motion="no-preference")
    opened(page, PLACES["explore"])
    assert page.evaluate(MOVING) != []


def test_numbers_are_copied_with_a_point_whatever_the_language(
    browser: Browser, base_url: str
) -> None:
    context = browser.new_context(
        base_url=base_url,
        locale="de-DE",
        service_workers="block",
        permissions=["clipboard-read", "clipboard-write"],
    )
    try:
        page = opened(context.new_page(), PLACES["explore"])
        assert page.evaluate("() => (1.5).toLocaleString()") == "1,5"
        page.locator('.number[aria-label^="Rs:"]').click()
        read = "() => navigator.clipboard.readText()"
        answer = page.request.get("/api/v1/snell?theta_i_deg=64").json()
        assert float(page.evaluate(read)) == answer["Rs"]
        page.get_by_role("button", name="copy all").click()
        expect(page.get_by_role("button", name="copy all")).to_have_attribute(
            "data-flash", "copied"
        )
        copied = page.evaluate(read)
        assert repr(answer["Rs"]) in copied
        with page.expect_download() as download:
            page.get_by_role("button", name="Save the plot as CSV").click()
        first = download.value.path().read_text(encoding="utf-8").splitlines()[2]
        assert all(float(cell) >= 0 for cell in first.split(",") if cell)
        box = page.locator("#n_t-box")
        box.fill("1.333")
        box.press("Enter")
        expect(box).to_have_value("1.333")
    finally:
        context.close()


def test_letters_of_plots_grow_with_the_window(page: Page) -> None:
    sizes = """() => [".plot-host .xtick text", ".number"].map((found) =>
      Number.parseFloat(getComputedStyle(document.querySelector(found)).fontSize))"""
    page.set_viewport_size({"width": 1280, "height": 800})
    opened(page, PLACES["explore"])
    tick, number = page.evaluate(sizes)
    page.set_viewport_size({"width": 3840, "height": 2160})
    page.wait_for_function(f"(before) => ({sizes})()[0] > before", arg=tick)
    later_tick, later_number = page.evaluate(sizes)
    assert later_number / number > 1.3
    assert abs(later_tick / tick - later_number / number) < 0.02
