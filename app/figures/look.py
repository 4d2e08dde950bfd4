"""How figures look: the page's own colors, read from its style sheet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from app.answers.looks import COLORS, model_look

Ground = Literal["paper", "white", "transparent"]

FACE = '"Fresnel Sans", system-ui, "Segoe UI", Roboto, sans-serif'


@dataclass(frozen=True, slots=True)
class Look:
    """Colors, type and size of one figure."""

    colors: Mapping[str, str]
    """Custom properties of the theme by name."""
    ground: Ground = "paper"
    """Behind the plot."""
    font_px: float = 14.0
    """Size of the text."""
    width: int | None = None
    height: int | None = None
    """In px; None to fill what is there."""

    def line(self, model_id: str, width: float = 2.0) -> dict[str, Any]:
        """Line of a model; the exact one is the heaviest."""
        color, dash = model_look(model_id)
        return {
            "color": self.colors[color],
            "dash": dash,
            "width": width * (1.3 if dash == "solid" else 1),
        }

    def color_at(self, place: int) -> str:
        """Color of a line that is known by its place alone."""
        return self.colors[f"model-{place % COLORS + 1}"]

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
