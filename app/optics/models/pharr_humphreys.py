"""The conductor formula of the first PBRT: q replaced by the complex index."""

import numpy as np

from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model


def pharr_humphreys_polarized(interface: Interface, incidence: Incidence) -> tuple[Array, Array]:
    """Rs and Rp for a wave that runs straight down into the metal."""
    mu, eta = incidence.cos, interface.eta
    t, twice, mu2 = eta * eta + interface.kappa**2, 2.0 * eta * mu, mu * mu
    Rs = (t - twice + mu2) / (t + twice + mu2)
    Rp = (t * mu2 - twice + 1.0) / (t * mu2 + twice + 1.0)
    return Rs, Rp


def pharr_humphreys(interface: Interface, incidence: Incidence) -> Array:
    """Half the sum of Rs and Rp for a wave that runs straight down into the metal."""
    Rs, Rp = pharr_humphreys_polarized(interface, incidence)
    return np.asarray(0.5 * (Rs + Rp))


MODEL = Model(
    id="pharr_humphreys",
    title="Pharr and Humphreys' conductor",
    applies_to=("conductor",),
    latex=r"R_s\approx\frac{t-2\eta\mu+\mu^2}{t+2\eta\mu+\mu^2},\quad "
    r"R_p\approx\frac{t\mu^2-2\eta\mu+1}{t\mu^2+2\eta\mu+1},\quad t=\eta^2+\kappa^2,\quad "
    r"R=\tfrac12(R_s+R_p)",
    reference="M. Pharr and G. Humphreys, Physically Based Rendering, 1st edition (2004), "
    "chapter 9; R. V. Dunkle (1963)",
    validity="Good where |N| is large against 1, as for most metals: it neglects the sine in Snell's "
    "law. Poor at k_t = 0; never meant for dielectrics.",
    cost=Cost(add=7, mul=4, div=2),
    function=pharr_humphreys,
    polarized=pharr_humphreys_polarized,
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.0043, at_deg=69.0, rms=0.00264),
        Measured(1, 2.9, 3, max_abs=0.00514, at_deg=82.8, rms=0.00294),
        Measured(1, 1.5, 5, max_abs=0.00465, at_deg=76.0, rms=0.00276),
    ),
)
