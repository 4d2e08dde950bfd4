"""One ray at the surface."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.answers.answer import answer, number_or_none
from app.answers.films import Coated, LayerFacts, convention_text, response
from app.answers.interface import InterfaceFacts
from app.optics.amplitudes import Amplitudes, Power, amplitudes, phase_deg, power
from app.optics.ellipsometry import CORE, Convention, delta_deg, psi_deg
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
    r_s: Amplitude | None
    r_p: Amplitude | None
    t_s: Amplitude | None
    t_p: Amplitude | None
    """Null where a layer is incoherent: it has powers alone."""
    psi_deg: float | None
    """arctan(|r_p| / |r_s|); null where nothing is reflected, or a layer is incoherent."""
    delta_deg: float | None
    """Phase of r_p / r_s in this convention; null where one of them is 0, or a layer incoherent."""
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


@answer
class CoatedRay(Ray):
    """One ray at a surface with layers on it, or in a medium that absorbs; `interface` has neither."""

    k_i: float
    """Imaginary part of the incident medium's index."""
    wavelength_nm: float
    layers: list[LayerFacts]
    """From the incident side on."""
    As: float
    Ap: float
    A: float
    """Power that all layers absorb."""
    absorbed: list[float]
    """Power that each layer absorbs, of unpolarized light."""


def ray(
    interface: Interface,
    incidence: Incidence,
    coated: Coated | None = None,
    convention: Convention = CORE,
) -> Ray:
    """Tell everything that is known of one ray.

    Parameters
    ----------
    interface, incidence
        The boundary and the direction.
    coated
        The boundary with layers on it.
    convention
        Which signs amplitudes and phases have.
    """
    if coated is None:
        return Ray(
            **_of_any(interface, incidence, convention_text(convention)),
            **_of_waves(amplitudes(interface, incidence), power(interface, incidence), convention),
        )
    found = response(coated.stack, incidence)
    lost, k_i = found.absorption, float(coated.stack.k_i)
    told = convention_text(convention, layers=True, k_i=k_i)
    return CoatedRay(
        **_of_any(interface, incidence, told),
        **_of_waves(found.amplitudes, found.power, convention),
        k_i=k_i,
        wavelength_nm=coated.wavelength_nm,
        layers=coated.layers,
        As=float(lost.As),
        Ap=float(lost.Ap),
        A=float(lost.A),
        absorbed=[float(share) for share in lost.layers],
    )


def _of_waves(ours: Amplitudes | None, energy: Power, convention: Convention) -> dict[str, Any]:
    """Amplitudes, psi, delta and powers."""
    told: dict[str, Any] = dict.fromkeys(("r_s", "r_p", "t_s", "t_p", "psi_deg", "delta_deg"))
    if ours is not None:
        amplitude = convention.of(ours)
        told = {x: Amplitude.of(getattr(amplitude, x)) for x in ("r_s", "r_p", "t_s", "t_p")}
        told["psi_deg"] = number_or_none(psi_deg(amplitude))
        told["delta_deg"] = number_or_none(delta_deg(amplitude))
    return told | {x: float(getattr(energy, x)) for x in ("Rs", "Rp", "R", "Ts", "Tp", "T")}


def _of_any(interface: Interface, incidence: Incidence, told: str) -> dict[str, Any]:
    """What layers do not change: the directions."""
    theta_t_deg = number_or_none(refraction_angle_deg(interface, incidence))
    refracted = None
    if theta_t_deg is not None:
        below = Incidence.from_degrees(theta_t_deg)
        refracted = [float(below.sin), -float(below.cos)]
    return {
        "interface": InterfaceFacts.of(interface),
        "convention": told,
        "theta_i_deg": float(incidence.theta_i_deg),
        "theta_t_deg": theta_t_deg,
        "total_internal_reflection": bool(is_totally_reflected(interface, incidence)),
        "reflected": [float(incidence.sin), float(incidence.cos)],
        "refracted": refracted,
        "penetration_depth_wavelengths": number_or_none(
            penetration_depth_wavelengths(interface, incidence)
        ),
        "field_penetration_depth_wavelengths": number_or_none(
            field_penetration_depth_wavelengths(interface, incidence)
        ),
    }
