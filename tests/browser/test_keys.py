"""The keys that work everywhere: undo and redo, the finder, the list of keys."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.conftest import in_both_forms
from tests.browser.explore_page import box, link, opened, settled_link, type_into

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
LOADED_MS = 20_000
browser_context_args = in_both_forms


def test_undo_and_redo_follow_the_state_not_the_history(quiet_page: Page) -> None:
    page = opened(quiet_page)
    type_into(page, "n_t", "1.7")
    settled_link(page, "n_t", "1.7")
    type_into(page, "theta_i_deg", "30")
    settled_link(page, "theta_i_deg", "30")
    page.keyboard.press("Control+z")
    expect(page).not_to_have_url(re.compile("theta_i_deg"))
    assert link(page)["n_t"] == "1.7"
    page.keyboard.press("Control+z")
    expect(page).not_to_have_url(re.compile("n_t"))
    page.keyboard.press("Control+Shift+z")
    page.keyboard.press("Control+Shift+z")
    settled_link(page, "theta_i_deg", "30")
    page.go_back()  # the undone state was a page of the history
    expect(page).not_to_have_url(re.compile("theta_i_deg"))


ADDRESSES = """() => {
  window.addresses = [];
  const { pushState } = history;
  history.pushState = (state, title, address) => {
    window.addresses.push(address.replace(/^[/]/, ''));
    pushState.call(history, state, title, address);
  };
}"""


def test_undo_of_a_link_whose_view_is_under_way_takes_the_link_back(quiet_page: Page) -> None:
    page = opened(quiet_page)
    type_into(page, "n_t", "1.7")
    settled_link(page, "n_t", "1.7")
    held: list[Route] = []
    view = re.compile(r"/(views/compare|packed/compare-[\w-]+)\.js$")
    page.route(view, lambda route: held.append(route))
    page.evaluate(ADDRESSES)
    page.keyboard.press("Control+k")
    page.get_by_role("combobox", name="Find a view").fill("lazanyi")
    with page.expect_request(view):
        page.keyboard.press("Enter")
    page.keyboard.press("Control+z")
    assert page.evaluate("() => window.addresses") == []  # the address waits for the state
    held[0].continue_()
    page.wait_for_function("() => window.addresses.length === 2")
    assert page.evaluate("() => window.addresses") == [
        "?view=compare&models=lazanyi2005",
        "?n_t=1.7",
    ]
    expect(page.locator(".view-explore")).to_be_visible()
    expect(page.locator(".view-compare")).to_be_hidden()


PRESSED = """(element, [key, times]) => {
  for (let i = 0; i < times; i += 1)
    element.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
  element.dispatchEvent(new KeyboardEvent("keyup", {key, bubbles: true}));
}"""


@pytest.mark.parametrize(
    ("address", "handle", "key", "expected"),
    [
        ("?n_t=1.5", "#n_t-slider", "ArrowRight", {"n_t": "1.57"}),
        ("?n_t=1.5", "#n_t-box", "ArrowDown", {"n_t": "1.43"}),
        ("?theta_i_deg=20", ".diagram-handle", "ArrowRight", {"theta_i_deg": "23.5"}),
        ("?theta_i_deg=20", ".plot-handle", "ArrowLeft", {"theta_i_deg": "16.5"}),
        ("?view=theory&own_deg=20", ".diagram-handle", "ArrowRight", {"own_deg": "23.5"}),
        ("?view=theory&own_deg=20", ".plot-handle", "ArrowRight", {"own_deg": "23.5"}),
        (
            "?view=films&layers=1.38:100",
            ".film-map .map-handle",
            "ArrowRight",
            {"layers": "1.38%3A170"},
        ),
    ],
)
def test_no_press_of_a_key_is_lost_before_the_next_frame(
    page: Page, address: str, handle: str, key: str, expected: dict[str, str]
) -> None:
    page.goto(f"/{address}")
    page.wait_for_load_state("networkidle")
    at = page.locator(f".view:not([hidden]) {handle}").filter(visible=True).first
    at.evaluate(PRESSED, [key, 7])
    for name, value in expected.items():
        settled_link(page, name, re.escape(value))


def test_a_box_that_is_written_in_keeps_its_own_undo(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_t=1.7")
    type_into(page, "theta_i_deg", "30")
    settled_link(page, "theta_i_deg", "30")
    field = box(page, "n_t")
    field.click()
    page.keyboard.type("2.2")
    page.keyboard.press("Control+z")
    assert link(page) == {"n_t": "1.7", "theta_i_deg": "30"}
    assert field.input_value() != "2.2"


def test_the_finder_opens_models_media_formulas_and_views(quiet_page: Page) -> None:
    page = opened(quiet_page)
    results = page.get_by_role("dialog").get_by_role("option")

    def find(words: str, first: str, view: str) -> None:
        page.keyboard.press("Control+k")
        box = page.get_by_role("combobox", name="Find a view")
        expect(box).to_be_focused()
        box.fill(words)
        expect(results.first).to_contain_text(first)
        page.keyboard.press("Enter")
        expect(page.get_by_role("dialog")).to_have_count(0)
        expect(page.locator(f".view-{view}")).to_be_visible(timeout=LOADED_MS)
        page.wait_for_load_state("networkidle")

    find("aurum", "Gold", "explore")
    settled_link(page, "material", r"\w.*")
    find("lazanyi", "Lazanyi", "compare")
    settled_link(page, "models", "lazanyi2005")
    find("brewster", "Brewster", "theory")
    settled_link(page, "formula", r"angle\.brewster")
    find("albedo", "Albedo", "albedo")
    settled_link(page, "view", "albedo")
    find("gold", "Gold", "materials")  # no medium to set here: among the materials
    settled_link(page, "view", "materials")
    find("undo", "Undo", "albedo")
    settled_link(page, "view", "albedo")


@pytest.mark.parametrize(
    ("words", "first"),
    [
        ("plastic", "PMMA"),
        ("acrylic", "PMMA"),
        ("chrome", "Chromium"),
        ("steel", "Stainless steel"),
        ("skin", "Skin"),
        ("glass", "Glass (typical)"),
        ("blender", "Use a material in Blender"),
        ("unreal", "Spherical Gaussian"),
        ("gltf", "Use a material in glTF"),
        ("worksheet", "Worksheets"),
        ("help", "Keys"),
        ("total reflection", "From below: total reflection"),
        ("pond", "Reflection at a pond"),
        ("filament", "Filament"),
        ("print", "Print"),
        ("thin film", "Films"),
        ("answer key", "Worksheets"),
        ("theme", "Light or dark"),
        ("export", "Use a material in Blender"),
    ],
)
def test_the_finder_leads_to_what_the_trade_means(page: Page, words: str, first: str) -> None:
    opened(page)
    page.keyboard.press("Control+k")
    results = page.get_by_role("dialog").get_by_role("option")
    page.get_by_role("combobox", name="Find a view").fill(words)
    expect(results.first).to_contain_text(first)
    if words in ("help", "gltf"):  # scattered letters of theirs are in Helium and LiF
        expect(results.filter(has_text=re.compile("Helium|Lithium"))).to_have_count(0)


def test_what_is_found_of_the_trade_opens(quiet_page: Page) -> None:
    page = opened(quiet_page)
    for words, key, value in (
        ("skin", "n_t", r"1\.4"),
        ("blender", "preset", "Au"),
        ("cycles", "engine", "cycles"),
        ("worksheet", "section", "worksheets"),
        ("why gold", "step", "rgb"),
    ):
        page.keyboard.press("Control+k")
        page.get_by_role("combobox", name="Find a view").fill(words)
        page.wait_for_function("() => document.querySelectorAll('#finder-list li').length > 0")
        page.wait_for_load_state("networkidle")
        page.keyboard.press("Enter")
        settled_link(page, key, value)


def test_the_finder_says_when_nothing_is_called_so(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_role("button", name="Find").click()
    page.get_by_role("combobox", name="Find a view").fill("qqqqqqqqq")
    expect(page.get_by_text("No match", exact=True)).to_be_visible()
    page.keyboard.press("Enter")
    page.keyboard.press("Escape")
    expect(page.get_by_role("dialog")).to_have_count(0)
    expect(page.get_by_role("button", name="Find")).to_be_focused()


def test_a_question_mark_shows_the_keys_except_where_it_is_written(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.keyboard.press("?")
    dialog = page.get_by_role("dialog", name="Keys")
    expect(dialog).to_contain_text("undo the last change")
    page.keyboard.press("Escape")
    expect(dialog).to_have_count(0)
    box(page, "n_t").click()
    page.keyboard.press("?")
    expect(box(page, "n_t")).to_have_value("?")
    expect(dialog).to_have_count(0)


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("key", ["Control+k", "?"])
def test_axe_finds_nothing_in_the_dialogs(quiet_page: Page, key: str, theme: str) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    page = opened(quiet_page)
    page.keyboard.press(key)
    expect(page.get_by_role("dialog")).to_be_visible()
    page.evaluate(AXE.read_text(encoding="utf-8"))
    found = page.evaluate("() => axe.run()")
    assert [(v["id"], v["nodes"][0]["html"]) for v in found["violations"]] == []


FOCUSED = """() => {
  const focused = document.activeElement;
  if (focused === document.body) return null;
  const { left, right, top, bottom } = focused.getBoundingClientRect();
  const over = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  const still = over?.closest(".top, .view > .panel");
  const covered = still && !still.contains(focused);
  return { covered, is: focused.outerHTML.slice(0, 120) };
}"""


@pytest.mark.parametrize(
    ("place", "width", "key"),
    [
        ("?view=compare", 390, "Tab"),
        ("?view=explore", 390, "Tab"),
        ("?view=materials", 1440, "Shift+Tab"),
        ("?view=theory&section=claims", 1440, "Shift+Tab"),
    ],
)
def test_the_tab_key_comes_to_what_can_be_seen_and_leaves_the_page_again(
    page: Page, place: str, width: int, key: str
) -> None:
    page.set_viewport_size({"width": width, "height": 850})
    page.goto(f"/{place}")
    page.locator(".view:not([hidden])").wait_for(timeout=LOADED_MS)
    page.wait_for_load_state("networkidle")
    covered = []
    for _ in range(400):
        page.keyboard.press(key)
        focused = page.evaluate(FOCUSED)
        if focused is None:
            break
        if focused["covered"]:
            covered.append(focused["is"])
    else:
        pytest.fail("the Tab key does not come to the end")
    assert covered == []
