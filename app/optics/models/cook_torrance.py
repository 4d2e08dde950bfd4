"""Exact dielectric of the same F0, for metals and dielectrics alike."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, no_critical_angle


def cook_torrance(interface: Interface, incidence: Incidence, F0: Array) -> Array:  # noqa: ARG001
    """Fresnel's g, c form with n = (1 + sqrt F0) / (1 - sqrt F0)."""
    root = np.sqrt(F0)
    n = (1.0 + root) / (1.0 - root)
    c = incidence.cos
    g = np.sqrt(n * n + c * c - 1.0)
    ratio = (c * (g + c) - 1.0) / (c * (g - c) + 1.0)
    R = 0.5 * ((g - c) / (g + c)) ** 2 * (1.0 + ratio * ratio)
    # n is infinite at F0 = 1 and nothing but a mirror; at n = 1 there is no boundary.
    return np.where(F0 >= 1.0, 1.0, np.where(n == 1.0, 0.0, R))


MODEL = Model(
    id="cook_torrance",
    title="Cook and Torrance: dielectric of the same F0",
    latex=r"R\approx\tfrac12\,\frac{(g-c)^2}{(g+c)^2}"
    r"\left(1+\frac{(c(g+c)-1)^2}{(c(g-c)+1)^2}\right),\quad g=\sqrt{n^2-1+c^2},\quad "
    r"c=\cos\theta_i,\quad "
    r"n=\frac{1+\sqrt{F_0}}{1-\sqrt{F_0}}",
    reference="R. L. Cook and K. E. Torrance, A Reflectance Model for Computer Graphics, ACM "
    "Transactions on Graphics 1(1), 1982, doi:10.1145/357290.357293; F_Fresnel of Unreal Engine",
    validity="Exact for dielectrics from the thinner side. For metals the index it makes up has the "
    "right F0 but a far deeper dip than the metal.",
    cost=Cost(add=8, mul=8, div=2, sqrt=1),
    function=cook_torrance,
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    limits=no_critical_angle,
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.485, at_deg=88.5, rms=0.147),
        Measured(1, 2.9, 3, max_abs=0.147, at_deg=86.1, rms=0.0576),
        Measured(1, 1.5, 5, max_abs=0.386, at_deg=87.8, rms=0.119),
    ),
)
