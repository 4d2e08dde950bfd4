"""Psi, delta, Jones and Mueller matrices: reference values, signs, and what must hold."""

import json
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tmm

from app.optics.amplitudes import Amplitudes
from app.optics.ellipsometry import (
    NORMALS,
    TIME_FACTORS,
    Convention,
    checked_stokes,
    degree_of_polarization,
    delta_deg,
    jones,
    mueller_of_reflection,
    mueller_of_transmission,
    psi_deg,
    stokes_of_jones,
)
from app.optics.errors import NotAllowed, UnknownName
from app.optics.films import amplitudes, power
from app.optics.incidence import Incidence
from app.optics.stack import Layer, Stack

GOLDEN: list[dict[str, Any]] = json.loads(
    (Path(__file__).parent / "reference" / "films.json").read_text("utf-8")
)["cases"]
RELATIVE = 1e-12
CONVENTIONS = [Convention(*each) for each in product(TIME_FACTORS, NORMALS)]
SILICON = Stack(1.0, (), 3.8827, 0.0196, wavelength_nm=632.8)
AT_70 = Incidence.from_degrees(70.0)


@pytest.mark.parametrize("case", GOLDEN, ids=[str(i) for i in range(len(GOLDEN))])
def test_reference_values(case: dict[str, Any]) -> None:
    layers = [Layer(each["n"], each["k"], each["thickness_nm"]) for each in case["layers"]]
    at = case["wavelength_nm"]
    stack = Stack(case["n_i"], layers, case["n_t"], case["k_t"], wavelength_nm=at)
    ours = amplitudes(stack, Incidence.from_degrees(case["theta_i_deg"]))
    assert float(psi_deg(ours)) == pytest.approx(float(case["psi_deg"]), rel=RELATIVE)
    expected = float(case["delta_deg"])
    # 180 degrees are -180.
    off = (float(delta_deg(ours)) - expected + 180.0) % 360.0 - 180.0
    assert off == pytest.approx(0.0, abs=RELATIVE * max(abs(expected), 1.0))


def test_bare_silicon_in_each_convention() -> None:
    """tmm prints 0.79392 for what ellipsometers print as 179.20608."""
    ours = amplitudes(SILICON, AT_70)
    found = {
        (each.time_factor, each.r_p_at_normal): (
            round(float(psi_deg(each.of(ours))), 5),
            round(float(delta_deg(each.of(ours))), 5),
        )
        for each in CONVENTIONS
    }
    assert found == {
        ("exp(-iwt)", "-r_s"): (10.57788, -179.20608),
        ("exp(+iwt)", "-r_s"): (10.57788, 179.20608),
        ("exp(-iwt)", "r_s"): (10.57788, 0.79392),
        ("exp(+iwt)", "r_s"): (10.57788, -0.79392),
    }
    theirs = tmm.ellips([1.0, 3.8827 + 0.0196j], [np.inf, np.inf], np.radians(70.0), 632.8)
    assert np.degrees(theirs["Delta"]) == pytest.approx(0.79392, abs=5e-6)


def test_where_nothing_is_reflected_there_is_no_phase() -> None:
    none = amplitudes(Stack(1.0, (), 1.0), AT_70)
    assert np.isnan(psi_deg(none))
    assert np.isnan(delta_deg(none))
    brewster = Amplitudes(*(np.asarray(x, np.complex128) for x in (-0.4, 0.0, 0.6, 0.67)))
    assert float(psi_deg(brewster)) == 0.0
    assert np.isnan(delta_deg(brewster))


STACKS = [
    SILICON,
    Stack(1.5, (), 1.0),
    Stack(1.0, [Layer(1.46, 0.0, 100.0)], 3.8827, 0.0196, wavelength_nm=632.8),
    Stack(1.0, [Layer(0.055, 3.32, 30.0), Layer(2.35, 0.0, 60.0)], 1.52),
]


