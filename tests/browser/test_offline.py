"""The page without its server: what was seen is shown, and said to be kept."""

import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.exact import exact
from tests.browser.conftest import ROOT, wait_until_healthy

KEPT_SECONDS = 60.0
KEPT = """async () => navigator.serviceWorker.controller?.state === "activated"
  && (await (await caches.open("fresnel-answers")).keys()).length >= 5"""


@pytest.fixture
def own_server(tmp_path: Path) -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    url, log = f"http://127.0.0.1:{port}", tmp_path / "server.log"
    arguments = ["app.main:create_app", "--factory", "--port", str(port)]
    with (
        log.open("wb") as output,
        subprocess.Popen(
            [sys.executable, "-m", "uvicorn", *arguments],
            cwd=ROOT,
            # Else the browser's own cache would answer for an hour, and nothing be missing.
            env={**os.environ, "FRESNEL_MAX_AGE_S": "0"},
            stdout=output,
            stderr=subprocess.STDOUT,
        ) as server,
    ):
        try:
            wait_until_healthy(server, url, log)
            yield url, server
        finally:
            server.terminate()


def test_what_was_seen_is_shown_without_the_server_and_said_to_be_kept(
    browser: Browser, own_server: tuple[str, subprocess.Popen[bytes]]
) -> None:
    url, server = own_server
    context = browser.new_context(base_url=url, service_workers="allow")
    try:
        page = context.new_page()
        page.goto("/?n_t=1.7")
        curve = page.locator(".plot-host path.js-line").first
        curve.wait_for(state="attached", timeout=15_000)
        shown = page.locator('.number[aria-label^="R:"]').get_attribute("aria-label")
        deadline = time.monotonic() + KEPT_SECONDS
        while not page.evaluate(KEPT):
            assert time.monotonic() < deadline, "nothing is kept"
            page.wait_for_timeout(200)
        assert not page.locator('[data-notice="kept"]').count()

        server.terminate()
        server.wait(timeout=30)
        page.reload()
        curve.wait_for(state="attached", timeout=15_000)
        expect(page.locator('[data-notice="kept"]')).to_contain_text(
            re.compile(r"kept when it did, on \d{4}-\d\d-\d\d \d\d:\d\d UTC")
        )
        number = page.locator('.number[aria-label^="R:"]')
        expect(number).to_have_attribute("aria-label", shown or "")

        box = page.locator("#n_t-box")  # never computed by the server
        box.fill("1.9")
        box.press("Enter")
        notice = page.locator('[data-notice="server"]')
        expect(notice).to_contain_text("does not answer")
        expect(notice).to_contain_text("worked out here")
        R = exact(Interface(n_t=1.9), Incidence.from_degrees(64.0))
        expect(number).to_have_attribute("aria-label", re.compile(rf"R: {float(R):.6g}"))
        page.get_by_role("link", name="Theory").click()  # every view's files are here
        expect(page.locator(".view-theory")).to_be_visible(timeout=15_000)
    finally:
        context.close()
