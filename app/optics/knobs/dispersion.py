r"""Knobs of dispersion, all made of the Abbe number V_d = (n_d - 1) / (n_F - n_C).

References
----------
.. [1] KHR_materials_dispersion, extension of glTF 2.0: dispersion = 20 / V_d; its viewers take red,
   green and blue at n_d - s, n_d and n_d + s with s = (n_d - 1) dispersion / 40.
.. [2] OpenPBR Surface specification 1.1.1, translucent base: n(lambda) = A + B / lambda^2.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from app.optics.knobs.knob import Input, Typed
from app.optics.parameters import AboveMinimum, Array, Parameter

D_LINE_NM, F_LINE_NM, C_LINE_NM = 587.5618, 486.1327, 656.2725
"""Spectral lines of the Abbe number: He d, H F and H C."""

GLTF_SCALE = 20.0
"""An Abbe number of 20 is a dispersion of 1."""

ABBE = AboveMinimum("abbe", "V_d", None, 0.0, 1e6, "", "Abbe number V_d = (n_d - 1) / (n_F - n_C).")
_DISPERSION = Parameter("dispersion", "D", None, 0.0, 1e6, "", "glTF's dispersion, 20 / V_d.")
_NUMBER = Parameter(
    "transmission_dispersion_abbe_number", "V_d", None, 0.0, 1e6, "", "OpenPBR's Abbe number."
)
_SCALE = Parameter(
    "transmission_dispersion_scale", "s", None, 0.0, 1.0, "", "What divides OpenPBR's Abbe number."
)

Curve = Callable[[float, float, Array], Array]
"""The index that an engine takes, of n_d, V_d and wavelengths in nm."""


def spread(n_d: float, abbe: float, wavelength_nm: Array) -> Array:
    """n_d, and half of n_F - n_C to both sides of it at the F and C lines [1]_."""
    half = 0.5 * (n_d - 1.0) / abbe
    lines = [F_LINE_NM, D_LINE_NM, C_LINE_NM]
    return np.asarray(np.interp(wavelength_nm, lines, [n_d + half, n_d, n_d - half]))


def cauchy(n_d: float, abbe: float, wavelength_nm: Array) -> Array:
    """A + B / lambda^2 through n_d with the given Abbe number [2]_."""
    B = (n_d - 1.0) / (abbe * (F_LINE_NM**-2 - C_LINE_NM**-2))
    return np.asarray(n_d + B * (np.asarray(wavelength_nm) ** -2.0 - D_LINE_NM**-2))


@dataclass(frozen=True, slots=True, kw_only=True)
class DispersionKnob:
    """One engine's way to say how much the index changes with the wavelength."""

    id: str
    title: str
    inputs: tuple[Input, ...]
    latex: str
    reference: str
    write: Callable[[float], Mapping[str, Typed]]
    """Of the Abbe number; infinite where there is no dispersion."""
    read: Callable[..., float]
    """The Abbe number of the inputs."""
    curve: Curve
    at_nm: tuple[float, ...] | None
    """Where the engine takes an index; None for all of the visible."""


def _over(value: float) -> float:
    return GLTF_SCALE / value if value else math.inf


DISPERSION_KNOBS = (
    DispersionKnob(
        id="gltf_dispersion",
        title="glTF, dispersion",
        inputs=(
            Input(
                "dispersion",
                _DISPERSION,
                0.0,
                (0.0, None),
                "less than 0 is an error to the validator",
            ),
        ),
        latex=r"D=20/V_d",
        reference="KHR_materials_dispersion, extension of glTF 2.0",
        write=lambda abbe: {_DISPERSION.name: GLTF_SCALE / abbe},
        read=_over,
        curve=spread,
        at_nm=(C_LINE_NM, D_LINE_NM, F_LINE_NM),
    ),
    DispersionKnob(
        id="openpbr_dispersion",
        title="OpenPBR, Abbe number",
        inputs=(
            Input(
                "transmission_dispersion_abbe_number",
                _NUMBER,
                20.0,
                (9.0, 91.0),
                "only the slider ends",
            ),
            Input("transmission_dispersion_scale", _SCALE, 0.0, (0.0, 1.0), "0 is no dispersion"),
        ),
        latex=r"V_d=\text{number}/\text{scale}",
        reference="OpenPBR Surface specification 1.1.1, translucent base",
        write=lambda abbe: (
            {_NUMBER.name: abbe, _SCALE.name: 1.0}
            if math.isfinite(abbe)
            else {_NUMBER.name: 20.0, _SCALE.name: 0.0}
        ),
        read=lambda number, scale: number / scale if scale else math.inf,
        curve=cauchy,
        at_nm=None,
    ),
)
"""Every knob of dispersion."""
