"""The Compare view: curves, errors, maps, the sources' figures, what will do, conversions."""

import json
import re
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Page, Route, expect

ROOT = Path(__file__).parents[2]
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
READY_MS = 30_000
expect.set_options(timeout=READY_MS)


def opened(page: Page, query: str = "") -> Page:
    """Open the view and wait for its curves, its errors and what will do."""
    page.set_default_timeout(READY_MS)
    page.goto(f"/?view=compare{query}")
    page.locator(".upper path.js-line").first.wait_for(state="attached")
    page.locator(".picks li").first.wait_for(state="attached")
    return page


def link(page: Page) -> dict[str, str]:
    """Read what the address says."""
    return {key: values[0] for key, values in parse_qs(urlsplit(page.url).query).items()}


def api(page: Page, path: str) -> Any:
    """Ask the API directly."""
    answer = page.request.get(f"/api/v1{path}")
    assert answer.ok, answer.text()
    return answer.json()


def row(page: Page, model: str) -> Any:
    """Find a model's row in the table of errors."""
    return page.locator(f'.errors tr[data-model="{model}"]')


def cell(page: Page, model: str, heading: str) -> str:
    """Read a cell of the table of errors."""
    names = [t.strip() for t in page.locator(".errors thead th").all_inner_texts()]
    index = next(i for i, name in enumerate(names) if name.replace("↑", "").strip() == heading)
    return str(row(page, model).locator("th, td").nth(index).inner_text())


def shown_number(text: str) -> float:
    """Parse a number as the page writes it."""
    plain = text.replace("−", "-").replace("\u00a0", " ").replace("°", "").strip()
    return float(plain.removesuffix(" %"))


def axe_violations(page: Page) -> list[str]:
    """Return the rules that axe-core finds broken, each with the first offender."""
    page.evaluate(AXE.read_text("utf-8"))
    found = page.evaluate("() => axe.run()")
    return [f"{v['id']}: {v['nodes'][0]['html']}" for v in found["violations"]]


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
    "lagarde-water-air": ("n_i=1.33&n_t=1", ["schlick", "schlick_tir"]),
    "lagarde-range": ("n_t=1.4", ["schlick"]),
    "wloka-family": ("n_t=1.52", []),
    "wloka-water-diamond": ("n_t=1.333333", ["schlick", "one_minus_cos"]),
    "deon-conductor": ("n_t=1.5&k_t=2", ["schlick", "pharr_humphreys", "complex_dielectric"]),
}


@pytest.mark.parametrize("example", EXAMPLES)
def test_a_named_example_shows_what_it_claims_with_measured_figures(
    quiet_page: Page, example: str
) -> None:
    page = opened(quiet_page)
    index = list(EXAMPLES).index(example)
    page.locator(".example").nth(index).click()
    expect(page).to_have_url(re.compile(f"example={example}"))
    found = page.locator(".found")
    expect(found).not_to_contain_text("…", timeout=READY_MS)
    query, models = EXAMPLES[example]
    figures = [shown_number(text) for text in found.locator("b").all_inner_texts()]
    assert figures
    if models:
        expect(page.locator(".errors tbody tr")).to_have_count(len(models))
        rows = api(page, f"/errors?{query}&models={','.join(models)}&samples=2")["errors"]
        measured = [
            value
            for entry in rows
            for value in (entry["max_abs"], entry["max_abs_at_deg"], 100 * entry["max_relative"])
        ]
        for entry in rows:
            assert shown_number(cell(page, entry["model"], "largest")) == pytest.approx(
                entry["max_abs"], rel=5e-3
            )
        # at least one figure of the caption is one of these errors, to the digits shown
        assert any(f == pytest.approx(m, rel=5e-3) for f in figures for m in measured)
    assert page.locator('.upper path.js-line[d^="M"]').count() > len(models)


