"""Wloka's equations 1 to 5: sines and tangents of sum and difference of the angles."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def wloka_sin_tan_terms(
    interface: Interface, incidence: Incidence
) -> tuple[Array, Array, Array, Array]:
    """sin(theta_i), R at normal incidence, where the quotients are 0/0, Rs and Rp."""
    n_i, n_t = interface.n_i, interface.n_t
    theta_i, sine = incidence.theta_i, incidence.sin
    theta_t = np.arcsin(n_i / n_t * sine)
    difference, total = theta_i - theta_t, theta_i + theta_t
    R_perpendicular = np.sin(difference) ** 2 / np.sin(total) ** 2
    R_parallel = np.tan(difference) ** 2 / np.tan(total) ** 2
    normal = ((n_i - n_t) / (n_i + n_t)) ** 2
    return sine, normal, R_perpendicular, R_parallel


def wloka_sin_tan(interface: Interface, incidence: Incidence) -> Array:
    """R from theta_i and theta_t, with the limit at normal incidence."""
    sine, normal, R_perpendicular, R_parallel = wloka_sin_tan_terms(interface, incidence)
    return np.where(sine == 0.0, normal, 0.5 * (R_perpendicular + R_parallel))


def wloka_sin_tan_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, with the limit at normal incidence."""
    sine, normal, R_perpendicular, R_parallel = wloka_sin_tan_terms(interface, incidence)
    return np.where(sine == 0.0, normal, R_perpendicular), np.where(sine == 0.0, normal, R_parallel)


MODEL = Model(
    id="wloka_sin_tan",
    title="Wloka's sine and tangent form",
    applies_to=("dielectric",),
    latex=r"R=\tfrac12\left(\frac{\sin^2(\theta_i-\theta_t)}{\sin^2(\theta_i+\theta_t)}"
    r"+\frac{\tan^2(\theta_i-\theta_t)}{\tan^2(\theta_i+\theta_t)}\right),\quad "
    r"R(0)=\left(\frac{n_i-n_t}{n_i+n_t}\right)^2",
    reference="M. Wloka, Fresnel Reflection, NVIDIA technical report (2002), equations 1 to 5",
    validity="Exact for dielectrics below the critical angle, undefined beyond it; 0/0 at normal "
    "incidence, where the limit stands in, and loses digits as n_t approaches n_i.",
    cost=Cost(add=3, mul=6, div=3, trig=6),
    function=wloka_sin_tan,
    polarized=wloka_sin_tan_polarized,
    rounding=(1e-14, 1e-9),
)
