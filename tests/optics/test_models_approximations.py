"""Every approximation against its formula worked out again in 30-digit arithmetic."""

from collections.abc import Callable

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.models.lazanyi2005 import largest_error_cosine, slope
from app.optics.parameters import Array
from app.optics.registry import default_registry
from app.optics.specular import F82

TOLERANCE = 1e-9  # the bar of the project; what is measured is about 1e-15
ANGLES_DEG = np.linspace(0.0, 90.0, 19)

Media = tuple[float, float, float]
FROM_THIN: list[Media] = [
    (1.0, 1.05, 0.0),
    (1.0, 1.333, 0.0),
    (1.0, 1.5, 0.0),
    (1.333, 2.417, 0.0),
    (1.0, 4.0, 0.0),
    (2.0, 90.0, 0.0),
]
FROM_DENSE: list[Media] = [
    (1.333, 1.0, 0.0),
    (1.5, 1.0, 0.0),
    (2.417, 1.333, 0.0),
    (1.5, 1.49, 0.0),
    (3.5, 1.0, 0.0),
    (50.0, 1.0, 0.0),
]
METALS: list[Media] = [
    (1.0, 1.5, 5.0),
    (1.0, 0.27, 2.9),
    (1.0, 2.9, 3.0),
    (1.333, 0.2, 3.4),
    (1.5, 4.2, 0.9),
    (1.0, 0.05, 4.2),
]
ALL = [*FROM_THIN, *METALS]

mpf = mp.mpf


def exact(media: Media, mu: mp.mpf) -> mp.mpf:
    """R from the complex angle of refraction, by Snell's law and the cosines."""
    n_i, N = mpf(media[0]), mp.mpc(media[1], media[2])
    cos_t = mp.sqrt(1 - (1 - mu**2) * (n_i / N) ** 2)
    r_s = (n_i * mu - N * cos_t) / (n_i * mu + N * cos_t)
    r_p = (N * mu - n_i * cos_t) / (N * mu + n_i * cos_t)
    return (abs(r_s) ** 2 + abs(r_p) ** 2) / 2


def normal(media: Media) -> mp.mpf:
    n_i, N = mpf(media[0]), mp.mpc(media[1], media[2])
    return abs((N - n_i) / (N + n_i)) ** 2


def schlick(media: Media, mu: mp.mpf, F0: mp.mpf | None = None) -> mp.mpf:
    F0 = normal(media) if F0 is None else F0
    return F0 + (1 - F0) * (1 - mu) ** 5


def schlick_tir(media: Media, mu: mp.mpf) -> mp.mpf:
    n_i, n_t, _ = map(mpf, media)
    if n_i <= n_t:
        return schlick(media, mu)
    sin2_t = (1 - mu**2) * (n_i / n_t) ** 2
    return mpf(1) if sin2_t > 1 else schlick(media, mp.sqrt(1 - sin2_t))


def srgb(linear: mp.mpf) -> mp.mpf:
    low = mpf("12.92") * linear
    return (
        low
        if linear <= mpf("0.0031308")
        else mpf("1.055") * linear ** (1 / mpf("2.4")) - mpf("0.055")
    )


def spherical_gaussian(media: Media, mu: mp.mpf) -> mp.mpf:
    exponent = (mpf("-5.55473") * mu - mpf("6.98316")) * mu
    return normal(media) + (1 - normal(media)) * mpf(2) ** exponent


def hoffman(media: Media, mu: mp.mpf) -> mp.mpf:
    F0, F82 = normal(media), exact(media, mpf(1) / 7)
    a = mpf("17.6513846") * (F0 - F82) + mpf("8.16666667") * (1 - F0)
    return schlick(media, mu) - a * mu * (1 - mu) ** 6


def f82_tint(media: Media, mu: mp.mpf) -> mp.mpf:
    bar = mpf(1) / 7
    tint = exact(media, bar) / schlick(media, bar)
    b = schlick(media, bar) * (1 - tint)
    return schlick(media, mu) - mu * (1 - mu) ** 6 / (bar * (1 - bar) ** 6) * b


