"""A drawn figure as a page of its own, and what all forms of figures share."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from app.figures.look import FACE, Look

if TYPE_CHECKING:
    import plotly.graph_objects as go

MEDIA_TYPES = {
    "json": "application/json",
    "html": "text/html; charset=utf-8",
    "svg": "image/svg+xml",
    "png": "image/png",
    "pdf": "application/pdf",
}

_BUNDLE = "plotly-cartesian-*/plotly-cartesian.min.js"
_FONT = "fresnel-sans-*/fresnel-sans-latin-*.woff2"
_DRAW = (
    "const figure = JSON.parse(document.getElementById('figure').textContent);"
    "Plotly.newPlot('plot', figure.data, figure.layout, "
    "{responsive: true, displaylogo: false, showSendToCloud: false});"
)


def _vendored(static_dir: Path, pattern: str) -> Path:
    (path,) = (static_dir / "vendor").glob(pattern)
    return path


def _hash(script: str) -> str:
    return f"'sha256-{base64.b64encode(sha256(script.encode()).digest()).decode()}'"


@lru_cache(maxsize=1)
def _parts(static_dir: Path) -> tuple[str, str, str]:
    """Plotly's script, the font as a data URL, and the policy that allows nothing else."""
    bundle = _vendored(static_dir, _BUNDLE).read_text("utf-8").replace("</script", "<\\/script")
    font = base64.b64encode(_vendored(static_dir, _FONT).read_bytes()).decode()
    policy = "; ".join(
        [
            "default-src 'none'",
            f"script-src {_hash(bundle)} {_hash(_DRAW)}",
            "style-src 'unsafe-inline'",
            "img-src data: blob:",
            "font-src data:",
            "base-uri 'none'",
            "form-action 'none'",
        ]
    )
    return bundle, f"data:font/woff2;base64,{font}", policy


def bundle(static_dir: Path) -> Path:
    """Plotly's script."""
    return _vendored(static_dir, _BUNDLE)


def policy(static_dir: Path) -> str:
    """Content security policy of a page that `page` writes."""
    return _parts(static_dir)[2]


def page(
    figure: go.Figure, title: str, lines: Sequence[str], look: Look, static_dir: Path
) -> bytes:
    """Write a page that holds all it needs: it works from a file and asks no host for anything."""
    bundle, font, policy = _parts(static_dir)
    # A figure's JSON may hold no end of a script, whatever a title says.
    heading = html.escape(str(figure.layout.title.text))
    figure.update_layout(title_text=None, margin_t=8)
    size = f"{look.width}px" if look.width else "100%"
    data = str(figure.to_json()).replace("<", "\\u003c")
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{html.escape(policy)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(title)}</title>
<style>
@font-face {{ font-family: "Fresnel Sans"; src: url({font}) format("woff2"); font-weight: 400 700 }}
body {{ margin: 0; min-height: 100vh; display: flex; flex-direction: column;
  background: {look.background}; color: {look.colors["muted"]}; font: 12px/1.45 {FACE} }}
#plot {{ flex: 1; min-height: {look.height or 320}px; width: {size} }}
h1 {{ margin: 12px 16px 4px; font-size: 16px; font-weight: 500; color: {look.colors["ink"]} }}
p {{ margin: 0 16px 12px; overflow-wrap: anywhere }}
</style>
</head>
<body>
<h1>{heading}</h1>
<div id="plot" role="img" aria-label="{html.escape(title)}"></div>
<p>{"<br>".join(html.escape(line) for line in lines)}</p>
<script type="application/json" id="figure">{data}</script>
<script>{bundle}</script>
<script>{_DRAW}</script>
</body>
</html>
""".encode()
