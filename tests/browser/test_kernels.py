"""What is drawn while something moves is what the server says at rest, and is drawn without it too."""

import re
from typing import Any

import pytest
from playwright.sync_api import Page, Request, expect

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.exact import exact
from app.optics.registry import default_registry
from app.snippets.snippet import reason_without
from tests.browser.explore_page import number, opened, type_into

TENTH_OF_A_PIXEL = 0.1

CLOSED = [m.id for m in default_registry().values() if reason_without(m) is None]

READ = """async (view) => {
  for (let i = 0; i < 3; i += 1) await new Promise(requestAnimationFrame);
  const numbersOf = (text) => (text ?? "").match(/-?[0-9.]+(e-?[0-9]+)?/g)?.map(Number) ?? [];
  const paths = [...document.querySelectorAll(`.view-${view} .plot-host path.js-line`)];
  const rays = [...document.querySelectorAll(".diagram .ray-shaft")];
  const ends = rays.flatMap((r) => ["x1", "y1", "x2", "y2"].map((a) => Number(r.getAttribute(a))));
  const cells = [...document.querySelectorAll(".numbers .number")];
  return {
    lines: [...paths.map((p) => numbersOf(p.getAttribute("d"))), ends],
    numbers: cells.map((c) => c.textContent),
  };
}"""

MOVE = """([parameter, value]) => {
  const slider = document.querySelector(`#${parameter}-slider`);
  slider.value = value;
  slider.dispatchEvent(new InputEvent("input", {bubbles: true}));
}"""

SETTLE = """(parameter) => document.querySelector(`#${parameter}-slider`)
  .dispatchEvent(new Event("change", {bubbles: true}))"""

ASKED_BY_ADDRESS = """() => performance.getEntriesByType("resource")
  .some(({name}) => name.endsWith("/kernels.js"))"""


def with_kernels(page: Page, query: str) -> Page:
    """Open the page and wait until the formulas are there and nothing is under way."""
    opened(page, query)
    page.wait_for_function(ASKED_BY_ADDRESS)
    page.wait_for_load_state("networkidle")
    return page


def is_answer(url: str) -> bool:
    return "/api/v1/curves" in url or "/api/v1/snell" in url


def assert_same_picture(moving: Any, resting: Any) -> None:
    assert [len(line) for line in moving["lines"]] == [len(line) for line in resting["lines"]]
    assert len(moving["lines"]) > 3
    for drawn, right in zip(moving["lines"], resting["lines"], strict=True):
        off = max((abs(a - b) for a, b in zip(drawn, right, strict=True)), default=0.0)
        assert off < TENTH_OF_A_PIXEL


@pytest.mark.parametrize(
    ("query", "parameter", "value"),
    [
        ("?show=T,phase", "n_t", 2.317),
        ("?n_i=2.4&show=phase", "n_t", 1.213),
        ("?n_i=1.5&n_t=1.2&k_t=0.01&show=phase", "k_t", 0.013),
        ("?k_t=3&models=f82_tint,hoffman_f82,lazanyi2005,generalized_schlick", "n_t", 1.07),
        ("?n_t=0.8&k_t=0.2&show=T", "n_i", 1.61),
        (f"?models={','.join(m for m in CLOSED if m not in ('exact', 'lazanyi2005'))}", "n_t", 1.7),
        ("?models=schlick&schlick.F0=0.1,0.5,0.9", "theta_i_deg", 71.3),
    ],
)
def test_moving_and_resting_differ_by_less_than_a_tenth_of_a_pixel(
    quiet_page: Page, query: str, parameter: str, value: float
) -> None:
    page = with_kernels(quiet_page, query)
    asked: list[str] = []

    def note(request: Request) -> None:
        if is_answer(request.url):
            asked.append(request.url)

    page.on("request", note)
    before = page.evaluate(READ, "explore")
    page.evaluate(MOVE, [parameter, value])
    page.wait_for_timeout(300)  # numbers are written as often as an eye can catch
    moving = page.evaluate(READ, "explore")
    assert moving != before
    assert asked == []
    with page.expect_response(lambda answer: is_answer(answer.url)):
        page.evaluate(SETTLE, parameter)
    page.wait_for_load_state("networkidle")
    resting = page.evaluate(READ, "explore")
    assert asked
    assert_same_picture(moving, resting)
    assert moving["numbers"] == resting["numbers"]


def test_a_model_without_a_formula_here_follows_as_the_server_answers(quiet_page: Page) -> None:
    page = with_kernels(quiet_page, "?models=lut_1d,schlick")
    with page.expect_response(lambda answer: "n_t=2.2" in answer.url):
        page.evaluate(MOVE, ["n_t", 2.2])
    page.wait_for_load_state("networkidle")
    moving = page.evaluate(READ, "explore")
    with page.expect_response(lambda answer: "/snell" in answer.url):
        page.evaluate(SETTLE, "n_t")
    page.wait_for_load_state("networkidle")
    assert_same_picture(moving, page.evaluate(READ, "explore"))


def test_explore_and_compare_draw_any_number_without_the_server(page: Page) -> None:
    with_kernels(page, "?models=schlick")
    before = page.evaluate(READ, "explore")
    page.route("**/api/v1/**", lambda route: route.abort())
    type_into(page, "n_t", "1.9137")
    R = exact(Interface(n_t=1.9137), Incidence.from_degrees(64.0))
    expect(number(page, "R")).to_have_attribute("aria-label", re.compile(f"R: {float(R):.6f}"[:9]))
    notice = page.locator('[data-notice="server"]')
    expect(notice).to_contain_text("does not answer")
    expect(notice).to_contain_text("worked out here")
    after = page.evaluate(READ, "explore")
    assert after["lines"][0] != before["lines"][0]
    page.unroute("**/api/v1/**")
    page.get_by_role("link", name="Compare").click()
    first = page.locator(".view-compare .plot-host path.js-line").first
    first.wait_for(state="attached", timeout=15_000)
    page.wait_for_load_state("networkidle")
    page.route("**/api/v1/**", lambda route: route.abort())
    drawn = page.evaluate(READ, "compare")
    box = page.locator("#compare-n_t-box")
    box.fill("2.2137")
    box.press("Enter")
    expect(notice).to_contain_text("worked out here")
    assert page.evaluate(READ, "compare")["lines"] != drawn["lines"]