def pharr_humphreys(media: Media, mu: mp.mpf) -> mp.mpf:
    # |r|^2 of the quotients with the sine neglected: q = N, relative to n_i.
    N = mp.mpc(media[1], media[2]) / mpf(media[0])
    return (abs((mu - N) / (mu + N)) ** 2 + abs((N * mu - 1) / (N * mu + 1)) ** 2) / 2


def complex_dielectric(media: Media, mu: mp.mpf) -> mp.mpf:
    # (r_s^2 + r_p^2) / 2 without moduli, of which evalF is another writing.
    n_i, N = mpf(media[0]), mp.mpc(media[1], media[2])
    cos_t = mp.sqrt(1 - (1 - mu**2) * (n_i / N) ** 2)
    r_s = (n_i * mu - N * cos_t) / (n_i * mu + N * cos_t)
    r_p = (N * mu - n_i * cos_t) / (N * mu + n_i * cos_t)
    return abs(r_s**2 + r_p**2) / 2


def cook_torrance(media: Media, mu: mp.mpf) -> mp.mpf:
    root = mp.sqrt(normal(media))
    index = (1 + root) / (1 - root)
    cos_t = mp.sqrt(1 - (1 - mu**2) / index**2)
    r_s = (mu - index * cos_t) / (mu + index * cos_t)
    r_p = (index * mu - cos_t) / (index * mu + cos_t)
    return (r_s**2 + r_p**2) / 2


def faded(media: Media, mu: mp.mpf) -> mp.mpf:
    F0 = normal(media)
    return F0 + (min(50 * F0, mpf(1)) - F0) * (1 - mu) ** 5


def cut_by_indices(media: Media, mu: mp.mpf) -> mp.mpf:
    F0, difference = normal(media), abs(mpf(media[1]) - mpf(media[0]))
    return F0 + (min(2 * difference, mpf(1)) - F0) * (1 - mu) ** 5


def lazanyi_alpha(media: Media) -> mp.mpf:
    """Alpha by Lagarde's recipe, with the largest error sought in mpmath."""

    def error(mu: mp.mpf) -> mp.mpf:
        return schlick(media, mu) - exact(media, mu)

    grid = [mpf(i) / 400 for i in range(1, 400)]
    best = max(grid, key=error)
    at = mp.findroot(lambda mu: mp.diff(error, mu), best)
    return mp.log(error(at) / (2 * mpf(media[1]) / media[0] * at)) / mp.log(1 - at)


def lazanyi(media: Media, mu: mp.mpf, alpha: mp.mpf) -> mp.mpf:
    return schlick(media, mu) - 2 * mpf(media[1]) / media[0] * mu * (1 - mu) ** alpha


Formula = Callable[[Media, mp.mpf], mp.mpf]
CASES: list[tuple[str, Formula, list[Media]]] = [
    ("schlick", schlick, ALL),
    ("schlick_ior", schlick, ALL),
    ("schlick_tir", schlick_tir, [*FROM_THIN, *FROM_DENSE]),
    ("schlick_wrong_angle", schlick, FROM_DENSE),
    ("schlick_f0_srgb", lambda m, mu: schlick(m, mu, srgb(normal(m))), ALL),
    ("schlick_four_percent", lambda m, mu: schlick(m, mu, mpf("0.04")), ALL),
    ("schlick_f90_50", faded, ALL),
    ("babylon_openpbr", cut_by_indices, FROM_THIN),
    ("constant_f0", lambda m, _: normal(m), ALL),
    ("spherical_gaussian", spherical_gaussian, ALL),
    ("one_minus_cos", lambda _, mu: 1 - mu, FROM_THIN),
    ("hoffman_f82", hoffman, METALS),
    ("f82_tint", f82_tint, METALS),
    ("generalized_schlick", hoffman, ALL),
    ("pharr_humphreys", pharr_humphreys, METALS),
    ("complex_dielectric", complex_dielectric, METALS),
    ("cook_torrance", cook_torrance, ALL),
]


def cosines() -> list[mp.mpf]:
    exact_ends = {0.0: mpf(1), 90.0: mpf(0)}
    return [exact_ends.get(a, mp.cos(mp.radians(mpf(a)))) for a in ANGLES_DEG]


def test_every_formula_is_written_a_second_time() -> None:
    """In the list above, from its source; two have tests of their own."""
    models = {m.id for m in default_registry().values() if m.kind == "approximation"}
    assert models - {case[0] for case in CASES} == {"lazanyi2005", "lut_1d"}


