"""The Compare view: curves, errors, the sources' figures, models and their parameters, links."""

import json
import re
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Page, Route, expect

from tests.browser.compare_page import (
    READY_MS,
    api,
    axe_violations,
    cell,
    link,
    opened,
    row,
    shown_number,
)


def test_starts_with_glass_and_the_measured_errors(quiet_page: Page) -> None:
    page = opened(quiet_page)
    expect(page.locator(".errors tbody tr")).to_have_count(3)
    errors = api(page, "/errors?models=schlick&samples=2")["errors"][0]
    assert shown_number(cell(page, "schlick", "largest")) == pytest.approx(0.0357)
    assert shown_number(cell(page, "schlick", "at")) == pytest.approx(
        errors["max_abs_at_deg"], abs=0.05
    )
    assert shown_number(cell(page, "schlick", "RMS")) == pytest.approx(errors["rms"], rel=5e-3)
    assert shown_number(cell(page, "schlick", "albedo")) == pytest.approx(
        errors["albedo_error"], rel=5e-3
    )
    assert link(page) == {"view": "compare"}
    # the errors stand below the curves on the same axis
    frames = [
        page.locator(f".{name} .nsewdrag").first.bounding_box() for name in ("upper", "lower")
    ]
    assert frames[0]
    assert frames[1]
    assert frames[0]["x"] == pytest.approx(frames[1]["x"], abs=0.6)
    assert frames[0]["width"] == pytest.approx(frames[1]["width"], abs=0.6)


def test_is_loaded_when_it_is_first_opened(page: Page) -> None:
    page.set_default_timeout(READY_MS)
    asked: list[str] = []
    page.on("request", lambda request: asked.append(urlsplit(request.url).path))
    page.goto("/")
    page.locator(".view-explore .plot-host path.js-line").first.wait_for(state="attached")
    page.wait_for_load_state("networkidle")
    assert not [path for path in asked if "compare" in path or "heatmap" in path]
    page.get_by_role("link", name="Compare", exact=True).click()
    page.locator(".upper path.js-line").first.wait_for(state="attached")
    assert any(path.endswith("/views/compare.js") for path in asked)
    page.get_by_role("link", name="Explore", exact=True).click()
    expect(page.locator(".view-explore")).to_be_visible()
    expect(page.locator(".view-compare")).to_be_hidden()


EXAMPLES: dict[str, tuple[str, list[str]]] = {
    # id: the query of /errors that it rests on, and the models in it
    "shirley-glass": ("n_t=1.5", ["schlick"]),
    "lagarde-conductor-k0": ("n_t=1.5", ["pharr_humphreys"]),
    "lagarde-conductor-k": ("n_t=1.5&k_t=3", ["pharr_humphreys"]),
    "lagarde-lazanyi": ("n_t=1.5&k_t=5&lazanyi2005.alpha=7.7", ["schlick", "lazanyi2005"]),
    "lagarde-error-term": (
        "n_t=1.5&k_t=5&lazanyi2005.a=3&lazanyi2005.alpha=7",
        ["schlick", "lazanyi2005"],
    ),
    "lagarde-sp-dielectric": ("n_t=1.5", []),
    "lagarde-sp-metal": ("n_t=1.5&k_t=5", []),
    "lagarde-water-air": ("n_i=1.33&n_t=1", ["schlick", "schlick_tir"]),
    "lagarde-range": ("n_t=1.4", ["schlick"]),
    "wloka-family": ("n_t=1.52", []),
    "wloka-water-diamond": ("n_t=1.333333", ["schlick", "one_minus_cos"]),
    "deon-conductor": ("n_t=1.5&k_t=2", ["schlick", "pharr_humphreys", "complex_dielectric"]),
}


