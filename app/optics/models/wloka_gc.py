"""Wloka's equations 7 to 9: g and c scaled by n_i / n_t."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def wloka_gc_factors(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp/Rs from c = cos(theta_i) n_i/n_t and g = sqrt(1 + c^2 - (n_i/n_t)^2)."""
    ratio = interface.n_i / interface.n_t
    c = incidence.cos * ratio
    square = ratio * ratio
    g = np.sqrt(1.0 + c * c - square)
    quotient = (c * (g + c) - square) / (c * (g - c) + square)
    return ((g - c) / (g + c)) ** 2, quotient**2


def wloka_gc(interface: Interface, incidence: Incidence) -> Array:
    """R as one product."""
    first, second = wloka_gc_factors(interface, incidence)
    return np.asarray(0.5 * first * (1.0 + second))


def wloka_gc_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, the two terms of the product."""
    first, second = wloka_gc_factors(interface, incidence)
    return first, first * second


MODEL = Model(
    id="wloka_gc",
    title="Wloka's g, c form",
    applies_to=("dielectric",),
    latex=r"R=\tfrac12\left(\frac{g-c}{g+c}\right)^2"
    r"\left(1+\left[\frac{c(g+c)-\rho^2}{c(g-c)+\rho^2}\right]^2\right),\quad "
    r"\rho=\frac{n_i}{n_t},\quad c=\rho\cos\theta_i,\quad g=\sqrt{1+c^2-\rho^2}",
    reference="M. Wloka, Fresnel Reflection, NVIDIA technical report (2002), equations 7 to 9",
    validity="Exact for dielectrics below the critical angle, undefined beyond it; loses digits as "
    "n_t approaches n_i, and is 0/0 for n_t = n_i at 90 degrees.",
    cost=Cost(add=8, mul=10, div=2, sqrt=1),
    function=wloka_gc,
    polarized=wloka_gc_polarized,
    rounding=(1e-14, 1e-9),
)
