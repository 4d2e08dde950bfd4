r"""A pane: two faces with absorption between them, and the incidence-angle modifiers of solar energy.

A modifier is what a pane lets through at an angle, over what it lets through along the normal. The exact
one is T(theta) / T(0) of `app.optics.films` with an incoherent layer; those in use are one-parameter
curves, or count the front face alone.

References
----------
.. [1] A. F. Souka and H. H. Safwat, Determination of the optimum orientations for the double-exposure,
   flat-plate collector and its reflectors, Solar Energy 10 (1966) 170-174; ASHRAE Standard 93-77.
.. [2] N. Martin and J. M. Ruiz, Calculation of the PV modules angular losses under field conditions by
   means of an analytical model, Solar Energy Materials and Solar Cells 70 (2001) 25-38, equation 4.
.. [3] W. De Soto, S. A. Klein and W. A. Beckman, Improvement and validation of a model for
   photovoltaic array performance, Solar Energy 80 (2006) 78-88, equations 13 to 16.
.. [4] C. Schlick, An inexpensive BRDF model for physically-based rendering, Computer Graphics Forum 13
   (1994) 233-246; as a modifier Y. Xie et al., Solar Energy 238 (2022) 1-10.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from app.optics.amplitudes import Power, reflectance
from app.optics.films import Absorption, absorption, power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array, Parameter
from app.optics.stack import Layer, Stack

N_PANE = Parameter("n", "n", 1.526, 1.0, 4.0, "", "Index of the pane, real.")
THICKNESS_MM = Parameter("thickness_mm", "d", 2.0, 0.0, 100.0, "mm", "Thickness of the pane.")
ABSORPTION_PER_M = Parameter(
    "absorption_per_m",
    "K",
    4.0,
    0.0,
    1000.0,
    "1/m",
    "Absorption: along a path of one meter the power falls by exp(-K).",
)
N_BEHIND = Parameter(
    "n_behind", r"n_b", 1.0, 1.0, 4.0, "", "Index behind the pane: 1 in air, n on a cell."
)

# Absorption is given by the meter, so any wavelength will do whose k is far below 1.
_WAVELENGTH_NM = 1.0

Modifier = Callable[[Incidence, Mapping[str, float]], Array]


@dataclass(frozen=True, slots=True)
class Pane:
    """A pane in air, with something of another index behind it.

    Raises
    ------
    OutOfRange
        If a value is out of bounds.
    """

    n: float = 1.526
    thickness_mm: float = 2.0
    absorption_per_m: float = 4.0
    n_behind: float = 1.0

    def __post_init__(self) -> None:
        for parameter in (N_PANE, THICKNESS_MM, ABSORPTION_PER_M, N_BEHIND):
            parameter.check(getattr(self, parameter.name))

    @property
    def stack(self) -> Stack:
        """The pane as a stack of one incoherent layer."""
        k = 1e-9 * self.absorption_per_m * _WAVELENGTH_NM / (4.0 * np.pi)
        layer = Layer(self.n, k, 1e6 * self.thickness_mm, incoherent=True)
        return Stack(1.0, [layer], self.n_behind, wavelength_nm=_WAVELENGTH_NM)

    def parts(self, incidence: Incidence) -> tuple[Power, Absorption]:
        """R, T and A over the angle."""
        return power(self.stack, incidence), absorption(self.stack, incidence)

    def modifier(self, incidence: Incidence) -> Array:
        """T(theta) / T(0), exact."""
        normal = power(self.stack, Incidence.from_degrees(0.0)).T
        return np.asarray(power(self.stack, incidence).T / normal)


def ashrae(incidence: Incidence, given: Mapping[str, float]) -> Array:
    """1 - b (1 / cos(theta) - 1), 0 where that is less and at 90 degrees [1]_."""
    grazes = incidence.cos == 0.0
    cos = np.where(grazes, 1.0, incidence.cos)
    return np.where(grazes, 0.0, np.maximum(1.0 - given["b"] * (1.0 / cos - 1.0), 0.0))


def martin_ruiz(incidence: Incidence, given: Mapping[str, float]) -> Array:
    """(1 - exp(-cos(theta) / a_r)) / (1 - exp(-1 / a_r)) [2]_."""
    a_r = given["a_r"]
    return np.asarray(np.expm1(-incidence.cos / a_r) / np.expm1(-1.0 / a_r))


def physical(incidence: Incidence, given: Mapping[str, float]) -> Array:
    """(1 - R) exp(-K L / cos(theta_t)) over its value along the normal: one face, one passage [3]_."""
    n, path = given["n"], 1e-3 * given["absorption_per_m"] * given["thickness_mm"]
    face = Interface(1.0, n)

    def through(at: Incidence) -> Array:
        cos_t = np.sqrt(1.0 - (at.sin / n) ** 2)
        with np.errstate(divide="ignore", invalid="ignore"):
            absorbed = np.where(cos_t > 0.0, np.exp(-path / cos_t), 0.0)
        return np.asarray((1.0 - reflectance(face, at)) * absorbed)

    return np.asarray(through(incidence) / through(Incidence.from_degrees(0.0)))


def schlick(incidence: Incidence, given: Mapping[str, float]) -> Array:  # noqa: ARG001
    """1 - (1 - cos(theta))^5: what Schlick's R leaves, over what it leaves at 0 [4]_."""
    return np.asarray(1.0 - (1.0 - incidence.cos) ** 5)


@dataclass(frozen=True, slots=True)
class KnownModifier:
    """A modifier in use."""

    id: str
    title: str
    latex: str
    reference: str
    parameters: tuple[Parameter, ...]
    """Its own; `physical` takes the pane's as well."""
    function: Modifier


ASHRAE_B = Parameter("b", "b", 0.05, 0.0, 1.0, "", "Coefficient of the ASHRAE modifier.")
MARTIN_RUIZ_A_R = Parameter(
    "a_r", "a_r", 0.16, 0.01, 1.0, "", "Angular loss coefficient of Martin and Ruiz."
)

MODIFIERS = (
    KnownModifier(
        "ashrae",
        "ASHRAE",
        r"1 - b\left(\frac{1}{\cos\theta} - 1\right)",
        "A. F. Souka and H. H. Safwat, Solar Energy 10 (1966) 170; ASHRAE Standard 93-77",
        (ASHRAE_B,),
        ashrae,
    ),
    KnownModifier(
        "martin_ruiz",
        "Martin and Ruiz",
        r"\frac{1 - e^{-\cos\theta/a_r}}{1 - e^{-1/a_r}}",
        "N. Martin and J. M. Ruiz, Sol. Energy Mater. Sol. Cells 70 (2001) 25, equation 4",
        (MARTIN_RUIZ_A_R,),
        martin_ruiz,
    ),
    KnownModifier(
        "physical",
        "Physical (De Soto)",
        r"\frac{(1 - R(\theta))\, e^{-KL/\cos\theta_t}}{(1 - R(0))\, e^{-KL}}",
        "W. De Soto, S. A. Klein and W. A. Beckman, Solar Energy 80 (2006) 78, equations 13 to 16",
        (),
        physical,
    ),
    KnownModifier(
        "schlick",
        "Schlick",
        r"1 - (1 - \cos\theta)^5",
        "C. Schlick, Computer Graphics Forum 13 (1994) 233; Y. Xie et al., Solar Energy 238 (2022) 1",
        (),
        schlick,
    ),
)
