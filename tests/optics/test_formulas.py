"""The collection of formulas: nothing registered is missing, nothing said of it is unmeasured."""

import json
import math
from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from mpmath import mp, mpf

from app.optics.albedo import FITS, albedo, coat_split, flatland_albedo
from app.optics.albedo.dielectric import dunkle
from app.optics.albedo.flatland import allen
from app.optics.angles import brewster_deg, critical_deg, principal_deg, pseudo_brewster_deg
from app.optics.color import decode_srgb
from app.optics.conversions import TITLES, Form, convert, know
from app.optics.formulas.collection import Formulas, UnknownFormula, of_model, symbols_of
from app.optics.formulas.formula import Formula
from app.optics.formulas.sources import ADDRESSES, links
from app.optics.formulas.symbols import GLOSSARY, defined, explain, letters
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import Array
from app.optics.registry import ROUNDED_AT, Model, default_registry
from app.optics.snell import penetration_depth_wavelengths, refraction_angle_deg
from app.optics.vectors import reflected, refracted
from tests.optics.reference.fresnel import DIGITS, Reference, fresnel

HERE = Path(__file__).parent / "reference"
MODELS = default_registry()
FORMULAS = Formulas(MODELS)
Media = tuple[float, float, float]
# The best a double can do, and a bound that says so.
LAST_DIGITS = 1e-14

over_formulas = pytest.mark.parametrize("formula", FORMULAS.values(), ids=lambda f: f.id)


def relative(found: float, expected: float) -> float:
    return abs(found - expected) / abs(expected)


# Complete


def test_everything_registered_is_there() -> None:
    expected = {f"model.{name}" for name in MODELS} | {f"albedo.{name}" for name in FITS}
    expected |= {f"conversion.{name}" for name in TITLES}
    expected |= {
        f"angle.{name}" for name in ("brewster", "critical", "pseudo_brewster", "principal")
    }
    assert expected <= set(FORMULAS)


@over_formulas
def test_everything_has_latex_reference_domain_and_measured_error(formula: Formula) -> None:
    assert formula.title
    assert formula.latex
    assert formula.reference
    assert formula.validity.endswith(".")
    assert formula.accuracy, "a formula says how wrong it is"
    for accuracy in formula.accuracy:
        assert 0.0 < accuracy.value < math.inf
        assert accuracy.of
        assert accuracy.over
        assert accuracy.against
    assert links(formula.reference), "a source is to be found by a DOI or an address"


@over_formulas
def test_every_letter_is_explained(formula: Formula) -> None:
    symbols = symbols_of(formula)
    assert [s.latex for s in symbols] == letters(formula.latex)
    assert all(s.meaning for s in symbols)
    # What is declared is there to be used.
    assert {s.latex for s in formula.symbols} - {"n", "k"} <= set(letters(formula.latex))


def test_no_word_of_the_glossary_is_unused() -> None:
    used = {letter for formula in FORMULAS.values() for letter in letters(formula.latex)}
    assert {symbol.latex for symbol in GLOSSARY} <= used


def test_an_unexplained_letter_is_found() -> None:
    with pytest.raises(LookupError, match="Q"):
        explain(r"R=Q\mu", (), ())


def test_letters_and_what_a_formula_defines() -> None:
    latex = (
        r"R_s\approx\frac{t-2\eta}{T_{j+1}},\quad t=\eta^2+\kappa^2,\quad F_0'=\text{tint}\,\bar\mu"
    )
    assert letters(latex) == [
        "R_s",
        "t",
        r"\eta",
        "T_{j+1}",
        r"\kappa",
        "F_0'",
        r"\text{tint}",
        r"\bar\mu",
    ]
    assert defined(latex) == {"t", "F_0'"}


def test_every_address_is_of_a_source() -> None:
    references = [formula.reference for formula in FORMULAS.values()]
    for words, address in ADDRESSES.items():
        assert any(words in reference for reference in references), words
        assert address.startswith("https://")


def test_an_unknown_formula_names_the_nearest() -> None:
    with pytest.raises(UnknownFormula) as caught:
        FORMULAS.find("model.schlik")
    assert caught.value.nearest[0] == "model.schlick"


# Rounding of the exact forms

