"""Schlick with free end, free exponent and Hoffman's dip."""

import numpy as np

from app.optics.models import (
    RGB,
    Array,
    Cost,
    Incidence,
    Interface,
    Measured,
    Model,
    Parameter,
    share,
)
from app.optics.specular import (
    DIP_SCALE,
    F0_PARAMETER,
    F82,
    MU_BAR,
    dip,
    is_own,
    no_critical_angle,
    own_F0,
)

F90 = share(
    "F90",
    "F_{90}",
    f"Reflectance at grazing incidence; 1 for every real surface.{RGB}",
    default=1.0,
    triple=True,
)
EXPONENT = Parameter(
    "exponent", "q", 5.0, 0.1, 100.0, "", "Exponent of 1 - mu; larger turns up later."
)
A = Parameter(
    "a",
    "a",
    None,
    -50.0,
    50.0,
    "",
    "Depth of the dip; 0 is none. Unless given it is what meets the interface's F82, or 0 where the "
    "F0 or F90 given is not the interface's. Three values are R, G and B.",
    triple=True,
)


def generalized_schlick(
    interface: Interface,  # noqa: ARG001
    incidence: Incidence,
    F0: Array,
    F90: Array,
    exponent: Array,
    a: Array,
) -> Array:
    """F0 + (F90 - F0)(1 - mu)^q - a mu (1 - mu)^6."""
    rise = (1.0 - incidence.cos) ** exponent
    return np.asarray(F0 + (F90 - F0) * rise - a * dip(incidence.cos))


def solved_a(interface: Interface, F0: Array, F90: Array, exponent: Array) -> Array:
    """Depth with which the curve meets the interface's F82 where its ends are the interface's."""
    at_82 = F0 + (F90 - F0) * (1.0 - MU_BAR) ** exponent
    own = (F90 == 1.0) & is_own(interface, F0)
    return np.where(own, DIP_SCALE * (at_82 - F82(interface)), 0.0)


MODEL = Model(
    id="generalized_schlick",
    title="Generalized Schlick",
    latex=r"R\approx F_0+(F_{90}-F_0)(1-\mu)^q-a\,\mu(1-\mu)^6",
    reference="N. Hoffman, Fresnel Equations Considered Harmful, Eurographics Workshop on Material "
    "Appearance Modeling (2019), doi:10.2312/mam.20191305; MaterialX, generalized_schlick_bsdf",
    validity="With its defaults Hoffman's F82 for any interface seen from the thinner side. An F0, an "
    "F90 below 1, an exponent other than 5 or an a that are given are an artist's choice; R may leave 0 "
    "to 1 for extreme a.",
    cost=Cost(add=3, mul=6, pow=1),
    function=generalized_schlick,
    parameters=(F0_PARAMETER, F90, EXPONENT, A),
    solve={"F0": own_F0, "a": solved_a},
    leaves_0_to_1=True,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.5, 0, max_abs=0.0276, at_deg=67.6, rms=0.0157),
        Measured(1, 0.27, 2.9, max_abs=0.00841, at_deg=68.8, rms=0.00486),
        Measured(1, 2.9, 3, max_abs=0.0177, at_deg=87.1, rms=0.00685),
    ),
)
