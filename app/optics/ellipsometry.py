r"""Polarization: psi and delta, Jones and Mueller matrices, Stokes vectors, and their signs.

Two choices divide the literature, and what is printed without both cannot be compared.

- The time factor. With exp(-i w t) a medium that absorbs is n + i k, with exp(+i w t) it is n - i k, and
  every amplitude is the complex conjugate: phases and delta change sign.
- Where the p axis of the reflected wave points. At normal incidence r_p = -r_s if the axes of the
  incident and of the reflected wave point the same way as seen along each ray (as in the core, and in
  Born and Wolf), and r_p = r_s if they point the same way in space: r_p changes sign, delta by 180.

Jones vectors are (E_p, E_s), p, s and the direction of travel in this order being right-handed.
Stokes vectors are (S0, S1, S2, S3) with S0 = I_p + I_s, S1 = I_p - I_s, S2 = I_+45 - I_-45 from p
towards s, and S3 > 0 for right circular light, which turns clockwise for the one whom it meets.

References
----------
.. [1] R. M. A. Azzam and N. M. Bashara, Ellipsometry and Polarized Light, sections 2.2 and 4.2.
.. [2] M. Born and E. Wolf, Principles of Optics, 7th ed., sections 1.4, 1.5 and 10.9.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from app.optics.amplitudes import Amplitudes, Complex, Power
from app.optics.errors import NotAllowed, UnknownName
from app.optics.parameters import Array

TimeFactor = Literal["exp(-iwt)", "exp(+iwt)"]
Normal = Literal["-r_s", "r_s"]

TIME_FACTORS: tuple[TimeFactor, ...] = get_args(TimeFactor)
NORMALS: tuple[Normal, ...] = get_args(Normal)

_ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Convention:
    """Which signs amplitudes, phases and delta have.

    Raises
    ------
    UnknownName
        If a choice is none of those that exist.
    """

    time_factor: TimeFactor = "exp(-iwt)"
    """Of all waves; it goes with the sign of the imaginary part of every index."""
    r_p_at_normal: Normal = "-r_s"
    """What r_p is at normal incidence."""

    def __post_init__(self) -> None:
        if self.time_factor not in TIME_FACTORS:
            raise UnknownName("convention", self.time_factor, TIME_FACTORS)
        if self.r_p_at_normal not in NORMALS:
            raise UnknownName("r_p_at_normal", self.r_p_at_normal, NORMALS)

    @property
    def text(self) -> str:
        """The convention in words, as answers state it."""
        minus = self.time_factor == TIME_FACTORS[0]
        time, sign = ("exp(-i w t)", "+") if minus else ("exp(+i w t)", "-")
        r_p = self.r_p_at_normal
        return f"time factor {time}; N = n_t {sign} i k_t with k_t >= 0; r_p = {r_p} at normal incidence"

    def of(self, ours: Amplitudes) -> Amplitudes:
        """Turn amplitudes of the core, in exp(-iwt) with r_p = -r_s, into this convention."""
        parts = ours.r_s, ours.r_p, ours.t_s, ours.t_p
        if self.time_factor == "exp(+iwt)":
            parts = tuple(np.conj(part) for part in parts)  # type: ignore[assignment]
        r_s, r_p, t_s, t_p = parts
        return Amplitudes(r_s, r_p if self.r_p_at_normal == "-r_s" else -r_p, t_s, t_p)


CORE = Convention()


def psi_deg(amplitude: Amplitudes) -> Array:
    r"""Ellipsometric psi, :math:`\tan\psi = |r_p| / |r_s|`, in degrees, 0 to 90.

    NaN where nothing is reflected.
    """
    r_p, r_s = np.abs(amplitude.r_p), np.abs(amplitude.r_s)
    return np.where((r_p == 0.0) & (r_s == 0.0), np.nan, np.degrees(np.arctan2(r_p, r_s)))


def delta_deg(amplitude: Amplitudes) -> Array:
    r"""Ellipsometric delta, :math:`\arg(r_p / r_s)`, in degrees above -180 up to 180.

    The sign is that of the convention which the amplitudes are in. NaN where r_p or r_s is 0.

    Examples
    --------
    Bare silicon at 632.8 nm and 70 degrees, as an ellipsometer prints it:

    >>> from app.optics.amplitudes import amplitudes
    >>> from app.optics.incidence import Incidence
    >>> from app.optics.interface import Interface
    >>> ours = amplitudes(Interface(1.0, 3.8827, 0.0196), Incidence.from_degrees(70.0))
    >>> round(float(delta_deg(Convention("exp(+iwt)").of(ours))), 5)
    179.20608
    """
    p, s = np.asarray(amplitude.r_p), np.asarray(amplitude.r_s)
    # In real arithmetic, where the products of r_p = -r_s cancel to 0 and the phase is 180 degrees.
    real, imaginary = p.real * s.real + p.imag * s.imag, p.imag * s.real - p.real * s.imag
    angle = np.degrees(np.arctan2(imaginary + 0.0, real))
    none = (real == 0.0) & (imaginary == 0.0)
    return np.where(none, np.nan, np.where(angle <= -180.0, 180.0, angle))


def jones(of_p: Complex, of_s: Complex) -> Complex:
    """Jones matrix in the basis (p, s), of the amplitudes' shape followed by (2, 2).

    It is diagonal, since neither polarization turns into the other at a plane surface.
    """
    matrix = np.zeros((*np.broadcast_shapes(of_p.shape, of_s.shape), 2, 2), np.complex128)
    matrix[..., 0, 0], matrix[..., 1, 1] = of_p, of_s
    return matrix


def mueller_of_reflection(amplitude: Amplitudes, convention: Convention = CORE) -> Array:
    """Mueller matrix of reflection, of the amplitudes' shape followed by (4, 4).

    Parameters
    ----------
    amplitude
        In `convention`.
    convention
        Its time factor does not change the matrix; r_p = r_s at normal incidence changes the sign of
        the last two rows.
    """
    R_p, R_s = np.abs(amplitude.r_p) ** 2, np.abs(amplitude.r_s) ** 2
    return _mueller(R_p, R_s, amplitude.r_p * np.conj(amplitude.r_s), convention)


def mueller_of_transmission(
    amplitude: Amplitudes, power: Power, convention: Convention = CORE
) -> Array:
    """Mueller matrix of transmission, for power across the last boundary.

    Where the second medium absorbs, the powers of s and p are not in the ratio of the squares of the
    fields; the lower rows then take the phases from the fields and the sizes from the powers.
    """
    cross = amplitude.t_p * np.conj(amplitude.t_s)
    size = np.abs(cross)
    turned = np.where(size > 0.0, cross / np.where(size > 0.0, size, 1.0), 1.0)
    return _mueller(power.Tp, power.Ts, np.sqrt(power.Tp * power.Ts) * turned, convention)


def _mueller(of_p: Array, of_s: Array, cross: Complex, convention: Convention) -> Array:
    matrix = np.zeros((*cross.shape, 4, 4))
    matrix[..., 0, 0] = matrix[..., 1, 1] = 0.5 * (of_p + of_s)
    matrix[..., 0, 1] = matrix[..., 1, 0] = 0.5 * (of_p - of_s)
    matrix[..., 2, 2] = matrix[..., 3, 3] = cross.real
    turning = cross.imag if convention.time_factor == "exp(-iwt)" else -cross.imag
    matrix[..., 2, 3], matrix[..., 3, 2] = -turning, turning
    return matrix


def stokes_of_jones(vector: ArrayLike, convention: Convention = CORE) -> Array:
    """Stokes vector of a Jones vector (E_p, E_s), shapes (..., 2) to (..., 4)."""
    field = np.asarray(vector, np.complex128)
    E_p, E_s = field[..., 0], field[..., 1]
    cross = E_p * np.conj(E_s)
    turning = cross.imag if convention.time_factor == "exp(-iwt)" else -cross.imag
    I_p, I_s = np.abs(E_p) ** 2, np.abs(E_s) ** 2
    return np.stack([I_p + I_s, I_p - I_s, 2.0 * cross.real, 2.0 * turning], axis=-1)


def checked_stokes(vector: ArrayLike) -> Array:
    """Return Stokes vectors as an array of shape (..., 4).

    Raises
    ------
    NotAllowed
        If one is not four finite numbers with S0 > 0 and S1^2 + S2^2 + S3^2 <= S0^2.
    """
    stokes = np.asarray(vector, np.float64)
    allowed = "four numbers S0,S1,S2,S3 with S0 > 0 and S1^2 + S2^2 + S3^2 at most S0^2"
    if stokes.ndim == 0 or stokes.shape[-1] != 4 or not np.isfinite(stokes).all():
        raise NotAllowed("stokes", stokes.tolist(), allowed)
    polarized = np.sqrt(np.sum(stokes[..., 1:] ** 2, axis=-1))
    if not np.all((stokes[..., 0] > 0.0) & (polarized <= stokes[..., 0] * (1.0 + _ROUNDING))):
        raise NotAllowed("stokes", stokes.tolist(), allowed)
    return stokes


def degree_of_polarization(stokes: Array) -> Array:
    """Part of the power that is polarized, 0 to 1; NaN where there is none."""
    total = np.where(stokes[..., 0] > 0.0, stokes[..., 0], np.nan)
    return np.asarray(np.sqrt(np.sum(stokes[..., 1:] ** 2, axis=-1)) / total)