def test_the_claims_figures_are_the_published_ones_or_what_they_really_are(
    quiet_page: Page,
) -> None:
    page = opened(quiet_page)

    def figures(example: str) -> list[float]:
        page.locator(".example").nth(list(EXAMPLES).index(example)).click()
        expect(page).to_have_url(re.compile(f"example={example}"))
        expect(page.locator(".found")).not_to_contain_text("…", timeout=READY_MS)
        return [shown_number(t) for t in page.locator(".found b").all_inner_texts()]

    # the largest error of Schlick at n = 1.5, k = 5 and the exponent that Lagarde prints as 7.7
    lazanyi = figures("lagarde-lazanyi")
    assert lazanyi[0] == pytest.approx(0.132)
    assert lazanyi[1] == pytest.approx(82.2)
    assert lazanyi[-1] == pytest.approx(7.7054)
    # Schlick knows no total internal reflection
    water = figures("lagarde-water-air")
    assert water[0] == pytest.approx(0.975)
    assert water[-1] == pytest.approx(0.0599)
    # accurate for 1.4 < n < 2.2: measured along the sweep that is shown beside it
    inside = figures("lagarde-range")[0]
    sweep = api(page, "/errors/sweep?model=schlick&minimum=1.4&maximum=2.2&steps=81")
    assert inside == pytest.approx(100 * max(sweep["max_relative"]), rel=5e-3)
    # no polarization costs more than Schlick does
    wloka = figures("wloka-water-diamond")
    assert wloka[0] < wloka[-1]
    assert wloka[2] > 0.5
    # the conductor form is far off without absorption and good with it
    assert figures("lagarde-conductor-k0")[0] > 0.09
    assert figures("lagarde-conductor-k")[0] < 0.01
    family = figures("wloka-family")
    assert family == sorted(family)
    assert family[-1] == pytest.approx(100 * (2.5 / 4.5) ** 2, abs=0.05)


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
    expect(page.locator(".chooser .reason")).to_contain_text("No model speaks of")
    search.press("Escape")
    expect(row(page, "hoffman_f82").locator(".outside")).to_contain_text("outside its domain")
    assert "hoffman_f82" in link(page)["against"]
    page.get_by_role("button", name="clear the choice of models").click()
    expect(page.locator(".empty").first).to_be_visible()
    assert link(page)["against"] == "none"


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
    page = opened(quiet_page, "&against=lut_1d,lazanyi2005,generalized_schlick&n_t=1.5&k_t=5")
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


@pytest.mark.parametrize("over", ["n", "k"])
def test_the_sweep_goes_where_it_is_clicked(quiet_page: Page, over: str) -> None:
    page = opened(quiet_page, f"&over={over}")
    frame = page.locator(".figure-host:not([hidden]) .nsewdrag").first
    frame.wait_for()
    area = frame.bounding_box()
    assert area
    page.mouse.click(area["x"] + area["width"] / 2, area["y"] + area["height"] / 2)
    middle = 2.05 if over == "n" else 2.5
    expect(page).to_have_url(re.compile(rf"{over}_t="))
    assert float(link(page)[f"{over}_t"]) == pytest.approx(middle, abs=0.03)


def test_schlicks_largest_errors_in_the_sweep_are_those_of_the_table_of_the_formulas(
    quiet_page: Page,
) -> None:
    page = opened(quiet_page, "&against=schlick&n_low=1.1&n_high=4")
    page.locator("summary", has_text="This figure as a table").click()
    expect(page.locator(".figure .curve-table caption")).to_contain_text("largest error against n")
    with page.expect_download(timeout=READY_MS) as waiting:
        page.get_by_role("button", name="Save the figure of the error as CSV").click()
    text = Path(waiting.value.path()).read_text("utf-8")
    lines = [line.split(",") for line in text.strip().splitlines()]
    assert lines[0] == ["n_t", "schlick"]
    values = {round(float(n), 4): float(e) for n, e in lines[1:]}
    for n, error in ((1.1, 0.2105), (4.0, 0.2009)):
        assert round(values[n], 4) == error


