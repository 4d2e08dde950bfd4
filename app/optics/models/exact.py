"""Fresnel's equations, on the forms of `app.optics.amplitudes`; the reference for all others."""

import numpy as np

from app.optics.amplitudes import power, reflectance
from app.optics.models import Array, Cost, Incidence, Interface, Model


def exact(interface: Interface, incidence: Incidence) -> Array:
    """Reflectance of unpolarized light, exact and free of cancellation."""
    return reflectance(interface, incidence)


def exact_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp, exact and free of cancellation."""
    energy = power(interface, incidence)
    return energy.Rs, energy.Rp


def exact_real(mu: Array, eta: Array, kappa: Array) -> Array:
    """The same in real arithmetic, in few enough operations for a shader."""
    sin2 = (1.0 - mu) * (1.0 + mu)
    N2_re, N2_im = (eta - kappa) * (eta + kappa), 2.0 * eta * kappa
    # q = a + i b, the root of N^2 - sin^2; the smaller part from the product, where nothing cancels.
    # Where eta is near 1 and the ray grazes, the differences from 1 keep the digits of both squares.
    grazing = (eta - 1.0) * (eta + 1.0) - kappa**2 + mu * mu
    q2_re = np.where(mu * mu > 0.5, N2_re - sin2, grazing)
    larger = np.sqrt(0.5 * (np.sqrt(q2_re * q2_re + N2_im * N2_im) + np.abs(q2_re)))
    smaller = 0.5 * N2_im / np.maximum(larger, 1e-18)
    a = np.where(q2_re >= 0.0, larger, smaller)
    b = np.where(q2_re >= 0.0, smaller, larger)
    contrast = ((eta - 1.0) ** 2 + kappa**2) * ((eta + 1.0) ** 2 + kappa**2)
    brewster = (N2_re * mu * mu - sin2) ** 2 + (N2_im * mu * mu) ** 2
    s = (mu + a) ** 2 + b**2
    p = (N2_re * mu + a) ** 2 + (N2_im * mu + b) ** 2
    # Not over p * p, which is no 32 bit float for an index above 60,000.
    R = 0.5 * contrast * (1.0 / (s * s) + brewster / p / p)
    # Without a boundary nothing is reflected, at 90 degrees neither.
    return np.where(contrast == 0.0, 0.0, R)


MODEL = Model(
    id="exact",
    title="Exact Fresnel",
    latex=r"R=\tfrac12\left(|r_s|^2+|r_p|^2\right),\quad "
    r"r_s=\frac{1-N^2}{(\mu+q)^2},\quad "
    r"r_p=\frac{(N^2-1)(N^2\mu^2-\sin^2\theta_i)}{(N^2\mu+q)^2},\quad "
    r"q=\sqrt{N^2-\sin^2\theta_i},\quad N=\eta+i\kappa",
    reference="A. Fresnel 1823; M. Born and E. Wolf, Principles of Optics, 7th edition, "
    "1.5 and 14.2, doi:10.1017/CBO9781139644181, "
    "rewritten here so that nothing cancels as N approaches 1",
    validity="Every interface and angle; the reference that all models are measured against.",
    cost=Cost(add=15, mul=23, div=4, sqrt=2),
    function=exact,
    polarized=exact_polarized,
    snippet=exact_real,
    rounding=(1e-14, 1e-14),
)
