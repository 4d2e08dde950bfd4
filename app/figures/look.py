"""How figures look: the page's own colors, read from its style sheet, and a dash for each model."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

Theme = Literal["light", "dark"]
Ground = Literal["paper", "white", "transparent"]

FACE = '"IBM Plex Sans", system-ui, "Segoe UI", Roboto, sans-serif'

_COLORS = 8
_DASHES = (
    "dash",
    "dot",
    "dashdot",
    "longdash",
    "longdashdot",
    "8px 3px 2px 3px",
    "3px 6px",
    "12px 4px",
)
# As static/js/models/look.js has them; a test compares the two.
_OWN = {
    "schlick": (1, "dash"),
    "pharr_humphreys": (4, "dashdot"),
    "complex_dielectric": (5, "12px 4px"),
    "lazanyi2005": (2, "longdash"),
    "schlick_tir": (3, "dashdot"),
    "spherical_gaussian": (6, "dashdot"),
    "generalized_schlick": (3, "longdash"),
    "hoffman_f82": (4, "8px 3px 2px 3px"),
    "f82_tint": (2, "dot"),
    "one_minus_cos": (7, "dot"),
    "cook_torrance": (7, "longdashdot"),
}


def theme_colors(css: str, theme: Theme) -> dict[str, str]:
    """Read the custom properties of a theme from the page's style sheet."""
    colors: dict[str, str] = {}
    for selector in (":root", '[data-theme="dark"]')[: 1 if theme == "light" else 2]:
        block = re.search(re.escape(selector) + r"\s*\{(.*?)\n\}", css, re.DOTALL)
        if block is None:
            raise ValueError(f"the style sheet has no block {selector}")
        colors |= re.findall(r"--([\w-]+):\s*(#[0-9a-f]{6});", block[1])
    return colors


def model_look(ids: Sequence[str], model_id: str) -> tuple[str, str]:
    """Color's name and dash of a model among those registered, the same as on the page."""
    if model_id == "exact":
        return "R", "solid"
    if model_id in _OWN:
        color, dash = _OWN[model_id]
        return f"model-{color}", dash
    taken = {_OWN[name] for name in ids if name in _OWN}
    place = [name for name in ids if name != "exact" and name not in _OWN].index(model_id)
    step = 0
    while True:
        # After eight models the colors come again with another dash.
        look = (step % _COLORS + 1, _DASHES[(step + step // _COLORS) % len(_DASHES)])
        step += 1
        if step <= _COLORS * len(_DASHES) and look in taken:
            continue
        if place == 0:
            return f"model-{look[0]}", look[1]
        place -= 1


@dataclass(frozen=True, slots=True)
class Look:
    """Colors, type and size of one figure."""

    colors: Mapping[str, str]
    """Custom properties of the theme by name."""
    models: Sequence[str]
    """Ids of all models, which give each its color and dash."""
    ground: Ground = "paper"
    """Behind the plot."""
    font_px: float = 14.0
    """Size of the text."""
    width: int | None = None
    height: int | None = None
    """In px; None to fill what is there."""

    def line(self, model_id: str, width: float = 2.0) -> dict[str, Any]:
        """Line of a model; the exact one is the heaviest."""
        color, dash = model_look(self.models, model_id)
        return {
            "color": self.colors[color],
            "dash": dash,
            "width": width * (1.3 if dash == "solid" else 1),
        }

    def color_at(self, place: int) -> str:
        """Color of a line that is known by its place alone."""
        return self.colors[f"model-{place % _COLORS + 1}"]

    @property
    def background(self) -> str:
        """Color behind the plot."""
        if self.ground == "transparent":
            return "rgba(0,0,0,0)"
        return "#ffffff" if self.ground == "white" else self.colors["paper"]

    def axis(self, title: str, **more: Any) -> dict[str, Any]:
        """One axis: hairlines, ticks outside, no frame."""
        return {
            "title": {"text": title, "standoff": 8, "font": {"size": self.font_px}},
            "gridcolor": self.colors["rule"],
            "gridwidth": 1,
            "linecolor": self.colors["edge"],
            "showline": True,
            "ticks": "outside",
            "ticklen": 4,
            "tickcolor": self.colors["edge"],
            "zerolinecolor": self.colors["edge"],
            "zerolinewidth": 1,
        } | more

    def layout(self) -> dict[str, Any]:
        """What all figures have in common."""
        return {
            "template": None,
            "paper_bgcolor": self.background,
            "plot_bgcolor": self.background,
            "font": {"family": FACE, "size": self.font_px, "color": self.colors["ink"]},
            "title": {"x": 0.02, "xanchor": "left", "font": {"size": 1.15 * self.font_px}},
            "legend": {"bgcolor": "rgba(0,0,0,0)"},
            "hovermode": "x unified",
            "hoverlabel": {"bgcolor": self.colors["panel"], "font": {"color": self.colors["ink"]}},
            "width": self.width,
            "height": self.height,
            "autosize": self.width is None,
        }
