"""Schlick as Unreal, Frostbite and Filament run it: grazing reflectance fades below F0 = 2 %."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, fifth_power, no_critical_angle


def schlick_f90_50(interface: Interface, incidence: Incidence, F0: Array) -> Array:  # noqa: ARG001
    """F0 + (F90 - F0)(1 - mu)^5 with F90 = min(50 F0, 1)."""
    F90 = np.minimum(50.0 * F0, 1.0)
    return np.asarray(F0 + (F90 - F0) * fifth_power(incidence.cos))


MODEL = Model(
    id="schlick_f90_50",
    title="Schlick with F90 = min(50 F0, 1)",
    latex=r"R\approx F_0+(F_{90}-F_0)(1-\mu)^5,\quad F_{90}=\min(50F_0,1)",
    reference="S. Lagarde and C. de Rousiers, Moving Frostbite to Physically Based Rendering, "
    "SIGGRAPH 2014 course notes; F_Schlick of Unreal Engine",
    validity="Schlick itself from F0 = 0.02 on (n_t/n_i = 1.33). Below, engines read a small F0 as "
    "shadowing and take the reflection away, which no interface does: an index near 1 still reflects "
    "everything at grazing incidence. Each channel has its own F90 here; engines take one for all.",
    cost=Cost(add=2, mul=4),
    function=schlick_f90_50,
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.1, 0, max_abs=0.887, at_deg=90.0, rms=0.196),
        Measured(1, 1.5, 0, max_abs=0.0357, at_deg=85.0, rms=0.0163),
    ),
)
