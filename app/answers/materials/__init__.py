"""Answers about materials: the list, one material, and what depends on the wavelength."""
