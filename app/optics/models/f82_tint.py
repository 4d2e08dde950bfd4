"""F82-tint: Hoffman's curve steered by the ratio to Schlick at 82 degrees."""

import numpy as np
from scipy.optimize.elementwise import find_root

from app.optics.models import (
    RGB,
    Array,
    Cost,
    Incidence,
    Interface,
    Measured,
    Model,
    share,
)
from app.optics.specular import (
    DIP_SCALE,
    F0_PARAMETER,
    F82,
    MU_BAR,
    dip,
    is_own,
    own_F0,
    polynomial,
    tint_at_82,
)

LARGEST_TINT = (1.0 - MU_BAR) ** -5
"""An F82 of 1 over Schlick's of F0 = 0: no interface has a tint above it."""

TINT = share(
    "tint",
    r"\text{tint}",
    "Reflectance at 82 degrees over Schlick's there; from the interface unless given, and 1 where an "
    f"F0 is given that is not the interface's.{RGB}",
    maximum=LARGEST_TINT,
    triple=True,
)


def f82_tint(interface: Interface, incidence: Incidence, F0: Array, tint: Array) -> Array:  # noqa: ARG001
    """S(mu) - mu (1 - mu)^6 / (mu_bar (1 - mu_bar)^6) S(mu_bar) (1 - tint), at least 0; S Schlick's."""
    depth = DIP_SCALE * polynomial(F0, MU_BAR) * (1.0 - tint)
    return np.maximum(polynomial(F0, incidence.cos) - depth * dip(incidence.cos), 0.0)


def _kinks(F0: Array, tint: Array) -> Array | None:
    """Cosines where each curve meets 0 and leaves it, NaN where it does neither."""
    # In g = 1 - mu the curve is F0 + (1 - F0) g^5 - depth (g^6 - g^7), which rises, falls and rises:
    # its slope is g^4 times a parabola.
    rise = np.asarray(1.0 - F0)
    depth = np.asarray(DIP_SCALE * polynomial(F0, MU_BAR) * (1.0 - tint))
    rise, depth = np.broadcast_arrays(*np.atleast_1d(rise, depth))
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(36.0 - 140.0 * rise / depth)
    top, bottom = (6.0 - root) / 14.0, (6.0 + root) / 14.0
    below = (depth > 0.0) & (_at(bottom, rise, depth) < 0.0)
    if not below.any():
        return None
    kinks = np.full((*below.shape, 2), np.nan)
    own = rise[below], depth[below]
    last = np.ones(own[0].shape)
    for which, ends in enumerate(((bottom[below], last), (top[below], bottom[below]))):
        kinks[below, which] = 1.0 - find_root(_at, ends, args=own).x
    return kinks


def _at(g: Array, rise: Array, depth: Array) -> Array:
    """The curve before it is cut at 0, of g = 1 - mu, 1 - F0 and the depth of the dip."""
    fifth = g**5
    return np.asarray(1.0 - rise + rise * fifth - depth * g * fifth * (1.0 - g))


def solved_tint(interface: Interface, F0: Array) -> Array:
    """Tint of the interface where F0 is its own, else none."""
    tint = tint_at_82(F0, F82(interface))
    return np.where(is_own(interface, F0), tint, 1.0)


MODEL = Model(
    id="f82_tint",
    title="F82-tint",
    applies_to=("conductor",),
    latex=r"R\approx\max\left(S(\mu)-\frac{\mu(1-\mu)^6}{\bar\mu(1-\bar\mu)^6}\,S(\bar\mu)\,"
    r"(1-\text{tint}),\,0\right),\quad S(\mu)=F_0+(1-F_0)(1-\mu)^5,\quad \bar\mu=\tfrac17",
    reference="P. Kutz, M. Hašan and D. Edmondson, Novel Aspects of the Adobe Standard Material "
    "(2021); OpenPBR Surface specification, metal",
    validity="Metals; the same curve as Hoffman's F82 when the tint is taken from it. A low tint "
    "beside a low F0 would take R below 0, where it is cut as the specification has it. Some metals "
    "have a tint above 1; beside a high F0 it takes R above 1.",
    cost=Cost(add=3, mul=7),
    function=f82_tint,
    parameters=(F0_PARAMETER, TINT),
    solve={"F0": own_F0, "tint": solved_tint},
    leaves_0_to_1=True,
    kinks=_kinks,
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.00841, at_deg=68.8, rms=0.00486),
        Measured(1, 2.9, 3, max_abs=0.0177, at_deg=87.1, rms=0.00685),
        Measured(1, 1.5, 5, max_abs=0.0114, at_deg=58.9, rms=0.00591),
    ),
)
