"""Measured optical constants with their provenance; reads the files of `materials/`."""

from app.materials.appearance import (
    Appearance,
    appearance,
    color_curve,
    f82_tint,
    interface,
    reflectance,
    rgb_constants,
)
from app.materials.catalog import Catalog, Constants, Spread, load_catalog
from app.materials.errors import NoSpectrum, UnknownMaterial, WavelengthOutOfRange
from app.materials.schema import Category, Preset
from app.materials.spectrum import Spectrum, Visible

__all__ = [
    "Appearance",
    "Catalog",
    "Category",
    "Constants",
    "NoSpectrum",
    "Preset",
    "Spectrum",
    "Spread",
    "UnknownMaterial",
    "Visible",
    "WavelengthOutOfRange",
    "appearance",
    "color_curve",
    "f82_tint",
    "interface",
    "load_catalog",
    "reflectance",
    "rgb_constants",
]
