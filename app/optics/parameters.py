"""Declared parameters: one place for name, symbol, bounds and unit.

The core checks its arguments against these declarations, and the API's query models, OpenAPI and the
controls on the page are made from them.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.optics.errors import OutOfRange
from app.optics.meant import instead

Array = NDArray[np.float64]

Number = float | Array
"""One number, with which Python is faster, or many, with which NumPy is."""

Condition = bool | NDArray[np.bool_]
"""What holds of one number, or of each of many."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number that users may set."""

    name: str
    """Spelling in Python, JSON, URL and JavaScript."""
    symbol: str
    """LaTeX of the symbol."""
    default: float | None
    """Value used when none is given; None where it is solved from the interface."""
    minimum: float
    maximum: float
    """Inclusive bounds."""
    unit: str
    """Unit, empty for pure numbers."""
    description: str
    """One sentence for API docs and labels on the page."""
    integer: bool = False
    """Whether only whole numbers make sense."""
    choices: tuple[tuple[str, float], ...] = ()
    """The only values there are, each a name and its number; empty where all within bounds are. The
    name may be given in place of the number."""
    triple: bool = False
    """Whether R, G and B may differ: three numbers give three curves. The core broadcasts, so three
    values of shape (3, 1) and angles of shape (n,) give R of shape (3, n)."""

    @property
    def allowed(self) -> str:
        """The bounds in words."""
        if self.choices:
            return "one of " + ", ".join(name for name, _ in self.choices)
        unit = f" {self.unit}" if self.unit else ""
        number = "whole" if self.integer else "finite"
        return f"a {number} number from {self.minimum:g} to {self.maximum:g}{unit}"

    def check(self, value: ArrayLike) -> Array:
        """Return `value` as a float64 array.

        Raises
        ------
        OutOfRange
            If any element is no real number, NaN, infinite, out of bounds or none of the choices.
        """
        given: Any = dict(self.choices).get(value, value) if isinstance(value, str) else value
        if isinstance(given, float) and self._inside(given):
            return np.asarray(given)
        try:
            if np.iscomplexobj(given):
                raise TypeError
            array = np.asarray(given, dtype=np.float64)
        except (TypeError, ValueError):
            raise OutOfRange(self.name, value, self.instead_of(value)) from None
        inside = self.admits(array)
        if not inside.all():
            wrong = array[~inside].flat[0]
            raise OutOfRange(self.name, wrong, self.instead_of(wrong))
        return array

    def instead_of(self, value: object) -> str:
        """Say what to give in place of a value that is refused."""
        return instead(self.name, value) or self.allowed

    def admits(self, array: Array) -> NDArray[np.bool_]:
        """Which elements are within the bounds, whole and among the choices as declared."""
        return np.asarray(self._inside(array))

    def _inside(self, values: Number) -> Condition:
        inside = (values >= self.minimum) & (values <= self.maximum)  # NaN compares false
        if self.integer:
            inside = inside & (values == np.rint(values))
        if self.choices:
            inside = inside & np.isin(values, [number for _, number in self.choices])
        return inside


UNLESS_GIVEN = "that of the interface unless given"
RGB = " Three values are R, G and B."


def share(
    name: str,
    symbol: str,
    description: str,
    default: float | None = None,
    maximum: float = 1.0,
    triple: bool = False,
) -> Parameter:
    """Declare a pure number from 0 to 1."""
    return Parameter(name, symbol, default, 0.0, maximum, "", description, triple=triple)


class AboveMinimum(Parameter):
    """A number that the minimum itself is not allowed for."""

    __slots__ = ()

    @property
    def allowed(self) -> str:
        """The bounds in words."""
        return f"a finite number above {self.minimum:g}, up to {self.maximum:g} {self.unit}"

    def _inside(self, values: Number) -> Condition:
        return super()._inside(values) & (values > self.minimum)


N_I = Parameter(
    "n_i", r"n_i", 1.0, 1e-3, 100.0, "", "Real refractive index of the incident medium."
)
N_T = Parameter(
    "n_t", r"n_t", 1.5, 1e-3, 100.0, "", "Real part of the second medium's refractive index."
)
K_T = Parameter(
    "k_t",
    r"k_t",
    0.0,
    0.0,
    100.0,
    "",
    "Imaginary part of the second medium's index (extinction), in N = n_t + i k_t.",
)
K_I = Parameter(
    "k_i",
    r"k_i",
    0.0,
    0.0,
    100.0,
    "",
    "Imaginary part of the incident medium's index. Where it is not 0, light may come along the normal "
    "alone.",
)
LAYER_N = replace(N_T, name="n", symbol="n", description="Real part of a layer's index.")
LAYER_K = replace(K_T, name="k", symbol="k", description="Imaginary part of a layer's index.")
THICKNESS_NM = Parameter("thickness_nm", r"d", 0.0, 0.0, 1e9, "nm", "Thickness of a layer.")
THETA_I_DEG = Parameter(
    "theta_i_deg",
    r"\theta_i",
    0.0,
    0.0,
    90.0,
    "deg",
    "Angle of incidence, measured from the surface normal.",
)
THETA_I = Parameter(
    "theta_i", r"\theta_i", 0.0, 0.0, np.pi / 2, "rad", "Angle of incidence from the normal."
)
THETA_I_RAD = replace(
    THETA_I,
    name="theta_i_rad",
    description="The angle of incidence in radians, in place of theta_i_deg; the double nearest pi/2 "
    "counts as 90 degrees.",
)
WAVELENGTH_NM = AboveMinimum(
    "wavelength_nm", r"\lambda", None, 0.0, 1e7, "nm", "Wavelength of the light."
)
MU = Parameter("mu", r"\mu", 1.0, 0.0, 1.0, "", "Cosine of the angle of incidence.")
