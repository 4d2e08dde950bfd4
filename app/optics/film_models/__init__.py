r"""Shortcuts of renderers for one film on a surface, each with what it does differently.

All sum Airy's series over the orders m of what goes to and fro in the film, by powers:

.. math::
    R = R_{12} + R_s + 2 \sum_{m \ge 1} C_m S(m D, m \varphi), \quad
    R_s = \frac{T^2 R_{23}}{1 - R_{12} R_{23}}, \quad
    C_m = (R_s - T) (R_{12} R_{23})^{m/2}, \quad T = 1 - R_{12}

with the path difference D = 2 n d cos(theta) in the film and the phase of both reflections. S is what a
sensor makes of a fringe: cos(2 pi D / lambda + phase) at one wavelength, the Fourier transform of its
sensitivities for a color. They differ in R12, R23, the phases, the number of orders and S.

References
----------
.. [1] L. Belcour and P. Barla, A Practical Extension to Microfacet Theory for the Modeling of Varying
   Iridescence, ACM Trans. Graph. 36(4) (2017), equations 9 and 10. doi:10.1145/3072959.3073620
"""

import importlib
import pkgutil
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from app.optics.collection import Collection
from app.optics.edge_tint import eta_max
from app.optics.errors import UnknownModel
from app.optics.parameters import Array

SMALLEST_COS = 1e-6

Sensitivity = Callable[[Array, Array], Array]
"""S(D, phase) of path differences in nm and phases in radians; the last axis runs over channels."""


@dataclass(frozen=True, slots=True, eq=False)
class CoatedSurface:
    """One film on a surface in air; all broadcast, the last axis over channels or wavelengths."""

    thickness_nm: Array
    cos: Array
    """Of the angle of incidence."""
    film_n: Array
    n: Array
    k: Array
    """Index of the surface."""
    F0: Array
    """What the surface reflects without the film at normal incidence."""
    F82: Array
    """The same at cos(theta_i) = 1/7."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Deviation:
    """Measured against the spectral truth over a film, as a test measures again."""

    film_n: float
    n_t: float
    k_t: float
    """A film of film_n on a surface of n_t + i k_t, in air."""
    max_abs: float
    """Largest |R - exact| at 450, 550 and 650 nm."""
    max_delta_e: float
    """Largest CIEDE2000 of the color in daylight; all over 0 to 1000 nm and 0 to 85 degrees, by 5."""
    mean_delta_e: float


@dataclass(frozen=True, slots=True, kw_only=True)
class FilmModel:
    """A shortcut for one film, as a renderer evaluates it."""

    id: str
    title: str
    reference: str
    """Where its source is to be read."""
    validity: str
    """What it leaves out, in words."""
    function: Callable[[CoatedSurface, Sensitivity], Array]
    """R of the surface with its film, by a sensitivity."""
    sensitivity: Sensitivity
    """S of red, green and blue, or of X, Y and Z."""
    to_rgb: Array | None = None
    """Matrix from what `function` gives with `sensitivity` to linear RGB, where that is not it."""
    floor: float | None = None
    ceiling: float | None = None
    """What its colors are cut to."""
    measured: tuple[Deviation, ...] = ()

    def color(self, surface: CoatedSurface) -> Array:
        """Linear RGB, an axis of three in the end."""
        rgb = self.function(_lit(surface), self.sensitivity)
        if self.to_rgb is not None:
            rgb = rgb @ self.to_rgb.T
        return np.asarray(np.clip(rgb, self.floor, self.ceiling))

    def reflectance(self, surface: CoatedSurface, wavelength_nm: Array) -> Array:
        """R at single wavelengths, the last axis."""
        return np.asarray(self.function(_lit(surface), monochromatic(wavelength_nm)))


def _lit(surface: CoatedSurface) -> CoatedSurface:
    """At 90 degrees, where a film of index 1 is 0/0, the limit; MaterialX cuts cosines at this value."""
    return replace(surface, cos=np.maximum(surface.cos, SMALLEST_COS))


def monochromatic(wavelength_nm: Array) -> Sensitivity:
    """S of a sensor that sees single wavelengths."""

    def at(difference: Array, phase: Array) -> Array:
        return np.asarray(np.cos(2.0 * np.pi * difference / wavelength_nm + phase))

    return at


def gaussian_xyz(difference: Array, phase: Array) -> Array:
    """S of X, Y and Z as a sum of Gaussians over the wave number [1]_."""
    turn = 2.0 * np.pi * difference * 1e-9
    value = np.array([5.4856e-13, 4.4201e-13, 5.2481e-13])
    place = np.array([1.6810e6, 1.7953e6, 2.2084e6])
    width = np.array([4.3278e9, 9.3046e9, 6.6121e9])
    xyz = (
        value
        * np.sqrt(2.0 * np.pi * width)
        * np.cos(place * turn + phase)
        * np.exp(-width * turn * turn)
    )
    second = 9.7470e-14 * np.sqrt(2.0 * np.pi * 4.5282e9)
    lobe = second * np.cos(2.2399e6 * turn + phase[..., :1]) * np.exp(-4.5282e9 * turn * turn)
    xyz[..., :1] += lobe[..., :1]
    return np.asarray(xyz / 1.0685e-7)


def airy(
    R12: Array,
    R23: Array,
    phase: Array,
    difference: Array,
    sensitivity: Sensitivity,
    orders: int,
    product: tuple[float, float] = (0.0, 1.0 - 1e-15),
) -> Array:
    """Airy's series, cut after some orders; R12 R23 is first cut to `product`."""
    both = np.clip(R12 * R23, *product)
    through = 1.0 - R12
    twice = through * through * R23 / (1.0 - both)
    total = R12 + twice
    C = twice - through
    for m in range(1, orders + 1):
        C = C * np.sqrt(both)
        total = total + 2.0 * C * sensitivity(m * difference, m * phase)
    return np.asarray(total)


def inside(surface: CoatedSurface, film_n: Array) -> tuple[Array, Array]:
    """Cosine of the angle in a film, 0 where no light enters, and where that is."""
    cos2 = 1.0 - (1.0 - surface.cos * surface.cos) / (film_n * film_n)
    return np.asarray(np.sqrt(np.maximum(cos2, 0.0))), np.asarray(cos2 < 0.0)


def faded(surface: CoatedSurface, whole_at_nm: float) -> Array:
    """Index of the film, going smoothly to 1 as the thickness goes from `whole_at_nm` to 0."""
    share = np.clip(surface.thickness_nm / whole_at_nm, 0.0, 1.0)
    return np.asarray(1.0 + (surface.film_n - 1.0) * share * share * (3.0 - 2.0 * share))


def index_of(F0: Array) -> Array:
    """The real index above 1 that reflects F0 in air."""
    return eta_max(np.clip(F0, 0.0, 0.9999))


class FilmModels(Collection[FilmModel]):
    """All shortcuts, by their ids."""

    def __init__(self, items: Iterable[FilmModel]) -> None:
        super().__init__(items, UnknownModel, "models")


@cache
def film_models() -> FilmModels:
    """Every shortcut of this package."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return FilmModels(importlib.import_module(f"{__name__}.{name}").MODEL for name in names)
