"""Reflectance of a material over the angle, per wavelength and as R, G and B.

The spectrum is integrated at every angle; beside that stand the curves that renderers get who keep
three numbers a material, each with its error.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.answers.answer import Table, Values, answer
from app.answers.curves import COLORS
from app.answers.interface import CONVENTION
from app.answers.materials.about import About, FrontMedium, refuse_more_than
from app.answers.materials.rgb import RgbCurves, rgb_curves
from app.materials.appearance import DAYLIGHT, Viewing, interface
from app.materials.front import Front
from app.materials.media import default_catalog
from app.materials.schema import Preset, called
from app.materials.spectrum import Spectrum
from app.optics.amplitudes import reflectance
from app.optics.color import Gamut
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import Model
from app.optics.specular import F82

SHIRLEY_NM = (400.0, 500.0, 600.0, 700.0, 800.0)
"""The wavelengths of Shirley's figure of copper."""


@answer
class WavelengthCurve:
    """Reflectance over the angle at one wavelength."""

    wavelength_nm: float
    n_i: float
    n: float
    """Against vacuum, as n_i is."""
    k: float | None
    F0: float
    F82: float
    R: Values


@answer
class MaterialCurves:
    """Reflectance over the angle per wavelength and per channel."""

    material: About
    front: FrontMedium
    convention: str
    theta_i_deg: Values
    wavelengths: list[WavelengthCurve]
    rgb: RgbCurves | None
    warnings: list[str]

    def table(self) -> Table:
        """Lay out a column a wavelength, and one a channel of each model."""
        columns = {"theta_i_deg": self.theta_i_deg}
        for single in self.wavelengths:
            columns[f"R_{_written(single.wavelength_nm)}nm"] = single.R
        for curve in self.rgb.curves if self.rgb else ():
            columns |= {f"{curve.model}.{name}": getattr(curve, name) for name in COLORS}
        return Table(columns, f"{called(self.material.id, self.material.name)}_curves.csv")


def curves(
    preset: Preset,
    front: Front,
    *,
    wavelengths_nm: Array | None = None,
    samples: int = 181,
    models: Sequence[Model] | None = None,
    viewing: Viewing = DAYLIGHT,
    gamut: Gamut = "unclamped",
) -> MaterialCurves:
    """Evaluate the reflectance over the angle.

    Parameters
    ----------
    preset, front
        The two media.
    wavelengths_nm
        Where R is evaluated; unless given at those of Shirley's figure where both media are known, and
        if none is, at five over the range where they are.
    samples
        Equally spaced angles from 0 to 90 degrees.
    models
        Those that stand beside the spectrum as R, G and B; None leaves R, G and B out.
    viewing, gamut
        How R, G and B are made.

    Raises
    ------
    NoSpectrum
        If the preset is a single index.
    WavelengthOutOfRange, OutOfRange, NotAllowed
        If a medium is not known or not computed at a wavelength, or there are too many values.
    """
    spectrum = default_catalog().spectrum(preset.id)
    if wavelengths_nm is None:
        low, high = front.range_beside(spectrum)
        known = [value for value in SHIRLEY_NM if low <= value <= high]
        wavelengths_nm = np.array(known or _over(low, high))
    count = wavelengths_nm.size * samples
    refuse_more_than("samples", samples, count, "values of all curves")
    theta_i_deg = np.linspace(0.0, 90.0, samples)
    incidence = Incidence.from_degrees(theta_i_deg)
    warnings = [*spectrum.unknown_k]
    single: list[WavelengthCurve] = []
    if wavelengths_nm.size:
        n_i, said = front.at(wavelengths_nm)
        single = _single(spectrum, n_i, wavelengths_nm, incidence)
        warnings += said
    rgb = None
    if models is not None:
        n_i, said = front.visible()
        warnings += [*spectrum.visible.warnings, *said]
        rgb = rgb_curves(spectrum, n_i, incidence, models, viewing, gamut)
    return MaterialCurves(
        material=About.of(preset),
        front=FrontMedium.of(front),
        convention=CONVENTION,
        theta_i_deg=theta_i_deg,
        wavelengths=single,
        rgb=rgb,
        warnings=list(dict.fromkeys(warnings)),
    )


def _over(low: float, high: float) -> list[float]:
    """Wavelengths in equal ratios, those between the ends in four digits."""
    inner = (float(f"{value:.4g}") for value in np.geomspace(low, high, 5)[1:-1])
    return sorted({low, high, *(value for value in inner if low < value < high)})


def _single(
    spectrum: Spectrum, n_i: Array | float, wavelength_nm: Array, incidence: Incidence
) -> list[WavelengthCurve]:
    """R over the angle at each wavelength."""
    boundary = interface(spectrum, wavelength_nm, n_i)
    media = (boundary.n_i, boundary.n_t, boundary.k_t)
    R = reflectance(Interface(*(np.atleast_1d(a)[:, np.newaxis] for a in media)), incidence)
    columns = (
        np.broadcast_to(a, wavelength_nm.shape).tolist()
        for a in (wavelength_nm, *media, boundary.F0, F82(boundary))
    )
    return [
        WavelengthCurve(
            wavelength_nm=at,
            n_i=in_front,
            n=n,
            k=None if spectrum.k_range_nm is None else k,
            F0=F0,
            F82=at_82,
            R=np.ascontiguousarray(row),
        )
        for (at, in_front, n, k, F0, at_82), row in zip(zip(*columns, strict=True), R, strict=True)
    ]


def _written(number: float) -> str:
    """The shortest digits that mean the number."""
    return repr(number).removesuffix(".0")
