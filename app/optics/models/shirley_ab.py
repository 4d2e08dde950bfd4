"""Shirley's equations 2.4 to 2.7: a conductor by two real numbers a and b."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def shirley_ab_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp from a and b."""
    n_i, n, k = interface.n_i, interface.n_t, interface.k_t
    cosine = incidence.cos
    sin2 = incidence.sin**2
    t0 = n**2 - k**2 - n_i**2 * sin2
    root = np.sqrt(t0**2 + 4.0 * n**2 * k**2)
    a2, b2 = (root + t0) / (2.0 * n_i**2), (root - t0) / (2.0 * n_i**2)
    a = np.sqrt(np.maximum(a2, 0.0))  # rounding may leave a vanishing a^2 just below 0
    sin_tan = sin2 / cosine
    Rs = (a2 + b2 - 2.0 * a * cosine + cosine**2) / (a2 + b2 + 2.0 * a * cosine + cosine**2)
    Rp = (
        Rs * (a2 + b2 - 2.0 * a * sin_tan + sin_tan**2) / (a2 + b2 + 2.0 * a * sin_tan + sin_tan**2)
    )
    return Rs, Rp


def shirley_ab(interface: Interface, incidence: Incidence) -> Array:
    """R from a^2 and b^2, the squares of real and imaginary part of q, relative to n_i."""
    Rs, Rp = shirley_ab_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="shirley_ab",
    title="Shirley's a, b form",
    latex=r"R_s=\frac{a^2+b^2-2a\cos\theta+\cos^2\theta}{a^2+b^2+2a\cos\theta+\cos^2\theta},\quad "
    r"R_p=R_s\,\frac{a^2+b^2-2a\sin\theta\tan\theta+\sin^2\theta\tan^2\theta}"
    r"{a^2+b^2+2a\sin\theta\tan\theta+\sin^2\theta\tan^2\theta},"
    r"\quad a+ib=\sqrt{N^2-\sin^2\theta}",
    reference="P. Shirley, Physically Based Lighting Calculations for Computer Graphics (1990), "
    "equations 2.4 to 2.7, quoted in Fresnel Equations, Schlick Approximation, Metals, and "
    "Dielectrics (2020)",
    validity="Exact for conductors and dielectrics; the tangent leaves it undefined at 90 degrees, "
    "and it loses digits where R is small.",
    cost=Cost(add=15, mul=19, div=5, sqrt=2),
    function=shirley_ab,
    polarized=shirley_ab_polarized,
    rounding=(1e-14, 0.001),
)
