"""A figure for a paper or a slide: size, ground, letters and caption, as the saved files have them."""

import io
import re
import struct
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Download, Page, Route, expect

from tests.browser.explore_page import READY_MS, opened
from tests.browser.test_accessible import AXE

SVG = "{http://www.w3.org/2000/svg}"
MM_PER_POINT = 25.4 / 72
# Red, green, blue and opacity near a picture's corner, as the browser decodes it.
PIXELS = """async (bytes) => {
  const picture = await createImageBitmap(new Blob([new Uint8Array(bytes)]));
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  const context = canvas.getContext('2d');
  context.drawImage(picture, 0, 0);
  return [...context.getImageData(2, 2, 1, 1).data];
}"""


def sheet(page: Page, what: str = "plot") -> Any:
    """Open the sheet of a figure and wait for its preview."""
    page.get_by_role("button", name=f"For print… ({what})", exact=True).click()
    dialog = page.get_by_role("dialog", name="Figure for print")
    expect(dialog.locator(".publish-preview img").first).to_be_visible(timeout=READY_MS)
    return dialog


def visited(page: Page, query: str) -> Page:
    """Open a view that is not the first one and wait until it stands still."""
    page.goto(f"/?{query}")
    page.locator(".js-plotly-plot .main-svg").first.wait_for(timeout=READY_MS)
    page.wait_for_load_state("networkidle")
    return page


def source_of(page: Page, material: str) -> str:
    """Say whom the API names for a material."""
    answer = page.request.get(f"/api/v1/materials/{material}").json()
    return str(answer["source"]).rstrip(".")


def saved(page: Page, dialog: Any, kind: str) -> bytes:
    """Save the figure and return the file."""
    with page.expect_download() as download:
        dialog.get_by_role("button", name=f"Save as {kind.upper()}").click()
    assert download.value.suggested_filename.endswith(f"-print.{kind}")
    return download.value.path().read_bytes()


