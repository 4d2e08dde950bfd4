"""What holds for every interface and angle, tried on indices and angles drawn by hypothesis."""

import cmath
from math import isclose

import numpy as np
import pytest
import tmm
from hypothesis import assume, given
from hypothesis import strategies as st

from app.optics.amplitudes import amplitudes, power, wave
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.snell import is_totally_reflected, refraction_angle_deg

# Identities between numbers that are each right to a few units in the last place.
IDENTITY = 1e-13
# The refracted angle, rounded to a double, is put in again; near 90 degrees that costs digits.
THERE_AND_BACK = 1e-11
CRITICAL_MARGIN_RAD = 1e-3
# tmm's quotients cancel where the media match and where its arcsine nears 90 degrees.
TMM = 1e-10


def logarithmic(minimum: float, maximum: float) -> st.SearchStrategy[float]:
    exponents = st.floats(np.log10(minimum), np.log10(maximum))
    return exponents.map(lambda x: min(max(float(10.0**x), minimum), maximum))


indices = logarithmic(1e-3, 100.0)
extinctions = st.just(0.0) | logarithmic(1e-9, 100.0)
angles = st.sampled_from([0.0, 45.0, 90.0]) | st.floats(0.0, 90.0)
interfaces = st.builds(Interface, indices, indices, extinctions)
dielectrics = st.builds(Interface, indices, indices)
incidences = angles.map(Incidence.from_degrees)


def is_near_critical(interface: Interface, incidence: Incidence) -> bool:
    critical = np.arcsin(min(float(interface.eta), 1.0))
    return bool(abs(critical - incidence.theta_i) < CRITICAL_MARGIN_RAD)


@given(interfaces, incidences)
def test_powers_lie_within_0_and_1(interface: Interface, incidence: Incidence) -> None:
    energy = power(interface, incidence)
    for value in (energy.Rs, energy.Rp, energy.R, energy.Ts, energy.Tp, energy.T):
        assert 0.0 <= float(value) <= 1.0


@given(interfaces, incidences)
def test_energy_is_conserved(interface: Interface, incidence: Incidence) -> None:
    """R and T are computed apart, from the field on either side."""
    energy = power(interface, incidence)
    assert float(energy.Rs + energy.Ts) == pytest.approx(1.0, abs=IDENTITY)
    assert float(energy.Rp + energy.Tp) == pytest.approx(1.0, abs=IDENTITY)
    assert float(energy.R + energy.T) == pytest.approx(1.0, abs=IDENTITY)


@given(interfaces, incidences)
def test_R_is_the_mean_of_both_polarizations(interface: Interface, incidence: Incidence) -> None:
    energy = power(interface, incidence)
    assert isclose(float(energy.R), float(energy.Rs + energy.Rp) / 2.0, rel_tol=IDENTITY)


@given(interfaces, incidences)
def test_power_is_the_square_of_the_amplitude(interface: Interface, incidence: Incidence) -> None:
    energy, amplitude = power(interface, incidence), amplitudes(interface, incidence)
    assert isclose(abs(complex(amplitude.r_s)) ** 2, float(energy.Rs), rel_tol=IDENTITY)
    assert isclose(abs(complex(amplitude.r_p)) ** 2, float(energy.Rp), rel_tol=IDENTITY)


@given(interfaces, incidences)
def test_tangential_fields_are_continuous(interface: Interface, incidence: Incidence) -> None:
    """Two conditions a polarization: electric and magnetic field along the surface."""
    amplitude, q = amplitudes(interface, incidence), wave(interface, incidence)
    r_s, r_p, t_s, t_p = (
        complex(getattr(amplitude, name)) for name in ("r_s", "r_p", "t_s", "t_p")
    )
    index = complex(interface.eta, interface.kappa)
    qz, c = complex(q.a, q.b), float(incidence.cos)
    assume(c > 0.0 or index != 1.0)  # without a boundary a grazing ray has no normal component
    assert t_s == pytest.approx(1.0 + r_s, abs=IDENTITY)
    assert index * t_p == pytest.approx(1.0 + r_p, abs=IDENTITY)
    assert qz * t_s == pytest.approx(c * (1.0 - r_s), abs=IDENTITY)
    assert qz * t_p == pytest.approx(c * (1.0 - r_p) * index, abs=IDENTITY * abs(index))


@given(dielectrics, incidences)
def test_reflectance_is_reciprocal(interface: Interface, incidence: Incidence) -> None:
    """The same R from the other side, at the refracted angle; t and t' obey Stokes' relations."""
    assume(not is_totally_reflected(interface, incidence))
    below = Incidence.from_degrees(refraction_angle_deg(interface, incidence))
    reverse = Interface(interface.n_t, interface.n_i)
    assume(not is_near_critical(interface, incidence))
    assume(not is_near_critical(reverse, below))
    there, back = power(interface, incidence), power(reverse, below)
    for name in ("Rs", "Rp", "R", "Ts", "Tp", "T"):
        one, other = float(getattr(there, name)), float(getattr(back, name))
        assert one == pytest.approx(other, abs=THERE_AND_BACK)
    forth, return_ = amplitudes(interface, incidence), amplitudes(reverse, below)
    for r, t in (("r_s", "t_s"), ("r_p", "t_p")):
        r_12, r_21 = complex(getattr(forth, r)), complex(getattr(return_, r))
        t_12, t_21 = complex(getattr(forth, t)), complex(getattr(return_, t))
        assert r_21 == pytest.approx(-r_12, abs=THERE_AND_BACK)
        assert t_12 * t_21 == pytest.approx(1.0 - r_12**2, abs=THERE_AND_BACK)


