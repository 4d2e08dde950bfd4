"""n and k of one material as functions of the wavelength, only where its source gives them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from app.materials.air import air_index
from app.materials.dispersion import refractive_index
from app.materials.errors import WavelengthOutOfRange
from app.materials.schema import Formula, Points, Quantity, SpectrumFile
from app.optics.color import WAVELENGTH_NM
from app.optics.knobs.dispersion import C_LINE_NM, D_LINE_NM, F_LINE_NM
from app.optics.parameters import Array

UNKNOWN_K = "k is not known and counts as 0"

FORMULA_POINTS = 241
"""Wavelengths in equal ratios that are enough to draw a formula."""


@dataclass(frozen=True, slots=True, eq=False)
class Visible:
    """n and k at `app.optics.color.WAVELENGTH_NM`, for color alone."""

    n: Array
    """Against vacuum, shape (471,)."""
    k: Array
    """Of the same shape. Where the range ends within the visible, the end value is held."""
    warnings: tuple[str, ...]
    """What was held, and whether k is not known and counts as 0."""


class Colored(Protocol):
    """Whatever has n and k over the visible, so that it has a color."""

    @property
    def visible(self) -> Visible:
        """At `app.optics.color.WAVELENGTH_NM`."""


class Spectrum:
    """Optical constants of one material, evaluated from native points or a formula.

    Parameters
    ----------
    file
        What `spectra/<id>.json` holds, provenance included.
    elsewhere
        Finds the ids of other measurements that are known at a wavelength, for messages.

    Attributes
    ----------
    n_range_nm
        Where n is known, both ends included.
    k_range_nm
        The same for k, or None where the source gives no k.
    """

    def __init__(
        self, file: SpectrumFile, elsewhere: Callable[[float], Sequence[str]] = lambda _: ()
    ) -> None:
        self.file = file
        self.id = file.id
        self._elsewhere = elsewhere
        self.n_range_nm = _range(file.n)
        self.k_range_nm = None if file.k is None else _range(file.k)
        self._n = _curve(file.n)
        self._k = None if file.k is None else _curve(file.k)

    def n(self, wavelength_nm: ArrayLike) -> Array:
        """Refractive index as the source has it, at wavelengths in nanometers, of their shape.

        `file.relative_to` says against what; `n_absolute` is what a boundary is made of.

        Raises
        ------
        WavelengthOutOfRange
            If one is outside `n_range_nm`, or NaN.
        """
        wavelengths = np.asarray(wavelength_nm, dtype=np.float64)
        self._check("n", wavelengths, self.n_range_nm)
        return self._n(wavelengths)

    def n_absolute(self, wavelength_nm: ArrayLike) -> Array:
        """Refractive index against vacuum; arguments and errors as for `n`.

        An index that was measured in air is multiplied by that of air, see `air_index`. One whose
        source does not say is taken as absolute.
        """
        return self._against_vacuum(wavelength_nm, self.n(wavelength_nm))

    def k(self, wavelength_nm: ArrayLike) -> Array | None:
        """Extinction coefficient, of the wavelengths' shape, or None where it is not known.

        Raises
        ------
        WavelengthOutOfRange
            If one is outside `k_range_nm`, or NaN.
        """
        if self._k is None or self.k_range_nm is None:
            return None
        wavelengths = np.asarray(wavelength_nm, dtype=np.float64)
        self._check("k", wavelengths, self.k_range_nm)
        return self._k(wavelengths)

    @property
    def range_nm(self) -> tuple[float, float]:
        """Where everything that the source gives is known: n, and k unless it gives none."""
        low, high = self.n_range_nm
        if self.k_range_nm is None:
            return low, high
        return max(low, self.k_range_nm[0]), min(high, self.k_range_nm[1])

    @property
    def known_range_nm(self) -> tuple[float, float]:
        """Where n or k is known."""
        (low, high), k = self.n_range_nm, self.k_range_nm
        return (low, high) if k is None else (min(low, k[0]), max(high, k[1]))

    @property
    def unknown_k(self) -> tuple[str, ...]:
        """Say that k counts as 0, where it does."""
        return (UNKNOWN_K,) if self.k_range_nm is None else ()

    def n_or_nan(self, wavelength_nm: Array) -> Array:
        """Refractive index as the source has it, NaN where it is not known."""
        return _or_nan(self._n, self.n_range_nm, wavelength_nm)

    def n_absolute_or_nan(self, wavelength_nm: Array) -> Array:
        """Refractive index against vacuum, NaN where it is not known."""
        return self._against_vacuum(wavelength_nm, self.n_or_nan(wavelength_nm))

    def k_or_nan(self, wavelength_nm: Array) -> Array | None:
        """Extinction coefficient, NaN where it is not known, or None where it is so everywhere."""
        if self._k is None or self.k_range_nm is None:
            return None
        return _or_nan(self._k, self.k_range_nm, wavelength_nm)

    def native_wavelengths(self, low: float, high: float) -> Array:
        """The source's own points from `low` to `high`, and enough of a formula to draw it."""
        nodes = [
            np.array(q.wavelength_nm)
            if isinstance(q, Points)
            else np.geomspace(*q.range_nm, FORMULA_POINTS)
            for q in (self.file.n, self.file.k)
            if q is not None
        ]
        together = np.unique(np.concatenate(nodes))
        return together[(together >= low) & (together <= high)]

    @cached_property
    def visible(self) -> Visible:
        """n and k over the visible for color, which needs them everywhere; see `Visible`."""
        n = self.n_absolute(np.clip(WAVELENGTH_NM, *self.n_range_nm))
        if self._k is None or self.k_range_nm is None:
            warnings = (*_held("n", self.n_range_nm), UNKNOWN_K)
            return Visible(n, np.zeros_like(n), warnings)
        k = self._k(np.clip(WAVELENGTH_NM, *self.k_range_nm))
        if self.n_range_nm == self.k_range_nm:
            return Visible(n, k, _held("n and k", self.n_range_nm))
        return Visible(n, k, (*_held("n", self.n_range_nm), *_held("k", self.k_range_nm)))

    @cached_property
    def abbe_number(self) -> float | None:
        """V_d = (n_d - 1) / (n_F - n_C), or None where n is not known at all three lines.

        None as well where n is a table: the difference would be that of its last digits. It is made
        of n as the source has it: catalogs of glass print it of n relative to air.
        """
        low, high = self.n_range_nm
        if not isinstance(self.file.n, Formula) or low > F_LINE_NM or high < C_LINE_NM:
            return None
        n_d, n_F, n_C = self.n([D_LINE_NM, F_LINE_NM, C_LINE_NM])
        return float((n_d - 1.0) / (n_F - n_C)) if n_F != n_C else None

    def _against_vacuum(self, wavelength_nm: ArrayLike, n: Array) -> Array:
        return n * air_index(wavelength_nm) if self.file.relative_to == "air" else n

    def _check(self, quantity: str, wavelengths: Array, span: tuple[float, float]) -> None:
        inside = (wavelengths >= span[0]) & (wavelengths <= span[1])  # NaN compares false
        if not inside.all():
            value = float(wavelengths[~inside].flat[0])
            raise WavelengthOutOfRange(self.id, quantity, value, *span, self._elsewhere(value))


