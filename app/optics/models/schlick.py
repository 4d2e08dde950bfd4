"""Schlick's polynomial, the approximation in nearly every renderer."""

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, no_critical_angle, polynomial


def schlick(interface: Interface, incidence: Incidence, F0: Array) -> Array:  # noqa: ARG001
    """F0 + (1 - F0)(1 - mu)^5."""
    return polynomial(F0, incidence.cos)


MODEL = Model(
    id="schlick",
    title="Schlick",
    rank=0,
    latex=r"R\approx F_0+(1-F_0)(1-\mu)^5",
    reference="C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, Computer "
    "Graphics Forum 13(3), 1994, doi:10.1111/1467-8659.1330233",
    validity="From the thinner side (n_t > n_i); seen from the denser side it knows no critical "
    "angle. Misses the dip of metals before grazing incidence.",
    cost=Cost(add=2, mul=4),
    function=schlick,
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    measured=(
        Measured(1, 1.333, 0, max_abs=0.0592, at_deg=83.8, rms=0.0246),
        Measured(1, 1.5, 0, max_abs=0.0357, at_deg=85.0, rms=0.0163),
        Measured(1, 2.42, 0, max_abs=0.0757, at_deg=84.5, rms=0.0304),
        Measured(1, 0.27, 2.9, max_abs=0.0182, at_deg=76.3, rms=0.0101),
        Measured(1, 2.9, 3.0, max_abs=0.175, at_deg=83.0, rms=0.0828),
    ),
    limits=no_critical_angle,
)
