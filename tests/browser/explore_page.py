"""Words for what the tests of the Explore view do."""

import re
from typing import Any
from urllib.parse import parse_qs, urlsplit

from playwright.sync_api import Page, expect

READY_MS = 15_000


def opened(page: Page, query: str = "") -> Page:
    """Open the view and wait for its first curve, which comes when it is seen, and its numbers."""
    page.goto(f"/{query}")
    page.locator(".plot-area").first.scroll_into_view_if_needed(timeout=READY_MS)
    page.locator(".plot-host path.js-line").first.wait_for(state="attached", timeout=READY_MS)
    page.evaluate("scrollTo(0, 0)")
    expect(number(page, "R")).to_be_visible()
    return page


def number(page: Page, name: str) -> Any:
    """Find the button that shows a number and copies it."""
    return page.locator(f'.number[aria-label^="{name}:"]')


def box(page: Page, parameter: str) -> Any:
    """Find the number box of a parameter."""
    return page.locator(f"#{parameter}-box")


def link(page: Page) -> dict[str, str]:
    """Read what the address says."""
    return {key: values[0] for key, values in parse_qs(urlsplit(page.url).query).items()}


def at_rest(page: Page) -> dict[str, str]:
    """Wait until a movement has ended and the REST call says what the address says."""
    page.wait_for_function(
        """() => {
          const call = document.querySelector("#calls code").textContent.split("?")[1];
          const said = new URLSearchParams(call);
          return [...new URLSearchParams(location.search)]
            .every(([key, value]) => said.get(key) === value);
        }"""
    )
    return link(page)


def settled_link(page: Page, key: str, pattern: str) -> None:
    """Wait until the address says something of a key."""
    expect(page).to_have_url(re.compile(rf"[?&]{re.escape(key)}={pattern}(&|$)"))


def type_into(page: Page, parameter: str, text: str) -> None:
    """Type into a number box and leave it."""
    field = box(page, parameter)
    field.fill(text)
    field.press("Enter")
