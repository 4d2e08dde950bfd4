"""The Preview view: pixels against the optics, modes, A and B, keys, export, links, fallback."""

import json
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Page, ViewportSize, expect

from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from tests.browser.preview_page import (
    RADIANCE,
    Figure,
    Shot,
    View,
    axe_violations,
    encoded,
    figure,
    link,
    opened,
    rested,
    shot,
)

SMALL: ViewportSize = {"width": 1000, "height": 760}
EVEN = "&sky=even&see=left"
STEPS = 2.0  # of 255, between a pixel and what optics says


def points(view: View) -> list[tuple[float, float]]:
    """Pixels' middles from the ball's center to its rim."""
    x, y = view.center()
    rim = view.rim()
    xs = [x + 0.5 + share * (rim - x) for share in (0.0, 0.3, 0.6, 0.8, 0.9, 0.96, 0.985)]
    return [(int(one) + 0.5, y) for one in [*xs, rim - 0.5]]


def off_by(picture: Shot, light: Callable[[float], Sequence[float]], rim: bool = True) -> float:
    """Largest distance, of 255, of the ball from the linear light that cos(theta_i) asks for."""
    height, width, _ = picture.pixels.shape
    view = View(width, height)
    off = []
    for x, y in points(view)[: None if rim else -1]:
        mu = view.cosine(x, y)
        assert mu is not None
        off.append(float(np.abs(picture.at(x, y) - encoded(light(mu))).max()))
    return max(off)


def over(degrees: Any, channels: Iterable[Any]) -> Callable[[float], list[float]]:
    """The light of reflectances over the angle, by cos(theta_i)."""
    kept = list(channels)
    return lambda mu: [
        RADIANCE * float(np.interp(np.degrees(np.arccos(mu)), degrees, one)) for one in kept
    ]


@pytest.mark.parametrize("media", ["n_t=0.27&k_t=2.9", "n_t=2.9&k_t=3", "n_t=1.5&k_t=5"])
def test_the_ball_shows_r_times_the_radiance(quiet_page: Page, media: str) -> None:
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&{media}{EVEN}")
    interface = Interface(**{k: float(v) for k, v in (p.split("=") for p in media.split("&"))})

    def light(mu: float) -> list[float]:
        return [float(power(interface, Incidence.from_cosine(mu)).R) * RADIANCE] * 3

    picture = shot(page)
    assert off_by(picture, light) <= STEPS
    assert np.abs(picture.at(3, 3) - encoded([RADIANCE] * 3)).max() <= 1.0


def test_gold_shows_its_spectrum_in_color(quiet_page: Page) -> None:
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&material=Au{EVEN}")
    answer = page.request.get("/api/v1/materials/Au/curves?models=schlick&samples=2001").json()
    curve = answer["rgb"]["curves"][0]
    channels = [curve[f"R_{name}"] for name in ("red", "green", "blue")]
    assert off_by(shot(page), over(answer["theta_i_deg"], channels)) <= STEPS


def test_paint_under_a_coat_lets_out_what_the_api_says(quiet_page: Page) -> None:
    """In even light: R of the coat, and of what the body sends out the share T(theta) / (1 - A_e)."""
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&paint=d8322a{EVEN}")
    albedos = [(c / 255 + 0.055) / 1.055 for c in (0xD8, 0x32, 0x2A)]
    coats = [page.request.get(f"/api/v1/albedo/coat?body_albedo={a**2.4}").json() for a in albedos]

    def light(mu: float) -> list[float]:
        R = float(power(Interface(n_t=1.5), Incidence.from_cosine(mu)).R)
        return [RADIANCE * (R + (1 - R) * c["body"] / (1 - c["external"])) for c in coats]

    assert off_by(shot(page), light) <= STEPS


def test_clear_glass_mixes_what_is_refracted_and_reflected(quiet_page: Page) -> None:
    """In even light: R + T * T, as light goes through the surface twice."""
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&body=clear{EVEN}")

    def light(mu: float) -> list[float]:
        R = float(power(Interface(n_t=1.5), Incidence.from_cosine(mu)).R)
        return [RADIANCE * (R + (1 - R) ** 2)] * 3

    assert off_by(shot(page), light) <= STEPS


