"""Films against 25 digits, against tmm, and against what has to hold for every stack."""

import json
import tracemalloc
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tmm
from hypothesis import given
from hypothesis import strategies as st

from app.optics.amplitudes import amplitudes as boundary_amplitudes
from app.optics.amplitudes import phase_deg
from app.optics.amplitudes import power as boundary_power
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.films import absorption, amplitudes, power
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.stack import Layer, Stack

GOLDEN: list[dict[str, Any]] = json.loads(
    (Path(__file__).parent / "reference" / "films.json").read_text("utf-8")
)["cases"]

RELATIVE = 1e-12
AMPLITUDE = 1e-11
# What 1 - R - T leaves of 0 in the reference.
ZERO = 1e-40
# Identities between numbers that are each right to a few units in the last place.
IDENTITY = 2e-13
NORMAL = Incidence.from_degrees(0.0)


def stack_of(case: dict[str, Any]) -> Stack:
    layers = [Layer(each["n"], each["k"], each["thickness_nm"]) for each in case["layers"]]
    wavelength_nm = case["wavelength_nm"]
    return Stack(case["n_i"], layers, case["n_t"], case["k_t"], wavelength_nm=wavelength_nm)


@pytest.mark.parametrize("many", [False, True], ids=["one ray", "an array"])
@pytest.mark.parametrize("case", GOLDEN, ids=[str(i) for i in range(len(GOLDEN))])
def test_reference_values(case: dict[str, Any], many: bool) -> None:
    """One number takes Python's functions and many take NumPy's."""
    degrees = case["theta_i_deg"]
    incidence = Incidence.from_degrees([degrees] * 3 if many else degrees)
    stack = stack_of(case)
    energy, lost, amplitude = (f(stack, incidence) for f in (power, absorption, amplitudes))
    powers = (energy, ("Rs", "Rp", "Ts", "Tp"), 0.0), (lost, ("As", "Ap"), ZERO)
    for source, names, zero in powers:
        for name in names:
            got = float(np.ravel(getattr(source, name))[-1])
            assert got == pytest.approx(float(case[name]), rel=RELATIVE, abs=zero), name
    for name in ("r_s", "r_p"):
        expected = complex(*map(float, case[name]))
        assert complex(np.ravel(getattr(amplitude, name))[-1]) == pytest.approx(
            expected, rel=AMPLITUDE
        )


def test_golden_values_cover_what_is_difficult() -> None:
    assert len(GOLDEN) == 54
    layers = [layer for case in GOLDEN for layer in case["layers"]]
    assert any(layer["thickness_nm"] == 0.0 for layer in layers)
    assert any(layer["k"] > 3.0 and layer["thickness_nm"] == 5000.0 for layer in layers)
    assert max(case["theta_i_deg"] for case in GOLDEN) > 89.0


def test_without_layers_it_is_the_boundary_to_the_last_bit() -> None:
    rng = np.random.default_rng(1)
    n_i, n_t, k_t = rng.uniform(0.3, 3.0, (3, 40, 1))
    k_t[::2] = 0.0
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 91))
    interface, stack = Interface(n_i, n_t, k_t), Stack(n_i, (), n_t, k_t)
    for ours, theirs, names in (
        (power(stack, incidence), boundary_power(interface, incidence), ("R", "Rs", "Rp", "T")),
        (
            amplitudes(stack, incidence),
            boundary_amplitudes(interface, incidence),
            ("r_s", "r_p", "t_s", "t_p"),
        ),
    ):
        for name in names:
            np.testing.assert_array_equal(getattr(ours, name), getattr(theirs, name))


