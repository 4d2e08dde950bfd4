"""Draw the icons that systems ask for as PNG from the page's own mark: run it by `make icons`."""

from __future__ import annotations

import struct
from pathlib import Path

from playwright.sync_api import Browser

from tools.pictures import launched

STATIC = Path(__file__).resolve().parent.parent / "static"
GROUND = "#faf9f6"  # --paper of the light theme
# File name, side in px, how much of it the mark takes: a mask may cut off all but a disc of 80 %.
ICONS = (
    ("icon-192.png", 192, 0.74),
    ("icon-512.png", 512, 0.74),
    ("maskable-512.png", 512, 0.54),
    ("apple-touch-180.png", 180, 0.66),
)


def draw(browser: Browser, side: int, share: float, target: Path) -> None:
    """Write the mark on its ground as a square picture."""
    page = browser.new_page(viewport={"width": side, "height": side}, color_scheme="light")
    mark = (STATIC / "favicon.svg").read_text(encoding="utf-8")
    page.set_content(
        f"""<style>
          body {{ margin: 0; height: 100vh; display: grid; place-items: center; background: {GROUND} }}
          svg {{ width: {share:.0%} }}
        </style>{mark}"""
    )
    page.screenshot(path=target)
    page.close()


def wrap(picture: bytes, side: int) -> bytes:
    """Give a PNG the header of an ICO, which is asked for at /favicon.ico whatever a page says."""
    header = struct.pack("<3H", 0, 1, 1)
    entry = struct.pack("<4B2H2I", side, side, 0, 0, 1, 32, len(picture), len(header) + 16)
    return header + entry + picture


def main() -> None:
    """Draw all icons."""
    folder = STATIC / "icons"
    folder.mkdir(exist_ok=True)
    with launched() as browser:
        for name, side, share in ICONS:
            draw(browser, side, share, folder / name)
            print(f"static/icons/{name}: {(folder / name).stat().st_size:,} bytes")
    name, side, _ = ICONS[0]
    (STATIC / "favicon.ico").write_bytes(wrap((folder / name).read_bytes(), side))


if __name__ == "__main__":
    main()
