"""The panel of shader code in the Compare view."""

from pathlib import Path

from playwright.sync_api import Page, expect

from tests.browser.compare_page import api, axe_violations, link, opened


def test_shows_the_code_of_what_is_compared(quiet_page: Page) -> None:
    page = opened(quiet_page, "&models=schlick,cos_form")
    panel = page.locator(".snippets")
    code = panel.locator("code")
    expect(code).to_have_text(api(page, "/shaders/schlick")["code"])
    offered = panel.get_by_label("Model whose code is shown")
    assert offered.locator("option").all_inner_texts() == [
        "Schlick",
        "Cosine form",
        "Exact Fresnel",
        "Reflected and refracted directions",
        "Reading a table, Wloka's figure 10",
    ]
    offered.select_option("vectors")
    expect(code).to_have_text(api(page, "/shaders/vectors")["code"])
    assert link(page)["code"] == "vectors"
    page.go_back()
    offered.select_option("cos_form")
    expect(code).to_have_text(api(page, "/shaders/cos_form")["code"])
    panel.get_by_label("GLSL").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("ArrowRight")
    panel.get_by_label("colors").check()
    expected = api(page, "/shaders/cos_form?language=wgsl&channels=3")
    expect(code).to_have_text(expected["code"])
    expect(panel.locator(".checked")).to_contain_text(expected["checked_by"])
    asked = link(page)
    assert (asked["code"], asked["language"], asked["channels"]) == ("cos_form", "wgsl", "3")
    page.go_back()
    expect(code).to_have_text(api(page, "/shaders/cos_form?language=wgsl")["code"])
    panel.get_by_label("OSL").check()
    expect(panel.locator(".checked")).to_contain_text("Untested")
    page.reload()
    expect(code).to_have_text(api(page, "/shaders/cos_form?language=osl")["code"])


def test_copies_saves_and_links(quiet_page: Page) -> None:
    page = opened(quiet_page, "&language=python&code=exact")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    expected = api(page, "/shaders/exact?language=python")["code"]
    panel = page.locator(".snippets")
    expect(panel.locator("code")).to_have_text(expected)
    expect(panel.get_by_text("colors")).to_be_hidden()
    panel.get_by_role("button", name="Copy code").click()
    expect(panel.locator("[data-flash=copied]")).to_be_visible()
    assert page.evaluate("() => navigator.clipboard.readText()") == expected
    with page.expect_download() as download:
        panel.get_by_role("button", name="Save").click()
    assert download.value.suggested_filename == "exact.py"
    assert Path(download.value.path()).read_text("utf-8") == expected
    address = panel.get_by_role("link", name="as plain text").get_attribute("href")
    assert page.request.get(f"/{address}").text() == expected


def test_says_why_there_is_no_code(page: Page) -> None:
    opened(page, "&models=lut_1d,schlick")
    panel = page.locator(".snippets")
    expect(panel.locator(".row-error")).to_contain_text("read from a table")
    expect(panel.locator("code")).to_be_hidden()
    expect(panel.get_by_role("button", name="Copy code")).to_be_disabled()
    panel.get_by_label("Model whose code is shown").select_option("schlick")
    expect(panel.locator("code")).to_contain_text("float schlick(")
    expect(panel.locator(".row-error")).to_have_text("")
    assert axe_violations(page) == []


def test_a_nonsense_link_is_said(page: Page) -> None:
    opened(page, "&language=metal&code=schlik&channels=2")
    expect(page.locator(".snippets code")).to_contain_text("float schlick(")
    for word in ("metal", "schlik", "channels"):
        expect(page.locator("body")).to_contain_text(word)
