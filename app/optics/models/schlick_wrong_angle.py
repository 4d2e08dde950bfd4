"""Schlick on the denser side with the angle of incidence: the trap that schlick_tir avoids."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import polynomial


def schlick_wrong_angle(interface: Interface, incidence: Incidence) -> Array:
    """Schlick with cos(theta_i), whichever side the light comes from."""
    return polynomial(interface.F0, incidence.cos)


def _always_wrong(interface: Interface) -> str:
    if bool(np.any(interface.eta < 1.0)):
        return "a trap: inside the denser medium the polynomial wants cos(theta_t), see schlick_tir"
    return "a trap that opens for n_t < n_i; here it is Schlick's approximation itself"


MODEL = Model(
    id="schlick_wrong_angle",
    title="Schlick with the wrong angle inside glass (trap)",
    trap=True,
    applies_to=("dielectric",),
    latex=r"R\approx F_0+(1-F_0)(1-\cos\theta_i)^5\quad\text{although}\ n_i>n_t",
    reference="S. Lagarde, Memo on Fresnel equations (2013), FresnelSchlick against FresnelSchlickTIR",
    validity="Nowhere: below the surface total internal reflection is missed entirely, so a water "
    "surface seen from below turns into a window.",
    cost=Cost(add=2, mul=4),
    function=schlick_wrong_angle,
    limits=_always_wrong,
    measured=(
        Measured(1.333, 1, 0, max_abs=0.975, at_deg=48.6, rms=0.638),
        Measured(1.5, 1, 0, max_abs=0.959, at_deg=41.8, rms=0.684),
    ),
)