@pytest.mark.parametrize(("over", "axes"), [("theta-n", "θ"), ("n-k", "n")])
def test_a_map_tells_its_values_and_goes_there(quiet_page: Page, over: str, axes: str) -> None:
    page = opened(quiet_page, f"&over={over}&k_t=1")
    page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    area = page.locator(".heatmap .nsewdrag").first.bounding_box()
    assert area
    x, y = area["x"] + 0.75 * area["width"], area["y"] + 0.5 * area["height"]
    page.mouse.move(x, y)
    tip = page.locator(".map-tip")
    expect(tip).to_be_visible()
    expect(tip).to_contain_text(axes)
    said = tip.inner_text()
    page.mouse.click(x, y)
    expect(page).to_have_url(re.compile("n_t="))
    if over == "theta-n":
        theta, n_t = float(link(page)["theta_i_deg"]), float(link(page)["n_t"])
        assert theta == pytest.approx(67.5, abs=0.6)
        curve = api(page, f"/errors?models=schlick&n_t={n_t}&k_t=1&samples=181")["errors"][0][
            "error"
        ]
        assert shown_number(said.rsplit(":", 1)[1]) == pytest.approx(
            curve[round(2 * theta)], rel=6e-3
        )
    else:
        assert float(link(page)["n_t"]) == pytest.approx(3.775, abs=0.05)
        assert float(link(page)["k_t"]) == pytest.approx(2.5, abs=0.06)


def test_a_map_is_read_by_keyboard(quiet_page: Page) -> None:
    page = opened(quiet_page, "&over=theta-n")
    page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    handle = page.locator(".map-handle")
    handle.focus()
    before = handle.get_attribute("aria-valuetext")
    handle.press("ArrowUp")
    handle.press("Shift+ArrowRight")
    assert handle.get_attribute("aria-valuetext") != before
    assert handle.get_attribute("aria-valuenow") == "69"
    handle.press("Enter")
    expect(page).to_have_url(re.compile("theta_i_deg=69"))


PLOTLYS_OWN = """async () => {
  const plot = document.querySelector('.heatmap .plot-canvas');
  await Plotly.react(plot, plot.data, {...plot.layout, datarevision: -1});
  return plot.querySelector('.heatmaplayer image').getAttribute('href');
}"""
PICTURES_APART = """async ([a, b]) => {
  const [width, height] = [181, 121];
  const pixels = async (url) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [width, height];
    const context = canvas.getContext('2d');
    context.imageSmoothingEnabled = false;
    context.drawImage(image, 0, 0, width, height);
    return context.getImageData(0, 0, width, height).data;
  };
  const [p, q] = [await pixels(a), await pixels(b)];
  return p.reduce((sum, value, i) => sum + Math.abs(value - q[i]), 0) / p.length;
}"""


def test_a_map_follows_a_slider_that_is_let_go(quiet_page: Page) -> None:
    page = opened(quiet_page, "&over=theta-n&k_t=1")
    picture = page.locator(".heatmap .heatmaplayer image")
    picture.wait_for(state="attached")
    before = picture.get_attribute("href")
    slider = page.locator("#compare-k_t-slider")
    slider.focus()
    for _ in range(5):
        slider.press("PageUp")
    expect(page).to_have_url(re.compile(r"k_t=1\.5(&|$)"))
    page.wait_for_load_state("networkidle")
    expect(picture).not_to_have_attribute("href", before or "")
    expect(picture).to_have_attribute("style", re.compile("pixelated"))
    in_place = picture.get_attribute("href")
    # What is written in place is what Plotly draws.
    page.reload()
    picture.wait_for(state="attached")
    page.wait_for_load_state("networkidle")
    fresh = page.evaluate(PLOTLYS_OWN)
    assert page.evaluate(PICTURES_APART, [before, fresh]) > 3
    assert page.evaluate(PICTURES_APART, [in_place, fresh]) < 2


