"""Values everyone knows: normal and grazing incidence, Brewster's, the critical and other angles."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpc, mpf

from app.optics.amplitudes import amplitudes, phase_deg, power
from app.optics.angles import (
    LANDMARKS,
    brewster_deg,
    critical_deg,
    principal_deg,
    pseudo_brewster_deg,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.snell import is_totally_reflected, refraction_angle_deg
from app.optics.specular import F82, MU_BAR

GOLDEN: list[dict[str, float]] = json.loads(
    (Path(__file__).parent / "reference" / "angles.json").read_text("utf-8")
)["pseudo_brewster_deg"]

# The least of a parabola is known to half the digits of its values; the solver does better.
ANGLE_DEG = 1e-11

NORMAL, GRAZING = Incidence.from_degrees(0.0), Incidence.from_degrees(90.0)


@pytest.mark.parametrize(
    ("n_i", "n_t", "k_t", "F0"),
    [
        (1.0, 1.5, 0.0, 0.04),
        (1.5, 1.0, 0.0, 0.04),
        (1.0, 2.0, 0.0, 1.0 / 9.0),
        (1.0, 1.0, 0.0, 0.0),
        (1.0, 1.0, 2.0, 0.5),
        (2.0, 3.0, 1.0, 1.0 / 13.0),
    ],
)
def test_normal_incidence(n_i: float, n_t: float, k_t: float, F0: float) -> None:
    interface = Interface(n_i, n_t, k_t)
    energy = power(interface, NORMAL)
    for value in (interface.F0, energy.Rs, energy.Rp, energy.R):
        assert float(value) == pytest.approx(F0, abs=1e-15)
    amplitude = amplitudes(interface, NORMAL)
    assert complex(amplitude.r_p) == pytest.approx(-complex(amplitude.r_s), abs=1e-15)


@pytest.mark.parametrize("n_t", [1e-3, 0.5, 1.0 - 1e-9, 1.0 + 1e-9, 1.5, 100.0])
@pytest.mark.parametrize("k_t", [0.0, 1e-9, 5.0])
def test_grazing_incidence_reflects_all(n_t: float, k_t: float) -> None:
    energy = power(Interface(1.0, n_t, k_t), GRAZING)
    assert (float(energy.Rs), float(energy.Rp), float(energy.R)) == (1.0, 1.0, 1.0)
    assert (float(energy.Ts), float(energy.Tp), float(energy.T)) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("index", [1e-3, 1.0, 1.33, 100.0])
def test_matched_media_reflect_nothing(index: float) -> None:
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 91))
    energy = power(Interface(index, index), incidence)
    assert np.all(energy.R == 0.0)
    assert np.allclose(energy.T, 1.0, rtol=0.0, atol=1e-14)
    amplitude = amplitudes(Interface(index, index), incidence)
    assert np.all(amplitude.r_s == 0.0)
    assert np.all(amplitude.r_p == 0.0)
    assert np.allclose([amplitude.t_s, amplitude.t_p], 1.0, rtol=0.0, atol=1e-14)


@pytest.mark.parametrize("n_i", [1.0, 1.33])
@pytest.mark.parametrize("n_t", [1e-3, 0.5, 1.0 + 1e-9, 1.5, 2.42, 100.0])
def test_brewsters_angle(n_i: float, n_t: float) -> None:
    interface = Interface(n_i, n_t)
    angle = float(brewster_deg(interface))
    with mp.workdps(30):
        assert angle == float(mp.degrees(mp.atan(mpf(n_t) / n_i)))
    incidence = Incidence.from_degrees(angle)
    # Half a unit in the angle's last place is all that is left, magnified by 1 / eta^3.
    assert float(power(interface, incidence).Rp) < 1e-28 / min(1.0, (n_t / n_i) ** 6)
    # Reflected and refracted ray are perpendicular there.
    below = float(refraction_angle_deg(interface, incidence))
    assert angle + below == pytest.approx(90.0, abs=1e-11)


@pytest.mark.parametrize("n_i", [1.0, 1.33, 100.0])
@pytest.mark.parametrize("eta", [1e-3, 0.5, 0.9, 1.0 - 1e-9])
def test_critical_angle(n_i: float, eta: float) -> None:
    n_t = max(eta * n_i, 1e-3)
    interface = Interface(n_i, n_t)
    angle = float(critical_deg(interface))
    with mp.workdps(30):
        assert angle == float(mp.degrees(mp.asin(mpf(n_t) / n_i)))
    beyond = Incidence.from_degrees(np.linspace(np.nextafter(angle, 91.0), 90.0, 50))
    assert is_totally_reflected(interface, beyond).all()
    energy = power(interface, beyond)
    assert np.all(energy.R == 1.0)
    assert np.all(energy.T == 0.0)
    below = Incidence.from_degrees(np.linspace(0.0, np.nextafter(angle, 0.0), 50))
    assert not is_totally_reflected(interface, below).any()
    assert np.all(power(interface, below).T > 0.0)


@pytest.mark.parametrize(("n_i", "n_t", "k_t"), [(1.0, 1.0, 0.0), (1.0, 1.5, 0.0), (1.5, 1.0, 1.0)])
def test_no_critical_angle(n_i: float, n_t: float, k_t: float) -> None:
    interface = Interface(n_i, n_t, k_t)
    assert np.isnan(critical_deg(interface))
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 91))
    assert not is_totally_reflected(interface, incidence).any()


def test_no_brewster_angle_in_absorbers() -> None:
    angles = brewster_deg(Interface(1.0, 1.5, [0.0, 1e-9, 2.0]))
    assert np.array_equal(np.isnan(angles), [False, True, True])


@pytest.mark.parametrize("row", GOLDEN, ids=lambda row: f"{row['n_t']}+{row['k_t']}i")
def test_golden_pseudo_brewster_angles(row: dict[str, Any]) -> None:
    angle = pseudo_brewster_deg(Interface(row["n_i"], row["n_t"], row["k_t"]))
    assert float(angle) == pytest.approx(row["deg"], abs=ANGLE_DEG)


@pytest.mark.parametrize("n_t", [1e-3, 0.05, 0.5, 1.0, 1.5, 4.0, 30.0, 100.0])
@pytest.mark.parametrize("k_t", [1e-6, 1e-2, 0.3, 1.0, 3.0, 10.0, 100.0])
def test_pseudo_brewster_is_the_least_Rp_there_is(n_t: float, k_t: float) -> None:
    interface = Interface(1.0, n_t, k_t)
    angle = float(pseudo_brewster_deg(interface))
    least = float(power(interface, Incidence.from_degrees(angle)).Rp)
    everywhere = np.concatenate([np.linspace(0.0, 90.0, 9001), 90.0 - np.geomspace(1e-6, 1.0, 999)])
    others = power(interface, Incidence.from_degrees(everywhere)).Rp
    assert least <= float(np.min(others)) * (1.0 + 1e-9)


@pytest.mark.parametrize(
    ("n_i", "n_t", "k_t"),
    [
        (100.0, 1e-3, 1e-15),  # 5.7e-4 degrees from normal incidence
        (1e-3, 100.0, 1e-9),
        (1.0, 1.0 + 1e-9, 1e-9),  # an Rp of 1e-18 at most
        (1.0, 1.0 - 1e-9, 3e-9),
        (1.5, 1.5, 1e-6),
        (1.0, 1.5, 1e-6),
    ],
)
def test_pseudo_brewster_of_faint_absorption_is_brewsters(
    n_i: float, n_t: float, k_t: float
) -> None:
    lossless = float(brewster_deg(Interface(n_i, n_t)))
    assert float(pseudo_brewster_deg(Interface(n_i, n_t))) == lossless
    angle = float(pseudo_brewster_deg(Interface(n_i, n_t, k_t)))
    assert angle == pytest.approx(lossless, rel=1e-11)


def test_pseudo_brewster_moves_where_absorption_blurs_the_critical_angle() -> None:
    """Brewster's angle is a 5e-11th part before the critical one; the least R_p in 60 digits."""
    angle = float(pseudo_brewster_deg(Interface(100.0, 1e-3, 1e-12)))
    assert angle == pytest.approx(0.00057295779479033878, rel=1e-14)


