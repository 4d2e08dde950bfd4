"""Engines that draw by WebGL: headless Chromium runs a script of ours beside the engine's package."""

from __future__ import annotations

import base64
import functools
import http.server
import json
import shutil
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from playwright.sync_api import Page, sync_playwright

from tools.engines.questions import Settings, asked
from tools.engines.results import Told

SCRIPTS = Path(__file__).parent / "web"
CHROMIUM = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NPM = ("npm", "install", "--silent", "--no-save", "--prefix")
PIP = (sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target")
SOURCES = ("npm", "pip")

# One gray pixel, for the pictures that an engine fetches from its makers: it adds no noise.
_GRAY = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mNoaGgAAAMEAYF1LgG8AAAAAElFTkSuQmCC"
)


def told(
    package: str,
    version: str,
    script: str,
    modules: Mapping[str, str],
    source: str = "npm",
    settings: Settings = (),
) -> list[Told]:
    """Run a package in the browser and return the curves that its script finds.

    Parameters
    ----------
    package, version
        As npm, or the index of Python packages, knows them.
    script
        In `web`, without its ending.
    modules
        What the names that the script imports stand for, in the folder of packages.
    source
        "npm" or "pip".
    settings
        What is typed besides the media.
    """
    questions = asked(settings)
    with TemporaryDirectory() as name:
        folder = Path(name)
        if source == "npm":
            subprocess.run([*NPM, name, f"{package}@{version}"], check=True)
        else:
            subprocess.run(
                [*PIP, str(folder / "node_modules"), f"{package}=={version}"], check=True
            )
        shutil.copytree(SCRIPTS, folder / "web")
        imports = {key: f"/node_modules/{path}" for key, path in modules.items()}
        mapped = json.dumps({"imports": imports})
        (folder / "index.html").write_text(f'<script type="importmap">{mapped}</script>')
        with _page(folder) as page:
            found: list[Told] = page.evaluate(
                "async (asked) => (await import('/web/measure.js')).measure(...asked)",
                [script, *questions.values()],
            )
    return found


class _Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_: Any) -> None:
        """Say nothing of requests."""


@contextmanager
def _page(folder: Path) -> Iterator[Page]:
    handler = functools.partial(_Quiet, directory=str(folder))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    here = f"http://127.0.0.1:{server.server_port}"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium"), args=[*CHROMIUM]
        )
        page = browser.new_page()
        page.on("pageerror", lambda error: print(error, file=sys.stderr))
        page.route(
            lambda url: not url.startswith(here),
            lambda route: route.fulfill(
                body=_GRAY,
                content_type="image/png",
                headers={"access-control-allow-origin": "*"},
            ),
        )
        page.goto(f"{here}/index.html")
        try:
            yield page
        finally:
            browser.close()
            server.shutdown()
