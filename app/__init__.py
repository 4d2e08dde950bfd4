"""Fresnel Explorer: reflection at smooth surfaces, exact and approximated."""

from importlib.metadata import version

__version__ = version("fresnel-explorer")
