"""Numerical methods that know nothing of optics."""