@pytest.mark.parametrize("theta_i_deg", [0.0, 30.0, 56.30993247402021, 89.99, 90.0])
@pytest.mark.parametrize("k_t", [0.0, 1e-7, 2.0])
def test_layers_of_no_thickness_change_nothing(theta_i_deg: float, k_t: float) -> None:
    layers = [Layer(2.0, 0.3, 0.0), Layer(1.2, 0.0, 0.0), Layer(0.2, 3.0, 0.0)]
    incidence = Incidence.from_degrees(theta_i_deg)
    energy = power(Stack(1.0, layers, 1.5, k_t), incidence)
    expected = boundary_power(Interface(1.0, 1.5, k_t), incidence)
    for name in ("Rs", "Rp", "Ts", "Tp"):
        assert float(getattr(energy, name)) == pytest.approx(
            float(getattr(expected, name)), rel=RELATIVE, abs=1e-40
        )


def random_stack(rng: np.random.Generator) -> tuple[list[complex], list[float], float, float]:
    """Indices from front to back, thicknesses, angle and wavelength: metals, films, thick glass."""
    n = [complex(rng.choice([1.0, 1.33, 1.5]))]
    d = [np.inf]
    for _ in range(rng.integers(1, 9)):
        if rng.uniform() < 0.3:
            n.append(complex(rng.uniform(0.05, 3.0), rng.uniform(0.5, 6.0)))
            d.append(rng.uniform(1.0, 40.0))
        else:
            faint = rng.choice([0.0, np.exp(rng.uniform(np.log(1e-4), np.log(0.1)))])
            n.append(complex(rng.uniform(1.2, 3.0), faint))
            d.append(np.exp(rng.uniform(np.log(2.0), np.log(1500.0))))
    n.append(complex(rng.uniform(1.0, 4.0), rng.choice([0.0, rng.uniform(0.0, 5.0)])))
    d.append(np.inf)
    return n, d, float(rng.uniform(0.0, 85.0)), float(rng.uniform(380.0, 780.0))


def test_200_random_stacks_agree_with_tmm() -> None:
    """S. J. Byrnes' tmm, with the same time factor, the same sign of r_p and the same t."""
    rng = np.random.default_rng(15)
    for _ in range(200):
        n, d, degrees, wavelength_nm = random_stack(rng)
        layers = [Layer(x.real, x.imag, t) for x, t in zip(n[1:-1], d[1:-1], strict=True)]
        stack = Stack(n[0].real, layers, n[-1].real, n[-1].imag, wavelength_nm=wavelength_nm)
        incidence = Incidence.from_degrees(degrees)
        energy, amplitude, lost = (f(stack, incidence) for f in (power, amplitudes, absorption))
        for polarization in "sp":
            theirs = tmm.coh_tmm(polarization, n, d, np.radians(degrees), wavelength_nm)
            for name in "RT":
                ours = float(getattr(energy, name + polarization))
                assert ours == pytest.approx(float(theirs[name]), rel=RELATIVE, abs=1e-13)
            for name in "rt":
                assert complex(getattr(amplitude, f"{name}_{polarization}")) == pytest.approx(
                    complex(theirs[name]), rel=RELATIVE, abs=1e-13
                )
            in_layers = tmm.absorp_in_each_layer(theirs)[1:-1]
            np.testing.assert_allclose(
                getattr(lost, polarization), in_layers, rtol=RELATIVE, atol=1e-12
            )


def random_pane(rng: np.random.Generator) -> tuple[list[complex], list[float], list[str]]:
    coating = [complex(rng.uniform(1.3, 2.5)), complex(rng.uniform(0.1, 2.0), rng.uniform(1, 4))]
    glass = complex(1.5, rng.choice([0.0, 1e-6, 1e-5]))
    n = [1.0, *coating, glass, coating[0], glass + 0.2, 1.0 if rng.uniform() < 0.5 else 1.4 + 2j]
    d = [np.inf, 90.0, 8.0, 2e5, 120.0, 5e4, np.inf]
    return n, d, ["i", "c", "c", "i", "c", "i", "i"]


