"""Schlick with F0 left in its sRGB encoding: the trap of a color picked from a picture."""

from app.optics.color import encode_srgb
from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import F0_PARAMETER, SOLVE_F0, polynomial


def schlick_f0_srgb(interface: Interface, incidence: Incidence, F0: Array) -> Array:  # noqa: ARG001
    """Schlick with the sRGB value of F0 where the linear one belongs."""
    return polynomial(encode_srgb(F0), incidence.cos)


MODEL = Model(
    id="schlick_f0_srgb",
    title="Schlick with F0 taken as sRGB (trap)",
    trap=True,
    latex=r"R\approx F_0'+(1-F_0')(1-\mu)^5,\quad F_0'=1.055\,F_0^{1/2.4}-0.055",
    reference="transfer function of IEC 61966-2-1:1999; P. Shirley (2020) warns of it: be careful "
    "about gamma",
    validity="Nowhere: an encoded color used as a reflectance is too bright everywhere but at "
    "grazing incidence. Decode it first.",
    cost=Cost(add=2, mul=4),
    function=schlick_f0_srgb,
    parameters=(F0_PARAMETER,),
    solve=SOLVE_F0,
    limits=lambda _: "a trap: F0 has to be decoded from sRGB to linear first",
    measured=(
        Measured(1, 1.5, 0, max_abs=0.181, at_deg=0.0, rms=0.153),
        Measured(1, 0.27, 2.9, max_abs=0.0675, at_deg=67.8, rms=0.0587),
    ),
)
