"""Fresnel's quotients in complex arithmetic, the textbook form."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def complex_form_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp from the complex quotients with N = n_t + i k_t."""
    n_i, cos_i = interface.n_i, incidence.cos
    index = interface.n_t + 1j * interface.k_t
    q = np.sqrt(index**2 - (n_i * incidence.sin) ** 2)
    r_s = (n_i * cos_i - q) / (n_i * cos_i + q)
    r_p = (index**2 * cos_i - n_i * q) / (index**2 * cos_i + n_i * q)
    return np.abs(r_s) ** 2, np.abs(r_p) ** 2


def complex_form(interface: Interface, incidence: Incidence) -> Array:
    """R = (|r_s|^2 + |r_p|^2) / 2 from the complex quotients with N = n_t + i k_t."""
    Rs, Rp = complex_form_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="complex_form",
    title="Complex form",
    latex=r"r_s=\frac{n_i\cos\theta_i-q}{n_i\cos\theta_i+q},\quad "
    r"r_p=\frac{N^2\cos\theta_i-n_i q}{N^2\cos\theta_i+n_i q},\quad "
    r"q=\sqrt{N^2-n_i^2\sin^2\theta_i},\quad N=n_t+ik_t",
    reference="S. Lagarde, Memo on Fresnel equations (2013), after K. Möller, Optics; sign of k for "
    "the time factor exp(-i w t)",
    validity="Exact for conductors and dielectrics, total internal reflection included; loses digits "
    "as N approaches n_i, and is 0/0 for N = n_i at 90 degrees.",
    cost=Cost(add=15, mul=25, div=2, sqrt=3),
    function=complex_form,
    polarized=complex_form_polarized,
    snippet="it is written in complex numbers, which shading languages lack; exact is the same in "
    "real ones",
    rounding=(1e-14, 1e-9),
)