def test_stacks_with_thick_layers_agree_with_tmm() -> None:
    rng = np.random.default_rng(16)
    for _ in range(40):
        n, d, kinds = random_pane(rng)
        degrees, wavelength_nm = float(rng.uniform(0.0, 80.0)), float(rng.uniform(400.0, 700.0))
        layers = [
            Layer(x.real, x.imag, t, incoherent=kind == "i")
            for x, t, kind in list(zip(n, d, kinds, strict=True))[1:-1]
        ]
        stack = Stack(1.0, layers, n[-1].real, n[-1].imag, wavelength_nm=wavelength_nm)
        incidence = Incidence.from_degrees(degrees)
        energy, lost = power(stack, incidence), absorption(stack, incidence)
        for polarization in "sp":
            theirs = tmm.inc_tmm(polarization, n, d, kinds, np.radians(degrees), wavelength_nm)
            R, T = (float(getattr(energy, x + polarization)) for x in "RT")
            assert pytest.approx(float(theirs["R"]), rel=RELATIVE) == R
            assert pytest.approx(float(theirs["T"]), rel=RELATIVE) == T
            A = float(np.sum(getattr(lost, polarization)))
            assert pytest.approx(1.0, abs=IDENTITY) == R + T + A


def test_an_incoherent_layer_is_the_mean_over_its_phase() -> None:
    """The trapezoidal rule over a period, of what the coherent layer does."""
    glass, angle = 1.52 + 0.01j, 50.0
    q = np.sqrt(glass**2 - np.sin(np.radians(angle)) ** 2).real
    period = 550.0 / (2.0 * q)
    thickness = 9000.0 + np.arange(64) * period / 64
    outer = (Layer(2.2, 0.0, 60.0), Layer(0.1, 3.0, 10.0))
    incidence = Incidence.from_degrees(angle)

    def layers(thickness_nm: Any, k: float, incoherent: bool) -> list[Layer]:
        thick = Layer(1.52, k, thickness_nm, incoherent=incoherent)
        return [outer[0], thick, outer[1]]

    # Without absorption nothing but the phase changes over the period.
    coherent = power(Stack(1.0, layers(thickness, 0.0, False), 1.7, wavelength_nm=550.0), incidence)
    thick = Stack(1.0, layers(9000.0, 0.0, True), 1.7, wavelength_nm=550.0)
    energy, lost = power(thick, incidence), absorption(thick, incidence)
    for name in ("Rs", "Rp", "Ts", "Tp"):
        mean = float(np.mean(getattr(coherent, name)))
        assert float(getattr(energy, name)) == pytest.approx(mean, abs=2e-4)
    of_coherent = absorption(
        Stack(1.0, layers(thickness, 0.0, False), 1.7, wavelength_nm=550.0), incidence
    )
    for ours, theirs in zip(lost.layers, of_coherent.layers, strict=True):
        assert float(ours) == pytest.approx(float(np.mean(theirs)), abs=2e-4)


def test_at_the_critical_angle_of_an_inner_layer() -> None:
    """There five packages answer R = 1 and R + T = 3.45."""
    gap = Stack(1.5, [Layer(1.0, 0.0, 100.0)], 1.5, wavelength_nm=550.0)
    incidence = Incidence.from_radians(np.arcsin(1.0 / 1.5))
    energy, amplitude = power(gap, incidence), amplitudes(gap, incidence)
    assert round(float(energy.Rs), 8) == 0.28968943
    assert round(float(energy.Rp), 8) == 0.07455392
    assert float(energy.Rs + energy.Ts) == pytest.approx(1.0, abs=IDENTITY)
    assert abs(amplitude.r_p) ** 2 == pytest.approx(energy.Rp, rel=RELATIVE)
    beside = power(gap, Incidence.from_radians(np.arcsin(1.0 / 1.5) + 1e-9))
    assert float(beside.Rs) == pytest.approx(float(energy.Rs), abs=1e-7)


