r"""Reflectance and edge tint in place of n and k, by Gulbrandsen and by d'Eon.

All indices here are relative to the incident medium: eta = n_t / n_i, kappa = k_t / n_i. Interfaces
of one F0 = r lie on a circle in the eta, kappa plane, between

.. math::
    \eta_{min} = \frac{1 - \sqrt r}{1 + \sqrt r}, \qquad \eta_{max} = \frac{1 + \sqrt r}{1 - \sqrt r}

about the center (1 + r)/(1 - r) with the radius rho = 2 sqrt(r)/(1 - r). Gulbrandsen's g runs along
eta from eta_max (0, a dielectric) to (1 - r)/(1 + r) (1, where |N| = 1); d'Eon's G is the angle about
the center over pi, from eta_max (0) to eta_min (1), and so covers the whole circle.

References
----------
.. [1] O. Gulbrandsen, Artist Friendly Metallic Fresnel, Journal of Computer Graphics Techniques
   3(4), 64-72 (2014).
.. [2] E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering (2019).
"""

import numpy as np

from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, RGB, UNLESS_GIVEN, Array, share

LARGEST_R = 0.9999
"""Largest reflectance that an index is worked out from; that of 1 is infinite."""

REFLECTANCE = share(
    "r",
    "r",
    f"Reflectance at normal incidence, F0; {UNLESS_GIVEN}.{RGB}",
    maximum=LARGEST_R,
    triple=True,
)
EDGE_TINT = share(
    "g",
    "g",
    f"Gulbrandsen's edge tint, 0 for a dielectric to 1 for |N| = 1; {UNLESS_GIVEN}, where it exceeds 1 "
    f"if |N| < 1.{RGB}",
    triple=True,
)
TINT_ANGLE = share(
    "G",
    "G",
    "D'Eon's edge tint, the angle about the circle's center over pi, 0 for a dielectric; "
    f"{UNLESS_GIVEN}.{RGB}",
    triple=True,
)


def eta_max(r: Array) -> Array:
    """Largest eta of reflectance r, (1 + sqrt r)/(1 - sqrt r): the dielectric n_t > n_i."""
    root = np.sqrt(r)
    return np.asarray((1.0 + root) / (1.0 - root))


def gulbrandsen_index(r: Array, g: Array) -> tuple[Array, Array]:
    """Eta and kappa of Gulbrandsen's r and g [1]_."""
    top, bottom = eta_max(r), (1.0 - r) / (1.0 + r)
    eta = g * bottom + (1.0 - g) * top
    # kappa^2 = (r (eta + 1)^2 - (eta - 1)^2)/(1 - r) factored: what lies to either side of the circle.
    # The first factor is an exact 0 for a dielectric; the second may round to just below 0.
    kappa2 = g * (top - bottom) * np.maximum(eta - 1.0 / top, 0.0)
    return np.asarray(eta), np.sqrt(kappa2)


def gulbrandsen_g(eta: Array, r: Array) -> Array:
    """Gulbrandsen's g of a relative index and its F0 = r; above 1 where eta^2 + kappa^2 < 1.

    Without a boundary, or one too faint for doubles, every g gives the same index: 0 is returned.
    """
    top = eta_max(r)
    width = top - (1.0 - r) / (1.0 + r)
    with np.errstate(invalid="ignore", divide="ignore"):
        g = (top - eta) / width
    # A dielectric has g = 0 exactly; rounding of the square root may leave it just below.
    return np.where(width == 0.0, 0.0, np.maximum(g, 0.0))


def deon_index(r: Array, G: Array) -> tuple[Array, Array]:
    """Eta and kappa of d'Eon's r and G [2]_, with no digits lost at either end."""
    rho = 2.0 * np.sqrt(r) / (1.0 - r)
    # (1 + r)/(1 - r) + rho cos(pi G) as a sum of positive terms; sin(pi) is made an exact 0.
    eta = 1.0 / eta_max(r) + 2.0 * rho * np.cos(0.5 * np.pi * G) ** 2
    kappa = rho * np.sin(np.pi * np.where(G > 0.5, 1.0 - G, G))
    return np.asarray(eta), np.asarray(kappa)


def deon_G(eta: Array, kappa: Array, r: Array) -> Array:
    """D'Eon's G of a relative index and its F0 = r, 0 to 1; 0 without a boundary."""
    with np.errstate(invalid="ignore", divide="ignore"):
        G = np.arctan2(kappa, eta - (1.0 + r) / (1.0 - r)) / np.pi
    return np.where(r == 0.0, 0.0, G)


def relative_interface(eta: Array, kappa: Array) -> Interface:
    """Interface of a relative index, with n_i chosen so that all three indices are in bounds.

    R depends on the ratios alone; r near 1 asks for indices beyond 100 or below 0.001 in air.
    """
    largest = np.maximum(eta, kappa)
    n_i = np.where(largest > N_T.maximum, N_T.maximum / largest, 1.0)
    n_i = np.where(eta < N_T.minimum, N_T.minimum / eta, n_i)
    # Rounding of the products may leave the very bound that they were scaled to.
    return Interface(
        np.clip(n_i, N_I.minimum, N_I.maximum),
        np.clip(eta * n_i, N_T.minimum, N_T.maximum),
        np.clip(kappa * n_i, K_T.minimum, K_T.maximum),
    )
