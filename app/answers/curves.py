"""Reflectance over the angle of incidence, of any models."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike

from app.answers.answer import Gaps, Table, Values, answer, number_or_none
from app.answers.films import Coated, LayerFacts, convention_text, exact_alone, response
from app.answers.interface import InterfaceFacts
from app.optics.amplitudes import amplitudes, phase_deg, power, reflectance
from app.optics.angles import LANDMARKS
from app.optics.ellipsometry import CORE, Convention, delta_deg, psi_deg
from app.optics.errors import NotAllowed
from app.optics.films import NO_AMPLITUDES
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.quantities import QUANTITIES
from app.optics.registry import Model

_OF_BAND = 65
"""Indices at which a range is sampled."""

COLORS = ("R_red", "R_green", "R_blue")
"""Quantities of a model that is given a color."""

_REFRACTION = (
    "theta_t_deg",
    "penetration_depth_wavelengths",
    "field_penetration_depth_wavelengths",
)


@dataclass(frozen=True, slots=True)
class Chosen:
    """A model that was asked for, with what was given for its own parameters."""

    model: Model
    given: Mapping[str, ArrayLike | None]

    def arguments(self, interface: Interface) -> dict[str, Array]:
        """Values of all its parameters at an interface."""
        return self.model.arguments(interface, **self.given)

    def of_one_color(self) -> Chosen:
        """Refuse what is given for R, G and B, of which a line or a map can show but one.

        Raises
        ------
        NotAllowed
            If a parameter is three.
        """
        for name, value in self.given.items():
            if value is not None and np.ndim(value) > 0:
                three = ",".join(f"{number:g}" for number in np.ravel(value))
                raise NotAllowed(f"{self.model.id}.{name}", three, "one number here, not three")
        return self


@answer
class Curve:
    """One quantity of one model over the angles."""

    model: str
    quantity: str
    values: Gaps
    """Null where the model is undefined."""
    in_domain: bool
    reason: str | None
    """Why the interface is outside the model's domain."""
    parameters: dict[str, float | None]
    """Values of the model's parameters that the curve was made with, given or solved."""


@answer
class Curves:
    """Curves over the angle of incidence."""

    interface: InterfaceFacts
    convention: str
    theta_i_deg: Values
    curves: list[Curve]

    def table(self) -> Table:
        """Lay out a column each curve."""
        curves = {f"{curve.model}.{curve.quantity}": curve.values for curve in self.curves}
        return Table({"theta_i_deg": self.theta_i_deg} | curves)


@answer
class CoatedCurves(Curves):
    """Curves of a surface with layers on it; `interface` is that without them."""

    wavelength_nm: float
    layers: list[LayerFacts]
    """From the incident side on."""


def curves(
    interface: Interface,
    models: Sequence[Chosen],
    *,
    samples: int = 181,
    landmarks: bool = False,
    phase: bool = False,
    refraction: bool = False,
    ellipsometry: bool = False,
    band: bool = False,
    polarized: bool = False,
    coated: Coated | None = None,
    convention: Convention = CORE,
) -> Curves:
    """Evaluate models over the angle of incidence.

    Parameters
    ----------
    interface
        The boundary, one of plain numbers.
    models
        What to evaluate; `exact` has more quantities than R.
    samples, landmarks
        The angles, as `sampled_incidence` takes them.
    phase, refraction
        Whether to add the phases of `exact`, and the angle and depths of its refracted wave.
    ellipsometry
        Whether to add psi and delta of `exact`.
    band
        Whether to add the least and the largest R of `exact` over the range of n that the source of
        a preset gives.
    polarized
        Whether to add Rs and Rp of other models than `exact` that tell them apart.
    coated
        The boundary with layers on it, which `exact` alone knows.
    convention
        Which signs phases and delta have.

    Raises
    ------
    NotAllowed
        If another model than `exact` is asked for layers, phases of an incoherent one, or a band
        where no source gives a range.
    """
    if coated is not None:
        exact_alone([chosen.model.id for chosen in models])
    incidence = sampled_incidence(interface, samples, landmarks)
    of_waves = (["phase"] if phase else []) + (["ellipsometry"] if ellipsometry else [])
    found: list[Curve] = []
    for chosen in models:
        model = chosen.model
        reason = model.reason_outside(interface)
        arguments = chosen.arguments(interface)
        if model.id == "exact":
            quantities = list(_exact(interface, incidence, coated, of_waves, convention))
            if band:
                quantities += _band(interface, incidence, coated)
            if refraction:
                quantities += _refracted(interface, incidence)
        else:
            values = np.atleast_2d(model.evaluate(interface, incidence, arguments))
            names = COLORS if len(values) > 1 else ("R",)
            quantities = list(zip(names, map(np.ascontiguousarray, values), strict=True))
            if polarized and model.polarized is not None:
                both = model.evaluate_polarized(interface, incidence, arguments)
                quantities += zip(("Rs", "Rp"), map(np.ascontiguousarray, both), strict=True)
        found += [
            Curve(
                model=model.id,
                quantity=quantity,
                values=values,
                in_domain=reason is None,
                reason=reason,
                parameters={name: of_channel(v, channel) for name, v in arguments.items()},
            )
            for channel, (quantity, values) in enumerate(quantities)
        ]
    facts, theta_i_deg = InterfaceFacts.of(interface), incidence.theta_i_deg
    told = convention_text(convention, layers=coated is not None)
    if coated is None:
        return Curves(interface=facts, convention=told, theta_i_deg=theta_i_deg, curves=found)
    return CoatedCurves(
        interface=facts,
        convention=told,
        theta_i_deg=theta_i_deg,
        curves=found,
        wavelength_nm=coated.wavelength_nm,
        layers=coated.layers,
    )


