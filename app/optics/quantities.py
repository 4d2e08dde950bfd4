"""What can be asked of a ray at an interface, by name: the quantities that curves are made of."""

from collections.abc import Callable, Mapping

import numpy as np

from app.optics import films
from app.optics.amplitudes import Amplitudes, amplitudes, phase_deg, power, reflectance
from app.optics.ellipsometry import delta_deg, psi_deg
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.blocks import broadcast
from app.optics.parameters import Array
from app.optics.snell import (
    field_penetration_depth_wavelengths,
    penetration_depth_wavelengths,
    refraction_angle_deg,
)
from app.optics.stack import Stack


def nothing_absorbed(interface: Interface, incidence: Incidence) -> Array:
    """Without layers nothing is absorbed between the media: R + T = 1."""
    return np.zeros(broadcast(interface, incidence))


QUANTITIES: Mapping[str, Callable[[Interface, Incidence], Array]] = {
    "R": reflectance,
    "Rs": lambda interface, incidence: power(interface, incidence).Rs,
    "Rp": lambda interface, incidence: power(interface, incidence).Rp,
    "T": lambda interface, incidence: power(interface, incidence).T,
    "Ts": lambda interface, incidence: power(interface, incidence).Ts,
    "Tp": lambda interface, incidence: power(interface, incidence).Tp,
    "A": nothing_absorbed,
    "As": nothing_absorbed,
    "Ap": nothing_absorbed,
    "psi_deg": lambda interface, incidence: psi_deg(amplitudes(interface, incidence)),
    "delta_deg": lambda interface, incidence: delta_deg(amplitudes(interface, incidence)),
    "phase_s_deg": lambda interface, incidence: phase_deg(amplitudes(interface, incidence).r_s),
    "phase_p_deg": lambda interface, incidence: phase_deg(amplitudes(interface, incidence).r_p),
    "theta_t_deg": refraction_angle_deg,
    "penetration_depth_wavelengths": penetration_depth_wavelengths,
    "field_penetration_depth_wavelengths": field_penetration_depth_wavelengths,
}
"""Quantities of the exact solution, NaN where there is none; every other model has R alone."""

_OF_FIELDS: Mapping[str, Callable[[Amplitudes], Array]] = {
    "psi_deg": psi_deg,
    "delta_deg": delta_deg,
    "phase_s_deg": lambda amplitude: phase_deg(amplitude.r_s),
    "phase_p_deg": lambda amplitude: phase_deg(amplitude.r_p),
}


def of_films(quantity: str, stack: Stack, incidence: Incidence) -> Array:
    """A quantity of `QUANTITIES` where there are films.

    Raises
    ------
    NotAllowed
        If it is a phase and a layer is incoherent.
    """
    if quantity in _OF_FIELDS:
        return _OF_FIELDS[quantity](films.amplitudes(stack, incidence))
    source = {"R": films.power, "T": films.power, "A": films.absorption}.get(quantity[0])
    if source is not None:
        return np.asarray(getattr(source(stack, incidence), quantity))
    # The refracted wave is that of the boundary without films.
    return QUANTITIES[quantity](stack.substrate, incidence)
