"""A medium of one n and k as an own material, so that everything that takes those takes it."""

from __future__ import annotations

from app.materials.media import default_catalog
from app.materials.own.token import OwnData, write
from app.materials.schema import Points, Preset
from app.optics.color import WAVELENGTH_NM

_ENDS = (float(WAVELENGTH_NM[0]), float(WAVELENGTH_NM[-1]))


def constant(n: float, k: float) -> Preset:
    """Return the preset of n and k that are the same at all wavelengths of color, to six decimals."""
    name = f"n = {n:g}" + (f", k = {k:g}" if k else "")
    quantities = (
        Points(kind="points", wavelength_nm=_ENDS, values=(value, value)) for value in (n, k)
    )
    index, absorption = quantities
    data = OwnData(name=name, relative_to="vacuum", n=index, k=absorption)
    return default_catalog().get(write(data).token)
