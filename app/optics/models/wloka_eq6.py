"""Wloka's equation 6: one product of sines and cosines."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def wloka_eq6_factors(
    interface: Interface, incidence: Incidence
) -> tuple[Array, Array, Array, Array]:
    """sin(theta_i), R at normal incidence, where the quotients are 0/0, Rs and Rp/Rs."""
    n_i, n_t = interface.n_i, interface.n_t
    theta_i, sine = incidence.theta_i, incidence.sin
    theta_t = np.arcsin(n_i / n_t * sine)
    difference, total = theta_i - theta_t, theta_i + theta_t
    sines = (np.sin(difference) / np.sin(total)) ** 2
    cosines = (np.cos(total) / np.cos(difference)) ** 2
    normal = ((n_i - n_t) / (n_i + n_t)) ** 2
    return sine, normal, sines, cosines


def wloka_eq6(interface: Interface, incidence: Incidence) -> Array:
    """R from theta_i and theta_t, with the limit at normal incidence."""
    sine, normal, sines, cosines = wloka_eq6_factors(interface, incidence)
    return np.where(sine == 0.0, normal, 0.5 * sines * (1.0 + cosines))


def wloka_eq6_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, with the limit at normal incidence."""
    sine, normal, sines, cosines = wloka_eq6_factors(interface, incidence)
    return np.where(sine == 0.0, normal, sines), np.where(sine == 0.0, normal, sines * cosines)


MODEL = Model(
    id="wloka_eq6",
    title="Wloka's equation 6",
    applies_to=("dielectric",),
    latex=r"R=\tfrac12\,\frac{\sin^2(\theta_i-\theta_t)}{\sin^2(\theta_i+\theta_t)}"
    r"\left(1+\frac{\cos^2(\theta_i+\theta_t)}{\cos^2(\theta_i-\theta_t)}\right)",
    reference="M. Wloka, Fresnel Reflection, NVIDIA technical report (2002), equation 6",
    validity="Exact for dielectrics below the critical angle, undefined beyond it; 0/0 at normal "
    "incidence, where the limit stands in, and loses digits as n_t approaches n_i.",
    cost=Cost(add=3, mul=5, div=3, trig=6),
    function=wloka_eq6,
    polarized=wloka_eq6_polarized,
    rounding=(1e-14, 1e-9),
)
