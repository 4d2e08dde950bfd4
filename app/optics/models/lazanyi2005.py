"""Lazanyi and Szirmay-Kalos: Schlick with a term for the dip of metals."""

import numpy as np
from numpy.typing import NDArray
from scipy.optimize.elementwise import find_root

from app.optics.amplitudes import amplitudes, wave
from app.optics.interface import normal_reflectance
from app.optics.models import Array, Cost, Incidence, Interface, Measured, Model, Parameter
from app.optics.models.exact import exact_real
from app.optics.models.lagarde_conductor import lagarde_conductor
from app.optics.models.schlick_ior import schlick_ior
from app.optics.registry import Peak
from app.optics.specular import polynomial

ALPHA = Parameter(
    "alpha",
    r"\alpha",
    None,
    0.01,
    1000.0,
    "",
    "Exponent of the dip; unless given it is solved so that the term meets Schlick's largest error.",
)
A = Parameter("a", "a", None, 0.0, 200.0, "", "Depth of the dip; 2 n_t/n_i unless given.")

# Dense toward grazing incidence, where the dip of a metal with a large index lies.
_SCAN = np.geomspace(1e-4, 0.98, 40)


def lazanyi2005(interface: Interface, incidence: Incidence, a: Array, alpha: Array) -> Array:
    """Schlick - a mu (1 - mu)^alpha; the term is not divided by Schlick's denominator."""
    mu = incidence.cos
    return np.asarray(schlick_ior(interface, incidence) - a * mu * (1.0 - mu) ** alpha)


def slope(interface: Interface, incidence: Incidence) -> Array:
    r"""Derivative of the exact R by mu.

    From r_s' = -2 r_s / q and r_p' = 2 N^2 (N^2 - 1) / (q (N^2 mu + q)^2), N relative.
    """
    r, w = amplitudes(interface, incidence), wave(interface, incidence)
    q, square = w.a + 1j * w.b, (interface.eta + 1j * interface.kappa) ** 2
    s = np.conj(r.r_s) * -2.0 * r.r_s / q
    p = np.conj(r.r_p) * 2.0 * square * (square - 1.0) / (q * (square * incidence.cos + q) ** 2)
    return np.asarray((s + p).real)


def largest_error_cosine(interface: Interface) -> Array:
    """Cosine at which Schlick exceeds the exact R most, of the interface's shape."""
    best = _scan(interface)
    media = [np.broadcast_to(m, best.shape) for m in _media(interface)]

    def rise(mu: Array, n_i: Array, n_t: Array, k_t: Array) -> Array:
        here, incidence = Interface(n_i, n_t, k_t), Incidence.from_cosine(mu)
        g = 1.0 - mu
        return np.asarray(-5.0 * (1.0 - here.F0) * (g * g) ** 2 - slope(here, incidence))

    root = find_root(
        rise,
        (_SCAN[best - 1], _SCAN[best + 1]),
        args=tuple(media),
        tolerances={"xatol": 1e-15, "xrtol": 1e-14},
    )
    return np.where(root.success, root.x, _SCAN[best])


def _scan(interface: Interface) -> NDArray[np.intp]:
    """Index of the scanned cosine, not the first or the last, with Schlick's largest error."""
    scanned = Incidence.from_cosine(_SCAN)
    columns = Interface(*(m[..., np.newaxis] for m in _media(interface)))
    error = schlick_ior(columns, scanned) - lagarde_conductor(columns, scanned)
    return np.asarray(np.clip(np.argmax(error, axis=-1), 1, _SCAN.size - 2))


def solve_alpha(interface: Interface, a: Array) -> Array:
    """Alpha by Lagarde's solver: the term a mu (1 - mu)^alpha equals Schlick's largest error.

    Returns
    -------
    Array
        Of the broadcast shape; NaN where Schlick exceeds the exact R nowhere, or by more than the
        term can with a positive alpha.
    """
    return alpha_at(largest_error_cosine(interface), *_media(interface), a)


def excess(mu: Array, n_i: Array, n_t: Array, k_t: Array) -> Array:
    """How far Schlick exceeds the exact R at the cosine mu."""
    F0 = normal_reflectance(n_i, n_t, k_t)
    return polynomial(F0, mu) - exact_real(mu, n_t / n_i, k_t / n_i)


def alpha_at(mu: Array, n_i: Array, n_t: Array, k_t: Array, a: Array) -> Array:
    """Alpha with which the term equals Schlick's error at the cosine mu, or NaN."""
    error = excess(mu, n_i, n_t, k_t)
    reach = np.maximum(a * mu, 1e-300)
    ratio = np.where((error > 0.0) & (error < reach), error / reach, np.nan)
    return np.log(ratio) / np.log(1.0 - mu)


def _media(interface: Interface) -> tuple[Array, Array, Array]:
    return interface.n_i, interface.n_t, interface.k_t


def solved_a(interface: Interface) -> Array:
    """Depth of the dip where none is given."""
    return np.asarray(2.0 * interface.eta)


def _outside(interface: Interface) -> str | None:
    # The scan tells as well as the solved angle whether there is an alpha at all.
    alpha = alpha_at(_SCAN[_scan(interface)], *_media(interface), 2.0 * interface.eta)
    if bool(np.any(np.isnan(alpha))):
        return "no positive alpha brings the term to Schlick's largest error"
    return None


MODEL = Model(
    id="lazanyi2005",
    title="Lazanyi and Szirmay-Kalos",
    applies_to=("conductor",),
    latex=r"R\approx\frac{(n_t-n_i)^2+4n_tn_i(1-\mu)^5+k_t^2}{(n_t+n_i)^2+k_t^2}"
    r"-a\,\mu(1-\mu)^\alpha,\quad a=2\,\frac{n_t}{n_i}",
    reference="I. Lazányi and L. Szirmay-Kalos, Fresnel Term Approximations for Metals, WSCG 2005; "
    "alpha as solved in S. Lagarde, Memo on Fresnel equations (2013)",
    validity="Metals with a dip. Alpha has to be found for every index, and meeting the largest error "
    "at one angle does not make the error least: nearer the normal much of Schlick's error remains.",
    cost=Cost(add=3, mul=6, pow=1),
    function=lazanyi2005,
    parameters=(A, ALPHA),
    solve={"a": solved_a, "alpha": solve_alpha},
    peaks={"alpha": Peak(_SCAN, excess, alpha_at)},
    leaves_0_to_1=True,
    limits=_outside,
    measured=(
        Measured(1, 0.27, 2.9, max_abs=0.0148, at_deg=85.5, rms=0.0064),
        Measured(1, 2.9, 3, max_abs=0.0626, at_deg=73.3, rms=0.032),
        Measured(1, 1.5, 5, max_abs=0.0285, at_deg=68.2, rms=0.0158),
    ),
)