EXACT_FORMS = [m for m in MODELS.values() if m.kind == "exact"]
STATED = [
    (model, media, most)
    for model in EXACT_FORMS
    for media, most in zip(ROUNDED_AT, model.rounding or (), strict=True)
]


@cache
def by_50_digits(n_i: float, n_t: float, k_t: float) -> list[float]:
    return [fresnel(n_i, n_t, k_t, float(degree)).R for degree in range(90)]


@pytest.mark.parametrize(
    ("model", "media", "most"), STATED, ids=[f"{m.id}-{media[1]:.7g}" for m, media, _ in STATED]
)
def test_stated_rounding_is_measured(model: Model, media: Media, most: float) -> None:
    R = model(Interface(*media), Incidence.from_degrees(np.arange(90.0)))
    error = float(np.nanmax(np.abs(R / np.array(by_50_digits(*media)) - 1.0)))
    assert error <= most
    assert most == LAST_DIGITS or error > most / 30.0


# Errors of the others, each measured by what is said to be the measure


def indices() -> Iterator[tuple[float, float]]:
    """Indices n from 0.05 to 10 and k up to 10."""
    rng = np.random.default_rng(11)
    for n, k in zip(np.geomspace(0.05, 10.0, 60), rng.uniform(0.0, 10.0, 60), strict=True):
        yield float(n), float(k)


def of_eta(
    angle: Callable[[Interface], Array], arc: Callable[[mpf], mpf], etas: Array
) -> Callable[[], float]:
    """Against the inverse tangent or sine of eta."""

    def measure() -> float:
        with mp.workdps(DIGITS):
            return max(
                relative(float(angle(Interface(1.0, eta))), float(mp.degrees(arc(mpf(eta)))))
                for eta in etas
            )

    return measure


Quotients = Callable[[mpf], tuple[mp.mpc, mp.mpc]]


def at_a_root(
    angle: Callable[[Interface], Array], vanishes: Callable[[Quotients, mpf], mpf]
) -> Callable[[], float]:
    """Against the root of what vanishes there, made of the textbook's r_s and r_p over theta."""

    def measure() -> float:
        errors = []
        for eta, kappa in product((0.2, 0.6, 1.5, 4.0), (0.1, 1.0, 3.0, 8.0)):
            found = float(angle(Interface(1.0, eta, kappa)))
            with mp.workdps(DIGITS):
                square = mp.mpc(eta, kappa) ** 2

                def quotients(theta: mpf, square: mp.mpc = square) -> tuple[mp.mpc, mp.mpc]:
                    q, c = mp.sqrt(square - mp.sin(theta) ** 2), mp.cos(theta)
                    return (c - q) / (c + q), (square * c - q) / (square * c + q)

                root = mp.findroot(partial(vanishes, quotients), mp.radians(found))
                errors.append(relative(found, float(mp.degrees(root))))
        return max(errors)

    return measure


def in_phase(quotients: Quotients, theta: mpf) -> mpf:
    r_s, r_p = quotients(theta)
    return mp.re(r_p / r_s)


def slope_of_Rp(quotients: Quotients, theta: mpf) -> mpf:
    return mp.diff(lambda t: abs(quotients(t)[1]) ** 2, theta)


@cache
def scattered() -> list[tuple[tuple[float, float, float, float], Reference]]:
    rng = np.random.default_rng(20)
    rays = []
    for _ in range(1500):
        n_i, n_t = np.exp(rng.uniform(np.log(1e-3), np.log(100.0), 2))
        k_t = rng.choice([0.0, np.exp(rng.uniform(np.log(1e-6), np.log(100.0)))])
        ray = (float(n_i), float(n_t), float(k_t), float(rng.uniform(0.0, 90.0)))
        rays.append((ray, fresnel(*ray)))
    return rays


def over_rays(quantity: Callable[[Interface, Incidence], Array], name: str) -> Callable[[], float]:
    """Against the reference, wherever there is such a quantity."""

    def measure() -> float:
        errors = []
        for (n_i, n_t, k_t, deg), reference in scattered():
            found = float(quantity(Interface(n_i, n_t, k_t), Incidence.from_degrees(deg)))
            if not math.isnan(found):
                errors.append(relative(found, getattr(reference, name)))
        assert len(errors) > 700
        return max(errors)

    return measure