@given(interfaces, incidences, st.integers(-8, 8))
def test_only_the_ratio_of_the_indices_counts(
    interface: Interface, incidence: Incidence, exponent: int
) -> None:
    scale = 2.0**exponent
    n_i, n_t, k_t = (float(n) * scale for n in (interface.n_i, interface.n_t, interface.k_t))
    assume(1e-3 <= n_i <= 100.0 and 1e-3 <= n_t <= 100.0 and k_t <= 100.0)
    one, other = power(interface, incidence), power(Interface(n_i, n_t, k_t), incidence)
    assert isclose(float(one.R), float(other.R), rel_tol=IDENTITY)


@given(dielectrics, incidences)
def test_absorption_sets_in_gradually(interface: Interface, incidence: Incidence) -> None:
    assume(not is_near_critical(interface, incidence))
    lossless = float(power(interface, incidence).R)
    n_i, n_t = float(interface.n_i), float(interface.n_t)
    for k_t in (1e-6, 1e-9, 1e-12):
        R = float(power(Interface(n_i, n_t, k_t), incidence).R)
        # dR/dkappa is largest beside the critical angle, of the order of 1 / sqrt(distance) / eta.
        slope = 1e3 / min(float(interface.eta), 1.0)
        assert abs(R - lossless) <= slope * k_t / n_i + IDENTITY


@given(dielectrics)
def test_Rs_rises_with_the_angle(interface: Interface) -> None:
    Rs = power(interface, Incidence.from_degrees(np.linspace(0.0, 90.0, 181))).Rs
    assert np.all(np.diff(Rs) >= -IDENTITY)


@given(interfaces, incidences)
def test_s_is_never_reflected_less_than_p(interface: Interface, incidence: Incidence) -> None:
    energy = power(interface, incidence)
    assert float(energy.Rs) >= float(energy.Rp) * (1.0 - IDENTITY)


SHAPES = [
    ((), (), (), (7,)),
    ((3, 1), (3, 1), (3, 1), (7,)),
    ((3, 1), (), (3, 1), (1, 7)),
    ((2, 1, 1), (3, 1), (), (7,)),
    ((7,), (7,), (7,), (7,)),
    ((), (5,), (), ()),
    ((), (0,), (), ()),
]


@pytest.mark.parametrize("shapes", SHAPES, ids=str)
def test_shapes_broadcast_and_elements_do_not_meet(shapes: tuple[tuple[int, ...], ...]) -> None:
    rng = np.random.default_rng(3)
    n_i, n_t = (rng.uniform(0.5, 2.5, shape) for shape in shapes[:2])
    k_t = rng.choice([0.0, 1.0], shapes[2])
    theta = rng.uniform(0.0, 90.0, shapes[3])
    interface, incidence = Interface(n_i, n_t, k_t), Incidence.from_degrees(theta)
    energy, amplitude = power(interface, incidence), amplitudes(interface, incidence)
    shape = np.broadcast_shapes(*shapes)
    each = np.broadcast_arrays(n_i, n_t, k_t, theta)
    for source, name in ((energy, "R"), (energy, "T"), (amplitude, "r_p"), (amplitude, "t_s")):
        values = np.asarray(getattr(source, name))
        assert values.shape == shape
        for index in np.ndindex(shape):
            a, b, c, angle = (float(array[index]) for array in each)
            alone = (Interface(a, b, c), Incidence.from_degrees(angle))
            single = power(*alone) if source is energy else amplitudes(*alone)
            expected = complex(getattr(single, name))
            assert cmath.isclose(complex(values[index]), expected, rel_tol=IDENTITY)


@given(
    logarithmic(0.1, 10.0), logarithmic(0.1, 10.0), st.just(0.0) | logarithmic(1e-2, 10.0),
    st.floats(0.0, 89.9),
)  # fmt: skip
def test_the_independent_package_tmm_agrees(
    n_i: float, n_t: float, k_t: float, theta_i_deg: float
) -> None:
    """S. J. Byrnes' tmm, with the same time factor and the same sign of r_p."""
    interface, incidence = Interface(n_i, n_t, k_t), Incidence.from_degrees(theta_i_deg)
    assume(not is_near_critical(interface, incidence))
    assume(abs(n_t - n_i) + k_t > 1e-3 * n_i)
    index, theta_i = complex(n_t, k_t), np.radians(theta_i_deg)
    theta_t = tmm.snell(n_i, index, theta_i)
    amplitude, energy = amplitudes(interface, incidence), power(interface, incidence)
    for polarization in "sp":
        theirs = (polarization, n_i, index, theta_i, theta_t)
        r, t = (complex(getattr(amplitude, f"{x}_{polarization}")) for x in "rt")
        assert r == pytest.approx(complex(tmm.interface_r(*theirs)), abs=TMM)
        assert t == pytest.approx(complex(tmm.interface_t(*theirs)), abs=TMM * abs(t))
        back, on = (float(getattr(energy, f"{x}{polarization}")) for x in "RT")
        assert back == pytest.approx(float(tmm.interface_R(*theirs)), abs=TMM)
        assert on == pytest.approx(float(tmm.interface_T(*theirs)), abs=TMM)
