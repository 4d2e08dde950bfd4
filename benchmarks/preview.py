"""Frames of the Preview view while it is turned, and until a new model shows, in headless Chromium."""

from __future__ import annotations

import asyncio
import os
import statistics
from dataclasses import dataclass

from playwright.async_api import Browser, Page, async_playwright

from benchmarks.drag import find_browser
from benchmarks.load import OURS, served

SECONDS = 4.0
SIDE = 512
INTERVAL_BAR_MS = 16.7
REDRAW_BAR_FRAMES = 2
VIEWPORT = {"width": SIDE + 28, "height": 900}  # the picture is a square between two margins
SCENES = {"glossy paint": "", "clear glass": "&body=clear", "water": "&scene=water&n_t=1.333"}
MODELS = ("one_minus_cos", "schlick")  # each is shown once before it counts

READY = "() => document.querySelector('.scene')?.dataset.points === '2'"

ORBIT = """(seconds) => new Promise((resolve) => {
  const canvas = document.querySelector('.scene');
  const {left, top, width, height} = canvas.getBoundingClientRect();
  const event = (kind, share) => canvas.dispatchEvent(new PointerEvent(kind, {
    pointerId: 1, pointerType: 'mouse', isPrimary: true, button: 0, buttons: 1, bubbles: true,
    clientX: left + width * (0.5 + 0.4 * Math.sin(2 * Math.PI * share)),
    clientY: top + height * (0.5 + 0.1 * Math.sin(4 * Math.PI * share)),
  }));
  canvas.setPointerCapture = () => {};
  let drawn = 0;
  new MutationObserver(() => { drawn += 1; })
    .observe(canvas, {attributeFilter: ['data-points']});
  const gaps = [];
  let start, last;
  event('pointerdown', 0);
  const tick = (now) => {
    start ??= now;
    if (last !== undefined) gaps.push(now - last);
    last = now;
    if (now - start < 1000 * seconds) {
      event('pointermove', (now - start) / 1000 / seconds);
      requestAnimationFrame(tick);
      return;
    }
    const points = Number(canvas.dataset.points);
    event('pointerup', 0);
    resolve({gaps, drawn, points});
  };
  requestAnimationFrame(tick);
})"""

CHANGE = """(model) => new Promise((resolve) => {
  const canvas = document.querySelector('.scene');
  const select = document.querySelector('[aria-label="Model on the right"]');
  let frames = 0, seen = false;
  const watch = new MutationObserver(() => {
    seen = true;
    watch.disconnect();
  });
  watch.observe(canvas, {attributeFilter: ['data-points']});
  const tick = () => {
    frames += 1;
    // What is drawn in a frame is seen in the same one.
    setTimeout(() => (seen ? resolve(frames) : requestAnimationFrame(tick)));
  };
  requestAnimationFrame(() => {
    select.value = model;
    select.dispatchEvent(new Event('change'));
    requestAnimationFrame(tick);
  });
})"""


@dataclass(frozen=True)
class Turn:
    """One scene turned for some seconds."""

    median_ms: float
    p95_ms: float
    share_drawn: float
    points: float


async def opened(browser: Browser, url: str, query: str) -> Page:
    """Open the view with a picture of SIDE by SIDE pixels."""
    page = await browser.new_page(viewport=VIEWPORT)  # type: ignore[arg-type]
    await page.goto(f"{url}?view=preview{query}")
    await page.wait_for_function(READY)
    size = await page.evaluate(
        "() => ['width', 'height'].map((side) => document.querySelector('.scene')[side])"
    )
    if size != [SIDE, SIDE]:
        raise SystemExit(f"the picture has {size} pixels, not {SIDE} x {SIDE}")
    return page


async def turned(page: Page) -> Turn:
    """Turn the scene; the first second is for compiling shaders and finding the resolution."""
    await page.evaluate(ORBIT, 2.0)
    await page.wait_for_function(READY)
    found = await page.evaluate(ORBIT, SECONDS)
    gaps = found["gaps"]
    return Turn(
        statistics.median(gaps),
        statistics.quantiles(gaps, n=20)[-1],
        found["drawn"] / len(gaps),
        found["points"],
    )


async def run(port: int) -> None:
    """Measure and print."""
    url = f"http://127.0.0.1:{port}/"
    async with async_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = await playwright.chromium.launch(executable_path=find_browser(), args=arguments)
        for name, query in SCENES.items():
            page = await opened(browser, url, query)
            turn = await turned(page)
            print(
                f"turning {name}, {SIDE} x {SIDE}: a frame every {turn.median_ms:.1f} ms (median; 95 %"
                f" within {turn.p95_ms:.1f}, bar: {INTERVAL_BAR_MS}), {100 * turn.share_drawn:.0f} %"
                f" of them drawn, at {100 * turn.points:.0f} % of the pixels along each side"
            )
            await page.close()
        page = await opened(browser, url, "")
        frames = []
        for model in MODELS * 4:
            frames.append(await page.evaluate(CHANGE, model))
            await page.wait_for_function(READY)
            await page.wait_for_timeout(300)
        await browser.close()
    cached = frames[len(MODELS) :]
    print(
        f"a model seen before is drawn in {max(cached)} frames at most of {len(cached)} changes"
        f" (bar: {REDRAW_BAR_FRAMES})"
    )


def main() -> None:
    """Serve the application with one worker and measure it."""
    with served(*OURS) as server:
        asyncio.run(run(server.port))


if __name__ == "__main__":
    main()
