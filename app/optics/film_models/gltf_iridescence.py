"""KHR_materials_iridescence as three.js evaluates it."""

import numpy as np

from app.optics.film_models import (
    CoatedSurface,
    Deviation,
    FilmModel,
    Sensitivity,
    airy,
    faded,
    gaussian_xyz,
    index_of,
    inside,
)
from app.optics.parameters import Array
from app.optics.specular import exponential

_TO_REC709 = np.array(
    [
        [3.2404542, -1.5371385, -0.4985314],
        [-0.9692660, 1.8760108, 0.0415560],
        [0.0556434, -0.2040259, 1.0572252],
    ]
)
_WHOLE_AT_NM = 0.03


def iridescence(surface: CoatedSurface, sensitivity: Sensitivity) -> Array:
    """Schlick's curve at both faces, of real indices that F0 gives; two orders, no polarization."""
    film_n = faded(surface, _WHOLE_AT_NM)
    cos2, kept_out = inside(surface, film_n)
    R12 = exponential(((film_n - 1.0) / (film_n + 1.0)) ** 2, surface.cos)
    base_n = index_of(surface.F0)
    R23 = exponential(((base_n - film_n) / (base_n + film_n)) ** 2, cos2)
    phase = np.where(film_n < 1.0, 0.0, np.pi) + np.where(base_n < film_n, np.pi, 0.0)
    difference = 2.0 * film_n * surface.thickness_nm * cos2
    coated = airy(R12, R23, phase, difference, sensitivity, 2, (1e-5, 0.9999))
    coated = np.where(kept_out, 1.0, coated)
    return np.where(surface.thickness_nm > 0.0, coated, exponential(surface.F0, surface.cos))


def _rec709(difference: Array, phase: Array) -> Array:
    return np.asarray(gaussian_xyz(difference, phase) @ _TO_REC709.T)


MODEL = FilmModel(
    id="gltf_iridescence",
    title="glTF iridescence in three.js",
    reference="L. Belcour and P. Barla, A Practical Extension to Microfacet Theory for the Modeling of "
    "Varying Iridescence (2017), doi:10.1145/3072959.3073620, as in three.js 0.187.0, "
    "iridescence_fragment.glsl.js, and in KHR_materials_iridescence",
    validity="No polarization: Schlick's curve at both faces, with phases 0 and pi. A metal is the real "
    "index that its color F0 gives, and has no phase of its own. Two orders. Above thickness 0 it "
    "jumps: two of Schlick's curves do not make the one of the bare surface, and the sensitivities sum "
    "to 1.20, 0.95 and 0.91 in red, green and blue. Glass under 0.01 nm of index 1.3 reflects 0.155 of "
    "red at 60 degrees in place of 0.089.",
    function=iridescence,
    sensitivity=_rec709,
    floor=0.0,
    measured=(
        Deviation(
            film_n=1.33, n_t=1.5, k_t=0.0, max_abs=0.0876, max_delta_e=7.08, mean_delta_e=2.707
        ),
        Deviation(
            film_n=2.4, n_t=1.5, k_t=0.0, max_abs=0.1920, max_delta_e=18.99, mean_delta_e=3.815
        ),
        Deviation(
            film_n=1.38, n_t=4.0, k_t=0.03, max_abs=0.2802, max_delta_e=30.18, mean_delta_e=5.956
        ),
        Deviation(
            film_n=1.5, n_t=1.0, k_t=6.6, max_abs=0.3026, max_delta_e=27.64, mean_delta_e=3.176
        ),
    ),
)
