"""What can be asked of a ray at an interface, by name: the quantities that curves are made of."""

from collections.abc import Callable, Mapping

from app.optics.amplitudes import amplitudes, phase_deg, power, reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.snell import (
    field_penetration_depth_wavelengths,
    penetration_depth_wavelengths,
    refraction_angle_deg,
)

QUANTITIES: Mapping[str, Callable[[Interface, Incidence], Array]] = {
    "R": reflectance,
    "Rs": lambda interface, incidence: power(interface, incidence).Rs,
    "Rp": lambda interface, incidence: power(interface, incidence).Rp,
    "T": lambda interface, incidence: power(interface, incidence).T,
    "Ts": lambda interface, incidence: power(interface, incidence).Ts,
    "Tp": lambda interface, incidence: power(interface, incidence).Tp,
    "phase_s_deg": lambda interface, incidence: phase_deg(amplitudes(interface, incidence).r_s),
    "phase_p_deg": lambda interface, incidence: phase_deg(amplitudes(interface, incidence).r_p),
    "theta_t_deg": refraction_angle_deg,
    "penetration_depth_wavelengths": penetration_depth_wavelengths,
    "field_penetration_depth_wavelengths": field_penetration_depth_wavelengths,
}
"""Quantities of the exact solution, NaN where there is none; every other model has R alone."""
