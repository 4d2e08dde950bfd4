"""Words for what the tests of the Compare view do."""

from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

from playwright.sync_api import Page, expect

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
