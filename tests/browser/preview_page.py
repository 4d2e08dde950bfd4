"""Words for what the tests of the Preview view do, and its geometry worked out a second time."""

import base64
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal
from urllib.parse import parse_qs, urlsplit

import numpy as np
from playwright.sync_api import Page, expect

ROOT = Path(__file__).parents[2]
AXE = ROOT / "node_modules" / "axe-core" / "axe.min.js"
READY_MS = 45_000
expect.set_options(timeout=READY_MS)

RADIANCE = 0.8  # of the even light
BALL = np.array([0.0, 1.12, 0.0])
TARGET = np.array([0.0, 0.72, 0.0])
HALF_ANGLE = math.radians(19.5)

AT_REST = """() => document.querySelector('.scene')?.dataset.points === '2'
  && !document.querySelector('.differences').hasAttribute('data-stale')"""

PIXELS = """async ([data]) => {
  const image = new Image();
  image.src = `data:image/png;base64,${data}`;
  await image.decode();
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [image.width, image.height];
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  const bytes = context.getImageData(0, 0, image.width, image.height).data;
  let text = '';
  for (let i = 0; i < bytes.length; i += 8192)
    text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return [image.width, image.height, btoa(text)];
}"""


def opened(page: Page, query: str = "") -> Page:
    """Open the view and wait until its picture is finished and measured."""
    page.set_default_timeout(READY_MS)
    page.goto(f"/?view=preview{query}")
    return rested(page)


def rested(page: Page) -> Page:
    """Wait until the picture is finished and measured."""
    page.wait_for_function(AT_REST)
    return page


def link(page: Page) -> dict[str, str]:
    """Read what the address says."""
    return {key: values[0] for key, values in parse_qs(urlsplit(page.url).query).items()}


Figure = Literal["steps.mean", "steps.largest", "colors.mean", "colors.largest"]


def figure(page: Page, name: Figure) -> float:
    """Read one of the differences shown."""
    text = page.locator(f"[data-difference='{name}']").inner_text()
    return float(text.replace("\u2212", "-"))


@dataclass(frozen=True)
class Shot:
    """The exported picture: sRGB bytes, shape (height, width, 3), rows from above."""

    pixels: Any
    name: str

    def at(self, x: float, y: float) -> Any:
        """Colour of the pixel that holds a point."""
        return self.pixels[int(y), int(x)].astype(int)


def shot(page: Page) -> Shot:
    """Export the picture and decode it."""
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the picture as PNG").click()
    data = base64.b64encode(Path(download.value.path()).read_bytes()).decode()
    width, height, text = page.evaluate(PIXELS, [data])
    raw = np.frombuffer(base64.b64decode(text), np.uint8).reshape(height, width, 4)
    return Shot(raw[..., :3], download.value.suggested_filename)


@dataclass(frozen=True)
class View:
    """Where the ball is seen, for the view's first camera or another."""

    width: int
    height: int
    pitch_deg: float = 11.0
    distance: float = 6.2

    def cosine(self, x: float, y: float) -> float | None:
        """cos(theta_i) where the ray through a point of the picture meets the ball; None beside it."""
        pitch = math.radians(self.pitch_deg)
        forward = np.array([0.0, -math.sin(pitch), -math.cos(pitch)])
        up = np.array([0.0, math.cos(pitch), -math.sin(pitch)])
        right = np.array([1.0, 0.0, 0.0])
        eye = TARGET - self.distance * forward
        unit = 2.0 * math.tan(HALF_ANGLE) / min(self.width, self.height)
        d = forward + unit * ((x - self.width / 2) * right + (self.height / 2 - y) * up)
        d /= np.linalg.norm(d)
        away = eye - BALL
        b = float(away @ d)
        square = b * b - float(away @ away) + 1.0
        if square < 0.0:
            return None
        normal = away + (-b - math.sqrt(square)) * d
        return float(-(normal @ d))

    def center(self) -> tuple[float, float]:
        """Find the ball's middle: the point where light meets it head-on."""
        x = self.width / 2
        rows = [y + 0.5 for y in range(self.height)]
        return x, max(rows, key=lambda y: self.cosine(x, y) or -1.0)

    def rim(self) -> float:
        """Find the last column to the right of the middle that is all ball."""
        x, y = self.center()
        while self.cosine(x + 1.5, y) is not None:
            x += 1.0
        return x


def encoded(linear: Sequence[float]) -> Any:
    """Linear light as 8-bit sRGB, not rounded."""
    c = np.clip(np.asarray(linear, float), 0.0, 1.0)
    return 255.0 * np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def axe_violations(page: Page) -> list[str]:
    """Return the rules that axe-core finds broken, each with the first offender."""
    page.evaluate(AXE.read_text("utf-8"))
    found = page.evaluate("() => axe.run()")
    return [f"{v['id']}: {v['nodes'][0]['html']}" for v in found["violations"]]
