"""n, k and F0 of a material over the wavelength; nothing is held beyond what is known."""

from typing import Literal

import numpy as np

from app.answers.answer import Gaps, Table, Values, answer
from app.answers.axes import MOST_STEPS
from app.answers.materials.about import About, range_within, refuse_more_than
from app.materials.appearance import normal_reflectance
from app.materials.media import default_catalog
from app.materials.schema import Formula, Points, Preset, Quantity, Range, called
from app.optics.errors import NotAllowed
from app.optics.parameters import Array


@answer
class NativePoints:
    """Points of the source within the range asked for."""

    kind: Literal["points"]
    wavelength_nm: Values
    values: Values


@answer
class Native:
    """What the source gives for n and for k."""

    n: NativePoints | Formula
    k: NativePoints | Formula | None


@answer
class MaterialSpectrum:
    """n, k and F0 over the wavelength; null where one is not known."""

    material: About
    n_range_nm: Range
    k_range_nm: Range | None
    """Null where the source gives no k."""
    sampling: Literal["native", "step"]
    """`native`: the points of the source, and 241 in equal ratios over the range of a formula;
    `step`: every step_nm."""
    wavelength_nm: Values
    n: Gaps
    """Relative to what the source measured it: see `relative_to` of the material."""
    n_absolute: Gaps | None
    """Against vacuum, where n is relative to air; null elsewhere, as it is n."""
    k: Gaps | None
    F0: Gaps
    """At normal incidence from vacuum."""
    native: Native | None
    """Null when a step is asked for."""
    warnings: list[str]

    def table(self) -> Table:
        """Lay out n, k and F0, of which what is not known is empty; n_absolute where it differs."""
        k = np.full(self.n.shape, np.nan) if self.k is None else self.k
        absolute = {} if self.n_absolute is None else {"n_absolute": self.n_absolute}
        columns = {"wavelength_nm": self.wavelength_nm, "n": self.n, **absolute, "k": k}
        columns["F0"] = self.F0
        return Table(columns, f"{called(self.material.id, self.material.name)}_spectrum.csv")


def spectrum(
    preset: Preset,
    minimum_nm: float | None = None,
    maximum_nm: float | None = None,
    step_nm: float | None = None,
) -> MaterialSpectrum:
    """Tell n, k and F0 over the wavelength.

    Parameters
    ----------
    preset
        The material.
    minimum_nm, maximum_nm
        The range; all that is known unless given.
    step_nm
        Distance of the wavelengths; the native points unless given.

    Raises
    ------
    NoSpectrum
        If the preset is a single index.
    WavelengthOutOfRange, NotAllowed
        As `range_within` does, or if there are too many wavelengths or none.
    """
    data = default_catalog().spectrum(preset.id)
    known = data.known_range_nm
    low, high = range_within((minimum_nm, maximum_nm), known, known, preset.called)
    native = None
    if step_nm is not None:
        wavelength_nm = _stepped(low, high, step_nm)
    else:
        wavelength_nm = data.native_wavelengths(low, high)
        if not wavelength_nm.size:
            raise NotAllowed(
                "step_nm", None, f"a step: no native point is from {low:.10g} to {high:.10g} nm"
            )
        k_file = data.file.k
        native = Native(
            n=_native(data.file.n, low, high),
            k=None if k_file is None else _native(k_file, low, high),
        )
    n, k = data.n_or_nan(wavelength_nm), data.k_or_nan(wavelength_nm)
    n_absolute = data.n_absolute_or_nan(wavelength_nm)
    F0, said = normal_reflectance(n_absolute, k)
    return MaterialSpectrum(
        material=About.of(preset),
        n_range_nm=data.n_range_nm,
        k_range_nm=data.k_range_nm,
        sampling="native" if step_nm is None else "step",
        wavelength_nm=wavelength_nm,
        n=n,
        n_absolute=n_absolute if data.file.relative_to == "air" else None,
        k=k,
        F0=F0,
        native=native,
        warnings=[*data.file.warnings, *data.unknown_k, *said],
    )


def _stepped(low: float, high: float, step: float) -> Array:
    """Wavelengths from `low` in equal steps, none above `high`."""
    count = int(min((high - low) / step + 1e-9, 1e9)) + 1
    refuse_more_than("step_nm", step, count, "wavelengths", MOST_STEPS)
    return np.asarray(np.minimum(low + step * np.arange(count), high))


def _native(quantity: Quantity, low: float, high: float) -> NativePoints | Formula:
    if not isinstance(quantity, Points):
        return quantity
    nodes, values = np.array(quantity.wavelength_nm), np.array(quantity.values)
    inside = (nodes >= low) & (nodes <= high)
    return NativePoints(kind="points", wavelength_nm=nodes[inside], values=values[inside])
