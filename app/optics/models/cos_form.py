"""Fresnel's equations in cosines, as Shirley's post and Wikipedia write them."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def cos_form_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp from cos(theta_i) and cos(theta_t) = sqrt(1 - (n_i/n_t sin theta_i)^2)."""
    n_i, n_t, cos_i = interface.n_i, interface.n_t, incidence.cos
    cos_t = np.sqrt(1.0 - (n_i / n_t * incidence.sin) ** 2)
    r_s = (n_i * cos_i - n_t * cos_t) / (n_i * cos_i + n_t * cos_t)
    r_p = (n_i * cos_t - n_t * cos_i) / (n_i * cos_t + n_t * cos_i)
    return r_s**2, r_p**2


def cos_form(interface: Interface, incidence: Incidence) -> Array:
    """R from cos(theta_i) and cos(theta_t) = sqrt(1 - (n_i/n_t sin theta_i)^2)."""
    Rs, Rp = cos_form_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="cos_form",
    title="Cosine form",
    applies_to=("dielectric",),
    latex=r"R=\tfrac12\left(\frac{n_i\cos\theta_i-n_t\cos\theta_t}{n_i\cos\theta_i+n_t\cos\theta_t}"
    r"\right)^2+\tfrac12\left(\frac{n_i\cos\theta_t-n_t\cos\theta_i}{n_i\cos\theta_t+n_t\cos\theta_i}"
    r"\right)^2",
    reference="P. Shirley, Fresnel Equations, Schlick Approximation, Metals, and Dielectrics (2020), "
    "quoting Wikipedia",
    validity="Exact for dielectrics below the critical angle, undefined beyond it; loses digits as "
    "n_t approaches n_i, and is 0/0 for n_t = n_i at 90 degrees.",
    cost=Cost(add=7, mul=11, div=2, sqrt=1),
    function=cos_form,
    polarized=cos_form_polarized,
    rounding=(1e-14, 1e-9),
)