def test_what_enters_an_absorber_is_what_is_not_reflected() -> None:
    """Three packages answer R_p + T_p = 0.939."""
    for layers in ((), [Layer(1.38, 0.0, 0.0)], [Layer(1.38, 0.0, 80.0)]):
        energy = power(Stack(1.0, layers, 2.0, 1.0), Incidence.from_degrees(60.0))
        assert float(energy.Rp + energy.Tp) == pytest.approx(1.0, abs=IDENTITY)


@pytest.mark.parametrize("polarization", ["s", "p"])
def test_thick_silver_lets_through_as_much_less_as_it_is_thicker(polarization: str) -> None:
    """From 600 nm on nothing comes back from behind: T falls by exp(-4 pi Im(q) d / wavelength)."""
    incidence = Incidence.from_degrees(40.0)
    q = np.sqrt((0.055 + 3.32j) ** 2 - incidence.sin**2)

    def T(thickness_nm: float) -> float:
        film = Layer(0.055, 3.32, thickness_nm)
        energy = power(Stack(1.0, [film], 1.52, wavelength_nm=550.0), incidence)
        return float(getattr(energy, f"T{polarization}"))

    for thickness_nm in (900.0, 5000.0):
        fall = np.exp(-4.0 * np.pi * q.imag * (thickness_nm - 600.0) / 550.0)
        assert T(thickness_nm) == pytest.approx(T(600.0) * fall, rel=1e-11, abs=0.0)
    assert T(20_000.0) == 0.0 or T(20_000.0) < 1e-300
    for degrees in (0.0, [0.0, 0.0]):
        thick = Stack(1.0, [Layer(0.055, 3.32, 900.0)], 1.5, wavelength_nm=550.0)
        theirs = tmm.coh_tmm("s", [1.0, 0.055 + 3.32j, 1.5], [np.inf, 900.0, np.inf], 0.0, 550.0)
        found = np.ravel(power(thick, Incidence.from_degrees(degrees)).T)[-1]
        assert found == pytest.approx(theirs["T"], rel=RELATIVE, abs=0.0)
    wide = Stack(1.0, [Layer(0.055, 3.32, 20_000.0)], 1.52, wavelength_nm=550.0)
    assert float(absorption(wide, incidence).A) == pytest.approx(
        1.0 - float(power(wide, incidence).R), rel=RELATIVE
    )


@pytest.mark.parametrize("degrees", [50.0, [50.0, 50.0]], ids=["one ray", "an array"])
@pytest.mark.parametrize("polarization", ["s", "p"])
def test_what_lies_behind_thick_silver_absorbs_its_share_of_nearly_nothing(
    polarization: str, degrees: float | list[float]
) -> None:
    films = [(0.055, 3.32, 600.0), (1.5, 0.1, 100.0), (0.2, 3.0, 20.0)]
    stack = Stack(1.0, [Layer(*film) for film in films], 1.5, wavelength_nm=550.0)
    found = getattr(absorption(stack, Incidence.from_degrees(degrees)), polarization)
    indices = [1.0, *(complex(n, k) for n, k, _ in films), 1.5]
    thick = [np.inf, *(nm for *_, nm in films), np.inf]
    theirs = tmm.coh_tmm(polarization, indices, thick, np.radians(50.0), 550.0)
    expected = tmm.absorp_in_each_layer(theirs)[1:-1]
    np.testing.assert_allclose([np.ravel(A)[-1] for A in found], expected, rtol=1e-10)