def test_which_will_do_is_the_cheapest_within_the_budget(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=0.27&k_t=2.9&budget=0.02")
    wanted = api(page, "/recommend?n_t=0.27&k_t=2.9&max_error=0.02&metric=max_abs")
    names = page.locator(".verdict .picks .pick-name").all_text_contents()
    assert names == [entry["title"] for entry in wanted["models"]]
    refusals = page.locator(".refused li").all_text_contents()
    assert len(refusals) == len(wanted["refused"])
    assert wanted["refused"][0]["reason"] in refusals[0]
    page.locator(".quick .mini", has_text="0.005").click()
    expect(page).to_have_url(re.compile("budget=0.005"))
    expect(page.locator(".refused li")).not_to_have_count(len(refusals))
    name = page.locator(".picks .pick").first
    name.click()
    expect(page).to_have_url(re.compile("against="))
    box = page.get_by_role("textbox", name="Error budget")
    box.fill("7")
    box.press("Enter")
    expect(page.locator("#budget-error")).to_contain_text("up to 1")


@pytest.mark.parametrize(
    ("query", "form", "text", "status"),
    [
        ("", "F0, linear", "0.0400000", "exact"),
        ("&n_t=0.27&k_t=2.9", "Gulbrandsen's r, g", "0.993919", "exact"),
        ("&from=f0&given=1", "Index of refraction", "none", "infeasible"),
        ("&from=hex&given=%23ffe29b", "F0, linear", "1, 0.7605, 0.3278", "exact"),
        ("&from=specular&given=0.5", "Filament reflectance", "0.5", "exact"),
    ],
)
def test_conversions_say_what_is_lost(
    quiet_page: Page, query: str, form: str, text: str, status: str
) -> None:
    page = opened(quiet_page, query)
    line = page.locator(".conversions tr", has=page.get_by_role("rowheader", name=form, exact=True))
    expect(line).to_contain_text(text)
    expect(line).to_have_attribute("data-status", status)


def test_a_conversion_can_be_used_as_the_second_medium(quiet_page: Page) -> None:
    page = opened(quiet_page, "&from=rg&given=0.9;0.5")
    page.get_by_role("button", name="Use Complex index as the second medium").click()
    expect(page).to_have_url(re.compile(r"n_t=[\d.]+&k_t=[\d.]+"))
    answer = api(page, "/convert?from=rg&r=0.9&g=0.5")
    nk = next(r for r in answer["results"] if r["form"] == "nk")["values"]
    assert float(link(page)["k_t"]) == pytest.approx(nk["k_t"], rel=1e-9)


def test_a_refused_conversion_is_told_in_its_panel(page: Page) -> None:
    opened(page, "&from=f0&given=0.04")
    box = page.locator(".given:visible")
    box.fill("four")
    box.press("Enter")
    expect(page.locator("#convert-problem")).to_contain_text("F0")
    expect(page.locator(".notice")).to_have_count(0)
    expect(page.locator(".conversions tr").first).to_be_visible()  # the last good answer
    box.fill("0.05")
    box.press("Enter")
    expect(page.locator("#convert-problem")).to_have_text("")


def test_a_link_reproduces_the_view(quiet_page: Page) -> None:
    query = (
        "&n_t=2&against=schlick,spherical_gaussian&error=relative&family=1.5&over=theta-n"
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


def test_a_failing_server_is_told_and_the_last_good_picture_stays(page: Page) -> None:
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
    assert page.locator(".upper path.js-line").first.get_attribute("d") == before
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


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("query", ["", "&over=n-k&n_t=0.27&k_t=2.9&from=hex&given=%23ffe29b"])
def test_is_accessible(page: Page, scheme: Any, query: str) -> None:
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    opened(page, f"{query}&against=schlick,lut_1d,lazanyi2005&lut_1d.bits=8&example=shirley-glass")
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
