r"""Colors of films over thickness and angle, from the whole spectrum.

The thickness of one layer varies, all else does not: at each wavelength and angle the amplitude of
reflection is a fraction whose numerator and denominator are linear in cos(delta) and sin(delta) of that
layer (`app.optics.transfer.pencils`), so a color costs a few operations a wavelength, whatever the
number of layers. Divided by cos(delta) they are polynomials in the tangent; where the layer absorbs,
the fraction is taken in exp(2 i delta).

A color is an integral over R of the spectrum. Where fringes are wide R is evaluated at every second or
fifth nanometer, and the weights are those of the cubic spline through the values.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from app.optics.color import WAVELENGTH_NM
from app.optics.films import power, reflectances, whole_group
from app.optics.incidence import Incidence
from app.optics.numerics.pairs import Pair
from app.optics.parameters import Array
from app.optics.stack import Layer, Stack
from app.optics.transfer import NOTHING, Pencil, pencils

STEPS_NM = (5, 2, 1)
SAMPLES_A_FRINGE = 10.0
"""Values of R that a fringe has at least at 400 nm, where there are enough wavelengths."""

UNRESOLVED = (
    "fringes are narrower than 4 nm: the color is that of 471 wavelengths; mark a thick layer as "
    "incoherent"
)

_VALUES = 8192
_SMALLEST_Q, _ROUNDING = 1e-8, 1e-9

Complex = NDArray[np.complex128]


def step_nm(optical_thickness_nm: float) -> int:
    """Distance of the wavelengths at which R is evaluated, for films of a total n d."""
    fringe = _fringe_nm(optical_thickness_nm)
    return next((step for step in STEPS_NM if SAMPLES_A_FRINGE * step <= fringe), STEPS_NM[-1])


def is_resolved(optical_thickness_nm: float) -> bool:
    """Whether the fringes of films of a total n d are seen at every nanometer."""
    return _fringe_nm(optical_thickness_nm) >= 4.0


def _fringe_nm(optical_thickness_nm: float) -> float:
    return 400.0**2 / (2.0 * max(optical_thickness_nm, 1e-9))


def sampled_nm(step: int) -> Array:
    """Wavelengths at which R is evaluated."""
    return WAVELENGTH_NM[::step]


@cache
def _spline(step: int) -> Array:
    """Matrix that takes values at `sampled_nm` to those at every nanometer."""
    at = sampled_nm(step)
    return np.asarray(CubicSpline(at, np.eye(at.size))(WAVELENGTH_NM))


def sampled_weights(weights: Array, step: int) -> Array:
    """Weights of the values at `sampled_nm(step)`, from those of every nanometer."""
    return weights if step == 1 else np.asarray(_spline(step).T @ weights)


def reflected_colors(stack: Stack, incidence: Incidence, weights: Array) -> Array:
    """Linear colors over the angle, shape (A, 3), by weights of the stack's wavelengths."""
    rows = Incidence(incidence.cos.reshape(-1, 1), incidence.sin.reshape(-1, 1))
    Rs, Rp = reflectances(stack, rows)
    return np.asarray(0.5 * (Rs + Rp) @ weights)


