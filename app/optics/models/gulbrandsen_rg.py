"""Gulbrandsen's artist-friendly parameters: exact Fresnel from reflectance and edge tint."""

import numpy as np

from app.optics.amplitudes import reflectance
from app.optics.edge_tint import (
    EDGE_TINT,
    LARGEST_R,
    REFLECTANCE,
    gulbrandsen_g,
    gulbrandsen_index,
    relative_interface,
)
from app.optics.models import Array, Cost, Incidence, Interface, Model
from app.optics.models.exact import exact_polarized, exact_real
from app.optics.specular import own_F0


def gulbrandsen_rg(interface: Interface, incidence: Incidence, r: Array, g: Array) -> Array:  # noqa: ARG001
    """Exact R of the index that r and g stand for."""
    return reflectance(relative_interface(*gulbrandsen_index(r, g)), incidence)


def gulbrandsen_rg_polarized(
    interface: Interface,  # noqa: ARG001
    incidence: Incidence,
    r: Array,
    g: Array,
) -> tuple[Array, Array]:
    """Rs and Rp of that index."""
    return exact_polarized(relative_interface(*gulbrandsen_index(r, g)), incidence)


def gulbrandsen_rg_real(mu: Array, r: Array, g: Array) -> Array:
    """The same in real arithmetic."""
    # Nothing has the index of a mirror, r = 1, which would be infinite.
    known = np.clip(r, 0.0, LARGEST_R)
    root = np.sqrt(known)
    n_max = (1.0 + root) / (1.0 - root)
    n_min = (1.0 - known) / (1.0 + known)
    eta = g * n_min + (1.0 - g) * n_max
    # (r (n + 1)^2 - (n - 1)^2)/(1 - r), factored so that it is 0 for g = 0 after rounding too.
    kappa2 = g * (n_max - n_min) * (eta - (1.0 - root) / (1.0 + root))
    return exact_real(mu, eta, np.sqrt(np.maximum(kappa2, 0.0)))


def solved_g(interface: Interface) -> Array:
    """Edge tint of the interface."""
    return gulbrandsen_g(interface.eta, interface.F0)


def _outside(interface: Interface) -> str | None:
    if bool(np.any(interface.eta**2 + interface.kappa**2 < 1.0)):
        return "|N| < n_i: the edge tint would have to exceed 1"
    return None


MODEL = Model(
    id="gulbrandsen_rg",
    title="Gulbrandsen's reflectance and edge tint",
    latex=r"\eta=g\,\frac{1-r}{1+r}+(1-g)\,\frac{1+\sqrt r}{1-\sqrt r},\quad "
    r"\kappa^2=\frac{r(\eta+1)^2-(\eta-1)^2}{1-r},\quad R=R_\text{exact}(\eta,\kappa)",
    reference="O. Gulbrandsen, Artist Friendly Metallic Fresnel, Journal of Computer Graphics "
    "Techniques 3(4), 64-72 (2014)",
    validity="Exact with other parameters: every interface with |N| >= n_i has an r and a g from 0 to "
    "1. Below, the g worked out exceeds 1 and cannot be given, but its curve is still exact.",
    cost=Cost(add=23, mul=29, div=7, sqrt=4),
    function=gulbrandsen_rg,
    polarized=gulbrandsen_rg_polarized,
    snippet=gulbrandsen_rg_real,
    rounding=(1e-14, 1e-14),
    parameters=(REFLECTANCE, EDGE_TINT),
    solve={"r": own_F0, "g": solved_g},
    limits=_outside,
)
