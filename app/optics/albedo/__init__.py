"""Albedo: the share of diffuse light that a smooth surface reflects, exact and by every fit."""

from app.optics.albedo.coat import BODY_ALBEDO, CoatSplit, coat_split
from app.optics.albedo.exact import Albedo, Quantity, albedo, method
from app.optics.albedo.fit import Claim, Domain, Fit
from app.optics.albedo.fits import FITS, UnknownFit, find_fit
from app.optics.albedo.flatland import flatland_albedo
from app.optics.albedo.models import model_albedo

__all__ = [
    "BODY_ALBEDO",
    "FITS",
    "Albedo",
    "Claim",
    "CoatSplit",
    "Domain",
    "Fit",
    "Quantity",
    "UnknownFit",
    "albedo",
    "coat_split",
    "find_fit",
    "flatland_albedo",
    "method",
    "model_albedo",
]
