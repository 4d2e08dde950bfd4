"""How models look on the page and in figures: a color of the page's style sheet, and a dash."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Literal
from zlib import crc32

from app.answers.answer import answer

Theme = Literal["light", "dark"]

COLORS = 8
"""Colors `model-1` and so on of the style sheet."""

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

# Each has a look of its own, and models often seen together are told apart, as in d'Eon's figure.
_OF_MODELS = {
    "exact": ("R", "solid"),
    "complex_form": ("model-4", "longdash"),
    "cos_form": ("model-5", "longdashdot"),
    "deon_gc": ("model-6", "8px 3px 2px 3px"),
    "deon_pq": ("model-7", "3px 6px"),
    "deon_rg": ("model-8", "12px 4px"),
    "gulbrandsen_rg": ("model-1", "dot"),
    "lagarde_conductor": ("model-2", "dashdot"),
    "lagarde_dielectric": ("model-4", "longdashdot"),
    "lagarde_gc": ("model-5", "8px 3px 2px 3px"),
    "shirley_ab": ("model-6", "3px 6px"),
    "wloka_eq6": ("model-7", "12px 4px"),
    "wloka_gc": ("model-8", "dash"),
    "wloka_sin_tan": ("model-1", "dashdot"),
    "babylon_openpbr": ("model-8", "longdash"),
    "complex_dielectric": ("model-5", "12px 4px"),
    "constant_f0": ("model-4", "dot"),
    "cook_torrance": ("model-7", "longdashdot"),
    "f82_tint": ("model-2", "dot"),
    "generalized_schlick": ("model-3", "longdash"),
    "hoffman_f82": ("model-4", "8px 3px 2px 3px"),
    "lazanyi2005": ("model-2", "longdash"),
    "lut_1d": ("model-3", "longdashdot"),
    "one_minus_cos": ("model-7", "dot"),
    "pharr_humphreys": ("model-4", "dashdot"),
    "schlick": ("model-1", "dash"),
    "schlick_f0_srgb": ("model-5", "3px 6px"),
    "schlick_f90_50": ("model-6", "12px 4px"),
    "schlick_four_percent": ("model-7", "dash"),
    "schlick_ior": ("model-8", "dot"),
    "schlick_tir": ("model-3", "dashdot"),
    "schlick_wrong_angle": ("model-1", "longdash"),
    "spherical_gaussian": ("model-6", "dashdot"),
}


@answer
class ModelLook:
    """Color and dash of a model's curves."""

    color: str
    """Name of the color in the page's style sheet."""
    light: str
    """The color on a light ground, #rrggbb."""
    dark: str
    """The color on a dark ground, #rrggbb."""
    dash: str
    """As Plotly names it, or lengths of strokes and gaps."""

    @classmethod
    def of(cls, model_id: str, themes: Mapping[Theme, Mapping[str, str]]) -> ModelLook:
        """Look of a model in the colors of the themes."""
        color, dash = model_look(model_id)
        return cls(color=color, light=themes["light"][color], dark=themes["dark"][color], dash=dash)


def model_look(model_id: str) -> tuple[str, str]:
    """Name of the color and dash of a model.

    What is not listed here gets its look from its id alone, so that no other changes its own.
    """
    listed = _OF_MODELS.get(model_id)
    if listed:
        return listed
    taken = set(_OF_MODELS.values())
    looks = [(f"model-{n + 1}", dash) for dash in _DASHES for n in range(COLORS)]
    free = [look for look in looks if look not in taken]
    return free[crc32(model_id.encode()) % len(free)]


def theme_colors(static_dir: Path, theme: Theme) -> dict[str, str]:
    """Read the custom properties of a theme from the page's style sheet."""
    css = (static_dir / "css" / "base.css").read_text("utf-8")
    colors: dict[str, str] = {}
    for selector in (":root", '[data-theme="dark"]')[: 1 if theme == "light" else 2]:
        block = re.search(re.escape(selector) + r"\s*\{(.*?)\n\}", css, re.DOTALL)
        if block is None:
            raise ValueError(f"the style sheet has no block {selector}")
        colors |= re.findall(r"--([\w-]+):\s*(#[0-9a-f]{6});", block[1])
    return colors
