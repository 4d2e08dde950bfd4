"""Figures in the terminal, in a browser and in files."""

from __future__ import annotations

import math
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    import plotly.graph_objects as go

_TALLEST = 30
_COLORS = (12, 9, 10, 13, 14, 8, 4, 1, 2, 5, 6)
"""Of the curves, in their order; yellow is left out, which cannot be seen on white."""
_LETTERS = "abcdefghijklmnopqrstuvwxyz"
"""What curves are drawn with where there are no colors, which would make them all alike."""


def in_terminal(figure: go.Figure) -> str:
    """Draw the lines of a Plotly figure with characters, a plot for each of its vertical axes."""
    import plotext

    axes: dict[str, list[object]] = {}
    for trace in figure.data:
        if trace.type == "scatter":
            axes.setdefault(trace.yaxis or "y", []).append(trace)
    columns, rows = shutil.get_terminal_size((100, 30))
    height = max(12, min(_TALLEST, rows - 4) // max(1, len(axes)))
    colored = sys.stdout.isatty() and "NO_COLOR" not in os.environ
    drawn = [_plain(figure.layout.title.text)]
    for axis, traces in axes.items():
        plot = plotext.figure
        plot.clear()
        plot.plot_size(columns, height)
        keys: list[tuple[str, int, str]] = []
        for at, trace in enumerate(traces):
            letter, color = _LETTERS[at % len(_LETTERS)], _COLORS[at % len(_COLORS)]
            marker = plotext.marker(None if colored else letter, pixel=plotext.pixel(color))
            given = zip(trace.x, trace.y, strict=True)  # type: ignore[attr-defined]
            points = [(float(x), float(y)) for x, y in given if math.isfinite(y)]
            x, y = map(list, zip(*points, strict=True))
            plot.draw(plot.signal(x, y, marker=marker).lines())
            key = f"\x1b[38;5;{color}m──\x1b[0m" if colored else letter
            keys.append((key, 2 if colored else 1, trace.name))  # type: ignore[attr-defined]
        plot.legend(False)  # it would stand on the curves
        plot.title(_plain(figure.layout[axis.replace("y", "yaxis")].title.text))
        plot.label(_plain(figure.layout[traces[0].xaxis.replace("x", "xaxis")].title.text), "x")  # type: ignore[attr-defined]
        drawn += [str(plot.build().string()), *_legend(keys, columns)]
    return "\n".join(drawn)


def _legend(keys: Iterable[tuple[str, int, str]], columns: int) -> list[str]:
    """Lines of keys, as many in each as there is room for: what is drawn, its width, the name."""
    lines, width = [""], 0
    for drawn, wide, name in keys:
        taken = wide + 1 + len(name) + 3
        if width and width + taken > columns:
            lines, width = [*lines, ""], 0
        lines[-1] += f"{drawn} {name}   "
        width += taken
    return [line.rstrip() for line in lines]


def _plain(text: str | None) -> str:
    """Take the markup out of a title."""
    return re.sub(r"<[^>]*>", "", text or "")


def open_page(page: bytes) -> Path:
    """Write a page into a file of its own and show it in the browser."""
    with tempfile.NamedTemporaryFile("wb", prefix="fresnel_", suffix=".html", delete=False) as file:
        file.write(page)
    typer.launch(Path(file.name).as_uri())
    return Path(file.name)