@pytest.mark.parametrize("scene", ["", "&scene=water", "&body=clear", "&material=Cu"])
def test_exact_against_exact_is_no_difference(quiet_page: Page, scene: str) -> None:
    page = opened(quiet_page, f"&right=exact{scene}")
    names: tuple[Figure, ...] = ("steps.mean", "steps.largest", "colors.mean", "colors.largest")
    for name in names:
        assert figure(page, name) == 0.0
    assert "pixels" in page.locator(".differences .reason").inner_text()


MODES = {
    "per vertex": "&right=exact&right_by=vertex",
    "two texels": "&right=exact&right_by=texture&texels=2",
    "no reflection": "&right=none",
    "1 - cos": "&right=one_minus_cos",
    "a model undefined at some angles": "&right=wloka_sin_tan",
}


@pytest.mark.parametrize("scene", ["ball", "water"])
@pytest.mark.parametrize("mode", MODES)
def test_each_mode_renders(quiet_page: Page, mode: str, scene: str) -> None:
    page = opened(quiet_page, f"&scene={scene}&n_t=1.333&see=right{MODES[mode]}")
    assert len(np.unique(shot(page).pixels.reshape(-1, 3), axis=0)) > 1000
    if "undefined" not in mode:
        assert figure(page, "steps.largest") >= 2
        assert 0 < figure(page, "colors.mean") < figure(page, "colors.largest")


def test_a_fine_table_is_as_good_as_the_curve_and_a_coarse_one_is_not(quiet_page: Page) -> None:
    errors = {}
    for texels in (4, 16, 4096):
        page = opened(quiet_page, f"&right=exact&right_by=texture&texels={texels}")
        errors[texels] = figure(page, "steps.largest")
    assert errors[4096] <= 2
    assert errors[4096] <= errors[16] < errors[4]


def test_no_reflection_leaves_an_opaque_ball_black(quiet_page: Page) -> None:
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&k_t=3&left=none{EVEN}")
    picture = shot(page)
    height, width, _ = picture.pixels.shape
    assert picture.at(*View(width, height).center()).tolist() == [0, 0, 0]
    assert picture.name == "fresnel-preview-none-f82_tint.png"


def test_the_difference_is_amplified_and_has_a_legend(quiet_page: Page) -> None:
    page = opened(quiet_page, "&right=one_minus_cos&see=difference&gain=1")
    faint = shot(page).pixels.astype(float).mean()
    expect(page.locator(".legend-marks .high")).to_have_text("+255")
    box = page.locator("#preview-gain-box")
    box.fill("20")
    box.press("Enter")
    rested(page)
    assert shot(page).pixels.astype(float).mean() > 2 * faint
    expect(page.locator(".legend-marks .high")).to_have_text("+12.8")
    assert link(page)["gain"] == "20"


def test_keys_turn_the_scene_and_move_the_split(quiet_page: Page) -> None:
    page = opened(quiet_page)
    scene = page.locator(".scene")
    before = shot(page).pixels
    scene.focus()
    scene.press("ArrowRight")
    scene.press("ArrowUp")
    scene.press("+")
    rested(page)
    found = link(page)
    assert (found["yaw"], found["pitch"]) == ("3", "14")
    assert float(found["distance"]) < 6.2
    assert (shot(page).pixels != before).mean() > 0.1
    scene.press("Home")
    rested(page)
    assert np.array_equal(shot(page).pixels, before)

    divider = page.get_by_role("slider", name="Where the left side ends")
    divider.focus()
    divider.press("ArrowRight")
    expect(divider).to_have_attribute("aria-valuenow", "52")
    divider.press("End")
    expect(divider).to_have_attribute("aria-valuenow", "100")
    page.go_back()
    page.go_back()
    expect(divider).to_have_attribute("aria-valuenow", "50")


def test_the_pointer_turns_the_scene_and_moves_the_split(quiet_page: Page) -> None:
    page = opened(quiet_page)
    frame = page.locator(".scene-frame").bounding_box()
    assert frame
    x, y = frame["x"] + frame["width"] / 4, frame["y"] + frame["height"] / 3
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 100, y + 40, steps=5)
    page.mouse.up()
    expect(page).to_have_url(re.compile("yaw=35&pitch=25|pitch=25&yaw=35"))
    middle = frame["x"] + frame["width"] / 2
    page.mouse.move(middle, y)
    page.mouse.down()
    page.mouse.move(frame["x"] + frame["width"] * 0.25, y, steps=5)
    page.mouse.up()
    expect(page).to_have_url(re.compile(r"split=0\.2[3-7]"))


