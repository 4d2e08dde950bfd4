"""Frames drawn per second while dragging, and what the first load costs, in headless Chromium.

A frame counts when what it shows has changed since the one before: the path of the first curve
while `n_t` is dragged, the incident ray or the marker while the angle is, the path of R over the
wavelength while the thickness of a film is. Frames in which nothing new was drawn do not count. It
is done at several round trips, which a proxy makes; with another build's folder in FRESNEL_OLDER, both
are measured in turn.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import shutil
from collections.abc import AsyncIterator
from dataclasses import dataclass, field

from playwright.async_api import Browser, Page, Response, async_playwright

from benchmarks.load import beside_the_older

SECONDS = 3.0
SWEEPS_PER_SECOND = 0.5
BROWSERS = ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome")
ROUND_TRIPS_MS = (0, 50, 150, 300)
BAR = 55.0
FILMS_BAR = 50.0
SPREAD_BAR = 0.1
BYTES_BAR = 120_000
LIBRARIES = ("plotly", "katex")

COUNTER = """(watched) => {
  const drawn = Object.fromEntries(Object.keys(watched).map((name) => [name, 0]));
  const watch = (name, selector, attribute) => {
    let last = null;
    // All that is drawn in one frame happens at one time of the document's timeline.
    new MutationObserver(() => {
      const frame = document.timeline.currentTime;
      if (frame !== last) drawn[name] += 1;
      last = frame;
    }).observe(document.querySelector(selector), {attributeFilter: [attribute]});
  };
  for (const [name, [selector, attribute]] of Object.entries(watched))
    watch(name, selector, attribute);
  window.drawnFrames = {read: () => ({...drawn})};
}"""

EXPLORE = {
    "curves": [".plot-canvas path.js-line", "d"],
    "ray": [".ray-incident .ray-shaft", "x1"],
}
FILMS = {"curves": [".film-curves .plot-canvas path.js-line", "d"]}

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


async def drag(page: Page, move: str) -> dict[str, float]:
    """Let the page's hand move once in each frame; frames drawn a second by the page's own clock."""
    rates: dict[str, float] = await page.evaluate(
        f"""([seconds, sweeps]) => new Promise((resolve) => {{
          const move = {move};
          const before = window.drawnFrames.read();
          const start = performance.now();
          const tick = () => {{
            const elapsed = (performance.now() - start) / 1000;
            if (elapsed < seconds) {{
              move(0.5 - 0.5 * Math.cos(2 * Math.PI * sweeps * elapsed));
              requestAnimationFrame(tick);
              return;
            }}
            const after = window.drawnFrames.read();
            resolve(Object.fromEntries(Object.keys(before).map(
              (name) => [name, (after[name] - before[name]) / elapsed])));
          }};
          requestAnimationFrame(tick);
        }})""",
        [SECONDS, SWEEPS_PER_SECOND],
    )
    return rates


async def press(page: Page, selector: str) -> None:
    """Take hold of an element with the mouse."""
    box = await page.locator(selector).bounding_box()
    if box is None:
        raise SystemExit(f"the page has no {selector}")
    await page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    await page.mouse.down()


SLIDE = """(share) => {
  const slider = document.querySelector('#n_t-slider');
  slider.value = 1.5 + 1.3 * share;
  slider.dispatchEvent(new InputEvent('input', {bubbles: true}));
}"""
THICKEN = """(share) => {
  const slider = document.querySelector('#films-film_nm-slider');
  slider.value = 50 + 500 * share;
  slider.dispatchEvent(new InputEvent('input', {bubbles: true}));
}"""
TURN = """(share) => {
  const host = document.querySelector('.diagram');
  const {left, top, width, height} = host.getBoundingClientRect();
  const theta = (80 - 65 * share) * Math.PI / 180;
  host.dispatchEvent(new PointerEvent('pointermove', {
    pointerId: 1, pointerType: 'mouse', isPrimary: true, buttons: 1, bubbles: true,
    clientX: left + width / 2 - 150 * Math.sin(theta),
    clientY: top + height / 2 - 150 * Math.cos(theta),
  }));
}"""


async def drags(browser: Browser, url: str) -> dict[str, dict[str, float]]:
    """Drag `n_t` on its slider, then the angle by the ray's handle."""
    page = await browser.new_page(viewport={"width": 1440, "height": 900})
    answers: list[Response] = []
    page.on("response", lambda answer: answers.append(answer))
    await page.goto(url)
    await page.wait_for_function(PAINT)
    await page.wait_for_timeout(2000)  # until the page rests
    await page.evaluate(COUNTER, EXPLORE)

    await press(page, "#n_t-slider")
    answers.clear()
    n_t = await drag(page, SLIDE)
    n_t["answers"] = len([answer for answer in answers if "/curves" in answer.url]) / SECONDS
    await page.mouse.up()
    await page.wait_for_timeout(500)

    await press(page, ".diagram [role=slider]")
    theta_i = await drag(page, TURN)
    await page.mouse.up()
    await page.close()
    return {"n_t": n_t, "theta_i": theta_i}


