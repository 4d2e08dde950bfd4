"""Reflected and refracted directions in space."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.optics.amplitudes import wave
from app.optics.errors import NotAllowed
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array, Number

_UNIT_TOLERANCE = 1e-6


def cos2_refracted(mu: Number, eta: Number) -> Array:
    """cos^2(theta_t), negative where all is reflected."""
    return np.asarray(1.0 - (1.0 - mu) * (1.0 + mu) / (eta * eta))


def reflected(mu: Number, d: Number, n: Number) -> Array:
    """A component of the reflected direction, of those of the incident one and of the normal."""
    return np.asarray(d + 2.0 * mu * n)


def refracted(mu: Number, eta: Number, d: Number, n: Number) -> Array:
    """A component of the refracted direction, 0 where there is none."""
    cos2_t = cos2_refracted(mu, eta)
    onward = (d + mu * n) / eta - np.sqrt(np.maximum(cos2_t, 0.0)) * n
    return np.where(cos2_t < 0.0, 0.0, onward)


def reflect(incident: ArrayLike, normal: ArrayLike) -> Array:
    """Mirror a direction at a surface, i - 2 (i . n) n.

    Parameters
    ----------
    incident
        Unit vectors pointing toward the surface, shape (..., 2) or (..., 3).
    normal
        Unit normals on the incident side, broadcasting against `incident`.

    Returns
    -------
    Array
        Unit vectors pointing away from the surface.

    Raises
    ------
    NotAllowed
        If a vector is no unit vector of two or three components, or comes from behind.
    """
    i, n, cos_i = _unit_pair(incident, normal)
    return reflected(cos_i, i, n)


@dataclass(frozen=True, slots=True, eq=False)
class Refraction:
    """Refracted directions, and where there is one at all.

    Attributes
    ----------
    direction
        Unit vectors; zero where `exists` is false.
    exists
        False beyond the critical angle.
    """

    direction: Array
    exists: NDArray[np.bool_]


def refract(
    incident: ArrayLike,
    normal: ArrayLike,
    n_i: ArrayLike,
    n_t: ArrayLike,
    k_t: ArrayLike = 0.0,
) -> Refraction:
    """Refract a direction by Snell's law in vector form.

    Parameters
    ----------
    incident, normal
        As for `reflect`.
    n_i, n_t, k_t
        Indices on the incident and the far side, broadcasting against the vectors' leading axes.
        Where k_t is not 0, the direction is that in which the phase advances.

    Returns
    -------
    Refraction
        The directions beyond the surface; never NaN.

    Raises
    ------
    NotAllowed
        If a vector is no unit vector of two or three components, or comes from behind.
    OutOfRange
        If an index is out of bounds.

    Examples
    --------
    >>> import numpy as np
    >>> ray = refract([np.sin(1.0), -np.cos(1.0)], [0.0, 1.0], 1.0, 1.5)
    >>> bool(np.isclose(ray.direction[0], np.sin(1.0) / 1.5))
    True
    """
    i, n, cos_i = _unit_pair(incident, normal)
    interface = Interface(n_i, n_t, k_t)
    if interface.is_conductor:
        incidence = Incidence.from_cosine(np.minimum(cos_i[..., 0], 1.0))
        q = np.asarray(wave(interface, incidence).a)[..., np.newaxis]
        onward = i + cos_i * n - q * n
        length = np.sqrt(np.sum(onward * onward, axis=-1, keepdims=True))
        stands = length[..., 0] == 0.0
        direction = onward / np.where(length == 0.0, 1.0, length)
        return Refraction(direction, ~stands)
    eta = interface.eta[..., np.newaxis]
    exists = cos2_refracted(cos_i, eta) >= 0.0
    return Refraction(refracted(cos_i, eta, i, n), exists[..., 0])


def _unit_pair(incident: ArrayLike, normal: ArrayLike) -> tuple[Array, Array, Array]:
    """Check the vectors and return them with cos(theta_i) = -i . n on a trailing axis."""
    i, n = np.asarray(incident, dtype=np.float64), np.asarray(normal, dtype=np.float64)
    for name, vector in (("incident", i), ("normal", n)):
        if vector.ndim == 0 or vector.shape[-1] not in (2, 3) or vector.shape[-1] != n.shape[-1]:
            raise NotAllowed(name, vector.tolist(), "vectors of two or of three components")
        length = np.sqrt(np.sum(vector * vector, axis=-1))
        if not np.all(np.abs(length - 1.0) <= _UNIT_TOLERANCE):
            raise NotAllowed(name, vector.tolist(), "unit vectors")
    cos_i = -np.sum(i * n, axis=-1, keepdims=True)
    # A ray along the surface may seem to come from behind it by as much as its vectors are rounded.
    if not np.all(cos_i >= -_UNIT_TOLERANCE):
        raise NotAllowed("incident", i.tolist(), "a direction toward the surface, i . n <= 0")
    return i, n, np.maximum(cos_i, 0.0)
