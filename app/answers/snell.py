"""One ray at the surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.answers.answer import answer, number_or_none
from app.answers.interface import CONVENTION, InterfaceFacts
from app.optics.amplitudes import amplitudes, phase_deg, power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.snell import (
    field_penetration_depth_wavelengths,
    is_totally_reflected,
    penetration_depth_wavelengths,
    refraction_angle_deg,
)


@answer
class Amplitude:
    """A complex amplitude."""

    re: float
    im: float
    abs: float
    phase_deg: float
    """Argument in degrees, -180 to 180; at 90 degrees the limit from smaller angles."""

    @classmethod
    def of(cls, array: NDArray[np.complex128]) -> Amplitude:
        """Describe one amplitude."""
        value = complex(array)
        return cls(
            re=value.real,
            im=value.imag + 0.0,  # 0, never -0
            abs=abs(value),
            phase_deg=float(phase_deg(np.asarray(value))),
        )


@answer
class Ray:
    """One ray at the surface y = 0 with normal +y, coming from the upper left."""

    interface: InterfaceFacts
    convention: str
    theta_i_deg: float
    theta_t_deg: float | None
    """Null at total internal reflection."""
    total_internal_reflection: bool
    reflected: list[float]
    """Unit vector [x, y]."""
    refracted: list[float] | None
    """Unit vector [x, y], or null."""
    r_s: Amplitude
    r_p: Amplitude
    t_s: Amplitude
    t_p: Amplitude
    Rs: float
    Rp: float
    R: float
    Ts: float
    Tp: float
    T: float
    penetration_depth_wavelengths: float | None
    """Depth of 1/e of the power in vacuum wavelengths; null if undamped."""
    field_penetration_depth_wavelengths: float | None
    """Depth of 1/e of the field, twice that of the power: the penetration depth of ATR."""


def ray(interface: Interface, incidence: Incidence) -> Ray:
    """Tell everything that is known of one ray."""
    amplitude, energy = amplitudes(interface, incidence), power(interface, incidence)
    theta_t_deg = number_or_none(refraction_angle_deg(interface, incidence))
    refracted = None
    if theta_t_deg is not None:
        below = Incidence.from_degrees(theta_t_deg)
        refracted = [float(below.sin), -float(below.cos)]
    return Ray(
        interface=InterfaceFacts.of(interface),
        convention=CONVENTION,
        theta_i_deg=float(incidence.theta_i_deg),
        theta_t_deg=theta_t_deg,
        total_internal_reflection=bool(is_totally_reflected(interface, incidence)),
        reflected=[float(incidence.sin), float(incidence.cos)],
        refracted=refracted,
        r_s=Amplitude.of(amplitude.r_s),
        r_p=Amplitude.of(amplitude.r_p),
        t_s=Amplitude.of(amplitude.t_s),
        t_p=Amplitude.of(amplitude.t_p),
        Rs=float(energy.Rs),
        Rp=float(energy.Rp),
        R=float(energy.R),
        Ts=float(energy.Ts),
        Tp=float(energy.Tp),
        T=float(energy.T),
        penetration_depth_wavelengths=number_or_none(
            penetration_depth_wavelengths(interface, incidence)
        ),
        field_penetration_depth_wavelengths=number_or_none(
            field_penetration_depth_wavelengths(interface, incidence)
        ),
    )