def test_the_split_has_each_side_where_it_belongs(quiet_page: Page) -> None:
    quiet_page.set_viewport_size(SMALL)
    pictures = {}
    for see in ("left", "right", "split"):
        page = opened(quiet_page, f"&right=one_minus_cos&split=0.5&see={see}")
        pictures[see] = shot(page).pixels
    half = pictures["split"].shape[1] // 2
    assert np.array_equal(pictures["split"][:, : half - 1], pictures["left"][:, : half - 1])
    assert np.array_equal(pictures["split"][:, half + 1 :], pictures["right"][:, half + 1 :])
    assert not np.array_equal(pictures["left"], pictures["right"])


def test_flicker_shows_one_after_the_other_and_can_be_paused(quiet_page: Page) -> None:
    page = opened(quiet_page, "&see=flicker")
    frame = page.locator(".scene-frame")
    expect(frame).to_have_attribute("data-show", "right")
    expect(frame).to_have_attribute("data-show", "left")
    page.get_by_role("button", name="pause", exact=True).click()
    shown = frame.get_attribute("data-show")
    page.wait_for_timeout(1600)
    assert frame.get_attribute("data-show") == shown
    page.get_by_role("button", name="other side").click()
    assert frame.get_attribute("data-show") != shown


def test_nothing_flickers_under_reduced_motion(quiet_page: Page) -> None:
    quiet_page.emulate_media(reduced_motion="reduce")
    page = opened(quiet_page, "&see=flicker")
    page.wait_for_timeout(1600)
    expect(page.locator(".scene-frame")).to_have_attribute("data-show", "left")
    expect(page.get_by_role("button", name="play", exact=True)).to_be_visible()


def test_every_model_can_stand_on_a_side(quiet_page: Page) -> None:
    page = opened(quiet_page)
    models = page.request.get("/api/v1/models?fields=id").json()["models"]
    select = page.get_by_label("Model on the right")
    offered = select.locator("option").evaluate_all("all => all.map(o => o.value)")
    assert sorted(offered) == sorted([*(m["id"] for m in models), "none"])
    select.select_option("schlick_four_percent")
    rested(page)
    assert link(page)["models"] == "schlick_four_percent"
    page.go_back()
    expect(select).to_have_value("schlick")


def test_examples_are_one_click_away(quiet_page: Page) -> None:
    page = opened(quiet_page)
    for button in page.locator(".preview-examples button").all():
        button.click()
        rested(page)
        expect(button).to_have_attribute("aria-pressed", "true")
    expect(page.locator(".notice")).to_have_count(0)


def test_a_link_with_nonsense_says_so(quiet_page: Page) -> None:
    page = opened(quiet_page, "&texels=1.5&paint=red&split=7&right=nobody")
    notice = page.locator(".notice")
    for name in ("texels = 1.5", "paint = red", "split = 7", "right = nobody"):
        expect(notice).to_contain_text(name)


def test_without_webgl_it_says_so(quiet_page: Page) -> None:
    quiet_page.add_init_script(
        """const own = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
          return kind === 'webgl2' ? null : own.call(this, kind, ...rest);
        };"""
    )
    page = quiet_page
    page.goto("/?view=preview")
    expect(page.locator(".no-webgl")).to_contain_text("no WebGL2")
    expect(page.locator(".scene")).to_have_count(0)
    page.get_by_label("Model on the right").select_option("one_minus_cos")
    expect(page).to_have_url(re.compile("models=one_minus_cos"))
    assert axe_violations(page) == []


