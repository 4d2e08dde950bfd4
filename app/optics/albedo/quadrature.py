r"""Integration over the hemisphere that resolves every corner of Fresnel's equations.

Reflectance is analytic in the angle but for a few points of the complex plane: the branch point
sin(theta) = N, the zeros of N^2 cos(theta) + q at sin^2(theta) = N^2 / (1 + N^2), and their images.
Where they approach the real axis a plain rule fails: the critical angle for kappa -> 0, grazing
incidence for N -> 1 and for large |N|. So the hemisphere is cut at the critical angle, each piece is
measured by an angle phi that removes the square root there, and

.. math:: \phi = a \sinh v

with `a` the distance of the nearest such point spreads every scale from `a` up evenly over v, where
Gauss-Legendre's rule converges geometrically. The number of nodes grows as log(1/a).

References
----------
.. [1] P. R. Johnston and D. Elliott, A sinh transformation for evaluating nearly singular boundary
   element integrals, Int. J. Numer. Meth. Engng 62 (2005) 564, doi:10.1002/nme.1208.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.quadrature import gauss_legendre
from app.optics.parameters import Array

Index = NDArray[np.intp]
Measure = Literal["hemisphere", "flatland"]
Integrand = Callable[[Interface, Incidence], Sequence[Array]]

_QUARTER_TURN = 0.5 * np.pi
# 24 + 8 v_max nodes leave 5e-14; the step of 8 keeps interfaces together in few batches.
_FEWEST_NODES, _NODES_PER_UNIT, _NODE_STEP = 24, 8, 8
# Below these the scale no longer moves the integral: R stays within 0 and 1 there.
_SMALLEST_SCALE, _SMALLEST_SCALE_AT_CUT = 1e-40, 1e-7
_LARGEST_BATCH = 1 << 17


@dataclass(frozen=True, slots=True, eq=False)
class Piece:
    """A stretch of the hemisphere: angles phi from 0 to 90 degrees, cut apart by the scale `a`."""

    scale: Array
    """Distance of the nearest singularity from phi = 0."""
    cos_squared: Callable[[Array, Array], Array]
    sin_squared: Callable[[Array, Array], Array]
    """Function of (cos^2 phi, sin^2 phi) giving cos^2 and sin^2 of theta_i, by sums of positive
    terms."""
    width: Array
    """d(sin^2 theta_i) = 2 width sin(phi) cos(phi) dphi."""


def integrate(
    interface: Interface,
    integrand: Integrand,
    measure: Measure = "hemisphere",
    refinement: int = 1,
) -> list[Array]:
    r"""Average of functions of the angle of incidence over the half-space of directions.

    .. math::
        2 \int_0^{\pi/2} f \sin\theta \cos\theta \, d\theta \quad\text{('hemisphere')}, \qquad
        \int_0^{\pi/2} f \cos\theta \, d\theta \quad\text{('flatland')}

    Parameters
    ----------
    interface
        Any shape.
    integrand
        Called with interfaces of shape (m, 1) and directions of shape (m, nodes), returns one or
        more arrays that broadcast to (m, nodes).
    measure
        Weight of the directions: cosine-weighted solid angle, or its two-dimensional counterpart.
    refinement
        Multiplies the number of nodes, for functions less smooth than Fresnel's.

    Returns
    -------
    list of Array
        One array of the interface's shape for each array the integrand returns. Relative error is
        below 1e-12 for Fresnel's own reflectances.
    """
    media = np.broadcast_arrays(interface.n_i, interface.n_t, interface.k_t)
    shape = media[0].shape
    n_i, n_t, k_t = (np.ravel(medium) for medium in media)
    flat = Interface(n_i, n_t, k_t)
    totals: list[Array] = []
    cut = (flat.eta < 1.0) & (flat.kappa < 1.0)
    for chosen, pieces in ((~cut, (_whole,)), (cut, (_before_cut, _beyond_cut))):
        index = np.flatnonzero(chosen)
        if index.size == 0:
            continue
        for piece_of in pieces:
            for batch, nodes in _batches(index, flat, piece_of, refinement):
                column = batch[:, np.newaxis]
                boundary = Interface(n_i[column], n_t[column], k_t[column])
                incidence, weights = _rule(piece_of(boundary), nodes, measure)
                values = integrand(boundary, incidence)
                if not totals:
                    totals = [np.zeros(n_i.size) for _ in values]
                for total, value in zip(totals, values, strict=True):
                    total[batch] += np.sum(value * weights, axis=1)
    return [total.reshape(shape) for total in totals]


def _whole(interface: Interface) -> Piece:
    """The hemisphere in one piece from grazing incidence, phi = 90 deg - theta_i."""
    scale = np.minimum(np.sqrt(_abs_contrast(interface)), 1.0 / np.sqrt(_abs_plus_1(interface)))
    return Piece(
        scale=np.clip(scale, _SMALLEST_SCALE, 1.0),
        cos_squared=lambda _, sin2: sin2,
        sin_squared=lambda cos2, _: cos2,
        width=np.ones_like(scale),
    )


def _before_cut(interface: Interface) -> Piece:
    """theta_i below the critical angle: sin(theta_i) = eta cos(phi), so q = eta sin(phi)."""
    eta = interface.eta
    beyond = _cos_squared_critical(interface)
    to_grazing = np.sqrt(beyond) / eta
    scale = np.minimum(np.sqrt(_gap(interface)) / eta, to_grazing)
    return Piece(
        scale=np.clip(scale, _SMALLEST_SCALE_AT_CUT * np.minimum(to_grazing, 1.0), 1.0),
        cos_squared=lambda _, sin2: beyond + eta**2 * sin2,
        sin_squared=lambda cos2, _: eta**2 * cos2,
        width=eta**2,
    )


def _beyond_cut(interface: Interface) -> Piece:
    """theta_i beyond the critical angle: cos(theta_i) = cos(critical angle) cos(phi)."""
    eta = interface.eta
    beyond = _cos_squared_critical(interface)
    scale = np.sqrt(np.minimum(_gap(interface), eta**2) / beyond)
    return Piece(
        scale=np.clip(scale, _SMALLEST_SCALE_AT_CUT, 1.0),
        cos_squared=lambda cos2, _: beyond * cos2,
        sin_squared=lambda _, sin2: eta**2 + beyond * sin2,
        width=beyond,
    )


def _rule(piece: Piece, nodes: int, measure: Measure) -> tuple[Incidence, Array]:
    """Directions and weights, of shape (m, nodes)."""
    fractions, gauss = gauss_legendre(nodes)
    largest = np.arcsinh(_QUARTER_TURN / piece.scale)
    phi = piece.scale * np.sinh(largest * fractions)
    dphi = largest * gauss * np.hypot(piece.scale, phi)
    cosine, sine = np.cos(phi), np.sin(phi)
    cos2, sin2 = cosine * cosine, sine * sine
    incidence = Incidence(
        np.sqrt(piece.cos_squared(cos2, sin2)), np.sqrt(piece.sin_squared(cos2, sin2))
    )
    weights = piece.width * cosine * sine * dphi
    if measure == "hemisphere":
        return incidence, 2.0 * weights
    return incidence, weights / incidence.sin


def _batches(
    index: Index, interface: Interface, piece_of: Callable[[Interface], Piece], refinement: int
) -> Iterator[tuple[Index, int]]:
    """Group the interfaces at `index` by the number of nodes they need, at most so many values."""
    one_piece = piece_of(
        Interface(*(m[index] for m in (interface.n_i, interface.n_t, interface.k_t)))
    )
    needed = _FEWEST_NODES + _NODES_PER_UNIT * np.arcsinh(_QUARTER_TURN / one_piece.scale)
    nodes = _NODE_STEP * np.ceil(needed / _NODE_STEP).astype(int) * refinement
    for count in np.unique(nodes):
        alike = index[nodes == count]
        for start in range(0, alike.size, step := max(1, _LARGEST_BATCH // count)):
            yield alike[start : start + step], int(count)


def _abs_contrast(interface: Interface) -> Array:
    """|N^2 - 1|: the squared modulus of the branch point's cosine."""
    eta, kappa, eta_minus_1 = interface.relative
    return np.hypot(eta_minus_1 * (eta + 1.0) - kappa * kappa, 2.0 * eta * kappa)


def _abs_plus_1(interface: Interface) -> Array:
    """|N^2 + 1|: the reciprocal of the squared modulus of the pole's cosine."""
    eta, kappa, _ = interface.relative
    return np.hypot(1.0 + (eta - kappa) * (eta + kappa), 2.0 * eta * kappa)


def _cos_squared_critical(interface: Interface) -> Array:
    """1 - eta^2, the squared cosine of the critical angle."""
    return np.asarray(-interface.eta_minus_1 * (interface.eta + 1.0))


def _gap(interface: Interface) -> Array:
    """Distance in sin^2(theta_i) from the critical angle to the nearest singularity."""
    eta, kappa = interface.eta, interface.kappa
    branch = kappa * np.hypot(kappa, 2.0 * eta)  # |eta^2 - N^2|
    # eta^2 - N^2 / (1 + N^2) = (eta^2 - N^2 + eta^2 N^2) / (1 + N^2)
    pole = np.hypot(
        kappa**2 + eta**2 * (eta - kappa) * (eta + kappa), 2.0 * eta * kappa * (eta**2 - 1.0)
    ) / _abs_plus_1(interface)
    return np.minimum(branch, pole)