def chunks(png: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Parts of a PNG, read as its specification has them."""
    file = io.BytesIO(png[8:])
    while head := file.read(8):
        length, kind = struct.unpack(">I4s", head)
        yield kind, file.read(length)
        file.read(4)


def mm(root: ET.Element, side: str) -> float:
    """Width or height of an SVG, which has to be in mm."""
    written = root.attrib[side]
    assert written.endswith("mm")
    return float(written.removesuffix("mm"))


@pytest.mark.parametrize(("width", "points"), [(85, 7), (174, 9)])
def test_size_and_letters_are_those_asked_for(quiet_page: Page, width: int, points: int) -> None:
    dialog = sheet(opened(quiet_page, "?models=schlick"))
    dialog.get_by_label("Width, mm").fill(str(width))
    dialog.get_by_label("Font size, pt").fill(str(points))
    root = ET.fromstring(saved(quiet_page, dialog, "svg"))  # noqa: S314 (made by the page)
    assert mm(root, "width") == pytest.approx(width, abs=1e-3)
    assert mm(root, "height") > 60  # the caption stands below
    px = float(root.attrib["viewBox"].split()[2])
    ticks = root.findall(f".//{SVG}g[@class='xtick']/{SVG}text")
    sizes = {re.findall(r"font-size: ([\d.]+)px", tick.attrib["style"])[0] for tick in ticks}
    assert len(sizes) == 1
    assert float(sizes.pop()) * width / px / MM_PER_POINT == pytest.approx(points, rel=1e-3)


def test_caption_has_parameters_and_sources(quiet_page: Page) -> None:
    page = opened(quiet_page, "?n_t=1.7&models=schlick")
    dialog = sheet(page)
    box = dialog.get_by_label("Text of the caption")
    reference = page.request.get("/api/v1/models/schlick").json()["reference"].rstrip(".")
    expect(box).to_have_value(re.compile(re.escape(reference)))  # which is asked for
    caption = box.input_value()
    version = page.request.get("/api/v1/health").json()["version"]
    assert "n_i = 1; n_t = 1.7; k_t = 0" in caption
    assert "albedo" not in caption  # a fit of the albedo has the same id
    assert f"Fresnel Explorer {version}, {page.url}" in caption
    box.fill("A title of my own & <mine>")
    text = "".join(ET.fromstring(saved(page, dialog, "svg")).itertext())  # noqa: S314
    assert "A title of my own & <mine>" in text
    assert "Fresnel Explorer" not in text
    dialog.get_by_label("Caption below the figure").uncheck()
    root = ET.fromstring(saved(page, dialog, "svg"))  # noqa: S314
    assert mm(root, "height") == pytest.approx(60, abs=1e-3)
    assert "my own" not in "".join(root.itertext())


@pytest.mark.parametrize("what", ["curves", "errors"])
def test_caption_of_a_family_names_every_index(quiet_page: Page, what: str) -> None:
    page = visited(quiet_page, "view=compare&n_t=1.52&family=1.31,2.417,3.5&models=schlick")
    expect(page.locator(".js-plotly-plot").first.locator("path.js-line")).to_have_count(8)
    caption = sheet(page, what).get_by_label("Text of the caption").input_value()
    assert "n_i = 1; n_t = 1.52, 1.31, 2.417, 3.5; k_t = 0." in caption


@pytest.mark.parametrize(
    ("ground", "corner"),
    [("white", [255, 255, 255, 255]), ("transparent", [0] * 4), ("dark slides", [0] * 4)],
)
def test_png_has_its_ground_and_says_its_size(
    quiet_page: Page, ground: str, corner: list[int]
) -> None:
    quiet_page.emulate_media(color_scheme="dark")
    page = opened(quiet_page)
    dialog = sheet(page)
    option = dialog.locator("option", has_text=re.compile(f"{ground}$")).get_attribute("value")
    dialog.get_by_label("Background").select_option(option)
    png = saved(page, dialog, "png")
    parts = dict(chunks(png))
    width, _ = struct.unpack(">II", parts[b"IHDR"][:8])
    x, y, unit = struct.unpack(">IIB", parts[b"pHYs"])
    assert (x, unit) == (y, 1)
    assert width / x * 1000 == pytest.approx(85, abs=0.1)
    assert page.evaluate(PIXELS, list(png)) == corner


def test_what_cannot_be_is_said_and_not_saved(quiet_page: Page) -> None:
    dialog = sheet(opened(quiet_page))
    dialog.get_by_label("Width, mm").fill("5")
    dialog.get_by_role("button", name="Save as SVG").click()
    expect(dialog.get_by_role("alert")).to_have_text("Width, mm: 30 to 400")
    dialog.get_by_label("Width, mm").fill("40")
    dialog.get_by_label("Font size, pt").fill("24")
    expect(dialog.get_by_role("alert")).to_contain_text("24 pt letters need a width of")
    quiet_page.keyboard.press("Escape")
    expect(dialog).to_be_hidden()
    expect(quiet_page.get_by_role("button", name="For print… (plot)")).to_be_focused()


@pytest.mark.parametrize(
    ("view", "what", "count"),
    [
        ("compare", "curves", 1),
        ("albedo", "map", 1),
        ("materials", "“Over the wavelength”", 1),
        ("materials", "“Two Schlicks against the spectrum”", 2),
    ],
)
def test_other_views_have_it(quiet_page: Page, view: str, what: str, count: int) -> None:
    page = visited(quiet_page, f"view={view}")
    dialog = sheet(page, what)
    captions = [box.input_value() for box in dialog.get_by_label("Text of the caption").all()]
    names = [caption.split("\n")[0] for caption in captions]
    assert dialog.locator(".publish-preview img").count() == len(set(names)) == count
    downloads: list[Download] = []
    page.on("download", lambda download: downloads.append(download))
    saved(page, dialog, "svg")
    while len(downloads) < count:
        page.wait_for_timeout(20)
    assert len({download.suggested_filename for download in downloads}) == count
    for download, own in zip(downloads, names, strict=True):
        root = ET.fromstring(download.path().read_bytes())  # noqa: S314 (made by the page)
        assert mm(root, "width") == pytest.approx(85, abs=1e-3)
        text = "".join("".join(root.itertext()).split())
        assert [name for name in names if "".join(name.split()) in text] == [own]


@pytest.mark.parametrize(
    ("query", "what", "cited", "others"),
    [
        ("view=materials&plot_of=F0", "“Over the wavelength”", ("Au", "Au-Johnson"), ()),
        (
            "view=materials&preset=Au&material=Cu&rivals=hidden",
            "“Over the wavelength”",
            ("Au",),
            ("Cu",),
        ),
        ("view=compare&material=Cu", "curves", ("Cu",), ("Au",)),
        ("view=compare&material=Au&over=n-k", "figure of the error", (), ("Au",)),
        (
            "view=compare&material=Au&over=n-k&incident=water",
            "figure of the error",
            ("water",),
            ("Au",),
        ),
        ("view=compare&material=water", "figure of the error", (), ("water",)),
        ("view=albedo&material=Cu&incident=water", "albedos", (), ("Cu", "water")),
        ("view=albedo&material=Cu&incident=water", "map", ("water",), ("Cu",)),
    ],
)
def test_caption_cites_the_measurements_that_are_drawn(
    quiet_page: Page, query: str, what: str, cited: tuple[str, ...], others: tuple[str, ...]
) -> None:
    page = visited(quiet_page, query)
    caption = sheet(page, what).get_by_label("Text of the caption").input_value()
    for material in cited:
        described = page.request.get(f"/api/v1/materials/{material}").json()
        assert described["source"].rstrip(".") in caption
        assert all(doi in caption for doi in described["doi"])
    for material in others:
        assert source_of(page, material) not in caption


def test_caption_says_the_wavelength(quiet_page: Page) -> None:
    page = opened(quiet_page, "?material=Au&wavelength_nm=550&models=schlick")
    caption = sheet(page).get_by_label("Text of the caption").input_value()
    assert f"Gold at 550 nm: {source_of(page, 'Au')}" in caption


def test_a_sweep_says_which_index_is_the_materials(quiet_page: Page) -> None:
    page = visited(quiet_page, "view=compare&material=Au&wavelength_nm=550&over=n")
    caption = sheet(page, "figure of the error").get_by_label("Text of the caption").input_value()
    answer = page.request.get("/api/v1/materials/Au?wavelength_nm=550").json()
    k_t = answer["constants"]["k"]
    assert f"k_t = {k_t}" in caption
    assert f"k_t of Gold at 550 nm: {source_of(page, 'Au')}" in caption


SOURCES = "**/api/v1/materials?fields=id,name,kind,wavelength_nm,source,doi"


def test_captions_come_back_after_a_failure(page: Page) -> None:
    opened(page, "?models=schlick")
    page.route(SOURCES, lambda route: route.abort())
    dialog = sheet(page)
    expect(dialog.get_by_role("alert")).to_contain_text("The sources cannot be had")
    expect(dialog.get_by_label("Text of the caption")).to_have_value("")
    dialog.get_by_role("button", name="Close").click()
    page.unroute(SOURCES)
    dialog = sheet(page)
    expect(dialog.get_by_role("alert")).to_be_hidden()
    expect(dialog.get_by_label("Text of the caption")).to_have_value(re.compile("Schlick"))
    expect(dialog.get_by_label("Caption below the figure")).to_be_checked()


def test_a_slow_caption_waits_and_stays_in_its_own_sheet(quiet_page: Page) -> None:
    page = visited(quiet_page, "view=compare")
    held: list[Route] = []
    page.route(SOURCES, lambda route: held.append(route))
    page.get_by_role("button", name="For print… (curves)").click()
    dialog = page.get_by_role("dialog", name="Figure for print")
    box = dialog.get_by_label("Text of the caption")
    expect(box).to_be_disabled()
    expect(dialog.get_by_role("button", name="Save as SVG")).to_be_disabled()
    dialog.get_by_role("button", name="Close").click()
    page.get_by_role("button", name="For print… (errors)").click()
    while box.is_disabled():
        while held:
            held.pop().continue_()  # the later one first
        page.wait_for_timeout(20)
    expect(box).to_have_value(re.compile("^Error of the models"))
    page.wait_for_load_state("networkidle")
    expect(box).to_have_value(re.compile("^Error of the models"))


def test_what_was_typed_is_kept(quiet_page: Page) -> None:
    page = visited(quiet_page, "view=compare")
    dialog = sheet(page, "curves")
    box = dialog.get_by_label("Text of the caption")
    box.fill("Figure 3, of my own")
    dialog.get_by_role("button", name="Close").click()
    expect(sheet(page, "errors").get_by_label("Text of the caption")).not_to_have_value(
        re.compile("of my own")
    )
    dialog.get_by_role("button", name="Close").click()
    expect(sheet(page, "curves").get_by_label("Text of the caption")).to_have_value(
        "Figure 3, of my own"
    )


def test_a_png_that_cannot_be_made_is_said(quiet_page: Page) -> None:
    dialog = sheet(opened(quiet_page))
    dialog.get_by_label("Width, mm").fill("400")
    # What a browser does with a canvas that is larger than it can have.
    quiet_page.evaluate("() => { HTMLCanvasElement.prototype.toBlob = (done) => done(null); }")
    dialog.get_by_role("button", name="Save as PNG").click()
    expect(dialog.get_by_role("alert")).to_contain_text("cannot make a PNG of 400 × 60 mm")


def test_the_pointer_of_the_page_is_not_printed(quiet_page: Page) -> None:
    page = opened(quiet_page, "?marks=off")
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the plot as SVG").click()
    lines = f".//{SVG}g[@class='shapelayer']/{SVG}*"

    def count(file: bytes) -> int:
        return len(ET.fromstring(file).findall(lines))  # noqa: S314 (made by the page)

    assert count(download.value.path().read_bytes()) == 1
    assert count(saved(page, sheet(page), "svg")) == 0


def test_a_map_needs_room_for_its_key(quiet_page: Page) -> None:
    dialog = sheet(visited(quiet_page, "view=albedo"), "map")
    dialog.get_by_label("Width, mm").fill("60")
    expect(dialog.get_by_role("alert")).to_contain_text("7 pt letters need a width of")


def test_what_is_written_stays_on_the_picture(quiet_page: Page) -> None:
    models = "schlick,schlick_ior,lazanyi2005,spherical_gaussian,cook_torrance"
    page = opened(quiet_page, f"?models={models}")
    dialog = sheet(page)
    dialog.get_by_label("Text of the caption").fill("n_i n_t k_t theta_i_deg 1 " * 12)
    dialog.get_by_label("Width, mm").fill("60")
    source = saved(page, dialog, "svg").decode()
    document = page.context.new_page()  # where no policy forbids the picture's own style
    document.set_content(source)
    names, outside = document.evaluate(
        """async () => {
          await document.fonts.ready;
          const edge = document.querySelector("svg").getBoundingClientRect();
          const texts = [...document.querySelectorAll("text")].filter((t) => t.textContent.trim());
          const beyond = texts.filter((text) => {
            const box = text.getBoundingClientRect();
            return box.left < edge.left || box.right > edge.right + 0.5 || box.bottom > edge.bottom;
          });
          return [texts, beyond].map((some) => some.map((text) => text.textContent));
        }"""
    )
    assert "Lazanyi" in " ".join(names)
    assert "theta_i_deg" in " ".join(names)
    assert outside == []


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_axe_finds_nothing(quiet_page: Page, theme: str) -> None:
    quiet_page.emulate_media(color_scheme="dark" if theme == "dark" else "light")
    dialog = sheet(opened(quiet_page))
    dialog.get_by_label("Width, mm").fill("5")
    expect(dialog.get_by_role("alert")).not_to_be_empty()
    quiet_page.evaluate(AXE.read_text(encoding="utf-8"))
    found = quiet_page.evaluate("() => axe.run()")
    assert [(v["id"], v["nodes"][0]["html"]) for v in found["violations"]] == []
