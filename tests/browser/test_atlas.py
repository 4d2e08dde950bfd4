"""The Atlas view: which formula for which material."""

import re
from typing import Any
from urllib.parse import quote

import pytest
from playwright.sync_api import Locator, Page, expect

SENTENCE = ".take-home"


def opened(page: Page, query: str = "") -> Page:
    page.goto(f"/?view=atlas{query}")
    page.locator(".scatter .scatterlayer .point").first.wait_for(state="attached")
    page.wait_for_function("() => !document.querySelector('[data-busy]')")
    return page


def told(page: Page, query: str = "") -> dict[str, Any]:
    answer: dict[str, Any] = page.request.get(f"/api/v1/atlas{query}").json()
    return answer


def rows(page: Page) -> Locator:
    return page.locator(".atlas-list tbody tr")


def test_the_sentence_and_the_points_are_those_of_the_server(quiet_page: Page) -> None:
    page = opened(quiet_page)
    answer = told(page)
    expect(page.locator(SENTENCE)).to_have_text(answer["sentence"])
    points = page.locator(".scatter .scatterlayer .point")
    expect(points).to_have_count(sum(error is not None for error in answer["points"]["error"]))
    expect(page.locator(".scatter .annotation", has_text=re.compile("^Gold$"))).to_have_count(1)
    assert page.evaluate("() => document.querySelector('.scatter').ariaLabel").startswith("Schlick")


def test_what_is_chosen_stands_in_the_link_and_is_counted(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_label("Formula", exact=True).select_option("f82_tint")
    page.get_by_label("Measure of the error").select_option("rms")
    page.get_by_role("radio", name="metals").check(force=True)
    page.get_by_label("What counts as small").fill("0.2 %")
    page.get_by_label("What counts as small").press("Enter")
    expect(page).to_have_url(re.compile("atlas_model=f82_tint&atlas_metric=rms&atlas_within=0.002"))
    answer = told(page, "?model=f82_tint&metric=rms&kind=metal&within=0.002")
    expect(page.locator(SENTENCE)).to_have_text(answer["sentence"])
    assert "within 0.2 %" in answer["sentence"]
    page.reload()
    expect(page.locator(SENTENCE)).to_have_text(answer["sentence"])
    expect(page.get_by_label("What counts as small")).to_have_value("0.2 %")


def test_a_search_leaves_what_is_called_so(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_label("Search the materials").fill("copper")
    many = told(page, "?q=copper")["total"]
    expect(page.locator(".scatter .scatterlayer .point")).to_have_count(many)
    expect(rows(page).first).to_contain_text(re.compile("copper", re.IGNORECASE))


def test_a_point_is_named_chosen_and_opened(quiet_page: Page) -> None:
    """By the pointer: over it, upon it, and once more."""
    page = opened(quiet_page, "&atlas_find=Gold&atlas_shelf=curated")
    point = page.locator(".scatter .scatterlayer .point").first
    box = point.bounding_box()
    assert box
    place = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.move(*place)
    expect(page.locator(".scatter .map-tip")).to_contain_text("Gold")
    page.mouse.click(*place)
    card = page.locator(".atlas-card")
    expect(card.get_by_role("heading", name=re.compile("Gold"))).to_be_visible()
    expect(card.locator(".picks li").first).to_contain_text("Lookup texture")
    page.mouse.click(*place)
    expect(page.locator(".view-materials h2", has_text="Gold").first).to_be_visible()
    expect(page).to_have_url(re.compile("view=materials&preset="))


def test_keys_walk_from_material_to_material(quiet_page: Page) -> None:
    page = opened(quiet_page, "&atlas_kind=metal&atlas_shelf=curated")
    handle = page.get_by_role("slider", name=re.compile("material$"))
    handle.focus()
    page.keyboard.press("Home")
    first = handle.get_attribute("aria-valuetext")
    page.keyboard.press("ArrowRight")
    expect(handle).not_to_have_attribute("aria-valuetext", first or "")
    expect(page.locator(".scatter .map-tip")).to_be_visible()
    page.keyboard.press("Enter")
    expect(page.locator(".atlas-card")).to_be_visible()
    expect(page).to_have_url(re.compile("atlas_at="))


def test_a_page_of_the_database_opens_in_materials(quiet_page: Page) -> None:
    page = opened(quiet_page, f"&atlas_at={quote('rii:main/Ag/Jiang', safe='')}")
    card = page.locator(".atlas-card")
    expect(card.locator(".picks li").first).to_be_visible()
    card.get_by_role("link", name="Open in Materials").click()
    expect(page.locator(".view-materials h2", has_text="Silver").first).to_be_visible()


def test_a_formula_is_taken_from_the_table_of_all(quiet_page: Page) -> None:
    page = opened(quiet_page)
    table = page.locator(".shares")
    expect(table.locator("tbody tr")).not_to_have_count(0)
    table.get_by_role("button", name="Pharr and Humphreys' conductor").click()
    expect(page).to_have_url(re.compile("atlas_model=pharr_humphreys"))
    expect(page.locator(SENTENCE)).to_contain_text(
        "Pharr and Humphreys' conductor stays within 1 %"
    )
    color = "getComputedStyle(document.documentElement).getPropertyValue('--model-4').trim()"
    drawn = page.evaluate(
        f"""() => {{
          const probe = document.createElement("i");
          probe.style.color = {color};
          document.body.append(probe);
          const wanted = getComputedStyle(probe).color;
          const point = document.querySelector(".scatter .scatterlayer .point");
          const style = getComputedStyle(point);
          probe.remove();
          return [style.fill, style.stroke].includes(wanted);
        }}"""
    )
    assert drawn


@pytest.mark.parametrize("kind", ["svg", "png", "csv"])
def test_the_figure_is_saved(quiet_page: Page, kind: str) -> None:
    page = opened(quiet_page, "&atlas_kind=metal")
    with page.expect_download() as saving:
        page.get_by_role("button", name=f"Save the atlas as {kind.upper()}").click()
    body = saving.value.path().read_bytes()
    assert saving.value.suggested_filename == f"fresnel-atlas-schlick.{kind}"
    starts = {"svg": b"<svg", "png": b"\x89PNG", "csv": b"material,name"}
    assert body.startswith(starts[kind])
    if kind == "svg":
        assert b"Gold" in body


def test_what_the_atlas_does_not_have_is_told(page: Page) -> None:
    page.goto("/?view=atlas&atlas_shelf=nowhere")
    alert = page.get_by_role("alert").filter(has_text="nowhere")
    expect(alert).to_be_visible()
    page.get_by_role("button", name="Back to Schlick").click()
    expect(page.locator(SENTENCE)).to_contain_text("Schlick stays within 1 %")


def test_it_is_drawn_for_print_with_its_source(quiet_page: Page) -> None:
    page = opened(quiet_page, "&atlas_kind=metal")
    page.get_by_role("button", name="For print… (atlas)").click()
    dialog = page.locator("dialog[open]")
    expect(dialog.locator("textarea")).to_have_value(re.compile(r"^Schlick: largest error at \d+"))
    expect(dialog.locator("textarea")).to_have_value(re.compile("C. Schlick"))
    expect(dialog.locator(".publish-preview img, .publish-preview svg")).to_be_visible()
