"""No Fresnel at all: what some engines reflect of glass or of metals, at every angle."""

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, no_critical_angle


def constant_f0(interface: Interface, incidence: Incidence, F0: Array) -> Array:  # noqa: ARG001
    """F0, at every angle."""
    return F0


MODEL = Model(
    id="constant_f0",
    title="F0 at every angle",
    latex=r"R\approx F_0",
    reference="PlayCanvas 2.23.3, StandardMaterial, and the preview shader of usd-core 26.11 for "
    "metals, both measured in 2026; https://openusd.org/release/spec_usdpreviewsurface.html asks for it",
    validity="Near normal incidence. Everything that changes with the angle is lost: clear media by "
    "far the most, metals by what they miss of 1 at grazing incidence.",
    cost=Cost(),
    function=constant_f0,
    snippet="it is F0 itself",
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.5, 0, max_abs=0.96, at_deg=90.0, rms=0.28),
        Measured(1, 0.27, 2.9, max_abs=0.108, at_deg=90.0, rms=0.028),
        Measured(1, 2.9, 3, max_abs=0.479, at_deg=90.0, rms=0.0908),
    ),
)
