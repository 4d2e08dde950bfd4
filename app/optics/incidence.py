"""The direction of incidence as an exact pair of cosine and sine."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from app.optics.numerics.choice import select
from app.optics.parameters import MU, THETA_I, THETA_I_DEG, Array, Number

_RADIANS = np.pi / 180.0


@dataclass(frozen=True, slots=True, eq=False)
class Incidence:
    """Directions of incidence, kept as cosine and sine so that neither end loses digits.

    Near 90 degrees the cosine and near 0 the sine would be lost if one were computed from the
    other or from a rounded angle in radians. At exactly 0 and 90 degrees both are exact.
    """

    cos: Array
    sin: Array
    """Cosine and sine of theta_i, float64 arrays of the same shape, within 0 and 1."""
    _degrees: Array | None = None

    @classmethod
    def from_degrees(cls, theta_i_deg: ArrayLike) -> Incidence:
        """Make directions from angles in degrees, 0 to 90.

        Raises
        ------
        OutOfRange
            If an angle is outside, NaN or infinite.
        """
        degrees = THETA_I_DEG.check(theta_i_deg)
        # 90 - degrees is exact for degrees >= 45 (Sterbenz), so the octant turn costs nothing.
        steep = degrees > 45.0
        # By the tangent, the only one of the three that NumPy has in a vectorised form.
        tangent = np.tan(_RADIANS * np.minimum(degrees, 90.0 - degrees))
        near = 1.0 / np.sqrt(1.0 + tangent * tangent)
        far = tangent * near
        cos, sin = select(steep, far, near), select(steep, near, far)
        return cls(np.asarray(cos), np.asarray(sin), degrees)

    @classmethod
    def from_radians(cls, theta_i: ArrayLike) -> Incidence:
        """Make directions from angles in radians; the double nearest pi/2 counts as 90 degrees.

        Raises
        ------
        OutOfRange
            If an angle is outside 0 and pi/2, NaN or infinite.
        """
        theta = THETA_I.check(theta_i)
        return cls(np.where(theta >= THETA_I.maximum, 0.0, np.cos(theta)), np.sin(theta))

    @classmethod
    def from_cosine(cls, mu: ArrayLike) -> Incidence:
        """Make directions from cosines, 0 to 1.

        Raises
        ------
        OutOfRange
            If a cosine is outside, NaN or infinite.
        """
        cosine = MU.check(mu)
        return cls(cosine, np.sqrt((1.0 - cosine) * (1.0 + cosine)))

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the directions."""
        return self.cos.shape

    @property
    def numbers(self) -> tuple[Number, Number]:
        """Cosine and sine, as plain numbers where the direction is one."""
        if self.cos.ndim == 0:
            return float(self.cos), float(self.sin)
        return self.cos, self.sin

    def map(self, pick: Callable[[Array], Array]) -> Incidence:
        """Pick the same directions from every array."""
        degrees = None if self._degrees is None else pick(self._degrees)
        return Incidence(pick(self.cos), pick(self.sin), degrees)

    @property
    def theta_i(self) -> Array:
        """Angle of incidence in radians."""
        return np.arctan2(self.sin, self.cos)

    @property
    def theta_i_deg(self) -> Array:
        """Angle of incidence in degrees, the very number it was made from where that was degrees."""
        return np.degrees(self.theta_i) if self._degrees is None else self._degrees

    @property
    def exact_degrees(self) -> Array | None:
        """The degrees it was made from, or None if it was made from radians or a cosine."""
        return self._degrees
