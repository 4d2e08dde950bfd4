"""The panel of lookup tables in the Compare view."""

import io
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

import numpy as np
import png
from playwright.sync_api import Page, expect

from tests.browser.compare_page import api, axe_violations, link, opened


def test_says_what_a_table_costs_and_hands_it_out(quiet_page: Page) -> None:
    page = opened(quiet_page, "&n_t=2.4&models=schlick,lut_1d&code=exact")
    panel = page.locator(".tables")
    panel.scroll_into_view_if_needed()
    errors = api(page, "/lut/errors?n_t=2.4")
    at_256 = errors["max_abs"]["unorm16"][errors["sizes"].index(256)]
    expect(panel.locator(".table-verdict")).to_contain_text(f"{at_256:.2e}".replace("e-0", "e−"))
    assert panel.locator(".table-files a").all_inner_texts() == ["PNG", "NPY", "CSV", "JSON"]
    with page.expect_download() as download:
        panel.get_by_role("link", name="PNG").click()
    body = Path(download.value.path()).read_bytes()
    width, height, rows, info = png.Reader(bytes=body).read()
    assert (width, height, info["bitdepth"]) == (256, 1, 16)
    (texels,) = rows
    assert abs(texels[-1] / 65535 - (1.4 / 3.4) ** 2) < 1 / 65535

    panel.get_by_label("Texels of the table").select_option("16")
    panel.get_by_label("float").check()
    at_16 = errors["max_abs"]["float"][errors["sizes"].index(16)]
    expect(panel.locator(".table-verdict")).to_contain_text(f"{at_16:.3g}")
    assert link(page)["table_size"] == "16"
    assert link(page)["bits"] == "32"
    with page.expect_download() as download:
        panel.get_by_role("link", name="NPY").click()
    stored = np.load(io.BytesIO(Path(download.value.path()).read_bytes()))
    assert (stored.shape, stored.dtype) == ((16,), np.float32)
    page.reload()
    expect(panel.locator(".table-verdict")).to_contain_text("16 texels, float")


def test_the_size_is_picked_in_the_plot_by_pointer_and_keys(quiet_page: Page) -> None:
    page = opened(quiet_page)
    host = page.locator(".table-plot")
    host.scroll_into_view_if_needed()
    expect(page.locator(".tables .table-verdict")).to_contain_text("256 texels")
    box = host.bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] * 0.4, box["y"] + box["height"] * 0.5)
    expect(page.locator(".tables .table-verdict")).not_to_contain_text("256 texels")
    size = page.get_by_label("Texels of the table").input_value()
    assert int(size) in {8, 16, 32, 64}
    assert link(page)["table_size"] == size
    host.get_by_role("slider").focus()
    page.keyboard.press("ArrowRight")
    expect(page.get_by_label("Texels of the table")).to_have_value(str(2 * int(size)))
    page.keyboard.press("ArrowLeft")
    expect(page.get_by_label("Texels of the table")).to_have_value(size)


def test_rgb_of_a_metal_and_models_without_a_table(page: Page) -> None:
    opened(page, "&material=Au&models=one_minus_cos,f82_tint&code=exact")
    panel = page.locator(".tables")
    address = panel.get_by_role("link", name="RGB as EXR").get_attribute("href") or ""
    assert parse_qs(urlsplit(address).query)["channels"] == ["3"]
    answer = page.request.get(f"/{address}")
    assert answer.headers["content-type"] == "image/x-exr"
    assert float(answer.headers["interpolation-error"]) < 1e-3
    assert axe_violations(page) == []
    opened(page, "&n_i=1.5&n_t=1&models=cos_form")
    expect(panel.locator(".row-error")).to_contain_text("defined over the whole table")
    expect(panel.locator(".table-plot")).to_be_hidden()
