"""Babylon's OpenPBR for clear media: grazing reflectance fades where the two indices come close."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, fifth_power, no_critical_angle


def babylon_openpbr(interface: Interface, incidence: Incidence, F0: Array) -> Array:
    """F0 + (F90 - F0)(1 - mu)^5 with F90 = min(2 |n_t - n_i|, 1)."""
    F90 = np.minimum(2.0 * np.abs(interface.n_t - interface.n_i), 1.0)
    return np.asarray(F0 + (F90 - F0) * fifth_power(incidence.cos))


MODEL = Model(
    id="babylon_openpbr",
    title="Babylon OpenPBR",
    applies_to=("dielectric",),
    latex=r"R\approx F_0+(F_{90}-F_0)(1-\mu)^5,\quad F_{90}=\min(2\,|n_t-n_i|,1)",
    reference="Babylon.js 9.35.0, OpenPBRMaterial of clear media, measured in 2026; "
    "https://github.com/BabylonJS/Babylon.js",
    validity="Schlick itself where the indices differ by half or more. Below, as in water, the "
    "reflection is cut at grazing incidence, where every interface reflects everything.",
    cost=Cost(add=3, mul=5),
    function=babylon_openpbr,
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.333, 0, max_abs=0.334, at_deg=90.0, rms=0.0812),
        Measured(1, 1.5, 0, max_abs=0.0357, at_deg=85.0, rms=0.0163),
    ),
)
