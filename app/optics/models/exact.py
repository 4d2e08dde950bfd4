"""Fresnel's equations, on the forms of `app.optics.amplitudes`; the reference for all others."""

from app.optics.amplitudes import power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import Cost, Model


def exact(interface: Interface, incidence: Incidence) -> Array:
    """Reflectance of unpolarized light, exact and free of cancellation."""
    return power(interface, incidence).R


MODEL = Model(
    id="exact",
    title="Exact Fresnel",
    kind="exact",
    applies_to=("dielectric", "conductor"),
    latex=r"R=\tfrac12\left(|r_s|^2+|r_p|^2\right),\quad "
    r"r_s=\frac{1-N^2}{(\mu+q)^2},\quad "
    r"r_p=\frac{(N^2-1)(N^2\mu^2-\sin^2\theta_i)}{(N^2\mu+q)^2},\quad "
    r"q=\sqrt{N^2-\sin^2\theta_i},\quad N=\eta+i\kappa",
    reference="A. Fresnel 1823; M. Born and E. Wolf, Principles of Optics, 1.5 and 14.2, "
    "rewritten here so that nothing cancels as N approaches 1",
    validity="Every interface and angle; the reference that all models are measured against.",
    cost=Cost(add=15, mul=24, div=3, sqrt=2),
    function=exact,
)