@pytest.mark.parametrize(("model_id", "formula", "interfaces"), CASES, ids=[c[0] for c in CASES])
def test_formula(model_id: str, formula: Formula, interfaces: list[Media]) -> None:
    model, incidence = default_registry()[model_id], Incidence.from_degrees(ANGLES_DEG)
    with mp.workdps(30):
        for media in interfaces:
            expected = [float(formula(media, mu)) for mu in cosines()]
            values = model(Interface(*media), incidence)
            np.testing.assert_allclose(values, expected, rtol=0.0, atol=TOLERANCE)


@pytest.mark.parametrize("media", METALS)
def test_lazanyi(media: Media) -> None:
    model, interface = default_registry()["lazanyi2005"], Interface(*media)
    with mp.workdps(30):
        alpha = lazanyi_alpha(media)
        expected = [float(lazanyi(media, mu, alpha)) for mu in cosines()]
    assert float(model.arguments(interface)["alpha"]) == pytest.approx(float(alpha), rel=1e-9)
    values = model(interface, Incidence.from_degrees(ANGLES_DEG))
    np.testing.assert_allclose(values, expected, rtol=0.0, atol=TOLERANCE)


def test_lazanyi_meets_the_exact_curve_where_schlick_is_worst() -> None:
    registry = default_registry()
    interface = Interface(1.0, [m[1] / m[0] for m in METALS], [m[2] / m[0] for m in METALS])
    incidence = Incidence.from_cosine(largest_error_cosine(interface))
    values = registry["lazanyi2005"](interface, incidence)
    exact_values = registry["exact"](interface, incidence)
    np.testing.assert_allclose(values, exact_values, rtol=0.0, atol=1e-14)


def test_lazanyi_without_a_dip_has_no_alpha_and_says_so() -> None:
    model, interface = default_registry()["lazanyi2005"], Interface(1.0, 0.5, 0.3)
    assert "alpha" in (model.reason_outside(interface) or "")
    assert np.isnan(model(interface, Incidence.from_degrees(45.0)))
    assert np.isfinite(model(interface, Incidence.from_degrees(45.0), alpha=5.0))


def test_slope_of_the_exact_curve() -> None:
    with mp.workdps(30):
        for media in METALS:
            expected = [
                float(mp.diff(lambda mu, m=media: exact(m, mu), x)) for x in (0.1, 0.5, 0.9)
            ]
            values = slope(Interface(*media), Incidence.from_cosine([0.1, 0.5, 0.9]))
            np.testing.assert_allclose(values, expected, rtol=1e-11)


def test_given_parameters_take_the_place_of_the_interface() -> None:
    registry, incidence = default_registry(), Incidence.from_degrees(ANGLES_DEG)
    interface, mu = Interface(1.0, 1.5, 5.0), incidence.cos
    base = 0.9 + 0.1 * (1.0 - mu) ** 5
    hoffman_a = 17.6513846 * (0.9 - 0.8) + 8.16666667 * 0.1
    dip = mu * (1.0 - mu) ** 6
    schlick_curve = registry["schlick"](interface, incidence)
    cases: list[tuple[str, dict[str, float], Array]] = [
        ("hoffman_f82", {"F0": 0.9, "F82": 0.8}, base - hoffman_a * dip),
        (
            "generalized_schlick",
            {"F0": 0.9, "exponent": 3.0, "F90": 0.5, "a": 0.7},
            0.9 - 0.4 * (1.0 - mu) ** 3 - 0.7 * dip,
        ),
        ("lazanyi2005", {"alpha": 7.0, "a": 3.0}, schlick_curve - 3.0 * mu * (1.0 - mu) ** 7),
        ("f82_tint", {"F0": 0.9, "tint": 1.0}, base),
    ]
    for model_id, parameters, expected in cases:
        values = registry[model_id](interface, incidence, **parameters)
        np.testing.assert_allclose(values, expected, rtol=0.0, atol=TOLERANCE, err_msg=model_id)


