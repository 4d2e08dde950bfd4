"""1 - cos(theta_i), the crudest curve that rises toward grazing incidence."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import no_critical_angle


def one_minus_cos(interface: Interface, incidence: Incidence) -> Array:  # noqa: ARG001
    """1 - mu, the same for every material."""
    return np.asarray(1.0 - incidence.cos)


MODEL = Model(
    id="one_minus_cos",
    title="1 - cos",
    applies_to=("dielectric",),
    latex=r"R\approx 1-\mu",
    reference="M. Wloka, Fresnel Reflection, NVIDIA technical report (2002), figures 4 and 15",
    validity="Right at grazing incidence alone; it knows neither F0 nor the index. Wloka calls it "
    "visually unacceptable.",
    cost=Cost(add=1),
    function=one_minus_cos,
    limits=no_critical_angle,
    measured=(
        Measured(1, 1.333, 0, max_abs=0.532, at_deg=73.1, rms=0.368),
        Measured(1, 1.5, 0, max_abs=0.492, at_deg=72.8, rms=0.34),
        Measured(1, 2.417, 0, max_abs=0.411, at_deg=75.9, rms=0.267),
    ),
)
