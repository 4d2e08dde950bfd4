"""Frames drawn per second while dragging, and what the first load costs, in headless Chromium.

A frame counts when what it shows has changed since the one before: the path of the first curve
while `n_t` is dragged, the incident ray or the marker while the angle is. Frames in which nothing
new was drawn do not count.
"""

from __future__ import annotations

import asyncio
import math
import os
import shutil
import time
from collections.abc import Callable
from dataclasses import dataclass, field

from playwright.async_api import Browser, Page, Response, async_playwright

from benchmarks.curves import served

SECONDS = 3.0
SWEEPS_PER_SECOND = 0.5
MOVES_PER_SECOND = 70
"""A little more often than frames are drawn, so that each frame has its move."""
BROWSERS = ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome")
BARS = {"n_t": 50.0, "theta_i": 55.0}
BYTES_BAR = 120_000
LIBRARIES = ("plotly", "katex")

COUNTER = """() => {
  const drawn = {curves: 0, ray: 0};
  const watch = (name, selector, attribute) => {
    let last = null;
    // All that is drawn in one frame happens at one time of the document's timeline.
    new MutationObserver(() => {
      const frame = document.timeline.currentTime;
      if (frame !== last) drawn[name] += 1;
      last = frame;
    }).observe(document.querySelector(selector), {attributeFilter: [attribute]});
  };
  watch('curves', '.plot-canvas path.js-line', 'd');
  watch('ray', '.ray-incident .ray-shaft', 'x1');
  window.drawnFrames = {read: () => ({...drawn, seconds: performance.now() / 1000})};
}"""

PAINT = """() => {
  const first = document.querySelector('.plot-canvas path.js-line');
  return first && first.getAttribute('d') ? performance.now() : 0;
}"""


@dataclass
class Load:
    """What the first load sent, with the bytes on the wire by address."""

    bytes_sent: dict[str, int] = field(default_factory=dict)
    before_curve: list[str] = field(default_factory=list)

    def besides_libraries(self) -> int:
        """Bytes besides Plotly and KaTeX."""
        return sum(n for url, n in self.bytes_sent.items() if not is_library(url))


def is_library(url: str) -> bool:
    """Whether an address is of Plotly or KaTeX."""
    return any(name in url.rsplit("/vendor/", 1)[-1] for name in LIBRARIES if "/vendor/" in url)


def find_browser() -> str:
    """Find the machine's browser."""
    found = os.environ.get("CHROME_PATH") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        raise SystemExit(f"no browser: set CHROME_PATH or install one of {', '.join(BROWSERS)}")
    return found


async def first_load(browser: Browser, url: str) -> tuple[Load, float]:
    """Load the page with empty caches; the bytes sent and ms to the first curve."""
    page = await browser.new_page(viewport={"width": 1440, "height": 900})
    session = await page.context.new_cdp_session(page)
    await session.send("Network.enable")
    load = Load()
    addresses: dict[str, str] = {}

    def note_response(event: dict[str, object]) -> None:
        response = event["response"]
        if isinstance(response, dict):
            addresses[str(event["requestId"])] = str(response["url"])

    def note_end(event: dict[str, object]) -> None:
        address = addresses.get(str(event["requestId"]))
        if address is not None:
            sent = event["encodedDataLength"]
            load.bytes_sent[address] = int(sent) if isinstance(sent, (int, float)) else 0

    session.on("Network.responseReceived", note_response)
    session.on("Network.loadingFinished", note_end)
    page.on("request", lambda request: load.before_curve.append(request.url))
    await page.goto(url, wait_until="commit")
    shown = await (await page.wait_for_function(PAINT)).json_value()
    load.before_curve = list(load.before_curve)
    await page.wait_for_load_state("networkidle")
    await page.close()
    return load, float(shown)