def ahead_of_90(n_t: float, k_t: float, degrees: mpf) -> mpf:
    """Cosine of the phase of r_p / r_s by the textbook quotients: -1 at 0 degrees, 1 at 90."""
    square, theta = mpc(n_t, k_t) ** 2, mp.radians(degrees)
    q = mp.sqrt(square - mp.sin(theta) ** 2)
    r_s = (mp.cos(theta) - q) / (mp.cos(theta) + q)
    r_p = (square * mp.cos(theta) - q) / (square * mp.cos(theta) + q)
    return mp.cos(mp.arg(r_p / r_s))


@pytest.mark.parametrize(
    ("n_t", "k_t"),
    [
        (1.5, 1e-6),
        (1.5, 0.3),
        (0.27, 2.9),
        (2.9, 3.0),
        (1e-3, 1e-3),
        (1e-3, 5.0),
        (1.0, 1e-6),
        (30.0, 100.0),
        (100.0, 1e-2),
        (1e-3, 100.0),
        (0.3, 1e-4),  # three angles from here on: the smallest
        (0.35, 0.01),
        (0.43, 0.05),
        (0.05, 1e-3),
        (0.4, 0.2),  # and one again
    ],
)
def test_principal_angle_is_the_first_where_the_phases_are_90_degrees_apart(
    n_t: float, k_t: float
) -> None:
    angle = float(principal_deg(Interface(1.0, n_t, k_t)))
    with mp.workdps(50):
        assert ahead_of_90(n_t, k_t, angle * mpf(1 - 1e-12)) < 0
        assert ahead_of_90(n_t, k_t, angle * mpf(1 + 1e-12)) > 0
        assert all(ahead_of_90(n_t, k_t, mpf(angle) * i / 200) < 0 for i in range(1, 200))


