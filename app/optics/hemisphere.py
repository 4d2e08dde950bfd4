r"""Integrals over the hemisphere by cos(theta_i), split where the exact curve bends sharply.

The exact R has its branch point where q = sqrt(N^2 - 1 + mu^2) vanishes, at
mu = sqrt(1 - N^2). Its real part is the cosine of the critical angle without absorption and of the
angle where R turns up with weak absorption. Each interval is integrated by a rule whose nodes crowd
toward both of its ends, so that neither the square root there nor a pole just outside costs digits.
"""

import numpy as np
from numpy.typing import NDArray

from app.optics.amplitudes import Wave, wave
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.quadrature import Nodes, Rule
from app.optics.parameters import Array

# Where no branch point lies within 0 and 1, the interval is split here all the same: half of what
# happens, happens close to grazing incidence.
_SPLIT = 0.3
_MARGIN = 1e-9

# With these distances 14 nodes integrate Schlick's squared error to 4e-7 over d'Eon's ranges.
_FAR, _BESIDE = 0.5, 0.1


def branch_cosine(interface: Interface) -> Array:
    """Real part of mu where q vanishes, |Re sqrt(1 - N^2)|, of the interface's shape."""
    return np.broadcast_to(_grazing(interface).b, interface.shape)


def bends_gently(interface: Interface) -> NDArray[np.bool_]:
    """Where the branch point is so far from 0 < mu < 1 that one interval will do."""
    q = _grazing(interface)  # Im q is the real and Re q the imaginary part of the branch point
    return np.asarray((q.a > _FAR) | (q.b > 1.0 + _BESIDE))


def _grazing(interface: Interface) -> Wave:
    return wave(interface, Incidence(np.zeros(()), np.ones(())))


def hemisphere(interface: Interface, rule: Rule, kinks: Array | None = None) -> Nodes:
    """Nodes and weights over mu from 0 to 1.

    Parameters
    ----------
    interface
        Boundaries of any shape.
    rule
        Used in each interval.
    kinks
        Cosines where intervals have to end besides: one-dimensional for all boundaries, or of the
        interface's shape with one more axis.

    Returns
    -------
    Nodes
        Of the interface's shape with one more axis.
    """
    branch = branch_cosine(interface)
    inside = (branch > _MARGIN) & (branch < 1.0 - _MARGIN)
    split = np.where(inside, branch, _SPLIT)[..., np.newaxis]
    fixed = [np.array([0.0, 1.0])] if kinks is None else [np.array([0.0, 1.0]), kinks]
    parts = [*(np.broadcast_to(f, (*branch.shape, f.shape[-1])) for f in fixed), split]
    edges = np.sort(np.concatenate(parts, axis=-1), axis=-1)
    low, width = edges[..., :-1, np.newaxis], np.diff(edges, axis=-1)[..., np.newaxis]
    x, w = np.concatenate([[0.0], rule.x]), np.concatenate([[0.0], rule.w])
    shape = (*branch.shape, -1)
    mu, weights = (low + width * x).reshape(shape), (width * w).reshape(shape)
    end = np.ones((*branch.shape, 1))
    return Nodes(np.concatenate([mu, end], axis=-1), np.concatenate([weights, 0.0 * end], axis=-1))