async def drag(page: Page, at: Callable[[float], tuple[float, float]]) -> dict[str, float]:
    """Hold the mouse down and move it as a hand would, without waiting for the page.

    Gives the frames a second by the page's own clock, from the first move to the last.
    """
    session = await page.context.new_cdp_session(page)

    def event(kind: str, x: float, y: float) -> asyncio.Task[object]:
        held = {"button": "left", "buttons": 1, "clickCount": 1}
        values = {"type": kind, "x": x, "y": y, **held}
        return asyncio.ensure_future(session.send("Input.dispatchMouseEvent", values))

    await event("mousePressed", *at(0.0))
    before = await page.evaluate("() => window.drawnFrames.read()")
    start = time.perf_counter()
    pending: list[asyncio.Task[object]] = []
    while (elapsed := time.perf_counter() - start) < SECONDS:
        pending.append(event("mouseMoved", *at(elapsed)))
        await asyncio.sleep(1 / MOVES_PER_SECOND)
    after = await page.evaluate("() => window.drawnFrames.read()")
    await asyncio.gather(*pending)
    await event("mouseReleased", *at(SECONDS))
    seconds = after["seconds"] - before["seconds"]
    return {key: (after[key] - before[key]) / seconds for key in ("curves", "ray")}


def swing(elapsed: float) -> float:
    """Go from 0 to 1 and back, smoothly."""
    return 0.5 - 0.5 * math.cos(2 * math.pi * SWEEPS_PER_SECOND * elapsed)


async def drags(browser: Browser, url: str) -> dict[str, dict[str, float]]:
    """Drag `n_t` on its slider, then the angle by the ray's handle."""
    page = await browser.new_page(viewport={"width": 1440, "height": 900})
    answers: list[Response] = []
    page.on("response", lambda answer: answers.append(answer))
    await page.goto(url)
    await page.wait_for_function(PAINT)
    await page.wait_for_timeout(2000)  # until the page rests
    await page.evaluate(COUNTER)

    slider = await page.locator("#n_t-slider").bounding_box()
    if slider is None:
        raise SystemExit("the page has no slider for n_t")
    left, middle = slider["x"], slider["y"] + slider["height"] / 2
    width = slider["width"]

    def on_slider(elapsed: float) -> tuple[float, float]:
        return left + width * (0.27 + 0.6 * swing(elapsed)), middle

    answers.clear()
    n_t = await drag(page, on_slider)
    n_t["answers"] = len([answer for answer in answers if "/curves" in answer.url]) / SECONDS
    await page.wait_for_timeout(500)

    handle = await page.locator(".diagram [role=slider]").bounding_box()
    stage = await page.locator(".diagram-svg").bounding_box()
    if handle is None or stage is None:
        raise SystemExit("the page has no ray to drag")
    x0, y0 = handle["x"] + handle["width"] / 2, handle["y"] + handle["height"] / 2
    x, y = stage["x"] + stage["width"] / 2, stage["y"] + stage["height"] / 2
    radius, first = math.hypot(x0 - x, y0 - y), math.atan2(x - x0, y - y0)

    def on_arc(elapsed: float) -> tuple[float, float]:
        theta = first + (math.radians(15) - first) * swing(elapsed)
        return x - radius * math.sin(theta), y - radius * math.cos(theta)

    theta_i = await drag(page, on_arc)
    await page.close()
    return {"n_t": n_t, "theta_i": theta_i}


async def run(port: int) -> None:
    """Measure and print."""
    url = f"http://127.0.0.1:{port}/"
    async with async_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = await playwright.chromium.launch(executable_path=find_browser(), args=arguments)
        await first_load(browser, url)  # the server compresses and caches on the first visit
        load, shown = await first_load(browser, url)
        rates = await drags(browser, url)
        await browser.close()
    n_t, theta_i = rates["n_t"], rates["theta_i"]
    print(
        f"dragging n_t:     {n_t['curves']:.1f} frames drawn per second"
        f" (bar: {BARS['n_t']:.0f}; {n_t['answers']:.0f} answers)"
    )
    print(
        f"dragging theta_i: {theta_i['ray']:.1f} frames drawn per second"
        f" (bar: {BARS['theta_i']:.0f})"
    )
    early = [address for address in load.before_curve if "katex" in address]
    print(f"first curve after {shown:.0f} ms; KaTeX asked for before it: {early or 'no'}")
    print(
        f"first load besides Plotly and KaTeX: {load.besides_libraries() / 1000:.1f} kB"
        f" (bar: {BYTES_BAR / 1000:.0f})"
    )
    largest = sorted(load.bytes_sent.items(), key=lambda item: -item[1])
    for address, sent in largest[:12]:
        print(f"  {sent / 1000:8.1f} kB  {address.removeprefix(url)}")


def main() -> None:
    """Serve the application with one worker and measure it."""
    with served("app.main:create_app", "--factory") as port:
        asyncio.run(run(port))


if __name__ == "__main__":
    main()