def _or_nan(
    curve: Callable[[Array], Array], span: tuple[float, float], wavelength_nm: Array
) -> Array:
    inside = (wavelength_nm >= span[0]) & (wavelength_nm <= span[1])
    values: Array = np.full(wavelength_nm.shape, np.nan)
    values[inside] = curve(wavelength_nm[inside])
    return values


def _held(what: str, span: tuple[float, float]) -> tuple[str, ...]:
    low, high = span
    warnings = []
    if low > WAVELENGTH_NM[0]:
        warnings.append(f"{what} not known below {low:.10g} nm: the color holds the value there")
    if high < WAVELENGTH_NM[-1]:
        warnings.append(f"{what} not known above {high:.10g} nm: the color holds the value there")
    return tuple(warnings)


def _range(quantity: Quantity) -> tuple[float, float]:
    if isinstance(quantity, Formula):
        return quantity.range_nm
    return quantity.wavelength_nm[0], quantity.wavelength_nm[-1]


def _curve(quantity: Quantity) -> Callable[[Array], Array]:
    if isinstance(quantity, Formula):
        number, coefficients = quantity.number, quantity.coefficients
        return lambda wavelengths: refractive_index(number, coefficients, wavelengths / 1000.0)
    nodes, values = np.array(quantity.wavelength_nm), np.array(quantity.values)
    return lambda wavelengths: np.asarray(np.interp(wavelengths, nodes, values))
