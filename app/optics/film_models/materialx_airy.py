"""The film of MaterialX's dielectric_bsdf and conductor_bsdf."""

from collections.abc import Callable

import numpy as np

from app.optics.film_models import (
    CoatedSurface,
    Deviation,
    FilmModel,
    Sensitivity,
    airy,
    gaussian_xyz,
    inside,
)
from app.optics.parameters import Array
from app.optics.real import Rp, Rs

TO_RGB = np.array(
    [
        [2.3706743, -0.9000405, -0.4706338],
        [-0.5138850, 1.4253036, 0.0885814],
        [0.0052982, -0.0146949, 1.0093968],
    ]
)
"""CIE RGB of XYZ, as MaterialX has it: neither the primaries nor the white of sRGB."""
ORDERS = 2


def _phases(cos: Array, film_n: Array, n: Array, k: Array) -> tuple[Array, Array]:
    """Phases of s and p at the lower face."""
    ratio = k / n
    A = n * n * (1.0 - ratio * ratio) - film_n * film_n * (1.0 - cos * cos)
    B = np.sqrt(A * A + (2.0 * n * n * ratio) ** 2)
    U2, V2 = np.maximum(0.5 * (B + A), 0.0), np.maximum(0.5 * (B - A), 0.0)
    U, V = np.sqrt(U2), np.sqrt(V2)
    s = np.arctan2(2.0 * film_n * V * cos, U2 + V2 - (film_n * cos) ** 2)
    p = np.arctan2(
        2.0 * film_n * n * n * cos * (2.0 * ratio * U - (1.0 - ratio * ratio) * V),
        (n * n * (1.0 + ratio * ratio) * cos) ** 2 - film_n * film_n * (U2 + V2),
    )
    return np.asarray(s), np.asarray(p)


Face = tuple[tuple[Array, Array], tuple[Array, Array]]
"""Reflectance and phase, of s and of p."""


def under_film(
    surface: CoatedSurface,
    sensitivity: Sensitivity,
    lower: Callable[[Array, Array], Face],
) -> Array:
    """Mean of s and p of a film, two orders.

    Parameters
    ----------
    surface, sensitivity
        As a model's function has them.
    lower
        The lower face, by the film's index and the cosine inside.
    """
    film_n = np.maximum(surface.film_n, 1.0)
    cos2, _ = inside(surface, film_n)
    difference = 2.0 * film_n * cos2 * surface.thickness_nm
    clear = np.zeros(())
    # At Brewster's angle of the upper face p changes its sign.
    brewster = 1.0 / np.sqrt(1.0 + film_n * film_n)
    above = np.where(surface.cos < brewster, 0.0, np.pi)
    (R23_s, phase_s), (R23_p, phase_p) = lower(film_n, cos2)
    total = sum(
        airy(R12(surface.cos, film_n, clear), R23, phase, difference, sensitivity, ORDERS)
        for R12, R23, phase in (
            (Rs, R23_s, np.pi + phase_s),
            (Rp, R23_p, above + phase_p),
        )
    )
    return np.asarray(0.5 * total)


def of_index(surface: CoatedSurface, n: Array, k: Array, sensitivity: Sensitivity) -> Array:
    """Each polarization by itself with its phase, two orders, over a surface of n + i k."""

    def lower(film_n: Array, cos2: Array) -> Face:
        eta, kappa = n / film_n, k / film_n
        s, p = _phases(cos2, film_n, n, k)
        return (Rs(cos2, eta, kappa), s), (Rp(cos2, eta, kappa), p)

    return under_film(surface, sensitivity, lower)


def coated(surface: CoatedSurface, sensitivity: Sensitivity) -> Array:
    """The same over the surface's own index."""
    return of_index(surface, surface.n, surface.k, sensitivity)


MODEL = FilmModel(
    id="materialx_airy",
    title="MaterialX thin film",
    reference="MaterialX 1.39.5, libraries/pbrlib/genglsl/lib/mx_microfacet_specular.glsl, "
    "mx_fresnel_airy, after L. Belcour and P. Barla (2017), doi:10.1145/3072959.3073620",
    validity="Each polarization by itself with its phase, two orders, and at single wavelengths nearly "
    "right. The color is that of CIE RGB under equal energy, not of sRGB, and a metal's red, green and "
    "blue n and k are taken for those of X, Y and Z: copper under 1 nm of index 1, which does nothing, "
    "turns from (0.952, 0.620, 0.511) to (1, 0.440, 0.511).",
    function=coated,
    sensitivity=gaussian_xyz,
    to_rgb=TO_RGB,
    floor=0.0,
    ceiling=1.0,
    measured=(
        Deviation(
            film_n=1.33, n_t=1.5, k_t=0.0, max_abs=0.0003, max_delta_e=5.24, mean_delta_e=2.262
        ),
        Deviation(
            film_n=2.4, n_t=1.5, k_t=0.0, max_abs=0.0073, max_delta_e=7.36, mean_delta_e=2.423
        ),
        Deviation(
            film_n=1.38, n_t=4.0, k_t=0.03, max_abs=0.0613, max_delta_e=9.58, mean_delta_e=2.814
        ),
        Deviation(
            film_n=1.5, n_t=1.0, k_t=6.6, max_abs=0.1971, max_delta_e=14.59, mean_delta_e=0.916
        ),
    ),
)
