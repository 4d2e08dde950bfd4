"""The API's documentation page: this server's own, quiet, usable by keyboard and reader."""

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, Response, expect

ROOT = Path(__file__).parents[2]
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
IMMUTABLE = "public, max-age=31536000, immutable"


def open_route(page: Page, path: str) -> Any:
    """Open the documentation and in it one route; return the route's block."""
    page.goto("/docs")
    block = page.locator(".opblock").filter(
        has=page.locator(f'.opblock-summary-path[data-path="{path}"]')
    )
    block.locator(".opblock-summary-control").click()
    expect(block.get_by_role("button", name="Execute")).to_be_visible()
    return block


def field(block: Any, name: str) -> Any:
    """Find the input of the parameter `name`."""
    return block.locator(f'tr[data-param-name="{name}"]').locator("input, select")


def axe_violations(page: Page) -> list[str]:
    """Return the rules that axe-core finds broken, each with the first offender."""
    page.evaluate(AXE.read_text("utf-8"))
    found = page.evaluate("() => axe.run()")
    return [f"{v['id']}: {v['nodes'][0]['html']}" for v in found["violations"]]


@pytest.mark.parametrize("address", ["/docs", "/docs/"])
def test_shows_every_route_with_no_message_and_no_other_host(
    quiet_page: Page, address: str
) -> None:
    quiet_page.goto(address)
    expect(quiet_page.locator(".opblock").first).to_be_visible()
    schema = quiet_page.request.get("/openapi.json").json()
    shown = quiet_page.locator(".opblock-summary-path").evaluate_all(
        "elements => elements.map((element) => element.dataset.path)"
    )
    operations = [path for path, methods in schema["paths"].items() for _ in methods]
    assert "/api/v1/curves" in shown
    assert sorted(shown) == sorted(operations)


def test_executes_a_call_and_shows_its_answer(quiet_page: Page) -> None:
    block = open_route(quiet_page, "/api/v1/snell")
    field(block, "theta_i_deg").fill("64")
    block.get_by_role("button", name="Execute").click()
    answer = block.locator(".live-responses-table .response .microlight").first
    expect(answer).to_contain_text('"theta_i_deg": 64')
    assert json.loads(answer.inner_text())["R"] == pytest.approx(0.113, abs=1e-4)


def test_sends_only_what_differs_from_the_defaults(quiet_page: Page) -> None:
    # With every default sent, /curves would refuse the parameters of models not asked for.
    block = open_route(quiet_page, "/api/v1/curves")
    field(block, "n_t").fill("1.33")
    field(block, "models").fill("exact,schlick")
    with quiet_page.expect_response("**/api/v1/curves**") as caught:
        block.get_by_role("button", name="Execute").click()
    response: Response = caught.value
    assert response.status == 200
    assert response.url.partition("?")[2] == "n_t=1.33&models=exact%2Cschlick"
    expect(block.locator(".request-url")).to_contain_text("n_t=1.33")


def test_a_path_parameter_is_kept(quiet_page: Page) -> None:
    block = open_route(quiet_page, "/api/v1/models/{model_id}")
    field(block, "model_id").fill("schlick")
    block.get_by_role("button", name="Execute").click()
    answer = block.locator(".live-responses-table .response .microlight").first
    expect(answer).to_contain_text('"id": "schlick"')


def test_leads_back_to_the_explorer(quiet_page: Page) -> None:
    quiet_page.goto("/docs/")
    link = quiet_page.get_by_role("link", name="Explorer", exact=True)
    expect(link).to_have_js_property("href", quiet_page.url.removesuffix("docs/"))


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_follows_the_theme(page: Page, scheme: Any) -> None:
    page.emulate_media(color_scheme=scheme)
    open_route(page, "/api/v1/snell")
    background, ink = page.evaluate(
        """() => [getComputedStyle(document.documentElement).backgroundColor,
                  getComputedStyle(document.querySelector(".opblock-summary-path")).color]"""
    )
    dark = ("rgb(14, 17, 21)", "rgb(233, 236, 241)")
    light = ("rgb(250, 249, 246)", "rgb(20, 24, 31)")
    assert (background, ink) == (dark if scheme == "dark" else light)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_is_accessible(page: Page, scheme: Any) -> None:
    page.emulate_media(color_scheme=scheme, reduced_motion="reduce")
    block = open_route(page, "/api/v1/snell")
    block.get_by_role("button", name="Execute").click()
    expect(block.locator(".live-responses-table").first).to_be_visible()
    # A second route, and in it a required parameter left empty.
    other = page.locator(".opblock").filter(has_text="/api/v1/models/{model_id}")
    other.locator(".opblock-summary-control").click()
    other.get_by_role("button", name="Execute").click()
    expect(other.locator("input.invalid")).to_be_visible()
    assert axe_violations(page) == []


def test_says_so_when_the_schema_cannot_be_read(page: Page) -> None:
    page.route("**/openapi.json", lambda route: route.fulfill(status=503, body=""))
    page.goto("/docs/")
    expect(page.locator("#swagger")).to_contain_text("could not be read: it answered 503")


def test_caches_the_bundle_for_ever_and_the_page_not(page: Page) -> None:
    caching: dict[str, str] = {}

    def note(response: Response) -> None:
        caching[response.url.partition("?")[0]] = response.headers.get("cache-control", "")

    page.on("response", note)
    page.goto("/docs/", wait_until="networkidle")
    bundles = {url: value for url, value in caching.items() if "/vendor/" in url}
    assert any(url.endswith("swagger-ui-bundle.js") for url in bundles)
    assert set(bundles.values()) == {IMMUTABLE}
    own = {url: value for url, value in caching.items() if "/docs/" in url}
    assert {"docs.js", "docs.css", ""} <= {url.rpartition("/")[2] for url in own}
    assert set(own.values()) == {"no-cache"}
