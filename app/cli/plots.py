"""Figures in the terminal, in a browser and in files."""

from __future__ import annotations

import math
import re
import shutil
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    import plotly.graph_objects as go

# Signals without a marker of their own would all be drawn alike where there are no colors.
_TALLEST = 30


def in_terminal(figure: go.Figure) -> str:
    """Draw the lines of a Plotly figure with characters, a plot for each of its vertical axes."""
    import plotext

    axes: dict[str, list[object]] = {}
    for trace in figure.data:
        if trace.type == "scatter":
            axes.setdefault(trace.yaxis or "y", []).append(trace)
    columns, rows = shutil.get_terminal_size((100, 30))
    height = max(12, min(_TALLEST, rows - 4) // max(1, len(axes)))
    drawn = []
    for axis, traces in axes.items():
        plot = plotext.figure
        plot.clear()
        plot.plot_size(columns, height)
        for trace in traces:
            given = zip(trace.x, trace.y, strict=True)  # type: ignore[attr-defined]
            points = [(float(x), float(y)) for x, y in given if math.isfinite(y)]
            signal = plot.signal(*map(list, zip(*points, strict=True))).lines()
            signal.label(trace.name)  # type: ignore[attr-defined]
            plot.draw(signal)
        plot.title(_plain(figure.layout[axis.replace("y", "yaxis")].title.text))
        plot.label(_plain(figure.layout[traces[0].xaxis.replace("x", "xaxis")].title.text), "x")  # type: ignore[attr-defined]
        drawn.append(str(plot.build().string()))
    return "\n".join(drawn)


def _plain(text: str | None) -> str:
    """Take the markup out of a title."""
    return re.sub(r"<[^>]*>", "", text or "")


def open_page(page: bytes) -> Path:
    """Write a page into a file of its own and show it in the browser."""
    with tempfile.NamedTemporaryFile("wb", prefix="fresnel_", suffix=".html", delete=False) as file:
        file.write(page)
    typer.launch(Path(file.name).as_uri())
    return Path(file.name)