def test_a_lost_context_comes_back(quiet_page: Page) -> None:
    page = opened(quiet_page)
    before = shot(page).pixels
    page.evaluate(
        """() => {
          const gl = document.querySelector('.scene').getContext('webgl2');
          window.lost = gl.getExtension('WEBGL_lose_context');
          window.lost.loseContext();
        }"""
    )
    expect(page.locator(".shown [role=alert]")).to_contain_text("comes back")
    page.evaluate("() => window.lost.restoreContext()")
    expect(page.locator(".shown [role=alert]")).to_be_empty()
    rested(page)
    assert np.array_equal(shot(page).pixels, before)


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("query", ["", "&see=difference&right_by=texture", "&see=flicker"])
def test_axe_finds_nothing(quiet_page: Page, theme: str, query: str) -> None:
    quiet_page.emulate_media(
        color_scheme="dark" if theme == "dark" else "light", reduced_motion="reduce"
    )
    page = opened(quiet_page, query)
    assert axe_violations(page) == []


def test_the_differences_are_copied_in_full_precision(quiet_page: Page) -> None:
    page = opened(quiet_page, "&right=one_minus_cos")
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    page.get_by_role("button", name="Copy the differences").click()
    expect(page.locator(".differences [data-flash=copied]")).to_be_visible()
    copied = json.loads(page.evaluate("() => navigator.clipboard.readText()"))
    assert (copied["left"], copied["right"]) == ("exact", "one_minus_cos")
    counted = page.locator(".differences .reason").inner_text().replace(",", "")
    assert str(copied["pixels"]) in counted
    names: tuple[Figure, ...] = ("steps.mean", "steps.largest", "colors.mean", "colors.largest")
    for name in names:
        of, which = name.split(".")
        assert copied[of][which] == pytest.approx(figure(page, name), rel=5e-3)