@pytest.mark.parametrize("example", EXAMPLES)
def test_a_named_example_shows_what_is_claimed_and_what_is_measured(
    quiet_page: Page, example: str
) -> None:
    page = opened(quiet_page)
    index = list(EXAMPLES).index(example)
    page.locator(".example").nth(index).click()
    expect(page).to_have_url(re.compile(f"example={example}"))
    claims = api(page, f"/claims?example={example}")["claims"]
    told = page.locator(".example-claims p")
    expect(told).to_have_count(2 * len(claims), timeout=READY_MS)
    for index, claim in enumerate(claims):
        expect(told.nth(2 * index)).to_contain_text(str(claim["source"]["year"]))
        # Letters that are typeset stand otherwise in the text.
        for paragraph, words in ((2 * index, claim["claimed"]), (2 * index + 1, claim["found"])):
            for part in re.split("alpha|n_i", words):
                expect(told.nth(paragraph)).to_contain_text(part)
        expect(told.nth(2 * index + 1).get_by_role("link")).to_contain_text(claim["verdict"])
    query, models = EXAMPLES[example]
    if models:
        expect(page.locator(".errors tbody tr")).to_have_count(len(models))
        for entry in api(page, f"/errors?{query}&models={','.join(models)}&samples=2")["errors"]:
            assert shown_number(cell(page, entry["model"], "largest")) == pytest.approx(
                entry["max_abs"], rel=5e-3
            )
    assert page.locator('.upper path.js-line[d^="M"]').count() > len(models)


