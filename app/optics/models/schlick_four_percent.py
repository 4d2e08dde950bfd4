"""Schlick with F0 = 0.04 whatever the material: the trap of the fixed default."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import polynomial


def schlick_four_percent(interface: Interface, incidence: Incidence) -> Array:  # noqa: ARG001
    """Schlick with F0 = 0.04, the value of n = 1.5 in air."""
    return polynomial(np.asarray(0.04), incidence.cos)


def _wrong_material(interface: Interface) -> str:
    if np.isclose(interface.F0, 0.04, rtol=1e-6, atol=0.0).all():
        return "a trap that does not show here, where F0 happens to be 0.04"
    return "a trap: F0 is 0.04 for n_t/n_i = 1.5 alone"


MODEL = Model(
    id="schlick_four_percent",
    title="Schlick with F0 of 4 % for everything (trap)",
    trap=True,
    latex=r"R\approx 0.04+0.96\,(1-\mu)^5",
    reference="Khronos Group, glTF 2.0 Specification (2021), appendix B: metallic-roughness materials",
    validity="Right for n_t = 1.5 in air alone; water has half of it, diamond four times as much.",
    cost=Cost(add=2, mul=4),
    function=schlick_four_percent,
    limits=_wrong_material,
    measured=(
        Measured(1, 1.333, 0, max_abs=0.068, at_deg=83.2, rms=0.0325),
        Measured(1, 2.417, 0, max_abs=0.143, at_deg=55.5, rms=0.115),
        Measured(1, 0.27, 2.9, max_abs=0.852, at_deg=0.0, rms=0.735),
    ),
)