def test_code_and_tables_of_both_sides_are_below_the_picture(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=2&left=cos_form&right=schlick&left_by=texture&texels=8")
    expect(page.locator(".takeaway .column")).to_have_count(0)
    before = shot(page).pixels
    page.locator(".takeaway").scroll_into_view_if_needed()
    code = page.locator(".snippets code")
    expect(code).to_have_text(page.request.get("/api/v1/shaders/schlick").json()["code"])
    offered = page.get_by_label("Model whose code is shown")
    values = offered.locator("option").evaluate_all("all => all.map(o => o.value)")
    assert values == ["schlick", "cos_form", "exact", "vectors", "lookup"]
    offered.select_option("cos_form")
    page.locator(".snippets").get_by_label("Python").check()
    python = page.request.get("/api/v1/shaders/cos_form?language=python").json()
    expect(code).to_have_text(python["code"])

    page.get_by_label("Texels of the table").select_option("32")
    errors = page.request.get("/api/v1/lut/errors?model=cos_form&n_t=2").json()
    largest = errors["max_abs"]["unorm16"][errors["sizes"].index(32)]
    verdict = page.locator(".table-verdict")
    expect(verdict).to_contain_text("32 texels")
    assert float(verdict.inner_text().split()[-1].rstrip(".")) == pytest.approx(largest, rel=5e-3)
    asked = link(page)
    assert (asked["table_size"], asked["texels"], asked["code"]) == ("32", "8", "cos_form")
    rested(page)
    assert np.array_equal(shot(page).pixels, before)
    page.get_by_label("Model on the left").select_option("lut_1d")
    page.get_by_label("Model whose code is shown").select_option("lut_1d")
    expect(page.locator(".snippets .row-error")).to_contain_text("read from a table")
    expect(page.locator(".notice")).to_have_count(0)
    assert axe_violations(page) == []
    page.reload()
    expect(page.get_by_label("Model on the left")).to_have_value("lut_1d")


def test_it_fits_a_phone(quiet_page: Page) -> None:
    quiet_page.set_viewport_size({"width": 390, "height": 844})
    page = opened(quiet_page)
    page.locator(".takeaway").scroll_into_view_if_needed()
    expect(page.locator(".tables")).to_be_visible()
    assert page.evaluate("() => document.documentElement.scrollWidth") <= 390
    frame = page.locator(".scene-frame").bounding_box()
    assert frame
    assert frame["width"] == pytest.approx(frame["height"], abs=1)


def test_a_film_on_the_ball_has_the_colors_of_the_spectrum(quiet_page: Page) -> None:
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&layers=2.4:60&material=Ti{EVEN}")
    answer = page.request.get(
        "/api/v1/films/color?layers=2.4&material=Ti&thickness_nm=60&samples=721"
    ).json()
    colors = np.array(answer["colors"][0]["linear_srgb"][0])
    assert off_by(shot(page), over(answer["theta_i_deg"], colors.T)) <= STEPS


def test_a_clear_ball_lets_through_what_its_film_does_not_absorb(quiet_page: Page) -> None:
    """In even light: R + T^2 of the spectrum's colors, which of gold leaf is far less than 1."""
    quiet_page.set_viewport_size(SMALL)
    page = opened(quiet_page, f"&layers=Au:30&n_t=1&body=clear{EVEN}")
    of = "/api/v1/films/color?layers=Au&n_t=1&thickness_nm=30&samples=181"
    R, T = (
        np.array(
            page.request.get(f"{of}&quantity={quantity}").json()["colors"][0]["linear_srgb"][0]
        )
        for quantity in ("R", "T")
    )
    light = over(np.linspace(0.0, 90.0, 181), (R + T * T).T)
    assert off_by(shot(page), light, rim=False) <= STEPS + 1.0


def test_films_are_put_on_and_a_shortcut_beside_them(quiet_page: Page) -> None:
    page = opened(quiet_page)
    page.get_by_label("Film on the surface").select_option("1.3:400")
    rested(page)
    assert link(page)["layers"] == "1.3:400"
    right = page.get_by_label("Model on the right")
    expect(right.locator("option[value='film.gltf_iridescence']")).to_have_count(1)
    right.select_option("film.gltf_iridescence")
    rested(page)
    assert link(page)["right"] == "film.gltf_iridescence"
    assert figure(page, "colors.mean") > 0.5
    thickness = page.get_by_label("thickness in nm, value")
    thickness.fill("120")
    thickness.press("Enter")
    expect(page).to_have_url(re.compile(r"layers=1\.3%3A120"))
    page.goto("/?view=preview&layers=1.3:100,2.4:50&right=film.gltf_iridescence")
    expect(page.locator(".side-choice .reason").last).to_contain_text("a stack of several")


def test_what_is_not_known_of_a_film_is_said(quiet_page: Page) -> None:
    page = opened(quiet_page, "&layers=water:330,1.5:20&n_t=1&body=clear")
    expect(page.locator(".film-on .reason")).to_have_text("water: k is not known and counts as 0")
    chosen = page.get_by_label("Film on the surface").locator("option:checked")
    expect(chosen).to_have_text("2 layers, d of the first")


@pytest.mark.parametrize(
    ("query", "told", "way_back", "after"),
    [
        ("&layers=unobtanium:100", "layers = unobtanium", "Take the film away", {}),
        (
            "&layers=1.38:100&left=film.cycles_film&right=film.nonsense",
            "models = nonsense: one of cycles_film, gltf_iridescence",
            "Show a model in its place",
            {"layers": "1.38:100", "left": "film.cycles_film"},
        ),
    ],
    ids=["medium", "shortcut"],
)
def test_what_a_link_names_but_nobody_knows_is_said_with_the_way_back(
    page: Page, query: str, told: str, way_back: str, after: dict[str, str]
) -> None:
    page.goto(f"/?view=preview{query}")
    expect(page.get_by_role("alert").filter(has_text=told)).to_be_visible()
    expect(page.locator(".scene-frame")).to_be_hidden()
    page.get_by_role("button", name=way_back).click()
    rested(page)
    expect(page.locator(".scene-frame")).to_be_visible()
    assert link(page) == {"view": "preview", **after}
    expect(page.get_by_role("button", name=way_back)).to_be_hidden()
    # What was drawn before stays above what cannot be drawn.
    page.go_back()
    expect(page.get_by_role("alert").filter(has_text=told)).to_be_visible()
    expect(page.locator(".scene-frame")).to_be_visible()


def test_films_leads_to_the_ball(quiet_page: Page) -> None:
    page = quiet_page
    page.goto("/?view=films&layers=water:330&n_t=1&film_model=cycles_film")
    page.get_by_role("link", name="On a ball, in Preview").click()
    rested(page)
    shown = link(page)
    assert (shown["view"], shown["layers"], shown["n_t"]) == ("preview", "water:330", "1")
    assert (shown["right"], shown["body"]) == ("film.cycles_film", "clear")
