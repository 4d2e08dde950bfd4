"""A material as color sees it: n and k over the visible, of spectra and of single indices alike."""

from dataclasses import dataclass

import numpy as np

from app.materials.media import default_catalog
from app.materials.schema import Preset
from app.materials.spectrum import UNKNOWN_K, Colored, Visible
from app.optics.color import WAVELENGTH_NM


@dataclass(frozen=True, slots=True)
class Constant:
    """A material of which one index is known, taken for all wavelengths."""

    visible: Visible


ONE_INDEX = "one index stands for all wavelengths"


def colored(preset: Preset) -> Colored:
    """Return n and k of a preset over the visible, end values held and a single index everywhere."""
    if preset.kind == "spectrum":
        return default_catalog().spectrum(preset.id)
    n, k = (np.full(WAVELENGTH_NM.shape, v) for v in (preset.n_absolute, preset.k or 0.0))
    unknown = (UNKNOWN_K,) if preset.k is None else ()
    return Constant(Visible(n, k, (ONE_INDEX, *unknown)))
