"""Shading per vertex and per pixel, against triangles in space that are looked at one by one."""

import numpy as np
import pytest
from numpy.typing import NDArray

from app.optics.amplitudes import reflectance
from app.optics.errors import OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.mesh import Spacing, mesh_errors

Array = NDArray[np.float64]

WATER = Interface(1.0, 1.333333)


def R(cosine: Array) -> Array:
    return reflectance(WATER, Incidence.from_cosine(np.clip(cosine, 0.0, 1.0)))


def triangles(cosines: Array, longitudes: int) -> Array:
    """Corners of a sphere's visible facets, (triangles, 3 corners, 3 coordinates); z to the viewer."""
    turn = 2.0 * np.pi * np.arange(longitudes + 1) / longitudes
    sines = np.sqrt(1.0 - cosines**2)[:, np.newaxis]
    grid = np.stack(
        [sines * np.cos(turn), sines * np.sin(turn), cosines[:, np.newaxis] + 0.0 * turn], axis=-1
    )
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    corners = [np.stack(t, axis=-2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))]
    return np.concatenate(corners)


@pytest.mark.parametrize(
    ("latitudes", "spacing", "per_vertex", "per_pixel", "apart"),
    [
        (16, "angle", 0.159, 0.130, 0.0408),
        (32, "angle", 0.079, 0.071, 0.0115),
        (64, "angle", 0.039, 0.037, 0.0030),
        (16, "cosine", 0.103, 0.090, 0.0188),
    ],
)
def test_a_mesh_of_triangles(
    latitudes: int, spacing: Spacing, per_vertex: float, per_pixel: float, apart: float
) -> None:
    share = np.linspace(0.0, 1.0, latitudes)
    cosines = np.cos(np.pi / 2.0 * share) if spacing == "angle" else 1.0 - share
    cosines[-1] = 0.0
    corners = triangles(cosines, 2000)
    # The outermost ring of facets, where all errors are largest, at points drawn at random.
    corners = corners[np.isclose(corners[:, :, 2].min(axis=1), 0.0)][::7]
    rng = np.random.default_rng(1)
    weights = rng.dirichlet((0.7, 0.7, 0.7), (len(corners), 400))
    points = weights @ corners
    vertex = (weights @ R(corners[:, :, 2])[..., np.newaxis])[..., 0]
    distance2 = points[..., 0] ** 2 + points[..., 1] ** 2
    sphere = R(np.sqrt(np.maximum(1.0 - distance2, 0.0)))
    pixel = R(points[..., 2] / np.linalg.norm(points, axis=-1))
    found = mesh_errors(WATER, latitudes, spacing)
    for figure, error, printed in (
        (found["per_vertex"], vertex - sphere, per_vertex),
        (found["per_pixel"], pixel - sphere, per_pixel),
        (found["apart"], vertex - pixel, apart),
    ):
        assert figure.max_abs == pytest.approx(printed, abs=5.1e-4)
        assert np.abs(error).max() == pytest.approx(printed, abs=1.5e-3)


def test_the_mean_square_is_that_of_the_pixels() -> None:
    found = mesh_errors(WATER, 16)
    ring = np.linspace(0.0, np.pi / 2.0, 16)
    x = np.sqrt((np.arange(400_000) + 0.5) / 400_000)  # pixels of one area, by their distance
    sphere = R(np.sqrt(1.0 - x**2))
    vertex = np.interp(x, np.sin(ring), R(np.cos(ring)))
    assert found["per_vertex"].rms == pytest.approx(
        np.sqrt(np.mean((vertex - sphere) ** 2)), rel=1e-4
    )


def test_finer_meshes_come_closer_and_without_a_boundary_nothing_is_wrong() -> None:
    errors = [mesh_errors(WATER, count)["per_vertex"].max_abs for count in (2, 8, 64, 4096)]
    assert errors == sorted(errors, reverse=True)
    assert errors[-1] < 1e-3
    assert mesh_errors(Interface(1.0, 1.0), 16)["per_vertex"].max_abs == 0.0


@pytest.mark.parametrize("latitudes", [1, 4097])
def test_refuses_what_is_no_number_of_latitudes(latitudes: int) -> None:
    with pytest.raises(OutOfRange, match="latitudes"):
        mesh_errors(WATER, latitudes)
