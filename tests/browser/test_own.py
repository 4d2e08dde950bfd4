"""One's own material: a file, a table or a drop becomes a medium, and a link carries it."""

import re
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Browser, Page, expect

from tests.browser.explore_page import opened

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
FILES = Path(__file__).parents[1] / "materials/reading/files"


def sheet_from_picker(page: Page) -> None:
    field = page.get_by_label("Second medium")
    field.click()
    own = page.get_by_role("option", name="Your own")
    expect(own).to_be_attached()
    page.wait_for_load_state("networkidle")  # then the list is what it stays
    field.fill("qqqqqqqq")  # nothing is called so
    expect(page.locator(".media-list [role=option]")).to_have_count(1)
    field.press("ArrowDown")
    expect(own).to_have_attribute("aria-selected", "true")
    field.press("Enter")
    expect(page.get_by_role("dialog", name="Your own material")).to_be_visible()


def test_a_file_becomes_a_medium_and_its_link_another_browser_s(
    quiet_page: Page, browser: Browser, base_url: str
) -> None:
    page = opened(quiet_page)
    sheet_from_picker(page)
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("A file of n and k").set_input_files(FILES / "other-sign.csv")
    expect(sheet).to_contain_text("sign = n-ik: k is negative in 100% of the rows")
    name = sheet.get_by_label("Name")
    name.fill("My film")
    name.press("Tab")
    expect(sheet.get_by_role("button", name="Use as second medium")).to_be_visible()
    expect(name).to_have_value("My film")
    sheet.get_by_role("button", name="Use as second medium").click()
    expect(page).to_have_url(re.compile("material=own(:|%3A)"))
    expect(page.get_by_label("Second medium")).to_have_value(re.compile("^My film"))
    other = browser.new_context(base_url=base_url, service_workers="block").new_page()
    other.goto(page.url)
    expect(other.get_by_label("Second medium")).to_have_value(re.compile("^My film"))
    said = page.get_by_text(re.compile("% reflected")).first
    expect(said).to_contain_text("reflected")
    expect(other.get_by_text(re.compile("% reflected")).first).to_have_text(said.inner_text())
    own = parse_qs(urlsplit(other.url).query)["material"][0]
    asked = other.request.get(f"/api/v1/snell?material={own}&wavelength_nm=450")
    interface = asked.json()["interface"]
    assert interface["n_t"] == pytest.approx(0.15, abs=1e-5)
    assert interface["k_t"] == pytest.approx(2.425, abs=1e-5)
    other.context.close()


def test_what_is_not_told_is_asked_in_the_sheet(page: Page) -> None:
    """The browser notes the refusal on its console, so the page is not quiet."""
    page = opened(page)
    sheet_from_picker(page)
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("A file of n and k").set_input_files(FILES / "headerless-um-or-ev.txt")
    expect(sheet.get_by_role("alert")).to_contain_text("in eV they are 495.9 to 4133 nm")
    sheet.locator("label", has_text="Unit").locator("select").select_option("um")
    expect(sheet.get_by_role("alert")).to_be_empty()
    expect(sheet.locator("figcaption")).to_contain_text("300 to 2500 nm")


def test_what_is_asked_is_answered_and_set_back_by_keys(page: Page) -> None:
    """The focus stays in the sheet when what it was on has gone."""
    page = opened(page)
    sheet_from_picker(page)
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("A file of n and k").set_input_files(FILES / "headerless-um-or-ev.txt")
    expect(sheet.get_by_role("alert")).to_contain_text("Needed: the unit of 0.3 to 2.5")
    sheet.get_by_role("button", name="unit = eV").focus()
    page.keyboard.press("Enter")
    expect(sheet).to_contain_text("unit = eV: set by hand")
    expect(sheet.get_by_role("button", name="found out again")).to_be_focused()
    page.keyboard.press("Enter")
    expect(sheet.get_by_role("button", name="unit = um")).to_be_focused()


def test_an_assumption_is_flipped(quiet_page: Page) -> None:
    page = opened(quiet_page)
    sheet_from_picker(page)
    sheet = page.get_by_role("dialog")
    sheet.get_by_label("A file of n and k").set_input_files(FILES / "zero-k.csv")
    expect(sheet).to_contain_text("k 0 to 0.0100")
    sheet.get_by_role("button", name="zero_k = unknown").click()
    expect(sheet).to_contain_text("k 0.0100")


DROP = """async () => {
  const data = new DataTransfer();
  data.items.add(new File(["nm,n,k\\n400,1.5,0\\n700,1.4,0.1\\n"], "dropped.csv"));
  for (const kind of ["dragenter", "dragover", "drop"]) {
    window.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    await new Promise((go) => setTimeout(go, 1500));  // as long as a hand takes
  }
}"""


def test_a_drop_anywhere_opens_the_sheet_and_what_is_kept_is_removed(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.evaluate(DROP)
    sheet = page.get_by_role("dialog", name="Your own material")
    expect(sheet.get_by_label("Name")).to_have_value("dropped")
    sheet.get_by_role("button", name="Open in Materials").click()
    expect(page.locator(".view-materials")).to_contain_text("dropped")
    page.goto("/")
    expect(page.get_by_label("Second medium")).to_be_visible()
    page.get_by_label("Second medium").fill("dropped")
    expect(page.locator(".media-list [role=option]").first).to_contain_text("dropped")
    page.keyboard.press("Escape")
    sheet_from_picker(page)
    page.get_by_role("button", name="Remove dropped").click()
    expect(page.get_by_role("button", name="Remove dropped")).to_have_count(0)
    assert page.evaluate("localStorage.getItem('own-materials')") == "[]"


def test_a_pasted_table_is_read_and_axe_finds_nothing(quiet_page: Page) -> None:
    page = opened(quiet_page)
    sheet_from_picker(page)
    sheet = page.get_by_role("dialog")
    pasted = sheet.get_by_label("or a table, pasted")
    pasted.fill("nm;n\n400;1,51\n700;1,50\n")
    pasted.press("Tab")
    expect(sheet).to_contain_text("decimal = ,")
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        page.wait_for_timeout(500)  # colors change over a moment
        page.evaluate(AXE.read_text("utf-8"))
        found = page.evaluate("() => axe.run('dialog')")
        assert [one["id"] for one in found["violations"]] == []


@pytest.mark.parametrize("width", [390, 1440])
def test_the_sheet_fits(quiet_page: Page, width: int) -> None:
    page = quiet_page
    page.set_viewport_size({"width": width, "height": 844})
    page = opened(page)
    page.evaluate(DROP)
    sheet = page.get_by_role("dialog")
    expect(sheet.get_by_label("Name")).to_have_value("dropped")
    inner = page.evaluate("document.querySelector('dialog').scrollWidth")
    assert inner <= page.evaluate("document.querySelector('dialog').clientWidth")
