"""The boundary between two media."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, wraps
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from app.optics.numerics.choice import anywhere, select
from app.optics.parameters import K_T, N_I, N_T, Array, Condition, Number

Kind = Literal["dielectric", "conductor"]

_SMALLEST_KAPPA = 1e-140


@dataclass(frozen=True, eq=False)
class Interface:
    """A smooth boundary from a transparent medium `n_i` to a medium N = n_t + i k_t.

    The time factor is exp(-i w t), so k_t >= 0 absorbs. All three broadcast against each other
    and against the angles they are evaluated at.

    Parameters
    ----------
    n_i
        Real index of the incident medium, 1e-3 to 100.
    n_t, k_t
        Real and imaginary part of the second medium's index, 1e-3 to 100 and 0 to 100.

    Raises
    ------
    OutOfRange
        If a value is out of bounds, NaN or infinite.

    Examples
    --------
    >>> glass = Interface(n_t=1.5)
    >>> round(float(glass.F0), 12), glass.kind
    (0.04, 'dielectric')
    """

    n_i: Array
    n_t: Array
    k_t: Array

    def __init__(self, n_i: ArrayLike = 1.0, n_t: ArrayLike = 1.5, k_t: ArrayLike = 0.0) -> None:
        object.__setattr__(self, "n_i", N_I.check(n_i))
        object.__setattr__(self, "n_t", N_T.check(n_t))
        object.__setattr__(self, "k_t", K_T.check(k_t))

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Shape that the three indices broadcast to."""
        if self.n_i.ndim == self.n_t.ndim == self.k_t.ndim == 0:
            return ()
        return np.broadcast_shapes(self.n_i.shape, self.n_t.shape, self.k_t.shape)

    def map(self, pick: Callable[[Array], Array]) -> Interface:
        """Pick the same boundaries from every array; they are not checked again."""
        if self.shape == ():
            return self
        picked = Interface.__new__(Interface)
        for name in ("n_i", "n_t", "k_t"):
            object.__setattr__(picked, name, pick(getattr(self, name)))
        return picked

    @cached_property
    def indices(self) -> tuple[Number, Number, Number]:
        """n_i, n_t and k_t, as plain numbers where the interface is one."""
        if self.shape == ():
            return float(self.n_i), float(self.n_t), float(self.k_t)
        return self.n_i, self.n_t, self.k_t

    @cached_property
    def relative(self) -> tuple[Number, Number, Number]:
        """Eta, kappa and eta - 1, as plain numbers where the interface is one.

        Kappa is 0 where the square of eta kappa would be no double. Eta - 1 is taken from the
        difference of the indices, which is exact where eta is near 1.
        """
        n_i, n_t, k_t = self.indices
        kappa = k_t / n_i
        return n_t / n_i, select(kappa >= _SMALLEST_KAPPA, kappa, 0.0), (n_t - n_i) / n_i

    @property
    def eta(self) -> Array:
        """Relative index n_t / n_i."""
        return np.asarray(self.relative[0])

    @property
    def kappa(self) -> Array:
        """Relative extinction k_t / n_i."""
        return np.asarray(self.relative[1])

    @property
    def eta_minus_1(self) -> Array:
        """Eta - 1 with the digits that the difference of eta and 1 would lose."""
        return np.asarray(self.relative[2])

    @cached_property
    def is_lossless(self) -> bool:
        """Whether kappa is 0 everywhere, so that all waves are real or totally reflected."""
        return not anywhere(self.relative[1] > 0.0)

    @cached_property
    def absorbs_strongly(self) -> Condition:
        """Where N^2 - sin^2 and N^2 cos^2 - sin^2 stay away from 0 at all angles.

        As kappa is neither small nor much less than eta, plain differences keep their digits.
        """
        eta, kappa, _ = self.relative
        return (kappa >= 0.5) & (8.0 * kappa >= eta)

    @cached_property
    def is_conductor(self) -> bool:
        """Whether the second medium absorbs anywhere."""
        return anywhere(self.indices[2] > 0.0)

    @property
    def kind(self) -> Kind:
        """'conductor' where the second medium absorbs, else 'dielectric'."""
        return "conductor" if self.is_conductor else "dielectric"

    @cached_property
    def F0(self) -> Array:
        """Reflectance at normal incidence."""
        return np.asarray(normal_reflectance(*self.indices))


def normal_reflectance(n_i: Number, n_t: Number, k_t: Number) -> Number:
    """Reflectance at normal incidence, ((n_t-n_i)^2 + k_t^2) / ((n_t+n_i)^2 + k_t^2)."""
    difference, total, k2 = n_t - n_i, n_t + n_i, k_t * k_t
    return (difference * difference + k2) / (total * total + k2)


Figure = Callable[[Interface], Array]


def worked_out_once(figure: Figure) -> Figure:
    """Keep a figure of an interface with it, which is frozen, for whoever asks again."""

    @wraps(figure)
    def kept(interface: Interface) -> Array:
        known = interface.__dict__
        if (found := known.get(name)) is None:
            found = known[name] = figure(interface)
        return found

    name = f"{figure.__module__}.{figure.__qualname__}"
    return kept
