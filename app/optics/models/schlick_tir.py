"""Schlick's polynomial made aware of total internal reflection."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model
from app.optics.specular import polynomial


def schlick_tir(interface: Interface, incidence: Incidence) -> Array:
    """Schlick with cos(theta_t) where n_i > n_t, and 1 beyond the critical angle.

    NaN from the denser side of an absorber, which has no critical angle.
    """
    eta, s = interface.eta, incidence.sin
    # The product keeps the digits that 1 - sin^2 / eta^2 would lose near the critical angle.
    cos2_t = (eta - s) * (eta + s) / (eta * eta)
    dense = interface.n_i > interface.n_t
    mu = np.where(dense, np.sqrt(np.maximum(cos2_t, 0.0)), incidence.cos)
    R = np.where(dense & (cos2_t < 0.0), 1.0, polynomial(interface.F0, mu))
    return np.where(dense & (interface.k_t > 0.0), np.nan, R)


def schlick_tir_real(mu: Array, eta: Array, F0: Array) -> Array:
    """The same for dielectrics, from eta alone."""
    sin2 = (1.0 - mu) * (1.0 + mu)
    cos2_t = 1.0 - sin2 / (eta * eta)
    cosine = np.where(eta < 1.0, np.sqrt(np.maximum(cos2_t, 0.0)), mu)
    return np.where(cos2_t < 0.0, 1.0, polynomial(F0, cosine))


MODEL = Model(
    id="schlick_tir",
    title="Schlick with total internal reflection",
    applies_to=("dielectric",),
    latex=r"R\approx F_0+(1-F_0)(1-\mu')^5,\quad \mu'=\begin{cases}\cos\theta_i & n_i\le n_t\\"
    r"\cos\theta_t=\sqrt{1-\sin^2\theta_i/\eta^2} & n_i>n_t\end{cases},\quad "
    r"R=1\ \text{for}\ \sin\theta_i>\eta",
    reference="S. Lagarde, Memo on Fresnel equations (2013), FresnelSchlickTIR",
    validity="Dielectrics from both sides; from the denser side as good as Schlick is from the "
    "thinner, because both see the same pair of angles.",
    cost=Cost(add=4, mul=6, sqrt=1),
    function=schlick_tir,
    snippet=schlick_tir_real,
    measured=(
        Measured(1, 1.333, 0, max_abs=0.0592, at_deg=83.8, rms=0.0246),
        Measured(1, 1.5, 0, max_abs=0.0357, at_deg=85.0, rms=0.0163),
        Measured(1.333, 1, 0, max_abs=0.0592, at_deg=48.2, rms=0.00863),
        Measured(1.5, 1, 0, max_abs=0.0357, at_deg=41.6, rms=0.00616),
    ),
)