def sampled_incidence(interface: Interface, samples: int, landmarks: bool) -> Incidence:
    """Equally spaced angles from 0 to 90 degrees, with the landmarks sorted in if asked for."""
    equally_spaced = _equally_spaced(samples)
    if not landmarks:
        return equally_spaced
    marks = np.array([float(angle(interface)) for angle in LANDMARKS.values()])
    marks = marks[np.isfinite(marks)]
    return Incidence.from_degrees(np.unique(np.concatenate([equally_spaced.theta_i_deg, marks])))


@lru_cache(maxsize=8)  # a reader's page asks for the same angles again and again
def _equally_spaced(samples: int) -> Incidence:
    return Incidence.from_degrees(np.linspace(0.0, 90.0, samples))


def of_channel(values: Array, channel: int) -> float | None:
    """Value of one channel out of one number or three; None where it is undefined."""
    return number_or_none(values.ravel()[channel if values.size > 1 else 0])


def _exact(
    interface: Interface,
    incidence: Incidence,
    coated: Coated | None,
    of_waves: Sequence[str],
    convention: Convention,
) -> Iterator[tuple[str, Array]]:
    """Yield the quantities that only the exact solution has, R first."""
    if coated is None:
        energy = power(interface, incidence)
        amplitude = amplitudes(interface, incidence) if of_waves else None
    else:
        if of_waves and not coated.stack.is_coherent:
            raise NotAllowed(of_waves[0], True, f"false where a layer is not {NO_AMPLITUDES}")
        energy, amplitude, lost = response(coated.stack, incidence)
    yield "R", energy.R
    yield "Rs", energy.Rs
    yield "Rp", energy.Rp
    yield "T", energy.T
    if coated is not None:
        yield "A", lost.A
    if amplitude is None:
        return
    amplitude = convention.of(amplitude)
    if "phase" in of_waves:
        yield "phase_s_deg", phase_deg(amplitude.r_s)
        yield "phase_p_deg", phase_deg(amplitude.r_p)
    if "ellipsometry" in of_waves:
        yield "psi_deg", psi_deg(amplitude)
        yield "delta_deg", delta_deg(amplitude)


def _band(
    interface: Interface, incidence: Incidence, coated: Coated | None
) -> list[tuple[str, Array]]:
    """The least and the largest R where the sources give n from one value to another.

    R is no monotonic function of n at every angle, so the range is sampled, both ends included.
    """
    ranges = []
    for side, value in (("incident", interface.n_i), ("material", interface.n_t)):
        resolved = getattr(interface, side, None)
        preset = None if resolved is None else resolved.preset
        if preset is None or preset.n_min is None or preset.n_max is None:
            ranges.append(np.atleast_1d(value))
        else:
            ranges.append(np.linspace(preset.n_min, preset.n_max, _OF_BAND))
    n_i, n_t = np.meshgrid(*ranges, indexing="ij")
    if n_i.size == 1 or coated is not None:
        why = "false, but for a bare surface of a preset whose source gives n from one value to another"
        raise NotAllowed("band", True, why)
    media = Interface(n_i.reshape(-1, 1), n_t.reshape(-1, 1), interface.k_t)
    R = reflectance(media, incidence)
    return [("R_minimum", R.min(axis=0)), ("R_maximum", R.max(axis=0))]


def _refracted(interface: Interface, incidence: Incidence) -> list[tuple[str, Array]]:
    """Angle and depths of the wave in the second medium."""
    return [(name, QUANTITIES[name](interface, incidence)) for name in _REFRACTION]
