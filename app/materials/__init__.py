"""Measured optical constants with their provenance; reads the files of `materials/`."""

from app.materials.appearance import (
    DAYLIGHT,
    Appearance,
    Viewing,
    appearance,
    averaged_interface,
    color_curve,
    interface,
    normal_reflectance,
    rgb_constants,
)
from app.materials.catalog import Catalog, Constants, Spread, load_catalog
from app.materials.errors import NoSpectrum, UnknownMaterial, WavelengthOutOfRange
from app.materials.front import Front
from app.materials.media import (
    NEGLIGIBLE_K,
    USELESS_WAVELENGTH,
    Resolved,
    constants_at,
    default_catalog,
    given_beside,
    resolve_incident,
    resolve_material,
    transparency_warnings,
    transparent,
    within,
)
from app.materials.schema import Category, Preset
from app.materials.spectrum import Spectrum, Visible

__all__ = [
    "DAYLIGHT",
    "NEGLIGIBLE_K",
    "USELESS_WAVELENGTH",
    "Appearance",
    "Catalog",
    "Category",
    "Constants",
    "Front",
    "NoSpectrum",
    "Preset",
    "Resolved",
    "Spectrum",
    "Spread",
    "UnknownMaterial",
    "Viewing",
    "Visible",
    "WavelengthOutOfRange",
    "appearance",
    "averaged_interface",
    "color_curve",
    "constants_at",
    "default_catalog",
    "given_beside",
    "interface",
    "load_catalog",
    "normal_reflectance",
    "resolve_incident",
    "resolve_material",
    "rgb_constants",
    "transparency_warnings",
    "transparent",
    "within",
]
