"""The film of MaterialX's generalized_schlick_bsdf, of which OpenPBR's metals are made."""

import numpy as np

from app.optics.film_models import (
    CoatedSurface,
    Deviation,
    FilmModel,
    Sensitivity,
    gaussian_xyz,
    index_of,
)
from app.optics.film_models.materialx_airy import TO_RGB, Face, under_film
from app.optics.parameters import Array
from app.optics.specular import polynomial


def coated(surface: CoatedSurface, sensitivity: Sensitivity) -> Array:
    """Half of Schlick's curve for each polarization of the lower face, and half of their sum."""

    def lower(film_n: Array, cos2: Array) -> Face:
        half = 0.5 * polynomial(surface.F0, cos2)
        phase = np.where(index_of(surface.F0) < film_n, np.pi, 0.0)
        return (half, phase), (half, phase)

    return under_film(surface, sensitivity, lower)


MODEL = FilmModel(
    id="materialx_schlick_airy",
    title="MaterialX thin film on Schlick's curve",
    reference="MaterialX 1.39.5, libraries/pbrlib/genglsl/lib/mx_microfacet_specular.glsl, "
    "mx_fresnel_airy with FRESNEL_MODEL_SCHLICK, after L. Belcour and P. Barla (2017), "
    "doi:10.1145/3072959.3073620",
    validity="The lower face has half of Schlick's curve for s and half for p, and the sum is halved "
    "again: any film, also of index 1, halves what a metal reflects. F0 counts as that of the film's "
    "face. The color is that of CIE RGB under equal energy, not of sRGB.",
    function=coated,
    sensitivity=gaussian_xyz,
    to_rgb=TO_RGB,
    floor=0.0,
    ceiling=1.0,
    measured=(
        Deviation(
            film_n=1.33, n_t=1.5, k_t=0.0, max_abs=0.0490, max_delta_e=10.64, mean_delta_e=4.834
        ),
        Deviation(
            film_n=2.4, n_t=1.5, k_t=0.0, max_abs=0.0713, max_delta_e=14.45, mean_delta_e=5.520
        ),
        Deviation(
            film_n=1.38, n_t=4.0, k_t=0.03, max_abs=0.1242, max_delta_e=12.80, mean_delta_e=5.746
        ),
        Deviation(
            film_n=1.5, n_t=1.0, k_t=6.6, max_abs=0.5310, max_delta_e=21.80, mean_delta_e=14.505
        ),
    ),
)
