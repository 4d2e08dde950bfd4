"""Lagarde's optimised shader form for a conductor."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def lagarde_conductor_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp from eta, kappa and cos(theta_i)."""
    eta2, kappa2 = interface.eta**2, interface.kappa**2
    mu2 = incidence.cos**2
    sin2 = 1.0 - mu2
    t0 = eta2 - kappa2 - sin2
    a2_plus_b2 = np.sqrt(t0 * t0 + 4.0 * eta2 * kappa2)
    # The sum is a square root of a sum of squares plus t0; rounding may leave it just below 0.
    two_a_mu = 2.0 * incidence.cos * np.sqrt(np.maximum(0.5 * (a2_plus_b2 + t0), 0.0))
    t1 = a2_plus_b2 + mu2
    Rs = (t1 - two_a_mu) / (t1 + two_a_mu)
    t3, t4 = mu2 * a2_plus_b2 + sin2 * sin2, two_a_mu * sin2
    Rp = Rs * (t3 - t4) / (t3 + t4)
    return Rs, Rp


def lagarde_conductor(interface: Interface, incidence: Incidence) -> Array:
    """R from eta, kappa and cos(theta_i) with a^2 + b^2 and a of the a, b form alone."""
    Rs, Rp = lagarde_conductor_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="lagarde_conductor",
    title="Lagarde's conductor shader",
    latex=r"R_s=\frac{m+\mu^2-2a\mu}{m+\mu^2+2a\mu},\quad "
    r"R_p=R_s\,\frac{\mu^2 m+\sin^4\theta-2a\mu\sin^2\theta}"
    r"{\mu^2 m+\sin^4\theta+2a\mu\sin^2\theta},\quad m=a^2+b^2,"
    r"\quad a+ib=\sqrt{N^2-\sin^2\theta}",
    reference="S. Lagarde, Memo on Fresnel equations (2013), dielectric-conductor interface",
    validity="Exact for conductors and dielectrics; loses digits where R is small, as near eta = 1 "
    "without absorption, and is 0/0 for eta = 1 at 90 degrees.",
    cost=Cost(add=11, mul=14, div=2, sqrt=2),
    function=lagarde_conductor,
    polarized=lagarde_conductor_polarized,
    rounding=(1e-14, 0.001),
)
