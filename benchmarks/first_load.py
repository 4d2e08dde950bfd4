"""How soon a new visitor sees a curve, from near and far, in headless Chromium with an empty cache.

Two times are taken: when a curve is first seen, which the server has drawn into the document, and
when the page's own plot stands, which can be touched. With another build's folder in FRESNEL_OLDER both
are measured in turn, and the ratios are to the plot of that build, which was its first curve. What was
asked for and sent before the first curve is listed at the slowest of the connections.
"""

from __future__ import annotations

import asyncio
import os
import statistics
from dataclasses import dataclass, field

from playwright.async_api import Browser, async_playwright

from app.page.packed import packed
from app.settings import Settings
from benchmarks.drag import find_browser, is_library
from benchmarks.load import beside_the_older

ROUNDS = 3
LINES = {
    "0 ms": (0, -1, 0.5),
    "150 ms, 20 Mbit/s": (150, 20e6 / 8, 1 / 3),
    "400 ms, 400 kbit/s": (400, 400e3 / 8, 1 / 4),
}
"""Round trip in ms, bytes a second (-1: as many as there are), and the share of the older time."""
MOST_REQUESTS = 12
MOST_BYTES = 100_000

SEEN = """(drawn) => {
  const painted = performance.getEntriesByName('first-contentful-paint')[0];
  const curve = document.querySelector('.first-curves path, .plot-canvas path.js-line[d]');
  if (!painted || !curve) return 0;
  // A document that was whole by then was painted with its curve, though scripts kept us from asking.
  const [sent] = performance.getEntriesByType('navigation');
  const whole = sent.domInteractive;
  return drawn && whole && whole <= painted.startTime ? painted.startTime : performance.now();
}"""
PLOTTED = """() => {
  const curve = document.querySelector('.plot-canvas path.js-line');
  return curve && curve.getAttribute('d') ? performance.now() : 0;
}"""


@dataclass
class Load:
    """Times in ms, and what was asked for before each."""

    seen: float = 0.0
    plotted: float = 0.0
    shift: float = 0.0
    asked: list[str] = field(default_factory=list)
    until_seen: int = 0
    until_plotted: int = 0
    sent: dict[str, int] = field(default_factory=dict)


SHIFTS = """() => {
  window.layoutShifts = 0;
  new PerformanceObserver((list) => {
    for (const one of list.getEntries()) if (!one.hadRecentInput) window.layoutShifts += one.value;
  }).observe({type: 'layout-shift', buffered: true});
}"""


async def load(browser: Browser, url: str, line: tuple[float, float, float]) -> Load:
    """Open the page once in a fresh context."""
    context = await browser.new_context(viewport={"width": 1440, "height": 900})
    page = await context.new_page()
    session = await context.new_cdp_session(page)
    await session.send("Network.enable")
    latency, throughput, _ = line
    conditions = {
        "offline": False,
        "latency": latency,
        "downloadThroughput": throughput,
        "uploadThroughput": throughput,
    }
    await session.send("Network.emulateNetworkConditions", conditions)
    found, names = Load(), dict[str, str]()

    def note_request(event: dict[str, object]) -> None:
        request = event["request"]
        if isinstance(request, dict):
            names[str(event["requestId"])] = str(request["url"])
            found.asked.append(str(request["url"]))

    def note_data(event: dict[str, object]) -> None:
        name = names.get(str(event["requestId"]), "")
        size = event.get("encodedDataLength")
        found.sent[name] = found.sent.get(name, 0) + (int(size) if isinstance(size, int) else 0)

    session.on("Network.requestWillBeSent", note_request)
    session.on("Network.dataReceived", note_data)
    await page.add_init_script(f"({SHIFTS})()")
    document = await page.goto(url, wait_until="commit")
    drawn = document is not None and "first-curves" in await document.text()
    seen = await page.wait_for_function(SEEN, arg=drawn, timeout=120_000)
    found.seen = float(await seen.json_value())
    found.until_seen = sum(n for name, n in found.sent.items() if not is_library(name))
    found.plotted = float(
        await (await page.wait_for_function(PLOTTED, timeout=120_000)).json_value()
    )
    found.until_plotted = sum(n for name, n in found.sent.items() if not is_library(name))
    found.asked = list(found.asked)
    found.shift = float(await page.evaluate("() => window.layoutShifts"))
    await context.close()
    return found


async def run(ports: dict[str, int]) -> None:
    """Measure and print, for builds by name: this one first."""
    async with async_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = await playwright.chromium.launch(executable_path=find_browser(), args=arguments)
        for port in ports.values():
            # The server compresses and caches on the first visit.
            await load(browser, f"http://127.0.0.1:{port}/", LINES["0 ms"])
        for name, line in LINES.items():
            loads: dict[str, list[Load]] = {build: [] for build in ports}
            for _ in range(ROUNDS):
                for build, port in ports.items():
                    loads[build].append(await load(browser, f"http://127.0.0.1:{port}/", line))
            seen, plotted = (
                {
                    b: statistics.median(getattr(one, of) for one in all_)
                    for b, all_ in loads.items()
                }
                for of in ("seen", "plotted")
            )
            for build in ports:
                print(
                    f"{name}, {build}: {seen[build]:.0f} ms seen, {plotted[build]:.0f} ms plotted"
                )
            for build in [build for build in ports if build != "this build"]:
                print(
                    f"{name}: seen after {seen['this build'] / plotted[build]:.2f} of {build}'s time"
                    f" (bar: {line[2]:.2f}), plotted after"
                    f" {plotted['this build'] / plotted[build]:.2f}"
                )
        browser_load = loads["this build"][-1]
        own = [a for a in browser_load.asked if not a.startswith("data:")]
        print(
            f"before the plot: {len(own)} requests (bar: {MOST_REQUESTS}),"
            f" {browser_load.until_plotted / 1000:.1f} kB besides Plotly (bar: {MOST_BYTES / 1000:.0f});"
            f" before the curve {browser_load.until_seen / 1000:.1f} kB;"
            f" layout shift {max(one.shift for one in loads['this build']):.4f}"
        )
        for address in own:
            print(f"  {browser_load.sent.get(address, 0) / 1000:8.1f} kB  {address}")
        await browser.close()


def main() -> None:
    """Serve the application, and an older build if there is one, with one worker and measure it."""
    settings = Settings()
    form = "packed" if packed(settings.static_dir) and settings.page != "sources" else "sources"
    print(f"the page is served {'packed' if form == 'packed' else 'module by module'}")
    with beside_the_older() as ports:
        asyncio.run(run(ports))


if __name__ == "__main__":
    main()
