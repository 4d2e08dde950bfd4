"""Albedo: the share of diffuse light that a smooth surface reflects, exact and by every fit."""

from app.optics.albedo.coat import BODY_ALBEDO, CoatSplit, coat_split
from app.optics.albedo.exact import Albedo, Quantity, albedo, method
from app.optics.albedo.flatland import flatland_albedo

__all__ = [
    "BODY_ALBEDO",
    "Albedo",
    "CoatSplit",
    "Quantity",
    "albedo",
    "coat_split",
    "flatland_albedo",
    "method",
]
