"""Hoffman's Schlick for metals, made to meet the reflectance at 82 degrees."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import (
    DIP_SCALE,
    F0_PARAMETER,
    F82,
    F82_PARAMETER,
    MU_BAR,
    dip,
    is_own,
    own_F0,
    polynomial,
)


def hoffman_f82(interface: Interface, incidence: Incidence, F0: Array, F82: Array) -> Array:  # noqa: ARG001
    """Schlick - a mu (1 - mu)^6 with a such that R = F82 at mu = 1/7."""
    # 17.6513846 and 8.16666667 in print: 7 (7/6)^6 and 49/6.
    a = DIP_SCALE * (F0 - F82) + 49.0 / 6.0 * (1.0 - F0)
    return np.asarray(polynomial(F0, incidence.cos) - a * dip(incidence.cos))


def solved_F82(interface: Interface, F0: Array) -> Array:
    """F82 of the interface where F0 is its own, else Schlick's there."""
    return np.where(is_own(interface, F0), F82(interface), polynomial(F0, MU_BAR))


MODEL = Model(
    id="hoffman_f82",
    title="Hoffman's F82",
    applies_to=("conductor",),
    latex=r"R\approx F_0+(1-F_0)(1-\mu)^5-a\,\mu(1-\mu)^6,\quad "
    r"a=17.6513846\,(F_0-F_{82})+8.16666667\,(1-F_0)",
    reference="N. Hoffman, Fresnel Equations Considered Harmful, Eurographics Workshop on Material "
    "Appearance Modeling (2019), doi:10.2312/mam.20191305",
    validity="Metals; exact at 0, 82 and 90 degrees. Works for dielectrics too, where it removes "
    "part of Schlick's error. A low F82 can take R below 0.",
    cost=Cost(add=3, mul=7),
    function=hoffman_f82,
    parameters=(F0_PARAMETER, F82_PARAMETER),
    solve={"F0": own_F0, "F82": solved_F82},
    leaves_0_to_1=True,
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.00841, at_deg=68.8, rms=0.00486),
        Measured(1, 2.9, 3, max_abs=0.0177, at_deg=87.1, rms=0.00685),
        Measured(1, 1.5, 5, max_abs=0.0114, at_deg=58.9, rms=0.00591),
    ),
)