def test_an_absorbing_incident_medium_along_the_normal_and_nowhere_else() -> None:
    film = [Layer(1.38, 0.0, 100.0)]
    stack = Stack(1.5, film, 1.52, wavelength_nm=550.0, k_i=0.1)
    energy = power(stack, NORMAL)
    assert round(float(energy.Rs), 8) == round(float(energy.Rp), 8) == 0.00940097
    assert round(float(energy.Ts), 8) == round(float(energy.Tp), 8) == 0.99507503
    r, t = amplitudes(stack, NORMAL).r_s, amplitudes(stack, NORMAL).t_s
    theirs = tmm.coh_tmm("s", [1.5 + 0.1j, 1.38, 1.52], [np.inf, 100.0, np.inf], 0.0, 550.0)
    assert complex(r) == pytest.approx(complex(theirs["r"]), rel=RELATIVE)
    assert complex(t) == pytest.approx(complex(theirs["t"]), rel=RELATIVE)
    with pytest.raises(NotAllowed, match="incident wave is not uniform along the surface"):
        power(stack, Incidence.from_degrees([0.0, 30.0]))


def test_an_incoherent_layer_has_no_amplitudes() -> None:
    pane = Stack(1.0, [Layer(1.5, 0.0, 3e6, incoherent=True)], 1.0)
    with pytest.raises(NotAllowed, match="no amplitudes and no phases"):
        amplitudes(pane, NORMAL)
    assert float(power(pane, NORMAL).R) == pytest.approx(2 * 0.04 / 1.04, rel=RELATIVE)
    assert float(power(pane, Incidence.from_degrees(90.0)).R) == 1.0


def test_a_thick_layer_beyond_its_critical_angle_lets_nothing_through() -> None:
    incidence = Incidence.from_degrees([0.0, 40.0, 45.0, 80.0, 90.0])
    gap = Stack(1.5, [Layer(1.0, 0.0, 1e6, incoherent=True)], 1.5)
    R = power(gap, incidence).R
    assert R[0] == pytest.approx(2 * 0.04 / 1.04, rel=RELATIVE)
    np.testing.assert_array_equal(R[2:], 1.0)


def test_a_thick_layer_from_which_nothing_leaks() -> None:
    """Light that is shut in by total reflection on one side and a wide gap on the other."""
    films = [
        Layer(0.691, 0.0, 952.0),
        Layer(82.8, 0.0, 1e6, incoherent=True),
        Layer(1.0, 0.0, 1e9),
        Layer(1.5, 0.0, 1e6, incoherent=True),
    ]
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 91))
    energy = power(Stack(1.25, films, 1.0, wavelength_nm=296.0), incidence)
    for R, T in ((energy.Rs, energy.Ts), (energy.Rp, energy.Tp)):
        assert np.all((R >= 0.0) & (R <= 1.0 + IDENTITY))
        assert np.all((T >= 0.0) & (T <= 1.0))


def test_200_layers() -> None:
    """A mirror of quarter waves, whose field falls by (2.35 / 1.38)^100, and one of no order."""
    pair = [Layer(2.35, 0.0, 550.0 / 4 / 2.35), Layer(1.38, 0.0, 550.0 / 4 / 1.38)]
    mirror = Stack(1.0, pair * 100, 1.52, wavelength_nm=550.0)
    y = (2.35 / 1.38) ** 200 * 1.52
    assert float(power(mirror, NORMAL).T) == pytest.approx(4.0 / y, rel=1e-10, abs=0.0)
    assert float(np.ravel(power(mirror, Incidence.from_degrees([0.0])).T)[0]) == pytest.approx(
        4.0 / y, rel=1e-10, abs=0.0
    )
    rng = np.random.default_rng(2)
    layers = [
        Layer(n, k, d)
        for n, k, d in zip(
            rng.uniform(1e-3, 5.0, 200), rng.choice([0.0, 1e-4], 200), rng.uniform(0, 400, 200),
            strict=True,
        )
    ]  # fmt: skip
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 91))
    stack = Stack(1.0, layers, 1.52, wavelength_nm=550.0)
    energy, lost = power(stack, incidence), absorption(stack, incidence)
    for R, T, A in ((energy.Rs, energy.Ts, lost.As), (energy.Rp, energy.Tp, lost.Ap)):
        np.testing.assert_allclose(R + T + A, 1.0, atol=1e-11)


