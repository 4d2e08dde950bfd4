"""What a mesh of flat facets costs, shaded at its vertices or at every pixel."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

import numpy as np

from app.answers.answer import Table, answer, filled
from app.answers.interface import CONVENTION, InterfaceFacts
from app.optics.interface import Interface
from app.optics.mesh import WAYS, Spacing, mesh_errors


@answer
class MeshError:
    """An error over the disk that is seen of a sphere."""

    max_abs: float
    """Largest absolute error, sought between the vertices."""
    max_abs_at_deg: float
    """Angle of incidence there, of the sphere itself."""
    error_at_max: float
    """Signed error there."""
    rms: float
    """Root mean square, each pixel alike."""


@answer
class MeshErrors:
    """Errors of R on a sphere of facets, seen from far away along its axis."""

    interface: InterfaceFacts
    convention: str = CONVENTION
    latitudes: int
    spacing: Spacing
    per_vertex: MeshError
    """R interpolated between the vertices, against the sphere."""
    per_pixel: MeshError
    """R of the normal that is interpolated between the vertices, against the sphere."""
    apart: MeshError
    """R per vertex less R per pixel, of the same facets."""

    def table(self) -> Table:
        """Lay out a row each way of shading."""
        rows = [getattr(self, way) for way in WAYS]
        columns: dict[str, Any] = {"shading": list(WAYS)} | {
            field.name: np.array([getattr(row, field.name) for row in rows])
            for field in fields(MeshError)
        }
        return Table(columns, "fresnel_mesh_errors.csv")


def errors_of_mesh(interface: Interface, latitudes: int, spacing: Spacing) -> MeshErrors:
    """Measure a sphere of facets."""
    found = mesh_errors(interface, latitudes, spacing)
    return MeshErrors(
        interface=InterfaceFacts.of(interface),
        latitudes=latitudes,
        spacing=spacing,
        per_vertex=filled(MeshError, found["per_vertex"]),
        per_pixel=filled(MeshError, found["per_pixel"]),
        apart=filled(MeshError, found["apart"]),
    )
