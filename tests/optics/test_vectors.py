"""Reflected and refracted directions in two and three dimensions, and the depth of what enters."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import ArrayLike, NDArray

from app.optics.angles import critical_deg
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.snell import refraction_angle_deg
from app.optics.vectors import reflect, refract

Array = NDArray[np.float64]

# Unit vectors are rounded in every component.
ROUNDING = 1e-14

indices = st.floats(0.5, 4.0)
tilts = st.floats(0.0, np.pi / 2)
turns = st.floats(-np.pi, np.pi)


def plane_pair(theta_i: float, turn: float) -> tuple[Array, Array]:
    """Incident direction and normal in the plane, the surface turned by `turn`."""
    incident = np.array([np.sin(theta_i + turn), -np.cos(theta_i + turn)])
    return incident, np.array([-np.sin(turn), np.cos(turn)])


def space_pair(theta_i: float, turn: float, lean: float) -> tuple[Array, Array]:
    """The same in space, turned about y by `lean` besides."""
    flat_i, flat_n = plane_pair(theta_i, turn)
    about_y = np.array(
        [[np.cos(lean), 0.0, np.sin(lean)], [0, 1, 0], [-np.sin(lean), 0, np.cos(lean)]]
    )
    return about_y @ np.append(flat_i, 0.0), about_y @ np.append(flat_n, 0.0)


plane_pairs = st.builds(plane_pair, tilts, turns)
space_pairs = st.builds(space_pair, tilts, turns, turns)
pairs = plane_pairs | space_pairs


def length(vector: Array) -> float:
    return float(np.sqrt(np.sum(vector * vector)))


def sine(vector: Array, normal: Array) -> float:
    """Length of the part of a unit vector along the surface."""
    return length(vector - (vector @ normal) * normal)


@given(pairs)
def test_reflection_mirrors_at_the_surface(pair: tuple[Array, Array]) -> None:
    incident, normal = pair
    reflected = reflect(incident, normal)
    assert length(reflected) == pytest.approx(1.0, abs=ROUNDING)
    assert reflected @ normal == pytest.approx(-(incident @ normal), abs=ROUNDING)
    along = incident - (incident @ normal) * normal
    assert reflected - (reflected @ normal) * normal == pytest.approx(along, abs=ROUNDING)
    # Mirroring the reversed ray gives the reversed incident one.
    assert reflect(-reflected, normal) == pytest.approx(-incident, abs=ROUNDING)


@given(pairs, indices, indices)
def test_refraction_obeys_snell(pair: tuple[Array, Array], n_i: float, n_t: float) -> None:
    incident, normal = pair
    ray = refract(incident, normal, n_i, n_t)
    assert np.isfinite(ray.direction).all()
    sin_i = sine(incident, normal)
    assume(abs(n_i * sin_i - n_t) > 1e-9)  # rounding decides at the very critical angle
    assert bool(ray.exists) == (n_i * sin_i < n_t)
    if not ray.exists:
        assert np.array_equal(ray.direction, np.zeros_like(incident))
        return
    assert length(ray.direction) == pytest.approx(1.0, abs=ROUNDING)
    assert ray.direction @ normal <= 0.0
    assert n_t * sine(ray.direction, normal) == pytest.approx(n_i * sin_i, abs=10 * ROUNDING)


@given(space_pairs, indices, indices)
def test_the_three_rays_lie_in_one_plane(pair: tuple[Array, Array], n_i: float, n_t: float) -> None:
    incident, normal = pair
    across = np.cross(incident, normal)
    assert reflect(incident, normal) @ across == pytest.approx(0.0, abs=ROUNDING)
    assert refract(incident, normal, n_i, n_t).direction @ across == pytest.approx(0, abs=ROUNDING)


@given(plane_pairs, indices, indices)
def test_space_holds_the_plane(pair: tuple[Array, Array], n_i: float, n_t: float) -> None:
    flat = refract(*pair, n_i, n_t)
    incident, normal = (np.append(vector, 0.0) for vector in pair)
    solid = refract(incident, normal, n_i, n_t)
    assert np.array_equal(solid.direction, np.append(flat.direction, 0.0))
    assert bool(solid.exists) == bool(flat.exists)


@given(st.floats(0.0, 90.0), indices, indices)
def test_vectors_and_angles_agree(theta_i_deg: float, n_i: float, n_t: float) -> None:
    incidence, interface = Incidence.from_degrees(theta_i_deg), Interface(n_i, n_t)
    critical = float(critical_deg(interface))
    assume(not abs(theta_i_deg - critical) < 1e-3)
    ray = refract([float(incidence.sin), -float(incidence.cos)], [0.0, 1.0], n_i, n_t)
    angle = float(refraction_angle_deg(interface, incidence))
    assert bool(ray.exists) == (not np.isnan(angle))
    if ray.exists:
        from_vector = np.degrees(np.arctan2(ray.direction[0], -ray.direction[1]))
        assert from_vector == pytest.approx(angle, abs=1e-9)


def test_textbook_ray_enters_glass() -> None:
    ray = refract([np.sqrt(0.5), -np.sqrt(0.5)], [0.0, 1.0], 1.0, 1.5)
    assert ray.direction == pytest.approx(
        [np.sqrt(0.5) / 1.5, -np.sqrt(1 - 0.5 / 2.25)], abs=ROUNDING
    )
    assert reflect([np.sqrt(0.5), -np.sqrt(0.5)], [0.0, 1.0]) == pytest.approx(
        [np.sqrt(0.5), np.sqrt(0.5)], abs=ROUNDING
    )


@pytest.mark.parametrize("index", [0.5, 1.0, 3.0])
def test_nothing_bends_where_the_media_match(index: float) -> None:
    incident, normal = space_pair(1.1, 0.3, -2.0)
    ray = refract(incident, normal, index, index)
    assert ray.direction == pytest.approx(incident, abs=ROUNDING)


@pytest.mark.parametrize("turn", np.linspace(-np.pi, np.pi, 41))
def test_a_ray_along_the_surface_is_none_from_behind(turn: float) -> None:
    """The scalar product of rounded vectors may have either sign there."""
    incident, normal = plane_pair(np.pi / 2, float(turn))
    assert reflect(incident, normal) == pytest.approx(incident, abs=ROUNDING)
    assert refract(incident, normal, 1.0, 1.5).exists
    assert not refract(incident, normal, 1.5, 1.0).exists


def test_vectors_broadcast() -> None:
    theta = np.radians([0.0, 20.0, 40.0, 60.0])
    incident = np.stack([np.sin(theta), -np.cos(theta)], axis=-1)
    assert reflect(incident, [0.0, 1.0]).shape == (4, 2)
    ray = refract(incident, [0.0, 1.0], [[1.5], [1.0]], [[1.0], [1.5]])
    assert ray.direction.shape == (2, 4, 2)
    assert ray.exists.tolist() == [[True, True, True, False], [True, True, True, True]]
    assert np.array_equal(ray.direction[0, 3], [0.0, 0.0])


@pytest.mark.parametrize(
    ("incident", "normal", "named"),
    [
        ([0.0, -1.0, 0.0], [0.0, 1.0], "incident"),
        ([0.0, -2.0], [0.0, 1.0], "incident"),
        ([0.0, -1.0], [0.0, 0.0], "normal"),
        ([0.0, 1.0], [0.0, 1.0], "incident"),
        ([np.nan, -1.0], [0.0, 1.0], "incident"),
        ([np.inf, -1.0], [0.0, 1.0], "incident"),
        ([-1.0], [1.0], "incident"),
        (1.0, 1.0, "incident"),
        ([0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 0.0, 1.0], "incident"),
    ],
)
def test_what_is_no_pair_of_directions(incident: ArrayLike, normal: ArrayLike, named: str) -> None:
    for call in (lambda: reflect(incident, normal), lambda: refract(incident, normal, 1.0, 1.5)):
        with pytest.raises(NotAllowed) as caught:
            call()
        assert caught.value.parameter == named


@pytest.mark.parametrize(("n_i", "n_t", "named"), [(0.0, 1.5, "n_i"), (1.0, np.nan, "n_t")])
def test_refraction_checks_the_indices(n_i: float, n_t: float, named: str) -> None:
    with pytest.raises(OutOfRange) as caught:
        refract([0.0, -1.0], [0.0, 1.0], n_i, n_t)
    assert caught.value.parameter == named