def test_grazing_light_is_reflected_but_where_nothing_is_in_the_way() -> None:
    grazing = Incidence.from_degrees(90.0)
    soap = Stack(1.0, [Layer(1.33, 0.0, 380.0)], 1.0)
    assert (float(power(soap, grazing).R), float(power(soap, grazing).T)) == (1.0, 0.0)
    assert complex(amplitudes(soap, grazing).r_s) == -1.0
    silver = Stack(1.0, [Layer(0.055, 3.32, 30.0)], 1.5)
    for name in ("r_s", "r_p"):
        phases = [
            float(phase_deg(getattr(amplitudes(silver, Incidence.from_degrees(angle)), name)))
            for angle in (89.9999, 90.0)
        ]
        assert phases[0] == pytest.approx(phases[1], abs=0.01), name
    for layer in (Layer(1.0, 0.0, 500.0), Layer(1.0, 0.0, 0.0)):
        nothing = Stack(1.0, [layer], 1.0)
        energy = power(nothing, Incidence.from_degrees([0.0, 60.0, 90.0]))
        np.testing.assert_array_equal(energy.R, 0.0)
        np.testing.assert_allclose(energy.T, 1.0, rtol=IDENTITY)


@pytest.mark.parametrize("n_t", [1.5, 1.0, 0.9])
def test_grazing_light_comes_through_a_thick_layer_of_its_own_index(n_t: float) -> None:
    """As if the layer were not there: no boundary, and no 0/0, between two media that are one."""
    layers = [Layer(1.0, 0.0, 1e6, incoherent=True), Layer(1.0, 0.0, 1e5, incoherent=True)]
    at = Incidence.from_degrees(np.array([30.0, 90.0]))
    found, bare = (power(Stack(1.0, each, n_t), at) for each in (layers, []))
    for name in ("Rs", "Rp", "Ts", "Tp"):
        np.testing.assert_allclose(getattr(found, name), getattr(bare, name), atol=1e-15)


def test_a_film_that_hardly_differs_keeps_its_digits() -> None:
    """R of a step of 1e-9 there and back is 4 (1e-9/3)^2 sin^2(delta), far below one bit of 1."""
    step = 1e-9
    film = Stack(1.5, [Layer(1.5 + step, 0.0, 100.0)], 1.5, wavelength_nm=550.0)
    exact_step = (1.5 + step) - 1.5
    expected = 4.0 * (exact_step / 3.0) ** 2 * np.sin(2.0 * np.pi * 1.5 * 100.0 / 550.0) ** 2
    assert float(power(film, NORMAL).R) == pytest.approx(expected, rel=1e-8)


def test_total_reflection_is_frustrated_by_a_narrow_gap_alone() -> None:
    incidence = Incidence.from_degrees(45.0)
    gaps = np.array([0.0, 10.0, 100.0, 1e3, 1e4, 1e6])
    energy = power(Stack(1.5, [Layer(1.0, 0.0, gaps)], 1.5, wavelength_nm=550.0), incidence)
    assert float(energy.R[0]) == 0.0
    assert np.all(np.diff(energy.Rs) >= 0.0)
    assert float(energy.R[-1]) == 1.0
    np.testing.assert_allclose(energy.Rs + energy.Ts, 1.0, atol=IDENTITY)


films = st.builds(
    Layer,
    st.floats(1e-3, 100.0),
    st.just(0.0) | st.floats(1e-9, 100.0),
    st.just(0.0) | st.floats(1e-3, 1e7),
)
panes = st.builds(
    Layer,
    st.floats(1.0, 3.0),
    st.just(0.0) | st.floats(1e-9, 1e-3),
    st.floats(1e4, 1e7),
    incoherent=st.just(True),
)


