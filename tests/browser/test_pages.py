"""Pages of refractiveindex.info in lists of media and in Materials, and one's own beside others."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.explore_page import opened

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
KEPT = """async () => {
  const data = new DataTransfer();
  data.items.add(new File(["nm,n,k\\n400,1.5,2.0\\n700,0.3,4.0\\n"], "film.csv"));
  for (const kind of ["dragenter", "dragover", "drop"]) {
    window.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    await new Promise((go) => setTimeout(go, 1500));
  }
}"""


def test_a_page_is_found_by_keys_and_its_link_shows_it_elsewhere(
    quiet_page: Page, browser: Browser, base_url: str
) -> None:
    page = opened(quiet_page)
    field = page.get_by_label("Second medium")
    field.click()
    field.fill("SF6")
    options = page.locator(".media-list [role=option]")
    expect(options.nth(0)).to_contain_text("SF6 (SCHOTT)")
    expect(options.nth(1)).to_contain_text("SF6 (HIKARI)")
    expect(options.nth(2)).to_contain_text("Sulphur hexafluoride")
    expect(options.nth(2)).to_contain_text("main/SF6/Vukovic")
    expect(options.nth(2)).to_have_attribute("title", re.compile("Vukovic"))
    field.press("ArrowDown")
    expect(options.nth(1)).to_have_attribute("aria-selected", "true")
    field.press("Enter")
    expect(page).to_have_url(re.compile("material=rii%3Aspecs%2FHIKARI-optical%2FSF6$"))
    expect(field).to_have_value(re.compile(r"^SF6 \(HIKARI\)"))
    said = page.get_by_text(re.compile("% reflected")).first
    other = browser.new_context(base_url=base_url, service_workers="block").new_page()
    other.goto(page.url)
    expect(other.get_by_label("Second medium")).to_have_value(re.compile(r"^SF6 \(HIKARI\)"))
    expect(other.get_by_text(re.compile("% reflected")).first).to_have_text(said.inner_text())
    other.context.close()


@pytest.mark.parametrize(
    ("link", "words"),
    [("main/Si/Daub", "this page has k alone"), ("main/Ag/Johnsen", "main/Ag/Johnson")],
)
def test_a_link_to_a_page_that_is_none_says_what_the_server_says(
    page: Page, link: str, words: str
) -> None:
    """The browser notes the refusal on its console, so the page is not quiet."""
    page.goto(f"/?material=rii:{link}")
    expect(page.get_by_role("alert").filter(has_text="not valid")).to_contain_text(words)


def test_what_history_names_is_brought_after_a_reload(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?material=rii:main/SF6/Vukovic")
    field = page.get_by_label("Second medium")
    expect(field).to_have_value(re.compile("^SF6 .Sulphur"))
    field.click()
    field.fill("SF6")
    expect(page.locator(".media-list [role=option]").nth(1)).to_contain_text("SCHOTT")
    field.press("ArrowDown")
    field.press("Enter")
    expect(page).to_have_url(re.compile("SCHOTT-optical%2FSF6$"))
    page.reload()
    expect(field).to_have_value(re.compile(r"^SF6 \(SCHOTT\)"))
    page.go_back()
    expect(field).to_have_value(re.compile("^SF6 .Sulphur"))


def test_presets_come_before_pages(quiet_page: Page) -> None:
    page = opened(quiet_page)
    field = page.get_by_label("Second medium")
    field.click()
    field.fill("gold")
    rows = page.locator(".media-list > li")
    expect(rows.filter(has_text="refractiveindex.info").first).to_be_attached()
    texts = rows.all_inner_texts()
    heading = texts.index("REFRACTIVEINDEX.INFO")
    assert texts[0].startswith("Gold\n")
    assert not any("main/Au/" in text for text in texts[:heading])
    assert "main/Au/" in texts[heading + 1]
    assert texts[-1].startswith("Your own")


def test_materials_finds_pages_and_says_which_are_refused(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=materials")
    page.locator("#find").fill("AgGaSe2")
    expect(page.locator(".browser-head .count")).to_have_text("0 of 192 presets, 5 pages")
    page.get_by_text("One more page fits").click()
    expect(page.locator(".refused")).to_contain_text("an odd number for formula 2")
    page.locator(".presets .entry").first.click()
    expect(page.locator(".material-name")).to_contain_text("AgGaSe2")
    expect(page.locator(".material-about")).to_contain_text("main/AgGaSe2/")
    expect(page.locator(".origin")).to_contain_text("temperature 294 K")
    # Nothing of it is in the visible: all that is known is shown, and wavelengths where it is.
    expect(page.locator("#nm")).to_have_value(re.compile("^810, "))
    page.locator(".rivals .rival").first.click()
    expect(page).to_have_url(re.compile("preset=rii%3Amain%2FAgGaSe2%2FHarasaki-o"))
    expect(page.locator(".material-name")).to_contain_text("Harasaki")


def test_one_s_own_is_listed_and_has_another_s_band_beside_it(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.evaluate(KEPT)
    page.get_by_role("dialog").get_by_role("button", name="Open in Materials").click()
    expect(page.locator(".browser-head .count")).to_have_text("192 presets, 1 of yours")
    first = page.locator(".presets .entry").first
    expect(first).to_contain_text("film")
    expect(first).to_contain_text("your own")
    beside = page.get_by_label("Another material beside it")
    beside.click()
    beside.fill("Au")
    expect(page.locator(".media-list [role=option]").first).to_contain_text("Gold")
    beside.press("Enter")
    expect(page).to_have_url(re.compile("beside=Au"))
    expect(page.locator(".sheet.spectrum")).to_contain_text("in the band of 6 measurements")
    page.reload()
    expect(page.locator(".sheet.spectrum")).to_contain_text("in the band of 6 measurements")
    expect(page.locator(".presets .entry").first).to_contain_text("film")
    page.locator("#find").fill("film")
    expect(page.locator(".browser-head .count")).to_contain_text("1 of yours")
    page.get_by_role("button", name="alone", exact=True).click()
    expect(page.locator(".sheet.spectrum")).not_to_contain_text("in the band")


def test_a_layer_is_a_page_or_one_s_own(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films")
    medium = page.get_by_label("Medium of the layer")
    medium.fill("silver johnson")
    expect(page.locator('#film-media option[value="rii:main/Ag/Johnson"]')).to_be_attached()
    medium.fill("rii:main/Ag/Johnson")
    medium.press("Enter")
    expect(page).to_have_url(re.compile("layers=rii%3Amain%2FAg%2FJohnson%3A"))
    expect(page.locator(".film-list button").first).to_contain_text("Ag/Johnson")
    page.get_by_role("button", name="your own…").click()
    sheet = page.get_by_role("dialog", name="Your own material")
    pasted = sheet.get_by_label("or a table, pasted")
    pasted.fill("nm,n,k\n400,1.5,0.1\n800,1.4,0.1\n")
    pasted.press("Tab")
    sheet.get_by_role("button", name="Use as the layer").click()
    expect(page).to_have_url(re.compile("layers=own%3A"))
    expect(page.locator(".film-list button").first).to_contain_text("your own")


def test_axe_finds_nothing_in_lists_with_pages(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=materials&find=AgGaSe2&preset=rii:main/AgGaSe2/Kato-o&beside=Au")
    page.get_by_text("One more page fits").click()
    expect(page.locator(".sheet.spectrum")).to_contain_text("Dotted: Gold")
    page.evaluate(AXE.read_text("utf-8"))
    found = page.evaluate("() => axe.run('.view-materials')")
    assert [one["id"] for one in found["violations"]] == []
    beside = page.get_by_label("Another material beside it")
    beside.click()
    beside.fill("ice")
    expect(page.locator(".media-list")).to_contain_text("main/H2O/Warren-2008")
    found = page.evaluate("() => axe.run('.beside-row')")
    assert [one["id"] for one in found["violations"]] == []
