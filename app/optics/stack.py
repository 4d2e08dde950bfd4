"""Films between two media, and what they are made of."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.optics.errors import NotAllowed, OutOfRange
from app.optics.interface import Interface
from app.optics.numerics.blocks import broadcast
from app.optics.parameters import (
    K_I,
    LAYER_K,
    LAYER_N,
    THICKNESS_NM,
    WAVELENGTH_NM,
    Array,
    Number,
)

D_LINE_NM = 587.6
"""Wavelength where none is given."""

MOST_LAYERS = 1000

MOST_K_OF_INCOHERENT = 0.01
TRANSPARENT = (
    f"at most {MOST_K_OF_INCOHERENT:g} n in an incoherent layer: in what fades within a few waves the "
    "phase of a passage cannot be averaged"
)

_MOST_WAVELENGTHS = 1e10


@dataclass(frozen=True, eq=False)
class Layer:
    """A film of index n + i k, its thickness in nm.

    All three may be arrays that broadcast against one another, wavelengths and angles.

    Parameters
    ----------
    n, k
        Real and imaginary part of the index, 1e-3 to 100 and 0 to 100.
    thickness_nm
        0 to 1e9 nm.
    incoherent
        Whether the layer is so thick, or so uneven, that waves reflected at its two faces do not
        interfere: what it does is the mean over the phase of one passage. Its k is at most 0.01 n.

    Raises
    ------
    OutOfRange
        If a value is out of bounds, NaN or infinite.
    """

    n: Array
    k: Array
    thickness_nm: Array
    incoherent: bool

    def __init__(
        self,
        n: ArrayLike,
        k: ArrayLike = 0.0,
        thickness_nm: ArrayLike = 0.0,
        *,
        incoherent: bool = False,
    ) -> None:
        object.__setattr__(self, "n", LAYER_N.check(n))
        object.__setattr__(self, "k", LAYER_K.check(k))
        object.__setattr__(self, "thickness_nm", THICKNESS_NM.check(thickness_nm))
        object.__setattr__(self, "incoherent", incoherent)
        if incoherent:
            opaque = self.k > MOST_K_OF_INCOHERENT * self.n
            if opaque.any():
                most = np.broadcast_to(self.k, opaque.shape)[opaque].max()
                raise OutOfRange("k", float(most), TRANSPARENT)


class Sheet(NamedTuple):
    """A layer as the wave meets it."""

    medium: Interface
    """From the incident medium to the layer's own."""
    phase: Number
    """2 pi n_i d / wavelength, to be multiplied by q, which is in units of n_i."""
    incoherent: bool


@dataclass(frozen=True, eq=False)
class Sheets:
    """All that light meets, in a form that can be taken apart into pieces."""

    kappa_i: Array
    """Extinction of the incident medium over its n_i."""
    between: tuple[Sheet, ...]
    substrate: Interface

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Shape that everything broadcasts to."""
        media = [each.medium for each in self.between]
        phases = [np.asarray(each.phase) for each in self.between]
        return broadcast(self.kappa_i, self.substrate, *media, *phases)

    def map(self, pick: Callable[[Array], Array]) -> Sheets:
        """Pick the same piece from every array."""
        between = tuple(
            Sheet(
                each.medium.map(pick),
                each.phase if isinstance(each.phase, float) else pick(each.phase),
                each.incoherent,
            )
            for each in self.between
        )
        return Sheets(pick(self.kappa_i), between, self.substrate.map(pick))


@dataclass(frozen=True, eq=False, init=False)
class Stack:
    """Layers between an incident medium and a second medium N = n_t + i k_t.

    The generalization of `Interface`, which `app.optics.films` equals to the last bit where there is
    no layer. The time factor is exp(-i w t), so that positive k absorb. Indices, thicknesses and
    wavelengths broadcast against one another and against the angles.

    Parameters
    ----------
    n_i
        Real part of the incident medium's index.
    layers
        From the incident side on.
    n_t, k_t
        Index of the second medium.
    wavelength_nm
        Wavelength in vacuum.
    k_i
        Imaginary part of the incident medium's index. Where it is not 0, light may come along the
        normal alone, R and T are parts of the power that the incident wave would carry without the
        reflected one, and R + T + A is not 1, since the two interfere in what absorbs.

    Raises
    ------
    OutOfRange
        If a value is out of bounds, NaN or infinite.
    NotAllowed
        If there are more than 1000 layers, or one is thicker than 1e10 wavelengths.

    Examples
    --------
    A quarter-wave film of the index sqrt(1.5) makes glass reflect nothing:

    >>> from app.optics.films import power
    >>> from app.optics.incidence import Incidence
    >>> film = Layer(1.5**0.5, thickness_nm=550.0 / 4.0 / 1.5**0.5)
    >>> stack = Stack(1.0, [film], 1.5, wavelength_nm=550.0)
    >>> bool(power(stack, Incidence.from_degrees(0.0)).R < 1e-30)
    True
    """

    substrate: Interface
    """The boundary that there would be without layers."""
    layers: tuple[Layer, ...]
    wavelength_nm: Array
    k_i: Array

    def __init__(
        self,
        n_i: ArrayLike = 1.0,
        layers: Sequence[Layer] = (),
        n_t: ArrayLike = 1.5,
        k_t: ArrayLike = 0.0,
        *,
        wavelength_nm: ArrayLike = D_LINE_NM,
        k_i: ArrayLike = 0.0,
    ) -> None:
        if len(layers) > MOST_LAYERS:
            raise NotAllowed("layers", f"{len(layers)} layers", f"at most {MOST_LAYERS}")
        object.__setattr__(self, "substrate", Interface(n_i, n_t, k_t))
        object.__setattr__(self, "layers", tuple(layers))
        object.__setattr__(self, "wavelength_nm", WAVELENGTH_NM.check(wavelength_nm))
        object.__setattr__(self, "k_i", K_I.check(k_i))
        for layer in layers:
            many = layer.thickness_nm > _MOST_WAVELENGTHS * self.wavelength_nm
            if many.any():
                thickest = f"{float(layer.thickness_nm.max()):g} nm"
                raise NotAllowed("layers", thickest, f"at most {_MOST_WAVELENGTHS:g} wavelengths")

    @property
    def n_i(self) -> Array:
        """Real part of the incident medium's index."""
        return self.substrate.n_i

    @property
    def is_coherent(self) -> bool:
        """Whether all waves interfere, so that there are amplitudes."""
        return not any(layer.incoherent for layer in self.layers)

    @cached_property
    def sheets(self) -> Sheets:
        """The stack as the wave meets it."""
        n_i = self.substrate.n_i
        between = []
        for layer in self.layers:
            phase = 2.0 * math.pi * n_i * (layer.thickness_nm / self.wavelength_nm)
            between.append(
                Sheet(
                    Interface(n_i, layer.n, layer.k),
                    float(phase) if phase.ndim == 0 else phase,
                    layer.incoherent,
                )
            )
        return Sheets(self.k_i / n_i, tuple(between), self.substrate)
