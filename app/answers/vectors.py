"""Reflected and refracted directions in space."""

from __future__ import annotations

import numpy as np

from app.answers.answer import answer
from app.answers.interface import InterfaceFacts
from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.vectors import reflect, refract


@answer
class Directions:
    """A ray at a surface in space; all vectors have length 1."""

    interface: InterfaceFacts
    incident: list[float]
    """Pointing toward the surface."""
    normal: list[float]
    """On the incident side."""
    theta_i_deg: float
    reflected: list[float]
    """Pointing away from the surface."""
    refracted: list[float] | None
    """Null at total internal reflection; in an absorber where the phase advances."""
    Rs: float
    Rp: float
    R: float
    T: float


def directions(interface: Interface, incident: Array, normal: Array) -> Directions:
    """Tell where a ray goes on.

    Parameters
    ----------
    interface
        The boundary.
    incident, normal
        Unit vectors of three components: the direction toward the surface, and the normal on the
        incident side.

    Raises
    ------
    NotAllowed
        If one is no unit vector, or the ray comes from behind.
    """
    reflected = reflect(incident, normal)
    refracted = refract(incident, normal, *interface.indices)
    # The sine from the tangential part, which has its digits along the normal.
    cos = -float(incident @ normal)
    sin = float(np.linalg.norm(incident + cos * normal))
    incidence = Incidence.from_degrees(np.clip(np.degrees(np.arctan2(sin, cos)), 0.0, 90.0))
    energy = power(interface, incidence)
    return Directions(
        interface=InterfaceFacts.of(interface),
        incident=incident.tolist(),
        normal=normal.tolist(),
        theta_i_deg=float(incidence.theta_i_deg),
        reflected=reflected.tolist(),
        refracted=refracted.direction.tolist() if refracted.exists else None,
        Rs=float(energy.Rs),
        Rp=float(energy.Rp),
        R=float(energy.R),
        T=float(energy.T),
    )
