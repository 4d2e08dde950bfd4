"""From letting go of a slider to the redrawn heat map of 181 x 121 cells, in headless Chromium."""

from __future__ import annotations

import asyncio
import os
import statistics

from playwright.async_api import Browser, Response, async_playwright

from benchmarks.drag import find_browser
from benchmarks.load import OURS, served

REDRAW_BAR_MS = 100.0
RELEASES = 12
VIEW = "?view=compare&k_t=1&over=theta-n&models=schlick,spherical_gaussian,generalized_schlick"

WATCH = """() => {
  const picture = () => document.querySelector('.heatmap .heatmaplayer image');
  window.heatMap = {times: []};
  let last = picture().getAttribute('xlink:href') ?? picture().getAttribute('href');
  const slider = document.querySelector('#compare-k_t-slider');
  slider.addEventListener('change', () => {
    const start = performance.now();
    const look = () => {
      const node = picture();
      const now = node?.getAttribute('xlink:href') ?? node?.getAttribute('href');
      if (now === undefined || now === last) return requestAnimationFrame(look);
      last = now;
      // The frame that shows it begins after this one's work.
      requestAnimationFrame(() => window.heatMap.times.push(performance.now() - start));
    };
    look();
  }, {capture: true});
}"""


async def redraws(browser: Browser, url: str) -> tuple[list[float], int]:
    """Drag `k_t` and let go, many times; ms until the map has changed, and the answer's bytes."""
    page = await browser.new_page(viewport={"width": 1440, "height": 900})
    answers: list[Response] = []
    page.on("response", lambda one: answers.append(one) if "/errors/map" in one.url else None)
    await page.goto(url + VIEW)
    await page.locator(".heatmap .heatmaplayer image").wait_for(state="attached")
    await page.wait_for_timeout(1000)
    await page.evaluate(WATCH)
    slider = await page.locator("#compare-k_t-slider").bounding_box()
    if slider is None:
        raise SystemExit("the view has no slider for k_t")
    y = slider["y"] + slider["height"] / 2
    for turn in range(RELEASES):
        start = slider["x"] + slider["width"] * (0.1 + 0.06 * turn)
        await page.mouse.move(start, y)
        await page.mouse.down()
        for step in range(6):
            await page.mouse.move(start + 3 * step, y)
            await page.wait_for_timeout(16)
        await page.mouse.up()
        await page.wait_for_function(f"() => window.heatMap.times.length > {turn}")
        await page.wait_for_timeout(300)
    times = await page.evaluate("() => window.heatMap.times")
    sizes = await answers[0].request.sizes()
    await page.close()
    return times, sizes["responseBodySize"]


async def run(port: int) -> None:
    """Measure and print."""
    async with async_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = await playwright.chromium.launch(executable_path=find_browser(), args=arguments)
        times, sent = await redraws(browser, f"http://127.0.0.1:{port}/")
        await browser.close()
    print(
        f"heat map redrawn {statistics.median(times):.0f} ms after letting go (median of {len(times)};"
        f" slowest {max(times):.0f}, bar: {REDRAW_BAR_MS:.0f}); the answer takes {sent / 1000:.1f} kB"
    )


def main() -> None:
    """Serve the application with one worker and measure it."""
    with served(*OURS) as server:
        asyncio.run(run(server.port))


if __name__ == "__main__":
    main()
