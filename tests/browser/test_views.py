"""The views together: one state, whatever is opened after what."""

import itertools
import re

import pytest
from playwright.sync_api import Page, expect

VIEWS = ("explore", "compare", "albedo", "materials", "preview", "theory")

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