def test_hoffman_and_f82_tint_are_one_curve() -> None:
    registry, incidence = default_registry(), Incidence.from_degrees(ANGLES_DEG)
    for media in METALS:
        tint = registry["f82_tint"](Interface(*media), incidence)
        same = registry["hoffman_f82"](Interface(*media), incidence)
        np.testing.assert_allclose(tint, same, rtol=0.0, atol=1e-14)
        at_82 = registry["f82_tint"](Interface(*media), Incidence.from_cosine(1.0 / 7.0))
        assert float(at_82) == pytest.approx(float(F82(Interface(*media))), abs=1e-15)


def test_schlick_tir_is_symmetric_in_the_sides() -> None:
    """From the denser side it sees the angle that Schlick sees from the thinner."""
    registry, sine = default_registry(), np.linspace(0.0, 1.0, 11)
    inside = Incidence(np.sqrt(1.0 - (sine / 1.5) ** 2), sine / 1.5)
    outside = Incidence(np.sqrt(1.0 - sine**2), sine)
    values = registry["schlick_tir"](Interface(1.5, 1.0), inside)
    np.testing.assert_allclose(
        values, registry["schlick"](Interface(1.0, 1.5), outside), rtol=0.0, atol=1e-7
    )  # at the critical angle itself the square root turns 1e-16 into 1e-8


def test_every_trap_is_labelled_and_outside_its_domain() -> None:
    traps = [m for m in default_registry().values() if "(trap)" in m.title]
    assert {m.id for m in traps} == {
        "complex_dielectric",
        "schlick_f0_srgb",
        "schlick_four_percent",
        "schlick_wrong_angle",
    }
    for model in traps:
        interface = (
            Interface(1.0, 1.0, 4.0) if "conductor" in model.applies_to else Interface(1.5, 1)
        )
        assert model.reason_outside(interface)


def test_mirror_and_no_boundary_of_cook_and_torrance() -> None:
    model, incidence = (
        default_registry()["cook_torrance"],
        Incidence.from_degrees([0.0, 45.0, 90.0]),
    )
    np.testing.assert_array_equal(model(Interface(), incidence, F0=1.0), 1.0)
    np.testing.assert_array_equal(model(Interface(1.0, 1.0), incidence), 0.0)


@pytest.mark.parametrize(
    ("model_id", "own", "at_80_degrees"),
    [
        ("generalized_schlick", {"F0": 0.02, "F90": 0.5}, 0.20496),
        ("generalized_schlick", {"F0": 0.5, "F90": 0.0}, 0.307338),
        ("generalized_schlick", {"F90": 0.5}, 0.217249),
        ("generalized_schlick", {"F0": 0.02}, 0.397617),
        ("hoffman_f82", {"F0": 0.02}, 0.397617),
        ("f82_tint", {"F0": 0.02}, 0.397617),
    ],
)
def test_the_dip_of_the_interface_is_not_kept_for_ends_that_are_given(
    model_id: str, own: dict[str, float], at_80_degrees: float
) -> None:
    model, incidence = default_registry()[model_id], Incidence.from_degrees(80.0)
    for interface in (Interface(), Interface(1.0, 0.2, 3.0)):
        if "F0" in own or interface.kind == "dielectric":
            value = float(model(interface, incidence, **own))
            assert value == pytest.approx(at_80_degrees, abs=6e-6)
    three = {name: [value, value] for name, value in own.items()}
    assert float(model(Interface(), incidence, **three)[1]) == pytest.approx(
        at_80_degrees, abs=6e-6
    )


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_f82_tint_stays_within_what_can_be_reflected(F0: float, tint: float, mu: float) -> None:
    model = default_registry()["f82_tint"]
    assert 0.0 <= float(model(Interface(), Incidence.from_cosine(mu), F0=F0, tint=tint)) <= 1.0


def test_where_the_curves_of_metals_turn_negative() -> None:
    """As their validity says; a tint of 1 and a white F0 keep R within 0 and 1."""
    registry, incidence = default_registry(), Incidence.from_degrees(np.linspace(0.0, 90.0, 901))
    metal = Interface(1.0, 1.5, 5.0)
    assert np.any(registry["hoffman_f82"](metal, incidence, F0=0.5, F82=0.0) < 0.0)
    white = registry["f82_tint"](
        metal, incidence, F0=1.0, tint=np.linspace(0, 1, 11)[:, np.newaxis]
    )
    assert np.all((white >= -1e-15) & (white <= 1.0))