def directions(name: str) -> Callable[[], float]:
    """Components of rays in space against Snell's law in 50 digits, solved for the angle."""

    def measure() -> float:
        rng = np.random.default_rng(3)
        worst = 0.0
        for _ in range(1000):
            d, n = rng.normal(size=(2, 3))
            d, n = d / np.linalg.norm(d), n / np.linalg.norm(n)
            n = -n if d @ n > 0.0 else n
            eta = float(rng.uniform(0.5, 4.0))
            mu = -float(d @ n)
            with mp.workdps(DIGITS):
                i, up = [mpf(x) for x in d.tolist()], [mpf(x) for x in n.tolist()]
                cos_i = mpf(mu)
                if name == "reflected":
                    expected = [a + 2 * cos_i * b for a, b in zip(i, up, strict=True)]
                    found = reflected(mu, d, n)
                else:
                    theta_t = mp.asin(mp.sin(mp.acos(cos_i)) / mpf(eta))
                    if mp.im(theta_t) != 0:
                        assert not refracted(mu, eta, d, n).any()
                        continue
                    expected = [
                        (a + cos_i * b) / mpf(eta) - mp.cos(theta_t) * b
                        for a, b in zip(i, up, strict=True)
                    ]
                    found = refracted(mu, eta, d, n)
                off = [
                    abs(float(x - mpf(y))) for x, y in zip(expected, found.tolist(), strict=True)
                ]
            worst = max(worst, *off)
        return worst

    return measure


def closed(
    function: Callable[[Array], Array], etas: Array, exact: Callable[[float], float]
) -> float:
    found = function(etas)
    return max(
        relative(float(one), exact(float(eta))) for one, eta in zip(found, etas, strict=True)
    )


def flatland_points() -> float:
    """Allen's form at the points that have 35 digits."""
    rows = [r for r in points() if r["k_t"] == 0.0 and r["n_t"] >= 1.25 * r["n_i"]]
    assert len(rows) > 3
    etas = np.array([row["n_t"] / row["n_i"] for row in rows])
    known = {float(eta): row["flatland"] for eta, row in zip(etas, rows, strict=True)}
    return closed(allen, etas, known.__getitem__)


def unpolarized(eta: float) -> float:
    return float(albedo(Interface(1.0, eta)).unpolarized)


@cache
def points() -> list[dict[str, float]]:
    rows: list[dict[str, float]] = json.loads((HERE / "albedo_points.json").read_text("utf-8"))
    return rows


def at_points(where: Callable[[float, float, float], bool]) -> Callable[[], float]:
    """Albedos of the points of some kind, against 35 digits."""

    def measure() -> float:
        errors = []
        for row in points():
            media = row["n_i"], row["n_t"], row["k_t"]
            if where(*media):
                found = albedo(Interface(*media))
                names = ("s", "p", "unpolarized")
                errors += [relative(float(getattr(found, name)), row[name]) for name in names]
        return max(errors)

    return measure


def flatland() -> float:
    return max(
        relative(
            float(flatland_albedo(Interface(row["n_i"], row["n_t"], row["k_t"]))), row["flatland"]
        )
        for row in points()
    )


def coat() -> float:
    """Follow the light: what enters is scattered, let out or sent back, again and again."""
    errors = []
    for eta in np.linspace(1.1, 4.0, 12):
        outside = float(albedo(Interface(1.0, eta)).unpolarized)
        inside = float(albedo(Interface(eta, 1.0)).unpolarized)
        for rho in np.linspace(0.0, 0.95, 9):
            light, body, absorbed = 1.0 - outside, 0.0, 0.0
            while light > 1e-18:
                absorbed += light * (1.0 - rho)
                body += light * rho * (1.0 - inside)
                light *= rho * inside
            split = coat_split(Interface(1.0, eta), rho)
            errors += [abs(float(split.body) - body), abs(float(split.absorbed) - absorbed)]
    return max(errors)


def value(known_as: Form, form: str, name: str, **given: float) -> float:
    found = next(c for c in convert(know(known_as, **given)) if c.form == form)
    number = found.values[name]
    assert isinstance(number, float)
    return number


def back_and_forth(name: str, low: float, high: float, form: Form, by: Form, by_name: str) -> float:
    errors = []
    for given in np.linspace(low, high, 200):
        through = value(form, by, by_name, **{name: float(given)})
        errors.append(relative(value(by, form, name, **{by_name: through}), float(given)))
    return max(errors)


