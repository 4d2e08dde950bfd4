"""What the models of Schlick's family share: F0, F82, their polynomial and their common limit."""

from collections.abc import Callable, Mapping

import numpy as np

from app.optics.amplitudes import reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface, normal_reflectance, worked_out_once
from app.optics.numerics.choice import anywhere
from app.optics.parameters import RGB, UNLESS_GIVEN, Array, Condition, Number, share

MU_BAR = 1.0 / 7.0
"""Cosine at which F82 is taken, about 81.8 degrees (Hoffman 2019; Kutz et al. 2021)."""

_AT_82 = Incidence.from_cosine(MU_BAR)

F0_PARAMETER = share(
    "F0", "F_0", f"Reflectance at normal incidence, linear; {UNLESS_GIVEN}.{RGB}", triple=True
)
F82_PARAMETER = share(
    "F82",
    r"F_{82}",
    f"Reflectance at cos(theta_i) = 1/7, about 82 degrees, linear; {UNLESS_GIVEN}, and Schlick's "
    f"where an F0 is given that is not the interface's.{RGB}",
    triple=True,
)

DIP_SCALE = 1.0 / (MU_BAR * (1.0 - MU_BAR) ** 6)
"""1 / (mu (1 - mu)^6) at mu = 1/7: 17.6513846 in Hoffman's slides."""


@worked_out_once
def F82(interface: Interface) -> Array:
    """Exact reflectance at cos(theta_i) = 1/7."""
    return reflectance(interface, _AT_82)


def tint_at_82(F0: Number, F82: Number) -> Array:
    """Tint of the F82-tint model, F82 / S(1/7), S(mu) = F0 + (1 - F0)(1 - mu)^5.

    It is above 1 beyond the critical angle and for some metals.

    References
    ----------
    .. [1] P. Kutz, M. Hašan, D. Edmondson, Novel Aspects of the Adobe Standard Material (2021).
    """
    return np.asarray(F82 / polynomial(F0, MU_BAR))


def fifth_power(mu: Number) -> Number:
    """(1 - mu)^5 by three multiplications, as shaders write it."""
    g = 1.0 - mu
    g2 = g * g
    return g2 * g2 * g


def polynomial(normal: Number, mu: Number) -> Array:
    """Schlick's F0 + (1 - F0)(1 - mu)^5."""
    return np.asarray(normal + (1.0 - normal) * fifth_power(mu))


def exponential(normal: Number, mu: Number) -> Array:
    """The same with 2^((-5.55473 mu - 6.98316) mu) in place of the fifth power."""
    return np.asarray(normal + (1.0 - normal) * np.exp2((-5.55473 * mu - 6.98316) * mu))


def dip(mu: Array) -> Array:
    """Hoffman's dip mu (1 - mu)^6, largest at mu = 1/7."""
    g = 1.0 - mu
    g2 = g * g
    return np.asarray(mu * (g2 * g2 * g2))


def own_F0(interface: Interface) -> Array:
    """F0 of the interface, where none is given."""
    return interface.F0


SOLVE_F0: Mapping[str, Callable[..., Array]] = {"F0": own_F0}
"""How models that ask for F0 alone find it."""


def is_own(interface: Interface, F0: Array) -> Condition:
    """Where an F0 is the interface's but for rounding.

    What else is known of the interface, as its F82, belongs to its own F0 and to no other.
    """
    own = normal_reflectance(interface.n_i, interface.n_t, interface.k_t)
    return np.abs(F0 - own) <= 1e-9 * own


def no_critical_angle(interface: Interface) -> str | None:
    """Why a curve from F0 alone is wrong on the denser side, or None on the thinner."""
    if not interface.is_conductor and anywhere(interface.relative[0] < 1.0):
        return "n_t < n_i: a curve made from F0 knows no critical angle"
    return None
