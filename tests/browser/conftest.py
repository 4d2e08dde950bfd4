"""A running application and a Chromium to look at it with."""

import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import ConsoleMessage, Page, Request, expect

ROOT = Path(__file__).parents[2]
BROWSERS = ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome")
# Chromium without windows opens a page at half the cost.
SHELL = "chromium-headless-shell"
STARTUP_SECONDS = 60.0
# A busy machine must not turn a slow page into a failure.
expect.set_options(timeout=20_000)
# Without a graphics card Chromium reads a canvas back to show it, and says that this is slow.
GRAPHICS_REMARK = "GPU stall due to ReadPixels"
# The files of the page are kept in one test, which is about that, and not fetched again in the others.
KEEPING_REMARK = "Service Worker registration blocked by Playwright"


def find_browser() -> str | None:
    """Find the browser that CHROME_PATH names, else one on the PATH."""
    named = os.environ.get("CHROME_PATH")
    if named:
        return named
    return next(filter(None, map(shutil.which, BROWSERS)), None)


@pytest.fixture(scope="session")
def browser_type_launch_args(browser_type_launch_args: dict[str, Any]) -> dict[str, Any]:
    """Launch the machine's own browser; without one skip on a laptop and fail in CI."""
    browser = os.environ.get("CHROME_PATH") or shutil.which(SHELL) or find_browser()
    if browser is None:
        names = ", ".join((SHELL, *BROWSERS))
        reason = f"no browser: set CHROME_PATH or install one of {names}"
        if os.environ.get("CI") or os.environ.get("REQUIRE_BROWSER"):
            pytest.fail(reason)
        pytest.skip(reason)
    # Chromium refuses to run its sandbox as root.
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    return {
        **browser_type_launch_args,
        "executable_path": browser,
        "args": [*browser_type_launch_args.get("args", []), *(["--no-sandbox"] if root else [])],
    }


@contextmanager
def served(folder: Path, **settings: str) -> Iterator[str]:
    """Serve the application on a free port, with settings, and its log in a folder."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    url = f"http://127.0.0.1:{port}"
    log = folder / "server.log"
    arguments = ["app.main:create_app", "--factory", "--port", str(port)]
    arguments += ["--log-level", "warning", "--no-server-header"]  # as the program does
    with (
        log.open("wb") as output,
        subprocess.Popen(
            [sys.executable, "-m", "uvicorn", *arguments],
            cwd=ROOT,
            env={**os.environ, **settings},
            stdout=output,
            stderr=subprocess.STDOUT,
        ) as server,
    ):
        try:
            wait_until_healthy(server, url, log)
            yield url
        finally:
            server.terminate()


@pytest.fixture(scope="session")
def server_url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Serve the page from its sources, for the whole session."""
    with served(tmp_path_factory.mktemp("server"), FRESNEL_PAGE="sources") as url:
        yield url


@pytest.fixture(scope="session")
def packed_url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Serve the page packed, from a copy that nothing else is packed into."""
    folder = tmp_path_factory.mktemp("packed")
    if shutil.which("node") is None or not (ROOT / "node_modules" / "rolldown").is_dir():
        if os.environ.get("CI"):
            pytest.fail("the page cannot be packed without node and rolldown")
        pytest.skip("the page cannot be packed without node and rolldown")
    static = folder / "static"
    shutil.copytree(ROOT / "static", static, ignore=shutil.ignore_patterns("packed"))
    subprocess.run(["node", "tools/pack.mjs", str(static)], cwd=ROOT, check=True)
    with served(folder, FRESNEL_PAGE="packed", FRESNEL_STATIC_DIR=str(static)) as url:
        yield url


@pytest.fixture(params=["sources", "packed"])
def in_both_forms(
    request: pytest.FixtureRequest, browser_context_args: dict[str, Any]
) -> dict[str, Any]:
    """Run a file's tests on either form of the page, as its `browser_context_args`."""
    if request.param == "sources":
        return browser_context_args
    return {**browser_context_args, "base_url": request.getfixturevalue("packed_url")}


def wait_until_healthy(server: subprocess.Popen[bytes], url: str, log: Path) -> None:
    """Return when the server answers, fail with its log when it stops or stays silent."""
    deadline = time.monotonic() + STARTUP_SECONDS
    while server.poll() is None and time.monotonic() < deadline:
        try:
            with urllib.request.urlopen(f"{url}/api/v1/health", timeout=5):  # noqa: S310
                return
        except (urllib.error.URLError, ConnectionError, TimeoutError):
            time.sleep(0.1)
    pytest.fail(f"the server did not start:\n{log.read_text()}")


@pytest.fixture(scope="session")
def base_url(server_url: str) -> str:
    """Let `page.goto("/?n_t=1.5")` reach the server."""
    return server_url


@pytest.fixture(scope="session")
def browser_context_args(browser_context_args: dict[str, Any]) -> dict[str, Any]:
    """Let no service worker keep files, unless a test asks for one."""
    return {**browser_context_args, "service_workers": "block"}


@pytest.fixture
def quiet_page(page: Page, browser_context_args: dict[str, Any]) -> Iterator[Page]:
    """Give a page that must log nothing, raise nothing and ask no other host for anything."""
    noise: list[str] = []
    own_host = urlsplit(browser_context_args["base_url"]).netloc

    def note_console(message: ConsoleMessage) -> None:
        if GRAPHICS_REMARK in message.text or KEEPING_REMARK in message.text:
            return
        noise.append(f"console {message.type}: {message.text} {message.location}")

    def note_request(request: Request) -> None:
        address = urlsplit(request.url)
        if address.scheme not in ("data", "blob") and address.netloc != own_host:
            noise.append(f"request to another host: {request.url}")

    page.on("console", note_console)
    page.on("pageerror", lambda error: noise.append(f"uncaught: {error}"))
    page.on("request", note_request)
    yield page
    assert noise == []
