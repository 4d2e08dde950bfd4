"""The Theory view: the first path, formulas, claims, traps, the mystery material, worksheets."""

import re
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Page, Response, expect

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"
READY_MS = 15_000
SECTIONS = {
    "path": ".lessons.path .katex",
    "formulas": ".formula-place .katex",
    "claims": ".claim",
    "traps": ".lessons.traps path.js-line",
    "mystery": ".mystery path.js-line",
    "worksheets": ".worksheet .katex",
}


def opened(page: Page, section: str = "path", query: str = "") -> Page:
    """Open a section and wait for what it is about."""
    of = "" if section == "path" else f"&section={section}"
    page.goto(f"/?view=theory{of}{query}")
    page.locator(SECTIONS[section]).first.wait_for(state="attached", timeout=READY_MS)
    if section in ("path", "traps") and "step=coat" not in query:
        page.locator(f".lessons.{section} path.js-line").first.wait_for(
            state="attached", timeout=READY_MS
        )
    return page


def link(page: Page) -> dict[str, str]:
    """Read what the address says."""
    return {key: values[0] for key, values in parse_qs(urlsplit(page.url).query).items()}


def type_into(page: Page, box: str, text: str) -> None:
    """Type a number into a box and leave it."""
    page.locator(box).fill(text)
    page.locator(box).press("Enter")


@pytest.mark.parametrize("section", SECTIONS)
def test_each_section_shows_and_logs_nothing(quiet_page: Page, section: str) -> None:
    page = opened(quiet_page, section)
    current = page.locator(".theory-tabs a[aria-current]")
    expect(current).to_have_count(1)
    expect(page.locator(".trouble:visible, .notice")).to_have_count(0)
    expect(page.locator(".theory-section > :visible")).to_have_count(1)


