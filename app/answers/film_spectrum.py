"""Reflectance, transmittance and absorption of films over the wavelength."""

from __future__ import annotations

import numpy as np

from app.answers.answer import Table, Values, answer
from app.answers.film_media import FilmMedia, MediaFacts
from app.answers.films import convention_text
from app.optics.films import absorption, power
from app.optics.incidence import Incidence
from app.optics.parameters import Array

QUANTITIES = ("R", "Rs", "Rp", "T", "Ts", "Tp", "A", "As", "Ap")


@answer
class FilmCurve:
    """One quantity over the wavelength."""

    quantity: str
    values: Values


@answer
class FilmSpectrum:
    """What films do to light over the wavelength, at one angle."""

    media: MediaFacts
    convention: str
    theta_i_deg: float
    wavelength_nm: Values
    curves: list[FilmCurve]
    warnings: list[str]

    def table(self) -> Table:
        """Lay out a column each quantity."""
        curves = {curve.quantity: curve.values for curve in self.curves}
        return Table({"wavelength_nm": self.wavelength_nm} | curves, "film_spectrum.csv")


def film_spectrum(media: FilmMedia, theta_i_deg: float, wavelength_nm: Array) -> FilmSpectrum:
    """Evaluate films over the wavelength.

    Parameters
    ----------
    media
        The two media and the layers.
    theta_i_deg
        Angle of incidence.
    wavelength_nm
        Wavelengths in nm.

    Raises
    ------
    OpticsError
        If a medium is not known at a wavelength.
    """
    stack, warnings = media.stack(wavelength_nm)
    incidence = Incidence.from_degrees(theta_i_deg)
    energy, lost = power(stack, incidence), absorption(stack, incidence)
    shape = wavelength_nm.shape
    values = {
        name: np.broadcast_to(getattr(energy if hasattr(energy, name) else lost, name), shape)
        for name in QUANTITIES
    }
    return FilmSpectrum(
        media=media.facts(),
        convention=convention_text(layers=True),
        theta_i_deg=theta_i_deg,
        wavelength_nm=wavelength_nm,
        curves=[
            FilmCurve(quantity=name, values=np.ascontiguousarray(curve))
            for name, curve in values.items()
        ],
        warnings=warnings,
    )
