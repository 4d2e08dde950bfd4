"""Snell's law: the refraction angle and the penetration depths."""

import numpy as np
from numpy.typing import NDArray

from app.optics.amplitudes import wave
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.blocks import broadcast
from app.optics.parameters import Array


def is_totally_reflected(interface: Interface, incidence: Incidence) -> NDArray[np.bool_]:
    """Where no wave travels on: q is imaginary, sin(theta_i) > eta without absorption."""
    stands = (interface.kappa == 0.0) & wave(interface, incidence).stands
    return np.broadcast_to(stands, broadcast(interface, incidence))


def refraction_angle_deg(interface: Interface, incidence: Incidence) -> Array:
    r"""Real angle of refraction, :math:`\theta_t = \arctan(\sin\theta_i / \mathrm{Re}\,q)`.

    In an absorber the planes of constant phase make this angle with the surface, while those of
    constant amplitude stay parallel to it (the wave is inhomogeneous).

    Returns
    -------
    Array
        Degrees, 0 to 90, of the broadcast shape; NaN at total internal reflection.
    """
    q = wave(interface, incidence)
    angle = np.degrees(np.arctan2(incidence.sin, q.a))
    return np.where(is_totally_reflected(interface, incidence), np.nan, angle)


def penetration_depth_wavelengths(interface: Interface, incidence: Incidence) -> Array:
    r"""Depth at which the power has fallen to 1/e, :math:`1/(2\,\mathrm{Im}\,k_z)`.

    Returns
    -------
    Array
        In vacuum wavelengths, 1 / (4 pi n_i Im q), of the broadcast shape; NaN where the wave
        travels on undamped. It is half of the field's.
    """
    b = np.asarray(wave(interface, incidence).b)
    depth = np.full(broadcast(interface, incidence), np.nan)
    np.divide(1.0, 4.0 * np.pi * interface.n_i * b, out=depth, where=b > 0.0)
    return depth


def field_penetration_depth_wavelengths(interface: Interface, incidence: Incidence) -> Array:
    r"""Depth at which the field has fallen to 1/e, :math:`1/\mathrm{Im}\,k_z`.

    Spectroscopy by attenuated total reflection (ATR) and many textbooks mean this one by
    "penetration depth"; microscopy by total internal reflection mostly that of the intensity.

    Returns
    -------
    Array
        In vacuum wavelengths, 1 / (2 pi n_i Im q), of the broadcast shape; NaN where the wave
        travels on undamped. It is twice the power's.
    """
    return 2.0 * penetration_depth_wavelengths(interface, incidence)