def test_nothing_of_it_is_loaded_before_it_is_asked_for(page: Page) -> None:
    asked: list[str] = []
    page.on("request", lambda request: asked.append(urlsplit(request.url).path))
    page.goto("/")
    page.locator(".plot-host path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    assert not [path for path in asked if "theory" in path or "katex" in path]
    page.locator(".views a", has_text="Theory").click()
    page.locator(".lessons.path .katex").first.wait_for(timeout=READY_MS)
    assert "/js/views/theory.js" in asked
    assert "/js/theory/formulas.js" not in asked


# The first path


def test_the_first_path_is_walked_by_keyboard_alone(quiet_page: Page) -> None:
    page = opened(quiet_page)
    heading = page.locator(".lessons.path .lesson-title")
    titles = [heading.inner_text()]
    next_button = page.locator(".lessons.path .forward")
    for _ in range(11):
        next_button.focus()
        page.keyboard.press("Enter")
        expect(heading).not_to_have_text(titles[-1])
        expect(heading).to_be_focused()
        titles.append(heading.inner_text())
    expect(next_button).to_be_disabled()
    assert titles[0] == "Look at water"
    assert len(set(titles)) == 12
    assert link(page) == {"view": "theory", "step": "planes"}
    page.go_back()
    expect(heading).to_have_text(titles[-2])


def test_a_task_is_found_by_arrow_keys(quiet_page: Page) -> None:
    page = opened(quiet_page)
    handle = page.locator(".lessons.path .diagram-handle")
    handle.focus()
    page.keyboard.press("Home")
    first = page.locator(".try").first
    expect(first).to_have_attribute("data-done", "")
    expect(first.locator(".reply")).to_contain_text("Two percent")
    expect(page.locator(".lesson-live:visible")).to_contain_text("reflects 2.0\u00a0%")
    expect(page).to_have_url(re.compile("own_deg=0"))


def test_the_curves_are_read_as_a_table(quiet_page: Page) -> None:
    page = opened(quiet_page, query="&step=schlick")
    page.locator(".stage summary:visible").click()
    rows = page.locator(".stage .plot-table tbody tr")
    expect(rows.last).to_contain_text("90")
    assert rows.count() > 20


def test_a_lesson_leaves_the_media_of_the_other_views_alone(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?n_t=1.7&theta_i_deg=30")
    page.locator(".plot-host path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    page.locator(".views a", has_text="Theory").click()
    page.locator(".lessons.path path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    expect(page.locator(".lessons.path .diagram")).to_contain_text("water")
    page.locator(".lesson-list a", has_text="Schlick").click()
    expect(page.locator(".lessons.path .lesson-title")).to_have_text("Schlick's shortcut")
    page.locator(".views a", has_text="Explore").click()
    expect(page.locator("#n_t-box")).to_have_value("1.7")


def test_brewsters_angle_is_held_and_judged(quiet_page: Page) -> None:
    page = opened(quiet_page, query="&step=brewster")
    slider = page.locator("#step-theta_i_deg-slider")
    slider.focus()
    for _ in range(60):
        page.keyboard.press("ArrowRight")
        # No press is lost: one that comes before the last was drawn would step past the mark.
        page.evaluate(
            "() => new Promise((drawn) => requestAnimationFrame(() => setTimeout(drawn)))"
        )
        if page.locator(".try[data-done]").count():
            break
        if float(slider.evaluate("e => e.value")) == pytest.approx(53.12296551221158):
            break
    page.keyboard.up("ArrowRight")
    expect(page.locator(".try").first).to_have_attribute("data-done", "")
    expect(page.locator(".lesson-live:visible")).to_contain_text("53.12°")


def test_total_reflection_is_reached_without_swapping(quiet_page: Page) -> None:
    page = opened(quiet_page, query="&step=below&own_deg=45&own_i=1")
    live = page.locator(".lesson-live:visible")
    expect(live).to_contain_text("no critical angle")
    type_into(page, "#step-n_i-box", "1.42")
    expect(live).to_contain_text("all is reflected")
    expect(page.locator(".try", has_text="Keep the ray")).to_have_attribute("data-done", "")
    expect(page.locator(".lessons.path .diagram")).to_contain_text("total internal reflection")


def test_the_critical_angle_is_reached_exactly(quiet_page: Page) -> None:
    page = opened(quiet_page, query="&step=below&own_deg=48.5")
    slider = page.locator("#step-theta_i_deg-slider")
    slider.focus()
    page.keyboard.press("ArrowRight")
    expect(page.locator(".try", has_text="exactly")).to_have_attribute("data-done", "")
    assert float(link(page)["own_deg"]) == pytest.approx(48.60661, abs=1e-4)
    expect(page.locator(".lesson-live:visible")).to_contain_text("The critical angle is 48.61°")


def test_a_number_that_is_none_is_refused_where_it_stands(quiet_page: Page) -> None:
    page = opened(quiet_page)
    type_into(page, "#step-theta_i_deg-box", "100")
    expect(page.locator(".lessons.path .row-error:visible")).to_have_text(
        "theta_i_deg = 100° is outside 0° to 90°"
    )
    type_into(page, "#step-theta_i_deg-box", "pi/3 rad")
    expect(page).to_have_url(re.compile(r"own_deg=(60|59\.9)"))


def test_colors_of_metals_are_exchanged(quiet_page: Page) -> None:
    page = opened(quiet_page, query="&step=rgb")
    expect(page.locator(".lesson-live:visible")).to_contain_text("Gold")
    page.locator(".medium", has_text="Silver").click()
    expect(page.locator(".lesson-live:visible")).to_contain_text("Silver")
    expect(page.locator(".try").first).to_have_attribute("data-done", "")
    expect(page.locator("#calls")).to_contain_text("/materials/Ag/curves")


def test_the_coat_is_that_of_the_albedo_view(quiet_page: Page) -> None:
    page = opened(quiet_page, query="&step=coat")
    type_into(page, "#step-coat_body-box", "1")
    expect(page.locator(".try").first).to_have_attribute("data-done", "")
    expect(page.locator(".coat .coat-says")).to_contain_text("lets out")
    page.locator(".lesson-more a", has_text="formula").click()
    expect(page.locator(".formula-detail .lesson-title")).to_have_text("Diffuse body under a coat")


# Formulas


def test_every_formula_is_typeset_without_an_error(quiet_page: Page) -> None:
    page = opened(quiet_page, "formulas")
    links = page.locator(".formula-groups a")
    count = links.count()
    assert count >= 70
    title = page.locator(".formula-detail .lesson-title")
    for index in range(count):
        name = links.nth(index).inner_text()
        links.nth(index).evaluate("e => e.click()")
        expect(title).to_have_text(name)
        equations = page.locator(".formula-place .equation")
        expect(equations.locator(".katex")).to_have_count(equations.count())
    assert page.locator(".katex-error").count() == 0


def test_every_formula_has_its_source_error_letters_and_curve(quiet_page: Page) -> None:
    page = quiet_page
    answer = page.request.get("/api/v1/formulas").json()["formulas"]
    page.goto("/?view=theory&section=formulas")
    page.locator(".formula-place .katex").first.wait_for(timeout=READY_MS)
    for formula in answer:
        page.locator(f'.formula-groups a[href$="formula={formula["id"]}"]').evaluate(
            "e => e.click()"
        )
        expect(page.locator(".letters dt .katex")).to_have_count(len(formula["symbols"]))
        expect(page.locator(".measured tbody tr:visible")).to_have_count(len(formula["measured"]))
        for address in formula["links"]:
            expect(page.locator(f'.source-links a[href="{address}"]')).to_have_count(1)
    page.locator(".formula-curve path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    assert page.locator(".katex-error").count() == 0


def test_a_formula_is_found_by_a_word(quiet_page: Page) -> None:
    page = opened(quiet_page, "formulas")
    page.locator(".find-box").fill("brewster")
    expect(page.locator(".formula-groups li:visible")).to_have_count(2)
    expect(page).to_have_url(re.compile("word=brewster"))
    page.locator(".formula-groups a:visible", has_text="Brewster's").click()
    expect(page.locator(".formula-detail .lesson-title")).to_have_text("Brewster's angle")
    page.locator(".find-box").fill("nonsense")
    expect(page.locator(".formula-list .hint")).to_be_visible()


def test_a_models_curve_follows_the_media_and_opens_in_compare(quiet_page: Page) -> None:
    page = opened(quiet_page, "formulas", "&formula=model.pharr_humphreys")
    expect(page.locator("#calls")).to_contain_text("/formulas/model.pharr_humphreys/curve")
    type_into(page, "#formula-k_t-box", "5")
    expect(page.locator("#calls")).to_contain_text("curve?k_t=5")
    page.locator(".formula-curve .lesson-more a").click()
    page.locator(".view-compare path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    said = link(page)
    assert said["view"] == "compare"
    assert said["models"] == "pharr_humphreys"
    assert (said["n_t"], said["k_t"]) == ("0.27", "2.9")
    page.go_back()
    expect(page.locator(".formula-detail .lesson-title")).to_be_visible()


def test_links_of_all_formulas_open_what_they_say(page: Page) -> None:
    """Each address is taken by the page without a complaint; one of each view is opened."""
    opened(page, "formulas")
    addresses: dict[str, str] = {}
    links = page.locator(".formula-groups a")
    for index in range(links.count()):
        links.nth(index).evaluate("e => e.click()")
        href = page.locator(".formula-curve .lesson-more a").get_attribute("href") or ""
        addresses[links.nth(index).get_attribute("href") or ""] = href
    for href in sorted(set(addresses.values()))[::4]:
        page.goto(f"/{href}")
        page.locator(".plot-host path.js-line").first.wait_for(state="attached", timeout=READY_MS)
        expect(page.locator(".notice")).to_have_count(0)


def test_an_unknown_formula_is_said_to_be_unknown(page: Page) -> None:
    page.goto("/?view=theory&section=formulas&formula=model.schlik")
    expect(page.locator(".formula-detail .lesson-title")).to_have_text(
        "There is no such formula", timeout=READY_MS
    )
    expect(page.locator(".view-theory > .trouble")).to_contain_text("model.schlick")
    page.locator(".formula-groups a", has_text="Spherical Gaussian").click()
    expect(page.locator(".view-theory > .trouble")).to_be_hidden()
    expect(page.locator(".formula-detail .lesson-title")).to_have_text("Spherical Gaussian")


def test_nonsense_in_a_link_is_said(page: Page) -> None:
    page.goto("/?view=theory&section=nowhere&step=dance&own_n=-3&mystery=zzzzzz")
    notice = page.locator(".notice")
    for key in ("section", "step", "own_n", "mystery"):
        expect(notice).to_contain_text(f"{key} =", timeout=READY_MS)
    expect(page.locator(".lessons.path .lesson-title")).to_have_text("Look at water")


# Claims


def test_claims_are_filtered_and_give_their_requests(quiet_page: Page) -> None:
    page = opened(quiet_page, "claims")
    cards = page.locator(".claim")
    total = cards.count()
    assert total >= 20
    page.locator(".filters button", has_text="does not hold").click()
    expect(page).to_have_url(re.compile("verdict=does"))
    shown = page.locator(".claim:visible")
    assert 0 < shown.count() < total
    for verdict in shown.locator(".claim-verdict").all_inner_texts():
        assert verdict == "does not hold"
    card = shown.first
    card.locator("summary").click()
    request = card.locator(".figures a").first.get_attribute("href") or ""
    assert request.startswith("api/v1/")
    assert page.request.get(f"/{request}").ok
    page.locator(".filters button", has_text="all").click()
    page.locator(".by-source").select_option(index=1)
    expect(page.locator(".claim-tools .hint")).to_contain_text("of")
    page.reload()
    page.locator(".claim:visible").first.wait_for(timeout=READY_MS)
    assert page.locator(".claim:visible").count() < total


# Traps and the mystery material


def test_every_trap_shows_the_right_curve_beside_the_wrong(quiet_page: Page) -> None:
    page = opened(quiet_page, "traps")
    links = page.locator(".lessons.traps .lesson-list a")
    assert links.count() == 5
    for index in range(links.count()):
        links.nth(index).click()
        expect(links.nth(index)).to_have_attribute("aria-current", "step")
        expect(page.locator(".trap-code")).to_be_visible()
        expect(page.locator(".lesson-live:visible")).not_to_have_text("")
        lines = page.locator(".lessons.traps path.js-line")
        assert lines.count() >= 2


def test_the_wrong_angle_is_as_wrong_as_the_server_says(quiet_page: Page) -> None:
    page = opened(quiet_page, "traps")
    expect(page.locator(".lesson-live:visible")).to_contain_text("Largest error 0.959")
    expect(page.locator(".lesson-live:visible")).to_contain_text("exact 100.0\u00a0%")


def test_the_solution_of_a_mystery_is_not_in_the_network(page: Page) -> None:
    sent: list[str] = []

    def note(response: Response) -> None:
        if "/api/v1/" in response.url and "/materials" not in response.url:
            sent.append(f"{response.url}\n{response.text()}")

    page.on("response", note)
    opened(page, "mystery", "&mystery=z1amiz")
    page.wait_for_load_state("networkidle")
    assert any("/mystery/z1amiz" in text for text in sent)
    with page.expect_response(lambda response: "clues=1" in response.url) as asked:
        page.get_by_role("button", name="a hint").click()
    assert asked.value.json()["F0"] is None
    with page.expect_response(lambda response: "clues=2" in response.url) as asked:
        page.get_by_role("button", name="a hint").click()
    assert asked.value.json()["F0"] == pytest.approx((1.42 / 3.42) ** 2)
    assert [text for text in sent if re.search(r"\b2\.42\b", text)] == []


def test_a_mystery_material_is_guessed(quiet_page: Page) -> None:
    page = opened(quiet_page, "mystery", "&mystery=z1amiz")
    verdict = page.locator(".verdict")
    check = page.get_by_role("button", name="Check my answer")
    assert "2.42" not in page.locator(".view-theory").inner_text()
    assert "2.42" not in page.locator("#calls").inner_text()
    check.click()
    expect(verdict).to_contain_text("Not yet. k is right")
    hint = page.get_by_role("button", name="a hint")
    hint.click()
    hint.click()
    expect(page.locator(".hints li")).to_have_count(2)
    expect(page.locator(".hints")).to_contain_text("17.2\u00a0%")
    type_into(page, "#mystery-n_t-box", "2.41")
    expect(page.locator(".mystery .lesson-live")).to_contain_text("apart")
    check.click()
    expect(verdict).to_contain_text("Found: n = 2.42, k = 0.")
    expect(verdict).to_contain_text("Diamond")


def test_a_teacher_sends_a_mystery_material(quiet_page: Page) -> None:
    page = opened(quiet_page, "mystery")
    page.locator("summary", has_text="Make one for others").click()
    boxes = page.locator(".maker .box")
    boxes.nth(0).fill("0.27")
    boxes.nth(1).fill("2.9")
    page.get_by_role("button", name="copy the link").click()
    address = page.locator(".made a")
    expect(address).to_have_attribute("href", "?view=theory&section=mystery&mystery=g21piv")
    boxes.nth(0).fill("70")
    page.get_by_role("button", name="copy the link").click()
    expect(page.locator(".made")).to_contain_text("n goes from 0.05 to 5")
    page.get_by_role("button", name="another material").click()
    expect(page).to_have_url(re.compile("mystery="))


def test_worksheets_open_what_they_say(quiet_page: Page) -> None:
    page = opened(quiet_page, "worksheets")
    links = page.locator(".worksheet li a")
    addresses = [links.nth(i).get_attribute("href") or "" for i in range(links.count())]
    assert len(addresses) >= 20
    for address in addresses:
        page.goto(f"/{address}")
        page.locator("main .view:visible").first.wait_for(timeout=READY_MS)
        page.locator(".plot-host path.js-line, .formula-place .katex").first.wait_for(
            state="attached", timeout=READY_MS
        )
        assert page.locator(".notice").count() == 0, address


# Everywhere


@pytest.mark.parametrize("width", [320, 390, 768, 1440])
@pytest.mark.parametrize("section", SECTIONS)
def test_no_horizontal_scroll(quiet_page: Page, section: str, width: int) -> None:
    quiet_page.set_viewport_size({"width": width, "height": 844})
    page = opened(quiet_page, section)
    assert page.evaluate("() => document.documentElement.scrollWidth") == width


@pytest.mark.parametrize(("theme", "width"), [("light", 1440), ("dark", 1440), ("light", 390)])
@pytest.mark.parametrize("section", SECTIONS)
def test_axe_finds_nothing(quiet_page: Page, section: str, theme: str, width: int) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    quiet_page.set_viewport_size({"width": width, "height": 900})
    page = opened(quiet_page, section)
    page.wait_for_timeout(300)
    page.evaluate(AXE.read_text(encoding="utf-8"))
    result: dict[str, Any] = page.evaluate("() => axe.run(document)")
    found = [
        (v["id"], [(node["target"], node["failureSummary"]) for node in v["nodes"]][:3])
        for v in result["violations"]
    ]
    assert found == []


def test_links_followed_by_keyboard_keep_the_focus_where_they_lead(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=theory&step=coat")
    page.get_by_role("link", name="Now beware of the traps").press("Enter")
    expect(page.locator(".lessons.traps")).to_be_focused()
    page.keyboard.press("Tab")
    expect(page.locator(".traps .lesson-list a").first).to_be_focused()
    page.get_by_role("link", name="The three curves in Compare").press("Enter")
    expect(page.locator(".view-compare")).to_be_visible(timeout=READY_MS)
    expect(page.locator("main")).to_be_focused()
    page.keyboard.press("Tab")
    expect(page.get_by_label("Incident medium")).to_be_focused()
