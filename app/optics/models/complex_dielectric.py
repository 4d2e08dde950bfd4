"""The dielectric formula fed with a complex index: a misunderstood form."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model


def complex_dielectric(interface: Interface, incidence: Incidence) -> Array:
    """|evalF(g, c)| with complex g = sqrt(N^2 - 1 + c^2): squares where moduli belong."""
    c = incidence.cos
    index = interface.eta + 1j * interface.kappa
    g = np.sqrt(index * index - 1.0 + c * c)
    ratio = (c * (g + c) - 1.0) / (c * (g - c) + 1.0)
    F = 0.5 * ((g - c) / (g + c)) ** 2 * (1.0 + ratio * ratio)
    return np.asarray(np.abs(F))


MODEL = Model(
    id="complex_dielectric",
    title="Dielectric formula with a complex index (trap)",
    trap=True,
    applies_to=("conductor",),
    latex=r"R\approx\left|\tfrac12\,\frac{(g-c)^2}{(g+c)^2}"
    r"\left(1+\frac{(c(g+c)-1)^2}{(c(g-c)+1)^2}\right)\right|,\quad g=\sqrt{N^2-1+c^2},\quad "
    r"c=\cos\theta_i",
    reference="E. d'Eon, Fresnel Boundaries, notebook to A Hitchhiker's Guide to Multiple Scattering "
    "(2019), misunderstood form",
    validity="Nowhere: it adds r_s^2 and r_p^2 as complex numbers, which cancel, before taking the "
    "modulus. Right at normal and at grazing incidence, where the two agree.",
    cost=Cost(add=24, mul=37, div=2, sqrt=4),
    function=complex_dielectric,
    snippet="a trap made of complex numbers, which shading languages lack; take exact",
    limits=lambda _: "a misunderstanding: the squares of complex amplitudes are not powers",
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.819, at_deg=72.7, rms=0.377),
        Measured(1, 2.9, 3, max_abs=0.168, at_deg=77.6, rms=0.0847),
        Measured(1, 1.5, 5, max_abs=0.544, at_deg=79.6, rms=0.233),
    ),
)