def test_deons_figure_has_his_line_styles(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.locator(".example").nth(list(EXAMPLES).index("deon-conductor")).click()
    expect(page.locator(".upper path.js-line")).to_have_count(4)
    style = page.locator(".upper path.js-line").evaluate_all(
        "paths => paths.map((p) => [p.style.stroke, p.style.strokeDasharray])"
    )
    exact, schlick, pharr, misunderstanding = style
    assert exact == ["rgb(20, 24, 31)", ""]
    assert schlick[1].count("px") == 2
    assert pharr[1].count("px") == 4
    red = [int(c) for c in re.findall(r"\d+", misunderstanding[0])]
    assert red[0] > 2 * max(red[1:])


def test_leaving_an_example_is_said_and_can_be_undone(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.locator(".example").first.click()
    expect(page.locator(".found")).to_contain_text("0.0357")
    box = page.locator("#compare-n_t-box")
    box.fill("1.8")
    box.press("Enter")
    expect(page.locator(".away")).to_be_visible()
    expect(page.locator(".found")).to_contain_text("0.0357")  # the caption stays beside it
    page.get_by_role("button", name="Back to it").click()
    expect(box).to_have_value("1.5")
    expect(page.locator(".found")).to_contain_text("0.0357")


def test_models_are_chosen_searched_and_out_of_domain_rows_say_why(quiet_page: Page) -> None:
    page = opened(quiet_page)
    search = page.get_by_role("searchbox", name="Search the models")
    search.fill("hoffman")
    visible = page.locator(".chooser .options label:visible")
    expect(visible.filter(has_text="Hoffman's F82")).to_have_count(1)
    assert visible.count() < 6
    page.locator('.chooser input[value="hoffman_f82"]').check(force=True)
    search.fill("nothing like this")
    expect(page.locator(".chooser .reason")).to_contain_text("No match for")
    search.press("Escape")
    expect(row(page, "hoffman_f82").locator(".outside")).to_contain_text("outside its domain")
    assert "hoffman_f82" in link(page)["models"]
    page.get_by_role("button", name="clear the choice of models").click()
    expect(page.locator(".empty").first).to_be_visible()
    assert link(page)["models"] == "none"


def test_the_table_sorts_and_lights_its_curve(quiet_page: Page) -> None:
    page = opened(quiet_page)
    order = "rows => rows.map((row) => row.dataset.model)"
    page.locator(".errors .sort", has_text="largest").click()
    expect(page.locator("th[aria-sort=ascending]")).to_contain_text("largest")
    up = page.locator(".errors tbody tr").evaluate_all(order)
    page.locator(".errors .sort", has_text="largest").click()
    expect(page.locator("th[aria-sort=descending]")).to_contain_text("largest")
    assert page.locator(".errors tbody tr").evaluate_all(order) == up[::-1]
    assert link(page)["sort"] == "max_abs"
    opacity = """() => [...document.querySelectorAll('.upper .scatterlayer .trace')]
      .map((g) => g.style.opacity)"""
    assert set(page.evaluate(opacity)) == {""}
    row(page, "schlick").hover()
    lit = page.evaluate(opacity)
    assert sorted(lit) == ["", "", "0.18", "0.18"]  # exact and Schlick stay
    page.mouse.move(0, 0)
    row(page, "schlick").locator(".pick").click()
    page.mouse.move(0, 0)
    page.locator("h2").first.hover()
    expect(row(page, "schlick").locator(".pick")).to_have_attribute("aria-pressed", "true")
    assert link(page)["focus"] == "schlick"


def test_parameters_of_models_are_controls(quiet_page: Page) -> None:
    page = opened(quiet_page, "&models=lut_1d,lazanyi2005,generalized_schlick&n_t=1.5&k_t=5")
    for title in ("Lookup texture", "Lazanyi", "Generalized"):
        page.locator(".own summary", has_text=title).click()
    # solved by the server, and said so
    alpha = page.locator("#compare-lazanyi2005-alpha-box")
    expect(alpha).to_have_attribute("placeholder", "auto 7.705")
    alpha.fill("7.7")
    alpha.press("Enter")
    expect(page).to_have_url(re.compile(r"lazanyi2005\.alpha=7\.7"))
    # a whole number
    size = page.locator("#compare-lut_1d-size-box")
    size.fill("16.5")
    size.press("Enter")
    expect(page.locator('[data-parameter="lut_1d.size"] .row-error')).to_contain_text("not whole")
    size.fill("16")
    size.press("Enter")
    expect(page).to_have_url(re.compile(r"lut_1d\.size=16"))
    # a choice
    before = cell(page, "lut_1d", "largest")
    page.locator(".own label", has_text="nearest").click()
    expect(page).to_have_url(re.compile(r"lut_1d\.filtering=nearest"))
    expect(row(page, "lut_1d")).not_to_contain_text(before)
    # a triple: three curves, three rows
    split = page.get_by_role("button", name=re.compile("normal incidence: a value for each")).first
    split.click()
    boxes = page.locator(".triple:visible .box")
    for index, value in enumerate(["0.9", "0.7", "0.3"]):
        boxes.nth(index).fill(value)
        boxes.nth(index).press("Enter")
        boxes.nth(index).blur()
    expect(page).to_have_url(re.compile(r"generalized_schlick\.F0=0\.9,0\.7,0\.3"))
    expect(row(page, "generalized_schlick")).to_have_count(3)


def test_a_link_reproduces_the_view(quiet_page: Page) -> None:
    query = (
        "&n_t=2&models=schlick,spherical_gaussian&error=relative&family=1.5&over=theta-n"
        "&point=relative&sort=cost&order=down&angle=rad&theta_i_deg=30"
    )
    page = opened(quiet_page, query)
    expect(page.locator(".lower")).to_have_attribute("aria-label", "Error of the models")
    expect(page.locator(".upper path.js-line")).to_have_count(6)
    said = page.locator(".errors").inner_text()
    page.reload()
    page.locator(".errors tbody tr").first.wait_for()
    expect(page.locator(".errors")).to_have_text(re.compile("Schlick"))
    assert page.locator(".errors").inner_text() == said
    page.get_by_role("link", name="Explore", exact=True).click()
    expect(page.locator(".view-explore")).to_be_visible()
    page.go_back()
    expect(page.locator(".view-compare")).to_be_visible()
    assert link(page)["family"] == "1.5"


def test_the_calls_of_the_footer_give_what_is_shown(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=2&over=n-k&metric=rms")
    calls = page.locator("#calls code").all_inner_texts()
    assert [urlsplit(call.removeprefix("GET ")).path for call in calls] == [
        f"/api/v1/{name}" for name in ("curves", "errors", "errors/map", "recommend", "convert")
    ]
    for call in calls:
        api(page, call.removeprefix("GET /api/v1"))


def test_a_failing_server_is_told_and_made_up_for(page: Page) -> None:
    opened(page)
    before = page.locator(".upper path.js-line").first.get_attribute("d")

    def fail(route: Route) -> None:
        problem = {"title": "Internal Server Error", "status": 500, "detail": "out of order"}
        route.fulfill(status=500, content_type="application/problem+json", body=json.dumps(problem))

    page.context.route("**/api/v1/curves**", fail)
    box = page.locator("#compare-n_t-box")
    box.fill("2")
    box.press("Enter")
    expect(page.locator(".notice")).to_contain_text("out of order")
    expect(page.locator(".notice")).to_contain_text("worked out here")
    assert page.locator(".upper path.js-line").first.get_attribute("d") != before
    page.context.unroute("**/api/v1/curves**")
    page.get_by_role("button", name="Try again").click()
    expect(page.locator(".notice")).to_have_count(0)


@pytest.mark.parametrize("kind", ["png", "svg", "csv"])
@pytest.mark.parametrize("what", ["curves", "errors", "figure of the error"])
def test_exports(quiet_page: Page, what: str, kind: str) -> None:
    page = opened(quiet_page, "&over=theta-n")
    page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    with page.expect_download(timeout=READY_MS) as waiting:
        page.get_by_role("button", name=f"Save the {what} as {kind.upper()}").click()
    data = Path(waiting.value.path()).read_bytes()
    start = {"png": b"\x89PNG", "svg": b"<svg", "csv": b"theta_i_deg,"}[kind]
    assert data.startswith(start)
    assert len(data) > 1000


def test_a_file_says_that_its_angles_are_in_radians(quiet_page: Page) -> None:
    page = opened(quiet_page, "&over=theta-n&angle=rad")
    page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    for what in ("curves", "errors", "figure of the error"):
        with page.expect_download(timeout=READY_MS) as waiting:
            page.get_by_role("button", name=f"Save the {what} as CSV").click()
        assert Path(waiting.value.path()).read_text("utf-8").startswith("theta_i_rad,")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("query", ["", "&over=n-k&n_t=0.27&k_t=2.9&from=hex&given=%23ffe29b"])
def test_is_accessible(page: Page, scheme: Any, query: str) -> None:
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    opened(page, f"{query}&models=schlick,lut_1d,lazanyi2005&lut_1d.bits=8&example=shirley-glass")
    page.locator(".conversions tr").first.wait_for(state="attached")
    page.locator("summary", has_text="Curves and errors as tables").click()
    page.locator("summary", has_text="This figure as a table").click()
    assert axe_violations(page) == []


@pytest.mark.parametrize("width", [320, 390, 768, 1024, 1440])
def test_fits_its_screen(page: Page, width: int) -> None:
    page.set_viewport_size({"width": width, "height": 844})
    opened(page, "&over=theta-n&example=wloka-water-diamond&from=hex")
    page.locator(".conversions tr").first.wait_for(state="attached")
    wide = page.evaluate("() => document.documentElement.scrollWidth")
    assert wide <= width


def test_knobs_of_engines_are_told_and_taken(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=1.45")
    knobs = page.locator(".knobs tbody tr")
    expect(knobs).to_have_count(8)
    told = {knob["knob"]: knob for knob in api(page, "/convert?n_t=1.45")["knobs"]}
    unreal = knobs.filter(has_text="Unreal")
    specular = told["unreal"]["inputs"][0]["value"]
    expect(unreal.locator(".converted")).to_have_text(f"Specular {specular:.6g}")
    unreal.locator("summary").click()
    expect(unreal).to_contain_text("Specular: 0 to 1, 0.5 unless typed")
    page.get_by_label("What is given").select_option("gltf")
    page.get_by_label("glTF's ior and specular, specularFactor").fill("0.5")
    page.keyboard.press("Tab")
    expect(knobs.filter(has_text="Blender")).to_contain_text("specularFactor is F90 as well")
    assert link(page)["given"] == "1.45;0.5;1"


def test_dispersion_of_the_material_is_told(quiet_page: Page) -> None:
    page = opened(quiet_page, "&material=BK7")
    row = page.locator(".knobs tr", has_text="glTF, dispersion")
    expect(row.locator(".converted")).to_contain_text("dispersion 0.311")
