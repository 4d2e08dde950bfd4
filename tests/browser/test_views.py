"""The views together: one state, whatever is opened after what."""

import itertools
import re

import pytest
from playwright.sync_api import Page, expect

VIEWS = (
    "explore",
    "compare",
    "albedo",
    "materials",
    "atlas",
    "films",
    "engines",
    "preview",
    "theory",
)

SHARED = """async (views) => {
  const all = async (path) => (await fetch(`/api/v1${path}`)).json();
  const catalog = Object.assign(
    {}, await all('/parameters'), await all('/models'), await all('/materials'));
  const found = {};
  for (const view of views) {
    const { fields } = await import(`/js/views/${view}.js`);
    for (const [key, { default: preset, print, parse }] of Object.entries(fields(catalog)))
      (found[key] ??= []).push([view, `${preset} ${print(preset)} ${parse}`]);
  }
  return found;
}"""


def test_a_key_of_the_state_means_the_same_in_every_view(page: Page) -> None:
    page.goto("/")
    found = page.evaluate(SHARED, list(VIEWS))
    assert {"table_size", "texels", "find", "coat_n"} <= found.keys()
    assert [key for key, told in found.items() if len({meaning for _, meaning in told}) > 1] == []


@pytest.mark.parametrize(
    ("first", "then"),
    list(itertools.permutations(("compare", "materials", "preview", "theory"), 2)),
)
def test_a_view_opens_after_any_other(quiet_page: Page, first: str, then: str) -> None:
    page = quiet_page
    page.goto(f"/?view={first}")
    expect(page.locator(f".view-{first}")).to_be_visible()
    page.locator(f'a[href="?view={then}"]').first.click()
    expect(page.locator(f".view-{then}")).to_be_visible()
    expect(page).to_have_url(re.compile(f"view={then}$"))


@pytest.mark.parametrize("part", ["views/compare.js", "compare/plots.js"])
def test_a_view_whose_script_fails_to_load_says_so_and_can_be_tried_again(
    page: Page, part: str
) -> None:
    page.route(f"**/js/{part}", lambda route: route.abort(), times=1)
    page.goto("/")
    expect(page.locator(".view-explore")).to_be_visible()
    page.get_by_role("link", name="Compare", exact=True).click()
    failure = page.get_by_role("alert").filter(has_text="Compare could not be loaded")
    expect(failure).to_be_visible()
    expect(page.locator(".view-explore")).to_be_hidden()
    failure.get_by_role("button", name="Try again").click()
    expect(page.locator(".view-compare")).to_be_visible()
    expect(failure).to_have_count(0)
    expect(page).to_have_url(re.compile(r"view=compare$"))


def test_the_tab_of_a_view_that_failed_to_load_opens_it_as_its_link_says(page: Page) -> None:
    page.route("**/js/views/theory.js", lambda route: route.abort(), times=1)
    page.goto("/?view=theory&step=brewster&n_t=1.7")
    expect(page.get_by_role("alert")).to_contain_text("Theory could not be loaded")
    page.get_by_role("link", name="Explore", exact=True).click()
    expect(page.locator(".view-explore")).to_be_visible()
    expect(page.get_by_role("alert")).to_have_count(0)
    page.go_back()
    expect(page.locator(".view-theory")).to_be_visible()
    expect(page).to_have_url(re.compile(r"view=theory"))
