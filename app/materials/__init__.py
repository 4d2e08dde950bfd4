"""Measured optical constants with their provenance; reads the files of `materials/`."""

from app.materials.catalog import Catalog, load_catalog
from app.materials.errors import UnknownMaterial
from app.materials.schema import Preset

__all__ = ["Catalog", "Preset", "UnknownMaterial", "load_catalog"]
