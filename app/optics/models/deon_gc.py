"""The g, c form with which d'Eon evaluates a dielectric."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def deon_gc_factors(interface: Interface, incidence: Incidence) -> tuple[Array, Array, Array]:
    """eta^2 - 1 + c^2 with c = cos(theta_i), and, where it is not negative, Rs and Rp/Rs."""
    c = incidence.cos
    radicand = interface.eta**2 - 1.0 + c**2
    g = np.sqrt(np.maximum(radicand, 0.0))
    first = (g - c) ** 2 / (g + c) ** 2
    second = (c * (g + c) - 1.0) ** 2 / (c * (g - c) + 1.0) ** 2
    return radicand, first, second


def deon_gc(interface: Interface, incidence: Incidence) -> Array:
    """R as one product; 1 where the radicand is negative."""
    radicand, first, second = deon_gc_factors(interface, incidence)
    return np.where(radicand >= 0.0, 0.5 * first * (1.0 + second), 1.0)


def deon_gc_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, 1 where the radicand is negative."""
    radicand, first, second = deon_gc_factors(interface, incidence)
    return np.where(radicand >= 0.0, first, 1.0), np.where(radicand >= 0.0, first * second, 1.0)


MODEL = Model(
    id="deon_gc",
    title="d'Eon's g, c form",
    applies_to=("dielectric",),
    latex=r"R=\tfrac12\,\frac{(g-c)^2}{(g+c)^2}"
    r"\left(1+\frac{(c(g+c)-1)^2}{(c(g-c)+1)^2}\right),\quad "
    r"g=\sqrt{\eta^2-1+c^2},\quad c=\cos\theta_i,\quad R=1\ \text{for}\ \eta^2-1+c^2<0",
    reference="E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering "
    "(2019), evalF",
    validity="Exact for dielectrics, total internal reflection included; loses digits as eta "
    "approaches 1, and is 0/0 for eta = 1 at 90 degrees.",
    cost=Cost(add=8, mul=10, div=2, sqrt=1),
    function=deon_gc,
    polarized=deon_gc_polarized,
    rounding=(1e-14, 1e-9),
)
