"""Reflectance of a material over angle and wavelength."""

from typing import Literal

import numpy as np

from app.answers.answer import Rows, Table, Values, answer
from app.answers.interface import CONVENTION
from app.answers.materials.about import About, FrontMedium, range_within, refuse_more_than
from app.materials.appearance import interface
from app.materials.front import Front
from app.materials.media import default_catalog
from app.materials.schema import Preset, called
from app.optics.amplitudes import power
from app.optics.incidence import Incidence

VISIBLE_NM = (380.0, 780.0)

Quantity = Literal["R", "Rs", "Rp"]


@answer
class MaterialMap:
    """Reflectance over angle and wavelength."""

    material: About
    front: FrontMedium
    convention: str
    quantity: Quantity
    theta_i_deg: Values
    wavelength_nm: Values
    n_i: Values
    n: Values
    """Against vacuum, as n_i is."""
    k: Values
    values: Rows
    """A row for each wavelength."""
    warnings: list[str]

    def table(self) -> Table:
        """Lay out a row a cell."""
        columns = {
            "wavelength_nm": np.repeat(self.wavelength_nm, self.theta_i_deg.size),
            "theta_i_deg": np.tile(self.theta_i_deg, self.wavelength_nm.size),
            self.quantity: self.values.ravel(),
        }
        return Table(columns, f"{called(self.material.id, self.material.name)}_map.csv")


def reflectance_map(
    preset: Preset,
    front: Front,
    quantity: Quantity = "R",
    *,
    minimum_nm: float | None = None,
    maximum_nm: float | None = None,
    steps: int = 201,
    samples: int = 91,
) -> MaterialMap:
    """Evaluate the reflectance over angle and wavelength.

    Parameters
    ----------
    preset, front
        The two media.
    quantity
        Unpolarized, s or p.
    minimum_nm, maximum_nm
        The range of wavelengths; from 380 to 780 nm, as far as both media are known, unless given.
    steps, samples
        Equally spaced wavelengths and angles, both ends included.

    Raises
    ------
    NoSpectrum
        If the preset is a single index.
    WavelengthOutOfRange, OutOfRange, NotAllowed
        If a medium is not known or not computed somewhere, or there are too many cells.
    """
    spectrum = default_catalog().spectrum(preset.id)
    known = front.range_beside(spectrum)
    visible = max(known[0], VISIBLE_NM[0]), min(known[1], VISIBLE_NM[1])
    names = (
        preset.called if front.spectrum is None else f"{preset.called} and of {front.spectrum.id}"
    )
    low, high = range_within(
        (minimum_nm, maximum_nm), known, visible if visible[0] < visible[1] else known, names
    )
    refuse_more_than("steps", steps, steps * samples, "cells")
    wavelength_nm = np.linspace(low, high, steps)
    theta_i_deg = np.linspace(0.0, 90.0, samples)
    n_i, said = front.at(wavelength_nm)
    boundary = interface(spectrum, wavelength_nm[:, np.newaxis], np.atleast_1d(n_i)[:, np.newaxis])
    values = getattr(power(boundary, Incidence.from_degrees(theta_i_deg)), quantity)
    n_i, n, k = (
        np.broadcast_to(column.ravel(), wavelength_nm.shape).copy()
        for column in (boundary.n_i, boundary.n_t, boundary.k_t)
    )
    return MaterialMap(
        material=About.of(preset),
        front=FrontMedium.of(front),
        convention=CONVENTION,
        quantity=quantity,
        theta_i_deg=theta_i_deg,
        wavelength_nm=wavelength_nm,
        n_i=n_i,
        n=n,
        k=k,
        values=np.ascontiguousarray(values),
        warnings=[*spectrum.unknown_k, *said],
    )