def tint_there_and_back(form: Form, tint: str, least: float) -> float:
    errors = []
    for n, k in indices():
        if n < 0.1 or math.hypot(n, k) < least:
            continue
        r = value("nk", form, "r", n_t=n, k_t=k)
        given = {"r": r, tint: value("nk", form, tint, n_t=n, k_t=k)}
        again = complex(value(form, "nk", "n_t", **given), value(form, "nk", "k_t", **given))
        errors.append(abs(again - complex(n, k)) / abs(complex(n, k)))
    return max(errors)


def against_50_digits(form: str, name: str, expected: Callable[[float, float], float]) -> float:
    errors = []
    for n, k in indices():
        found = next(c for c in convert(know("nk", n_t=n, k_t=k)) if c.form == form).values[name]
        if isinstance(found, float):
            errors.append(relative(found, expected(n, k)))
    assert len(errors) > 30
    return max(errors)


def F0_from(front: float) -> Callable[[float, float], float]:
    def at(n: float, k: float) -> float:
        with mp.workdps(DIGITS):
            index = mp.mpc(n, k)
            return float(abs((index - mpf(front)) / (index + mpf(front))) ** 2)

    return at


def F82(n: float, k: float) -> float:
    with mp.workdps(DIGITS):
        index, mu = mp.mpc(n, k), mpf(1) / 7
        q = mp.sqrt(index**2 - 1 + mu**2)
        r_s, r_p = (mu - q) / (mu + q), (index**2 * mu - q) / (index**2 * mu + q)
        return float((abs(r_s) ** 2 + abs(r_p) ** 2) / 2)


def tint(n: float, k: float) -> float:
    F0 = F0_from(1.0)(n, k)
    return F82(n, k) / (F0 + (1.0 - F0) * (6.0 / 7.0) ** 5)


def eight_bits() -> float:
    """Half of the largest step between neighboring codes, by the standard's own formula."""
    codes = [
        c / 255.0 / 12.92 if c / 255.0 <= 0.04045 else ((c / 255.0 + 0.055) / 1.055) ** 2.4
        for c in range(256)
    ]
    # It is largest half way between two codes in sRGB, on either side of where the code changes.
    turns = decode_srgb((np.arange(255) + 0.5) / 255.0)
    tried = np.concatenate([turns - 1e-9, turns + 1e-9, np.linspace(0.0, 1.0, 101)])
    worst: float = max(abs(value("f0", "f0_hex", "F0", F0=F0) - F0) for F0 in tried.tolist())
    assert worst <= np.diff(codes).max()
    return worst


MEASURED: dict[str, Callable[[], float]] = {
    "angle.brewster": of_eta(brewster_deg, mp.atan, np.geomspace(1e-3, 100.0, 300)),
    "angle.critical": of_eta(critical_deg, mp.asin, np.geomspace(1e-3, 1.0 - 1e-9, 300)),
    "angle.pseudo_brewster": at_a_root(pseudo_brewster_deg, slope_of_Rp),
    "angle.principal": at_a_root(principal_deg, in_phase),
    "angle.reflected_direction": directions("reflected"),
    "angle.refracted_direction": directions("refracted"),
    "angle.refraction": over_rays(refraction_angle_deg, "theta_t_deg"),
    "angle.penetration_depth": over_rays(penetration_depth_wavelengths, "depth"),
    "albedo.exact": at_points(lambda n_i, n_t, k_t: k_t > 0.0),  # noqa: ARG005
    "albedo.dielectric": at_points(lambda n_i, n_t, k_t: k_t == 0.0 and n_t > n_i),
    "albedo.reciprocity": at_points(lambda n_i, n_t, k_t: k_t == 0.0 and n_t < n_i),
    "albedo.flatland": flatland,
    "albedo.dunkle": lambda: closed(dunkle, np.geomspace(1.0001, 100.0, 200), unpolarized),
    "albedo.allen": flatland_points,
    "albedo.coat": coat,
    "conversion.ior": lambda: back_and_forth("n_t", 1.05, 60.0, "ior", "f0", "F0"),
    "conversion.nk": lambda: against_50_digits("f0", "F0", F0_from(1.0)),
    "conversion.f0": lambda: back_and_forth("F0", 1e-3, 0.96, "f0", "ior", "n_t"),
    "conversion.f0_srgb": lambda: back_and_forth("F0", 1e-3, 1.0, "f0", "f0_srgb", "F0_srgb"),
    "conversion.f0_hex": eight_bits,
    "conversion.specular": lambda: back_and_forth("specular", 0.01, 1.0, "specular", "ior", "n_t"),
    "conversion.reflectance": lambda: back_and_forth(
        "reflectance", 0.1, 1.0, "reflectance", "ior", "n_t"
    ),
    "conversion.rg": lambda: tint_there_and_back("rg", "g", 1.01),
    "conversion.dg": lambda: tint_there_and_back("dg", "G", 0.0),
    "conversion.f82": lambda: against_50_digits("f82", "F82", F82),
    "conversion.f82_tint": lambda: against_50_digits("f82_tint", "tint", tint),
    "conversion.f0_seen_from": lambda: against_50_digits("f0_seen_from", "F0", F0_from(1.333)),
}


