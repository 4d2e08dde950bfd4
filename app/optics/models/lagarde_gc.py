"""Lagarde's second shader form for dielectrics, with the test for total reflection."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def lagarde_gc(interface: Interface, incidence: Incidence) -> Array:
    """R from eta and c = cos(theta_i) by g^2 = eta^2 + c^2 - 1; 1 where g is imaginary."""
    eta, c = interface.eta, incidence.cos
    radicand = eta * eta + c * c - 1.0
    g = np.sqrt(np.maximum(radicand, 0.0))
    ratio = ((g + c) * c - 1.0) / ((g - c) * c + 1.0)
    R = 0.5 * ((g - c) / (g + c)) ** 2 * (1.0 + ratio * ratio)
    return np.where(radicand < 0.0, 1.0, R)


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
    rounding=(1e-14, 1e-9),
)
