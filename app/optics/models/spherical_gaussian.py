"""Schlick with the fifth power replaced by an exponential of base 2."""

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, exponential, no_critical_angle


def spherical_gaussian(interface: Interface, incidence: Incidence, F0: Array) -> Array:  # noqa: ARG001
    """F0 + (1 - F0) 2^((-5.55473 mu - 6.98316) mu)."""
    return exponential(F0, incidence.cos)


MODEL = Model(
    id="spherical_gaussian",
    title="Spherical Gaussian",
    latex=r"R\approx F_0+(1-F_0)\,2^{(-5.55473\,\mu-6.98316)\,\mu}",
    reference="S. Lagarde, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel "
    "(2012); B. Karis, Real Shading in Unreal Engine 4, SIGGRAPH 2013 course notes",
    validity="Where Schlick holds, whose polynomial it follows; it ends a little above F0 at normal "
    "incidence.",
    cost=Cost(add=2, mul=3, pow=1),
    function=spherical_gaussian,
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.5, 0, max_abs=0.0387, at_deg=85.3, rms=0.0162),
        Measured(1, 0.27, 2.9, max_abs=0.0179, at_deg=76.4, rms=0.0101),
        Measured(1, 2.9, 3, max_abs=0.176, at_deg=83.1, rms=0.0829),
    ),
)
