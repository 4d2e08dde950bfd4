"""The film of the OpenPBR Surface specification, on dielectrics and on metals by F0 and F82-tint."""

from dataclasses import replace

import numpy as np

from app.optics.edge_tint import LARGEST_R, gulbrandsen_index
from app.optics.film_models import CoatedSurface, Sensitivity
from app.optics.film_models.materialx_airy import MODEL as MATERIALX
from app.optics.film_models.materialx_airy import of_index
from app.optics.parameters import Array
from app.optics.real import Rp, Rs
from app.optics.specular import MU_BAR, polynomial

_HALVINGS = 50


def effective_index(F0: Array, F82: Array) -> tuple[Array, Array]:
    """n and k of a metal of that F0 which reflects F82 at 82 degrees, or comes nearest to it.

    They lie on Gulbrandsen's circle of F0; F82 counts as far as a tint of 1 has it, Schlick's curve.
    """
    r = np.clip(F0, 0.0, LARGEST_R)
    wanted = np.minimum(F82, polynomial(r, MU_BAR))
    mu = np.asarray(MU_BAR)
    low, high = np.zeros_like(r), np.ones_like(r)
    for _ in range(_HALVINGS):
        g = 0.5 * (low + high)
        eta, kappa = gulbrandsen_index(r, g)
        # Along the circle what is reflected at 82 degrees rises from the dielectric on.
        below = 0.5 * (Rs(mu, eta, kappa) + Rp(mu, eta, kappa)) < wanted
        low, high = np.where(below, g, low), np.where(below, high, g)
    return gulbrandsen_index(r, 0.5 * (low + high))


def coated(surface: CoatedSurface, sensitivity: Sensitivity) -> Array:
    """Each polarization by itself with its phase, two orders, over the index that F0 and F82 give."""
    n, k = effective_index(surface.F0, surface.F82)
    absorbs = surface.k > 0.0
    n, k = np.where(absorbs, n, surface.n), np.where(absorbs, k, 0.0)
    return of_index(surface, n, k, sensitivity)


# Of one n and k, as those that are measured, F0 and F82 give the very same: so are the errors.
MODEL = replace(
    MATERIALX,
    id="openpbr_film",
    title="OpenPBR thin film",
    reference="OpenPBR Surface specification 1.1.1, Thin-film iridescence, with L. Belcour and P. Barla "
    "(2017), doi:10.1145/3072959.3073620, and O. Gulbrandsen, Artist Friendly Metallic Fresnel, "
    "JCGT 3(4), 64 (2014)",
    validity="The specification asks for Belcour and Barla's film and leaves how to the renderer. On a "
    "dielectric it is MaterialX's film, number for number. A metal is typed in as F0 and F82-tint, "
    "for which the specification wants the best matching n and k: here those on Gulbrandsen's circle "
    "of F0 that reflect as much at 82 degrees, with a tint of 1 at most. MaterialX's own graph of "
    "OpenPBR has none: it takes halves of Schlick's curve, as MaterialX's film on Schlick's curve.",
    function=coated,
)
