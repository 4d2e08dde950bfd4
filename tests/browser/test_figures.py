"""A figure's page, from the server and from a file, in the browser."""

from pathlib import Path

import pytest
from playwright.sync_api import Page

QUERY = "n_t=1.5&models=schlick&format=html"


@pytest.mark.parametrize("saved", [False, True], ids=["served", "saved"])
def test_a_page_draws_itself_and_asks_nobody(
    page: Page, server_url: str, saved: bool, tmp_path: Path
) -> None:
    address = f"{server_url}/api/v1/figures/compare?{QUERY}"
    if saved:
        file = tmp_path / "figure.html"
        file.write_bytes(page.request.get(address).body())
        address = file.as_uri()
    asked: list[str] = []
    faults: list[str] = []
    page.on("request", lambda request: asked.append(request.url))
    page.on("console", lambda message: faults.append(message.text))
    page.on("pageerror", lambda error: faults.append(str(error)))
    page.goto(address)
    page.wait_for_selector("#plot .main-svg")
    assert page.locator("#plot .scatterlayer .trace").count() == 3
    assert page.get_by_text("Fresnel Explorer").is_visible()
    assert [url for url in asked if not url.startswith(("data:", "blob:"))] == [address]
    assert faults == []


def test_a_page_can_be_embedded_elsewhere(page: Page, server_url: str) -> None:
    page.set_content(f'<iframe src="{server_url}/api/v1/figures/explore?format=html"></iframe>')
    page.frame_locator("iframe").locator("#plot .main-svg").first.wait_for()
