"""Lagarde's first shader form for dielectrics."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def lagarde_dielectric_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp from eta and cos(theta_i) by way of cos(theta_t)."""
    eta, mu = interface.eta, incidence.cos
    cos_t = np.sqrt(1.0 - (1.0 - mu * mu) / (eta * eta))
    r_s = (mu - eta * cos_t) / (mu + eta * cos_t)
    r_p = (cos_t - eta * mu) / (cos_t + eta * mu)
    return r_s * r_s, r_p * r_p


def lagarde_dielectric(interface: Interface, incidence: Incidence) -> Array:
    """R from eta and cos(theta_i) by way of cos(theta_t), as the shader computes it."""
    Rs, Rp = lagarde_dielectric_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="lagarde_dielectric",
    title="Lagarde's dielectric shader",
    applies_to=("dielectric",),
    latex=r"R=\tfrac12\left(\frac{\mu-\eta t}{\mu+\eta t}\right)^2"
    r"+\tfrac12\left(\frac{t-\eta\mu}{t+\eta\mu}\right)^2,\quad "
    r"t=\sqrt{1-\frac{1-\mu^2}{\eta^2}}",
    reference="S. Lagarde, Memo on Fresnel equations (2013), dielectric-dielectric interface",
    validity="Exact for dielectrics below the critical angle, undefined beyond it; loses digits as "
    "eta approaches 1, and is 0/0 for eta = 1 at 90 degrees.",
    cost=Cost(add=7, mul=7, div=3, sqrt=1),
    function=lagarde_dielectric,
    polarized=lagarde_dielectric_polarized,
    rounding=(1e-14, 1e-9),
)
