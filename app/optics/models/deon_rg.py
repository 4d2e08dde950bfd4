"""D'Eon's modified parameters: exact Fresnel from reflectance and a tint that is an angle."""

import numpy as np

from app.optics.amplitudes import reflectance
from app.optics.edge_tint import (
    LARGEST_R,
    REFLECTANCE,
    TINT_ANGLE,
    deon_G,
    deon_index,
    relative_interface,
)
from app.optics.models import Array, Cost, Incidence, Interface, Model
from app.optics.models.exact import exact_polarized, exact_real
from app.optics.specular import own_F0


def deon_rg(interface: Interface, incidence: Incidence, r: Array, G: Array) -> Array:  # noqa: ARG001
    """Exact R of the index that r and G stand for."""
    return reflectance(relative_interface(*deon_index(r, G)), incidence)


def deon_rg_polarized(
    interface: Interface,  # noqa: ARG001
    incidence: Incidence,
    r: Array,
    G: Array,
) -> tuple[Array, Array]:
    """Rs and Rp of that index."""
    return exact_polarized(relative_interface(*deon_index(r, G)), incidence)


def deon_rg_real(mu: Array, r: Array, G: Array) -> Array:
    """The same in real arithmetic."""
    # Nothing has the index of a mirror, r = 1, which would be infinite.
    known = np.clip(r, 0.0, LARGEST_R)
    root = np.sqrt(known)
    rho = 2.0 * root / (1.0 - known)
    # From its nearer end: the sine of a rounded pi is not 0, and may lie below it.
    angle = np.clip(G, 0.0, 1.0)
    eta = (1.0 - root) / (1.0 + root) + 2.0 * rho * np.sin(0.5 * np.pi * (1.0 - angle)) ** 2
    kappa = rho * np.sin(np.pi * np.minimum(angle, 1.0 - angle))
    return exact_real(mu, eta, kappa)


def solved_G(interface: Interface) -> Array:
    """Tint angle of the interface."""
    return deon_G(interface.eta, interface.kappa, interface.F0)


MODEL = Model(
    id="deon_rg",
    title="d'Eon's reflectance and tint angle",
    latex=r"\eta=\frac{1+r}{1-r}+\rho\cos\pi G,\quad \kappa=\rho\sin\pi G,\quad "
    r"\rho=\frac{2\sqrt r}{1-r},\quad R=R_\text{exact}(\eta,\kappa)",
    reference="E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering "
    "(2019), modified Gulbrandsen mapping",
    validity="Exact with other parameters, for every interface: G = 0 is the dielectric n_t > n_i of "
    "that reflectance, G = 1 the one with n_t < n_i.",
    cost=Cost(add=22, mul=30, div=6, sqrt=4, trig=2),
    function=deon_rg,
    polarized=deon_rg_polarized,
    snippet=deon_rg_real,
    rounding=(1e-14, 1e-14),
    parameters=(REFLECTANCE, TINT_ANGLE),
    solve={"r": own_F0, "G": solved_G},
)
