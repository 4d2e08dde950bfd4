"""Measured optical constants with their provenance; reads the files of `materials/`."""
