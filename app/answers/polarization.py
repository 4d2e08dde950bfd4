"""What a surface does to polarized light: Jones and Mueller matrices, and a Stokes vector."""

from __future__ import annotations

import numpy as np

from app.answers.answer import Rows, Values, answer, number_or_none
from app.answers.films import Coated, LayerFacts, convention_text, response
from app.answers.interface import InterfaceFacts
from app.optics.amplitudes import Complex, amplitudes, power
from app.optics.ellipsometry import (
    Convention,
    checked_stokes,
    degree_of_polarization,
    delta_deg,
    jones,
    mueller_of_reflection,
    mueller_of_transmission,
    psi_deg,
)
from app.optics.errors import NotAllowed
from app.optics.films import NO_AMPLITUDES
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array

BASIS = (
    "Jones vectors are (E_p, E_s), with p, s and the direction of travel right-handed; Stokes vectors "
    "are (S0, S1, S2, S3) with S1 = I_p - I_s, S2 = I_+45 - I_-45 from p towards s, and S3 > 0 for "
    "right circular light, which turns clockwise for the one whom it meets"
)


@answer
class ComplexNumber:
    """A complex number."""

    re: float
    im: float


@answer
class Beam:
    """A Stokes vector."""

    stokes: Values
    """S0, S1, S2, S3."""
    degree_of_polarization: float | None
    """Null where there is no light."""

    @classmethod
    def of(cls, stokes: Array) -> Beam:
        """Describe a Stokes vector."""
        return cls(
            stokes=stokes, degree_of_polarization=number_or_none(degree_of_polarization(stokes))
        )


@answer
class Polarizer:
    """What reflection or transmission does to polarization."""

    jones: list[list[ComplexNumber]]
    """Of the electric field, in the basis (p, s)."""
    mueller: Rows
    """For power."""
    beam: Beam
    """What becomes of the incident beam."""


@answer
class Polarization:
    """One ray's polarization at a surface."""

    interface: InterfaceFacts
    """The boundary without layers."""
    layers: list[LayerFacts]
    """From the incident side on."""
    wavelength_nm: float | None
    """Of the phases in layers; null without them."""
    convention: str
    basis: str = BASIS
    theta_i_deg: float
    psi_deg: float | None
    """arctan(|r_p| / |r_s|); null where nothing is reflected."""
    delta_deg: float | None
    """Phase of r_p / r_s in this convention; null where one of them is 0."""
    incident: Beam
    reflection: Polarizer
    transmission: Polarizer


def polarization(
    interface: Interface,
    incidence: Incidence,
    stokes: Array,
    coated: Coated | None,
    convention: Convention,
) -> Polarization:
    """Tell what a surface does to polarized light.

    Parameters
    ----------
    interface, incidence
        The boundary and the direction.
    stokes
        Stokes vector of the incident beam.
    coated
        The boundary with layers on it; None without.
    convention
        Which signs amplitudes and phases have.

    Raises
    ------
    NotAllowed
        If it is no Stokes vector, or a layer is incoherent.
    """
    incident = checked_stokes(stokes)
    if coated is None:
        ours, energy = amplitudes(interface, incidence), power(interface, incidence)
    else:
        energy, known, _ = response(coated.stack, incidence)
        if known is None:
            raise NotAllowed("layers", "an incoherent layer", NO_AMPLITUDES)
        ours = known
    amplitude = convention.of(ours)
    reflecting = mueller_of_reflection(amplitude, convention)
    transmitting = mueller_of_transmission(amplitude, energy, convention)
    return Polarization(
        interface=InterfaceFacts.of(interface),
        layers=[] if coated is None else coated.layers,
        wavelength_nm=None if coated is None else coated.wavelength_nm,
        convention=convention_text(convention, layers=coated is not None),
        theta_i_deg=float(incidence.theta_i_deg),
        psi_deg=number_or_none(psi_deg(amplitude)),
        delta_deg=number_or_none(delta_deg(amplitude)),
        incident=Beam.of(incident),
        reflection=_polarizer(jones(amplitude.r_p, amplitude.r_s), reflecting, incident),
        transmission=_polarizer(jones(amplitude.t_p, amplitude.t_s), transmitting, incident),
    )


def _polarizer(matrix: Complex, mueller: Array, incident: Array) -> Polarizer:
    return Polarizer(
        jones=[
            [ComplexNumber(re=float(each.real), im=float(each.imag) + 0.0) for each in row]
            for row in matrix
        ],
        mueller=np.ascontiguousarray(mueller),
        beam=Beam.of(np.asarray(mueller @ incident)),
    )
