"""Lagarde's second shader form for dielectrics, with the test for total reflection."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def lagarde_gc_factors(interface: Interface, incidence: Incidence) -> tuple[Array, Array, Array]:
    """g^2 = eta^2 + c^2 - 1 with c = cos(theta_i), and, where it is not negative, Rs and Rp/Rs."""
    eta, c = interface.eta, incidence.cos
    radicand = eta * eta + c * c - 1.0
    g = np.sqrt(np.maximum(radicand, 0.0))
    ratio = ((g + c) * c - 1.0) / ((g - c) * c + 1.0)
    return radicand, ((g - c) / (g + c)) ** 2, ratio * ratio


def lagarde_gc(interface: Interface, incidence: Incidence) -> Array:
    """R as one product; 1 where g is imaginary."""
    radicand, first, second = lagarde_gc_factors(interface, incidence)
    return np.where(radicand < 0.0, 1.0, 0.5 * first * (1.0 + second))


def lagarde_gc_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, 1 where g is imaginary."""
    radicand, first, second = lagarde_gc_factors(interface, incidence)
    return np.where(radicand < 0.0, 1.0, first), np.where(radicand < 0.0, 1.0, first * second)


MODEL = Model(
    id="lagarde_gc",
    title="Lagarde's g, c shader",
    applies_to=("dielectric",),
    latex=r"R=\frac{(g-c)^2}{2(g+c)^2}\left(1+\frac{(c(g+c)-1)^2}{(c(g-c)+1)^2}\right),\quad "
    r"g=\sqrt{\eta^2+c^2-1},\quad c=\cos\theta_i,\quad R=1\ \text{for}\ g^2<0",
    reference="S. Lagarde, Memo on Fresnel equations (2013), after Larsen, Shading a Surface using "
    "BRDFs; the form of R. Cook and K. Torrance (1982)",
    validity="Exact for dielectrics, total internal reflection included; loses digits as eta "
    "approaches 1, and is 0/0 for eta = 1 at 90 degrees.",
    cost=Cost(add=8, mul=8, div=2, sqrt=1),
    function=lagarde_gc,
    polarized=lagarde_gc_polarized,
    rounding=(1e-14, 1e-9),
)
