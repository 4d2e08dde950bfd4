"""F82-tint: Hoffman's curve steered by the ratio to Schlick at 82 degrees."""

from collections.abc import Mapping

import numpy as np

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
from app.optics.specular import DIP_SCALE, F0_PARAMETER, F82, MU_BAR, dip, polynomial, tint_at_82

TINT = share(
    "tint",
    r"\text{tint}",
    f"Reflectance at 82 degrees over Schlick's there; from the interface unless given.{RGB}",
    triple=True,
)


def f82_tint(interface: Interface, incidence: Incidence, F0: Array, tint: Array) -> Array:  # noqa: ARG001
    """S(mu) - mu (1 - mu)^6 / (mu_bar (1 - mu_bar)^6) S(mu_bar) (1 - tint), S Schlick's curve."""
    depth = DIP_SCALE * polynomial(F0, MU_BAR) * (1.0 - tint)
    return np.asarray(polynomial(F0, incidence.cos) - depth * dip(incidence.cos))


def _solve(interface: Interface, **_: Array | None) -> Mapping[str, Array]:
    return {"F0": interface.F0, "tint": tint_at_82(interface.F0, F82(interface))}


MODEL = Model(
    id="f82_tint",
    title="F82-tint",
    applies_to=("conductor",),
    latex=r"R\approx S(\mu)-\frac{\mu(1-\mu)^6}{\bar\mu(1-\bar\mu)^6}\,S(\bar\mu)\,"
    r"(1-\text{tint}),\quad S(\mu)=F_0+(1-F_0)(1-\mu)^5,\quad \bar\mu=\tfrac17",
    reference="P. Kutz, M. Hašan and D. Edmondson, Novel Aspects of the Adobe Standard Material "
    "(2021); OpenPBR Surface specification, metal",
    validity="Metals; the same curve as Hoffman's F82 when the tint is taken from it. A low tint "
    "beside a low F0 takes R below 0.",
    cost=Cost(add=3, mul=7),
    function=f82_tint,
    parameters=(F0_PARAMETER, TINT),
    solve=_solve,
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.00841, at_deg=68.8, rms=0.00486),
        Measured(1, 2.9, 3, max_abs=0.0177, at_deg=87.1, rms=0.00685),
        Measured(1, 1.5, 5, max_abs=0.0114, at_deg=58.9, rms=0.00591),
    ),
)
