"""Models of R that keep three numbers a material, given a material's color."""

from __future__ import annotations

import numpy as np

from app.materials.appearance import Appearance
from app.optics.parameters import Array
from app.optics.registry import Model


def has_rgb_form(model: Model) -> bool:
    """Whether a model makes three curves of a color, or of n and k averaged over the channels."""
    return model.id == "exact" or model.takes_color


def color_given(model: Model, look: Appearance) -> dict[str, Array]:
    """What of a color a model takes, by the names of its parameters.

    Parameters
    ----------
    model
        One that takes a color; others are given nothing.
    look
        The color, of the light's white.

    Returns
    -------
    dict
        Linear channels, shape (3,) each.
    """
    colors = {"F0": look.F0, "F82": look.F82, "tint": look.F82_tint}
    return {p.name: colors[p.name] for p in model.parameters if p.name in colors}


def color_arguments(model: Model, look: Appearance) -> dict[str, Array]:
    """Values of all the parameters of a model that has an RGB form, shape (3, 1) or ().

    They are not checked: the unclamped F0 of gold is above 1 in red.
    """
    given = color_given(model, look)
    return {
        p.name: given[p.name][:, np.newaxis] if p.name in given else np.asarray(p.default)
        for p in model.parameters
    }


def rgb_title(model: Model) -> str:
    """What a model's RGB form is called."""
    return "Exact, from n and k averaged" if model.id == "exact" else model.title