def test_all_that_is_declared_here_is_measured_here() -> None:
    elsewhere = {f"model.{name}" for name in MODELS} | {f"albedo.{name}" for name in FITS}
    assert set(FORMULAS) - elsewhere == set(MEASURED)


@pytest.mark.parametrize("formula_id", MEASURED)
def test_stated_accuracy_is_measured(formula_id: str) -> None:
    (stated,) = FORMULAS[formula_id].accuracy
    error = MEASURED[formula_id]()
    if stated.at_most:
        assert error <= stated.value
        assert stated.value <= LAST_DIGITS or error > stated.value / 300.0
    else:
        assert f"{error:.3g}" == f"{stated.value:.3g}"


# Curves


@over_formulas
def test_curves_have_the_points_asked_for(formula: Formula) -> None:
    curve = formula.curve(formula.at, 7)
    assert curve.at.shape == (7,)
    assert np.all(np.diff(curve.at) > 0.0)
    assert len({series.id for series in curve.series}) == len(curve.series)
    for series in curve.series:
        assert series.values.shape == (7,)
        assert np.isfinite(series.values).sum() >= 2, series.id


@over_formulas
def test_curves_depend_on_what_they_say(formula: Formula) -> None:
    own = [float(x) for x in (formula.at.n_i, formula.at.n_t, formula.at.k_t)]
    before = formula.curve(formula.at, 9)
    taken = {parameter.name for parameter in formula.takes}
    for at, name in enumerate(("n_i", "n_t", "k_t")):
        other = [*own]
        other[at] = own[at] * 1.25 + 0.5
        after = formula.curve(Interface(*other), 9)
        same = all(
            np.array_equal(a.values, b.values, equal_nan=True)
            for a, b in zip(before.series, after.series, strict=True)
        )
        if name not in taken:
            assert same or name in ("n_i", "k_t"), (formula.id, name)
        elif formula.kind != "model":
            assert not same, (formula.id, name)


def test_the_curve_of_a_model_is_the_model_beside_the_exact_one() -> None:
    schlick = of_model(MODELS["schlick"])
    curve = schlick.curve(Interface(n_t=1.5), 91)
    exact, approximate = curve.series
    assert curve.at[56] == 56.0
    assert exact.values[56] == pytest.approx(fresnel(1.0, 1.5, 0.0, 56.0).R, rel=1e-13)
    expected = 0.04 + 0.96 * (1.0 - math.cos(math.radians(56.0))) ** 5
    assert approximate.values[56] == pytest.approx(expected, rel=1e-13)


def test_curves_of_angles_are_the_textbook_ones() -> None:
    curve = FORMULAS["angle.brewster"].curve(FORMULAS["angle.brewster"].at, 31)
    np.testing.assert_allclose(curve.series[0].values, np.degrees(np.arctan(curve.at)), rtol=1e-14)
    curve = FORMULAS["angle.critical"].curve(FORMULAS["angle.critical"].at, 31)
    total = curve.at < 1.0
    np.testing.assert_allclose(
        curve.series[0].values[total], np.degrees(np.arcsin(curve.at[total])), rtol=1e-14
    )
    assert np.isnan(curve.series[0].values[~total]).all()
