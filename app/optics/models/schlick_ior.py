"""Schlick's polynomial written with the indices, as Lazanyi's paper and Lagarde's memo have it."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import fifth_power, no_critical_angle


def schlick_ior(interface: Interface, incidence: Incidence) -> Array:
    """R from n_i, n_t and k_t without F0; the same numbers as Schlick's form."""
    n_i, n_t, k2 = interface.n_i, interface.n_t, interface.k_t**2
    rise = 4.0 * n_t * n_i * fifth_power(incidence.cos)
    return np.asarray(((n_t - n_i) ** 2 + rise + k2) / ((n_t + n_i) ** 2 + k2))


MODEL = Model(
    id="schlick_ior",
    title="Schlick from the index",
    latex=r"R\approx\frac{(n_t-n_i)^2+4n_tn_i(1-\mu)^5+k_t^2}{(n_t+n_i)^2+k_t^2}",
    reference="I. Lazányi and L. Szirmay-Kalos, Fresnel Term Approximations for Metals, WSCG 2005; "
    "S. Lagarde, Memo on Fresnel equations (2013)",
    validity="Identical to Schlick: from the thinner side (n_t > n_i), and without the dip of metals "
    "before grazing incidence.",
    cost=Cost(add=2, mul=4),
    function=schlick_ior,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.5, 0, max_abs=0.0357, at_deg=85.0, rms=0.0163),
        Measured(1, 0.27, 2.9, max_abs=0.0182, at_deg=76.3, rms=0.0101),
        Measured(1, 2.9, 3, max_abs=0.175, at_deg=83.0, rms=0.0828),
    ),
)
