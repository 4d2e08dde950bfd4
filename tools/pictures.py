"""Take the README's pictures from the running page: run it by `make pictures`.

The server answers on a free port of this machine, and Chromium is the one that CHROME_PATH names or
the first found on the PATH.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import uvicorn
from playwright.sync_api import Browser, sync_playwright

from app.main import create_app
from app.settings import Settings

FOLDER = Path(__file__).resolve().parent.parent / "docs"
BROWSERS = ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome")
SIZE = (1440, 900)
# What is there when a view is drawn.
CURVES = ".js-plotly-plot .scatterlayer path"
MAP = ".heatmaplayer image"
SCENE = ".differences:not([data-stale]) dd:not(:empty)"
# File name, colours, address of the page, what to wait for.
PICTURES: tuple[tuple[str, Literal["light", "dark"], str, str], ...] = (
    ("explore-light.png", "light", "/?n_t=1.5&theta_i_deg=64&models=schlick", CURVES),
    ("explore-dark.png", "dark", "/?n_t=1.5&theta_i_deg=64&models=schlick", CURVES),
    ("compare.png", "light", "/?view=compare", CURVES),
    ("albedo.png", "light", "/?view=albedo", MAP),
    ("materials.png", "light", "/?view=materials&material=Cu", MAP),
    ("theory-light.png", "light", "/?view=theory&step=below&own_deg=40", CURVES),
    ("theory-dark.png", "dark", "/?view=theory&step=below&own_deg=40", CURVES),
    (
        "films.png",
        "light",
        "/?view=films&material=water&layers=1.47:280&theta_i_deg=30&film_model=gltf_iridescence",
        CURVES,
    ),
    ("engines.png", "light", "/?view=engines&measured=chromium", CURVES),
    ("preview.png", "light", "/?view=preview&split=0.46", SCENE),
)


@contextlib.contextmanager
def served() -> Iterator[str]:
    """Serve the page from this process and yield its address."""
    settings = Settings(port=0)
    config = uvicorn.Config(
        create_app(settings), host=settings.host, port=settings.port, log_level="warning"
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        while not server.started and thread.is_alive():
            time.sleep(0.05)
        port = server.servers[0].sockets[0].getsockname()[1]
        yield f"http://{settings.host}:{port}"
    finally:
        server.should_exit = True
        thread.join()


def take(
    browser: Browser, url: str, scheme: Literal["light", "dark"], drawn: str, target: Path
) -> None:
    """Photograph one page after everything on it is drawn."""
    width, height = SIZE
    page = browser.new_page(
        viewport={"width": width, "height": height}, color_scheme=scheme, reduced_motion="reduce"
    )
    page.goto(url, wait_until="networkidle")
    page.evaluate("() => document.fonts.ready.then(() => undefined)")
    page.wait_for_selector(drawn)
    page.wait_for_timeout(500)  # the settled drawing follows the first one
    page.screenshot(path=target)
    page.close()


@contextlib.contextmanager
def launched() -> Iterator[Browser]:
    """Start the machine's own browser."""
    executable = os.environ.get("CHROME_PATH") or next(filter(None, map(shutil.which, BROWSERS)))
    # Chromium refuses to run its sandbox as root.
    arguments = ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=arguments)
        yield browser
        browser.close()


def main() -> None:
    """Take all pictures."""
    FOLDER.mkdir(exist_ok=True)
    with served() as address, launched() as browser:
        for name, scheme, path, drawn in PICTURES:
            take(browser, f"{address}{path}", scheme, drawn, FOLDER / name)
            print(f"docs/{name}: {(FOLDER / name).stat().st_size:,} bytes")


if __name__ == "__main__":
    main()