def swept_colors(
    stack: Stack,
    place: int,
    thickness_nm: Array,
    incidence: Incidence,
    weights: Array,
    step: int = 1,
) -> Array:
    """Linear colors over the thickness of one layer and the angle, not clamped.

    Parameters
    ----------
    stack
        Its arrays run over `sampled_nm(step)`.
    place
        Of the layer whose thickness varies, from 0 at the front.
    thickness_nm
        Thicknesses, shape (T,).
    incidence
        Directions, shape (A,).
    weights
        Of shape (471, 3): R @ weights is the color, as `app.optics.color.srgb_weights` returns them.
    step
        Distance of the wavelengths in nm.

    Returns
    -------
    Array
        Shape (T, A, 3).
    """
    weights = sampled_weights(weights, step)
    colors = np.empty((thickness_nm.size, incidence.cos.size, 3))
    rows = Incidence(incidence.cos.reshape(-1, 1), incidence.sin.reshape(-1, 1))
    if not stack.is_coherent:
        for i, thickness in enumerate(thickness_nm.tolist()):
            colors[i] = reflected_colors(
                _with_thickness(stack, place, thickness), incidence, weights
            )
        return colors
    group = whole_group(stack.sheets, rows)
    layer, *of_both = pencils(group, place, rows)
    shape = (rows.cos.size, weights.shape[0])
    a, b = (np.broadcast_to(part, shape) for part in layer.q)
    wave_number = np.broadcast_to(2.0 * np.pi * stack.n_i / stack.wavelength_nm, shape)
    transparent = not b.any() and bool(a.all())
    make = _in_tangent if transparent else _in_exponential
    prepared = [make(pencil, a + 1j * b, shape) for pencil in of_both]
    several = max(1, _VALUES // shape[1])
    for first in range(0, thickness_nm.size, several):
        some = slice(first, first + several)
        thick = thickness_nm[some, np.newaxis]
        for angle in range(shape[0]):
            k = wave_number[angle]
            grazes = incidence.cos.flat[angle] == 0.0
            t = np.tan(thick * (k * a[angle]))
            fractions = [p[angle] for p in prepared]
            if transparent:
                R = _of_tangent(t, fractions, grazes)
            else:
                u = np.exp(thick * (-2.0 * k * b[angle]))
                R = _of_exponential(t, u, fractions, grazes)
            colors[some, angle] = R @ weights
    return colors


def transmitted_colors(
    stack: Stack,
    place: int,
    thickness_nm: Array,
    incidence: Incidence,
    weights: Array,
    step: int = 1,
) -> Array:
    """Linear colors of the light that enters the second medium; parameters as of `swept_colors`."""
    weights = sampled_weights(weights, step)
    rows = Incidence(incidence.cos.reshape(-1, 1), incidence.sin.reshape(-1, 1))
    colors = np.empty((thickness_nm.size, incidence.cos.size, 3))
    for i, thickness in enumerate(thickness_nm.tolist()):
        T = power(_with_thickness(stack, place, thickness), rows).T
        colors[i] = np.broadcast_to(T, (rows.cos.size, weights.shape[0])) @ weights
    return colors


def _with_thickness(stack: Stack, place: int, thickness_nm: float) -> Stack:
    layers = list(stack.layers)
    old = layers[place]
    layers[place] = Layer(old.n, old.k, thickness_nm, incoherent=old.incoherent)
    substrate = stack.substrate
    at = stack.wavelength_nm
    return Stack(stack.n_i, layers, substrate.n_t, substrate.k_t, wavelength_nm=at)


def _complex(pair: Pair, shape: tuple[int, int]) -> Complex:
    return np.broadcast_to(np.asarray(pair[0]) + 1j * np.asarray(pair[1]), shape)


def _in_tangent(pencil: Pencil, q: Complex, shape: tuple[int, int]) -> Array:
    """Coefficients of 1, t and t^2 in numerator and denominator, shape (A, 6, wavelengths)."""
    D, D_sin, S, S_sin = (_complex(each, shape) for each in pencil)
    rows = []
    for even, odd in ((D, D_sin / q), (S, S_sin / q)):
        rows += [np.abs(even) ** 2, 2.0 * (even * odd.conj()).real, np.abs(odd) ** 2]
    return np.stack(rows, axis=1)


def _of_tangent(t: Array, coefficients: list[Array], grazes: bool) -> Array:
    """(Rs + Rp) / 2; grazing light that meets no boundary would be 0/0."""
    halves = []
    for n0, n1, n2, d0, d1, d2 in coefficients:
        over = t * n2
        over += n1
        over *= t
        over += n0
        under = t * d2
        under += d1
        under *= t
        under += d0
        if grazes:
            np.maximum(under, NOTHING, out=under)
        over /= under
        halves.append(over)
    total: Array = halves[0]
    total += halves[1]
    total *= 0.5
    return total


def _in_exponential(pencil: Pencil, q: Complex, shape: tuple[int, int]) -> Array:
    """|alpha|^2, |beta|^2, 2 Re and -2 Im of alpha* beta of both, shape (A, 8, wavelengths)."""
    D, D_sin, S, S_sin = (_complex(each, shape) for each in pencil)
    q = np.where(np.abs(q) < _SMALLEST_Q, _SMALLEST_Q, q)
    rows = []
    for even, odd in ((D, 1j * D_sin / q), (S, 1j * S_sin / q)):
        # cos = (1 + w)/2 and sin = (w - 1)/(2 i) with w = exp(2 i delta), but for exp(-i delta)
        alpha, beta = 0.5 * (even + odd), 0.5 * (even - odd)
        cross = 2.0 * alpha.conj() * beta
        rows += [np.abs(alpha) ** 2, np.abs(beta) ** 2, cross.real, -cross.imag]
    return np.stack(rows, axis=1)


def _of_exponential(t: Array, u: Array, coefficients: list[Array], grazes: bool) -> Array:
    """(Rs + Rp) / 2, from tan(Re delta) and |w|; grazing light as in `_of_tangent`."""
    t2 = t * t
    scale = u / (1.0 + t2)
    X, Y, u2 = (1.0 - t2) * scale, 2.0 * t * scale, u * u
    halves = []
    for n0, n1, n2, n3, d0, d1, d2, d3 in coefficients:
        under = d0 + d1 * u2 + d2 * X + d3 * Y
        if grazes:
            # Of this sum nothing but rounding may be left.
            under = np.maximum(under, _ROUNDING * (d0 + d1) + NOTHING)
        halves.append((n0 + n1 * u2 + n2 * X + n3 * Y) / under)
    return np.asarray(0.5 * (halves[0] + halves[1]))
