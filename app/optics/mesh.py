"""R on a sphere of flat facets, evaluated at its vertices or at every pixel.

The sphere is seen from far away along its axis, where rings of vertices run around the middle: facets
between two rings are strips in which everything is linear in the distance from the middle. They lie
inside the sphere, so that a pixel near the rim belongs to another angle of the sphere than of the mesh.
"""

from functools import partial
from typing import Literal, NamedTuple, get_args

import numpy as np

from app.optics.amplitudes import reflectance
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.numerics.peaks import largest
from app.optics.numerics.quadrature import gauss_legendre
from app.optics.parameters import Array, Parameter

Spacing = Literal["angle", "cosine"]
Way = Literal["per_vertex", "per_pixel", "apart"]
WAYS: tuple[Way, ...] = get_args(Way)

LATITUDES = Parameter(
    "latitudes",
    "",
    16.0,
    2.0,
    4096.0,
    "",
    "Rings of vertices from the rim to the middle of the visible half, both counted.",
    integer=True,
)
_RULE = gauss_legendre(12)


class MeshError(NamedTuple):
    """An error over the disk that is seen."""

    max_abs: float
    max_abs_at_deg: float
    """Angle of incidence on the sphere itself."""
    error_at_max: float
    rms: float
    """Each pixel alike."""


def mesh_errors(
    interface: Interface, latitudes: int, spacing: Spacing = "angle"
) -> dict[Way, MeshError]:
    """Measure shading on a sphere of facets.

    Parameters
    ----------
    interface
        One boundary, from the medium of the viewer to that of the sphere.
    latitudes
        Rings of vertices from the rim to the middle, 2 to 4096.
    spacing
        Rings at equal differences of the angle, as meshes have them, or of its cosine.

    Returns
    -------
    dict
        `per_vertex`: R of the vertices, interpolated, less R of the sphere at that pixel. `per_pixel`:
        R of the interpolated and normalized normal less that of the sphere. `apart`: the one less
        the other.

    Raises
    ------
    OutOfRange
        If the number of latitudes is out of its bounds.
    """
    count = int(LATITUDES.check(latitudes))
    share = np.linspace(0.0, 1.0, count)
    cosine = np.cos(0.5 * np.pi * share) if spacing == "angle" else 1.0 - share
    cosine[-1] = 0.0
    sine = np.sqrt((1.0 - cosine) * (1.0 + cosine))
    R = reflectance(interface, Incidence(cosine, sine))
    inner, outer = (np.stack([cosine, sine, R])[:, part, np.newaxis] for part in _NEIGHBORS)

    def on_facets(way: Way, s: Array) -> Array:
        # Near the rim R rises like the root of what is left: s is that root.
        t = s * (2.0 - s)
        c, distance, vertex = inner + t * (outer - inner)
        true = np.sqrt(np.maximum((1.0 - distance) * (1.0 + distance), 0.0))
        length = np.hypot(c, distance)
        if way == "per_vertex":
            return np.asarray(vertex - reflectance(interface, Incidence(true, distance)))
        pixel = reflectance(interface, Incidence(c / length, distance / length))
        if way == "apart":
            return np.asarray(vertex - pixel)
        return np.asarray(pixel - reflectance(interface, Incidence(true, distance)))

    nodes = np.concatenate([[0.0], _RULE.x, [1.0]])
    wide = outer[1] - inner[1]
    distance = inner[1] + wide * nodes * (2.0 - nodes)
    weights = 4.0 * wide * distance * (1.0 - nodes) * np.concatenate([[0.0], _RULE.w, [0.0]])
    found: dict[Way, MeshError] = {}
    for way in WAYS:
        error = on_facets(way, nodes)
        peaks = largest(partial(on_facets, way), nodes, error, points=7, rounds=6)
        facet = int(np.argmax(np.abs(peaks.value)))
        t = peaks.at[facet] * (2.0 - peaks.at[facet])
        at = float(inner[1, facet, 0] + t * wide[facet, 0])
        value = float(peaks.value[facet])
        angle = float(np.degrees(np.arcsin(min(at, 1.0))))
        found[way] = MeshError(abs(value), angle, value, float(np.sqrt(np.sum(weights * error**2))))
    return found


_NEIGHBORS = slice(None, -1), slice(1, None)