def test_three_principal_angles_of_30_degrees_are_one() -> None:
    """N^2 = (5 + i sqrt(2))/27, where three angles coincide [Azzam 1981, abstract]."""
    index = np.sqrt((5.0 + 1j * np.sqrt(2.0)) / 27.0)
    # A triple root is known to a third of the digits.
    assert float(principal_deg(Interface(1.0, index.real, index.imag))) == pytest.approx(
        30.0, abs=1e-4
    )


@pytest.mark.parametrize(
    ("n_i", "n_t", "k_t"),
    [(1.0, 1.5, 1e-9), (1.5, 1.0, 1e-9), (10.0, 0.5, 1e-9), (1e-3, 100.0, 1e-9)],
)
def test_principal_becomes_brewsters_without_absorption(n_i: float, n_t: float, k_t: float) -> None:
    lossless = float(brewster_deg(Interface(n_i, n_t)))
    assert float(principal_deg(Interface(n_i, n_t))) == lossless
    assert float(principal_deg(Interface(n_i, n_t, k_t))) == pytest.approx(lossless, rel=1e-11)


@pytest.mark.parametrize("k_t", [10.0, 100.0])
def test_principal_angle_of_strong_absorbers(k_t: float) -> None:
    """For large |N| sin tan = |N| (1 + O(|N|^-2)), as books on metals print it."""
    n_t = 0.3 * k_t
    theta = np.radians(principal_deg(Interface(1.0, n_t, k_t)))
    size = np.hypot(n_t, k_t)
    assert np.sin(theta) * np.tan(theta) == pytest.approx(size, rel=1.0 / size**2)


def test_angles_broadcast() -> None:
    interface = Interface([[1.0], [1.5]], [1.2, 1.5, 1.8], [[0.0], [0.5]])
    for angle in LANDMARKS.values():
        values = angle(interface)
        assert values.shape == (2, 3)
        each = Interface(1.5, 1.2, 0.5)
        assert np.array_equal(values[1, 0], angle(each), equal_nan=True)


def test_phases_of_total_internal_reflection() -> None:
    """tan(delta_s / 2) = sqrt(sin^2 - eta^2) / cos, tan(delta_p / 2) = that / eta^2 [Born, Wolf]."""
    eta, theta = 1.0 / 1.5, np.radians(np.array([45.0, 60.0, 80.0]))
    amplitude = amplitudes(Interface(1.5, 1.0), Incidence.from_degrees(np.degrees(theta)))
    root = np.sqrt(np.sin(theta) ** 2 - eta**2) / np.cos(theta)
    assert np.allclose(np.angle(amplitude.r_s), -2.0 * np.arctan(root), rtol=1e-12)
    # In the convention r_p = -r_s at normal incidence, r_p is +exp(-i delta_p).
    assert np.allclose(np.angle(amplitude.r_p), -2.0 * np.arctan(root / eta**2), rtol=1e-12)


def test_fresnels_rhomb() -> None:
    """Two reflections at 54.6 degrees in glass of 1.51 turn linear into circular light."""
    amplitude = amplitudes(Interface(1.51, 1.0), Incidence.from_degrees(54.6228))
    shift = np.degrees(np.angle(amplitude.r_p / amplitude.r_s))
    assert abs(float(shift)) == pytest.approx(45.0, abs=0.02)


def test_F82_is_the_reflectance_at_one_seventh() -> None:
    interface = Interface(1.0, [0.2, 1.5], [3.0, 0.0])
    incidence = Incidence.from_degrees(np.degrees(np.arccos(MU_BAR)))
    assert np.allclose(F82(interface), power(interface, incidence).R, rtol=1e-12)


@pytest.mark.parametrize(
    ("n_i", "n_t", "k_t", "s", "p"),
    [
        (1.5, 1.0, 0.0, -180.0, -180.0),
        (1.0, 1.5, 0.0, 180.0, 180.0),
        (1.0, 0.27, 2.9, -180.0, 180.0),
        (1.0, 1.0, 0.3, -180.0, -180.0),  # |q| < 1: the p wave's curve ends below, too
        (1.33, 2.9, 3.0, -180.0, 180.0),
    ],
)
def test_phases_do_not_jump_at_90_degrees(
    n_i: float, n_t: float, k_t: float, s: float, p: float
) -> None:
    angles = Incidence.from_degrees(np.array([90.0 - 1e-6, 90.0]))
    found = amplitudes(Interface(n_i, n_t, k_t), angles)
    for r, end in ((found.r_s, s), (found.r_p, p)):
        before, at = phase_deg(r)
        assert before == pytest.approx(end, abs=1e-5)
        assert at == end
