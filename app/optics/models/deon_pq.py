"""The p, q form with which d'Eon evaluates a conductor."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Model


def deon_pq_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp from p and q."""
    n_i, n, k = interface.n_i, interface.n_t, interface.k_t
    t0 = n**2 - k**2 - (n_i * incidence.sin) ** 2
    root = np.sqrt(t0**2 + 4.0 * n**2 * k**2)
    # Rounding may leave a vanishing p^2 or q^2 just below 0.
    p = np.sqrt(np.maximum(0.5 * (root + t0), 0.0))
    q2 = np.maximum(0.5 * (root - t0), 0.0)
    cosine, sin_tan = n_i * incidence.cos, n_i * incidence.sin**2 / incidence.cos
    rho_perpendicular = ((cosine - p) ** 2 + q2) / ((cosine + p) ** 2 + q2)
    rho_parallel = rho_perpendicular * ((p - sin_tan) ** 2 + q2) / ((p + sin_tan) ** 2 + q2)
    return rho_perpendicular, rho_parallel


def deon_pq(interface: Interface, incidence: Incidence) -> Array:
    """R from p and q, real and imaginary part of the second medium's normal wave number."""
    Rs, Rp = deon_pq_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="deon_pq",
    title="d'Eon's p, q form",
    latex=r"\rho_\perp=\frac{(n_i\cos\theta-p)^2+q^2}{(n_i\cos\theta+p)^2+q^2},\quad "
    r"\rho_\parallel=\rho_\perp\,\frac{(p-n_i\sin\theta\tan\theta)^2+q^2}"
    r"{(p+n_i\sin\theta\tan\theta)^2+q^2},\quad R=\tfrac12(\rho_\perp+\rho_\parallel),"
    r"\quad p+iq=\sqrt{N^2-n_i^2\sin^2\theta},\quad N=n_t+ik_t",
    reference="E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering "
    "(2019), conductor, exact",
    validity="Exact for conductors and dielectrics; the tangent leaves it undefined at 90 degrees, "
    "and it loses digits as eta approaches 1.",
    cost=Cost(add=13, mul=15, div=3, sqrt=2),
    function=deon_pq,
    polarized=deon_pq_polarized,
    rounding=(1e-14, 1e-9),
)