async def film_drag(browser: Browser, url: str) -> float:
    """Drag the thickness of a film on glass on its slider; frames drawn a second."""
    page = await browser.new_page(viewport={"width": 1440, "height": 900})
    await page.goto(f"{url}?view=films&material=BK7&layers=MgF2-o:99.6")
    await page.wait_for_function(PAINT)
    await page.wait_for_timeout(2000)  # until the page rests
    await page.evaluate(COUNTER, FILMS)
    await press(page, "#films-film_nm-slider")
    found = await drag(page, THICKEN)
    await page.mouse.up()
    await page.close()
    return found["curves"]


@contextlib.asynccontextmanager
async def far_away(port: int, round_trip_ms: float) -> AsyncIterator[int]:
    """Listen where a server seems to be so far away; connecting costs nothing more."""
    loop, delay_s = asyncio.get_running_loop(), round_trip_ms / 2000

    async def carry(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        with contextlib.suppress(ConnectionError):
            while data := await reader.read(65536):
                loop.call_later(delay_s, writer.write, data)
        loop.call_later(delay_s, writer.close)

    async def meet(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        inner_reader, inner_writer = await asyncio.open_connection("127.0.0.1", port)
        await asyncio.gather(carry(reader, inner_writer), carry(inner_reader, writer))

    server = await asyncio.start_server(meet, "127.0.0.1", 0)
    try:
        yield server.sockets[0].getsockname()[1]
    finally:
        server.close()


async def run(ports: dict[str, int]) -> None:
    """Measure and print, for builds by name: this one first."""
    url = f"http://127.0.0.1:{ports['this build']}/"
    rates: dict[str, list[tuple[float, float]]] = {build: [] for build in ports}
    async with async_playwright() as playwright:
        arguments = ["--no-sandbox"] if os.geteuid() == 0 else []
        browser = await playwright.chromium.launch(executable_path=find_browser(), args=arguments)
        await first_load(browser, url)  # the server compresses and caches on the first visit
        load, shown = await first_load(browser, url)
        for milliseconds in ROUND_TRIPS_MS:
            for build, port in ports.items():
                async with far_away(port, milliseconds) as far:
                    found = await drags(browser, f"http://127.0.0.1:{far}/")
                    films = await film_drag(browser, f"http://127.0.0.1:{far}/")
                rates[build].append((found["n_t"]["curves"], found["theta_i"]["ray"]))
                print(
                    f"{build}, {milliseconds} ms round trip: {rates[build][-1][0]:.1f} frames drawn per"
                    f" second dragging n_t ({found['n_t']['answers']:.0f} answers),"
                    f" {rates[build][-1][1]:.1f} dragging theta_i (bar: {BAR:.0f}),"
                    f" {films:.1f} dragging a film's thickness (bar: {FILMS_BAR:.0f} at 0 ms)"
                )
        await browser.close()
    for i, name in enumerate(("n_t", "theta_i")):
        ours = [pair[i] for pair in rates["this build"]]
        print(f"{name}: rates within {max(ours) / min(ours) - 1:.0%} (bar: {SPREAD_BAR:.0%})")
        for build, others in list(rates.items())[1:]:
            ratios = [f"{a / max(b[i], 0.01):.1f}" for a, b in zip(ours, others, strict=True)]
            print(f"{name}: {', '.join(ratios)} times {build}")
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
    """Serve the application, and an older build if there is one, with one worker and measure it."""
    with beside_the_older() as ports:
        asyncio.run(run(ports))


if __name__ == "__main__":
    main()