@pytest.mark.parametrize("stack", STACKS)
@pytest.mark.parametrize("convention", CONVENTIONS)
def test_mueller_does_to_stokes_what_jones_does_to_fields(
    stack: Stack, convention: Convention
) -> None:
    incidence = Incidence.from_degrees([0.0, 30.0, 55.0, 70.0])
    ours, energy = amplitudes(stack, incidence), power(stack, incidence)
    amplitude = convention.of(ours)
    field = np.array([0.6 + 0.1j, -0.2 + 0.7j])
    if convention.time_factor == "exp(+iwt)":
        field = field.conj()
    incoming = stokes_of_jones(field, convention)
    reflected = np.einsum("...ij,j->...i", jones(amplitude.r_p, amplitude.r_s), field)
    M = mueller_of_reflection(amplitude, convention)
    np.testing.assert_allclose(M @ incoming, stokes_of_jones(reflected, convention), atol=1e-14)
    np.testing.assert_allclose(M[..., 0, 0], energy.R, rtol=RELATIVE)
    transmitted = np.einsum("...ij,j->...i", jones(amplitude.t_p, amplitude.t_s), field)
    M = mueller_of_transmission(amplitude, energy, convention)
    np.testing.assert_allclose(M[..., 0, 0], energy.T, rtol=RELATIVE)
    if not stack.substrate.is_conductor:
        passes = energy.Ts / np.maximum(np.abs(amplitude.t_s) ** 2, 1e-300)
        expected = passes[:, np.newaxis] * stokes_of_jones(transmitted, convention)
        np.testing.assert_allclose(M @ incoming, expected, atol=1e-13)


def test_the_time_factor_is_no_matter_of_power() -> None:
    ours = amplitudes(STACKS[2], AT_70)
    minus, plus = (
        mueller_of_reflection(each.of(ours), each) for each in (CONVENTIONS[0], CONVENTIONS[2])
    )
    np.testing.assert_array_equal(minus, plus)


def test_mueller_in_the_form_of_ellipsometry() -> None:
    """M = R (1, -N; -N, 1; C, S; -S, C), N = cos 2 psi, S = sin 2 psi sin delta, in exp(+iwt)."""
    convention = Convention("exp(+iwt)")
    ours = convention.of(amplitudes(STACKS[2], AT_70))
    M = mueller_of_reflection(ours, convention)
    psi, delta = np.radians(psi_deg(ours)), np.radians(delta_deg(ours))
    N, S, C = np.cos(2 * psi), np.sin(2 * psi) * np.sin(delta), np.sin(2 * psi) * np.cos(delta)
    expected = [[1, -N, 0, 0], [-N, 1, 0, 0], [0, 0, C, S], [0, 0, -S, C]]
    np.testing.assert_allclose(M / M[0, 0], expected, atol=1e-14)


def test_handedness() -> None:
    """E_s lags E_p by a quarter of a period: for the one it meets, it turns counterclockwise."""
    w_t = np.array([0.0, 0.1])
    E_p, E_s = (np.real(x * np.exp(-1j * w_t)) for x in (1.0, 1j))
    turned = np.diff(np.arctan2(E_s, E_p))[0]
    assert turned == pytest.approx(0.1)
    assert stokes_of_jones([1.0, 1j]).tolist() == [2.0, 0.0, 0.0, -2.0]
    assert stokes_of_jones([1.0, -1j], Convention("exp(+iwt)")).tolist() == [2.0, 0.0, 0.0, -2.0]


def test_a_mirror_changes_the_hand() -> None:
    mirror = amplitudes(Stack(1.0, (), 0.05, 5.0), Incidence.from_degrees(0.0))
    out = mueller_of_reflection(mirror) @ np.array([1.0, 0.0, 0.0, 1.0])
    assert out[3] < -0.9
    assert float(degree_of_polarization(out)) == pytest.approx(1.0)


def test_total_reflection_turns_linear_light() -> None:
    """Fresnel's rhomb, of glass of 1.51 at 54 degrees 37 minutes (Born and Wolf, section 1.5.4)."""
    rhomb = amplitudes(Stack(1.51, (), 1.0), Incidence.from_degrees(54.0 + 37.0 / 60.0))
    assert abs(float(delta_deg(rhomb))) == pytest.approx(45.0, abs=0.01)


def test_what_is_no_convention_and_no_light_is_refused() -> None:
    with pytest.raises(UnknownName, match="convention"):
        Convention("exp(iwt)")  # type: ignore[arg-type]
    for wrong in ([1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0], [1.0, 1.0, 1.0, 0.0], [1.0, 0, 0, np.nan]):
        with pytest.raises(NotAllowed, match="stokes"):
            checked_stokes(wrong)