@given(
    st.floats(1e-3, 100.0),
    st.lists(films | panes, max_size=4),
    st.floats(1e-3, 100.0),
    st.just(0.0) | st.floats(1e-9, 100.0),
    st.sampled_from([0.0, 45.0, 90.0]) | st.floats(0.0, 90.0),
)
def test_powers_are_parts_of_what_comes(
    n_i: float, between: list[Layer], n_t: float, k_t: float, degrees: float
) -> None:
    stack = Stack(n_i, between, n_t, k_t)
    for incidence in (Incidence.from_degrees(degrees), Incidence.from_degrees([degrees])):
        energy, lost = power(stack, incidence), absorption(stack, incidence)
        for R, T, A in ((energy.Rs, energy.Ts, lost.As), (energy.Rp, energy.Tp, lost.Ap)):
            parts = [float(np.ravel(part)[0]) for part in (R, T, A)]
            assert all(-1e-9 <= part <= 1.0 + 1e-9 for part in parts), parts


def test_everything_broadcasts_and_pieces_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    wavelength_nm = np.linspace(400.0, 700.0, 7)[:, np.newaxis, np.newaxis]
    thickness_nm = np.linspace(0.0, 300.0, 5)[:, np.newaxis]
    incidence = Incidence.from_degrees(np.linspace(0.0, 90.0, 4))
    n = 1.4 + 3000.0 / wavelength_nm**2

    def stack(i: Any = slice(None), j: Any = slice(None)) -> Stack:
        first = Layer(n[i], 0.01, thickness_nm[j])
        second = Layer(2.0, 0.0, 50.0)
        at = wavelength_nm[i]
        return Stack(1.0, [first, second], 0.2 + at / 2000.0, at / 200.0, wavelength_nm=at)

    whole = power(stack(), incidence)
    lost, amplitude = absorption(stack(), incidence), amplitudes(stack(), incidence)
    assert whole.Rp.shape == lost.A.shape == amplitude.t_p.shape == (7, 5, 4)
    for i, j in product(range(7), range(5)):
        one = power(stack(slice(i, i + 1), slice(j, j + 1)), incidence)
        np.testing.assert_allclose(one.Rp[0, 0], whole.Rp[i, j], rtol=1e-13, atol=1e-16)
    monkeypatch.setattr("app.optics.films.VALUES", 10)
    np.testing.assert_allclose(power(stack(), incidence).Rp, whole.Rp, rtol=1e-13)
    np.testing.assert_allclose(absorption(stack(), incidence).A, lost.A, rtol=1e-12)
    np.testing.assert_allclose(amplitudes(stack(), incidence).t_p, amplitude.t_p, rtol=1e-12)


@pytest.mark.parametrize(
    ("n", "k", "thickness_nm", "told"),
    [
        (0.0, 0.0, 1.0, "n = 0"),
        (1.5, -0.1, 1.0, "k = -0.1"),
        (1.5, 0.0, -1.0, "thickness_nm = -1"),
        (1.5, 0.0, np.nan, "thickness_nm = nan"),
    ],
)
def test_what_a_layer_cannot_be_is_refused_by_name(
    n: float, k: float, thickness_nm: float, told: str
) -> None:
    with pytest.raises(OutOfRange, match=f"^{told}"):
        Layer(n, k, thickness_nm)


def test_what_fades_within_a_few_waves_is_not_incoherent() -> None:
    with pytest.raises(OutOfRange, match=r"^k = 0\.5 is not allowed: at most 0\.01 n"):
        Layer(1.5, 0.5, 1e6, incoherent=True)


def test_memory_is_less_than_three_times_the_answer() -> None:
    at = np.linspace(400.0, 800.0, 1000)[:, np.newaxis]
    film = Layer(1.38 + 3000.0 / at**2, 0.0, 100.0)
    stack = Stack(1.0, [film], 0.2 + at / 2000.0, at / 200.0, wavelength_nm=at)
    incidence = Incidence.from_degrees(np.linspace(0.0, 89.0, 100))
    power(stack, incidence)
    tracemalloc.start()
    energy = power(stack, incidence)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 3 * 5 * energy.R.nbytes
