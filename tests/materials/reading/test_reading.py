"""Small files, two a format and one a trap: read right, or refused with what to do."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from app.materials.dispersion import refractive_index
from app.materials.reading.read import read
from app.materials.reading.registry import default_formats
from app.materials.reading.report import Choices, Reading, Undecided, Unreadable
from app.materials.schema import Formula, Points, Quantity
from app.optics.errors import NotAllowed, UnknownName

FILES = Path(__file__).parent / "files"
HC = 6.62607015e-34 * 299792458.0 / 1.602176634e-19 * 1e9
"""h c in eV nm from the SI's defining constants, independent of the reader's."""


def reading(*names: str, **choices: object) -> Reading:
    return read([(name, (FILES / name).read_bytes()) for name in names], Choices(**choices))  # type: ignore[arg-type]


def points(quantity: Quantity | None) -> list[tuple[float, float]]:
    assert isinstance(quantity, Points)
    return list(zip(quantity.wavelength_nm, quantity.values, strict=True))


def assumed(read_: Reading) -> dict[str, str]:
    return {one.what: one.value for one in read_.assumed}


def sellmeier(K: list[float], L: list[float], um: float) -> float:
    square = um * um
    return float(np.sqrt(1.0 + sum(k * square / (square - x) for k, x in zip(K, L, strict=True))))


GOLD = [(400.0, 1.66), (500.0, 0.85)], [(400.0, 1.956), (500.0, 1.895)]

TABLES = [
    ("comma.csv", {}, "table", "nm", *GOLD),
    ("semicolon-decimal-comma.csv", {}, "table", "um", *GOLD),
    ("latin1.csv", {}, "table", "um", *GOLD),
    ("bom.csv", {}, "table", "nm", [(400.0, 1.5), (500.0, 1.6)], None),
    ("utf16-be.csv", {}, "table", "nm", [(400.0, 1.5), (500.0, 1.6)], None),
    ("angstrom.txt", {}, "table", "A", [(200.0, 1.2), (900.0, 0.2)], [(200.0, 0.5), (900.0, 6.0)]),
    (
        "wavenumber.txt",
        {},
        "table",
        "cm-1",
        [(2500.0, 1.4), (25000.0, 2.5)],
        [(2500.0, 0.001), (25000.0, 1.2)],
    ),
    ("frequency.csv", {}, "table", "THz", [(149896.229, 2.12), (299792.458, 2.1)], None),
    (
        "headerless-um-or-ev.txt",
        {"unit": "um"},
        "table",
        "um",
        [(300.0, 1.55), (1000.0, 1.5), (2500.0, 1.48)],
        None,
    ),
    (
        "lambda-a-over-nm.txt",
        {"unit": "nm"},
        "table",
        "nm",
        [(300.0, 1.5), (800.0, 0.2)],
        [(300.0, 0.9), (800.0, 5.0)],
    ),
    ("fortran.txt", {}, "table", "nm", [(400.0, 1.5), (500.0, 1.6)], [(400.0, 0.1), (500.0, 0.2)]),
    (
        "four-columns.txt",
        {"columns": ("wavelength", "n", "k", "-")},
        "table",
        "nm",
        [(400.0, 1.5), (500.0, 1.6)],
        [(400.0, 0.1), (500.0, 0.2)],
    ),
    (
        "two-blocks.csv",
        {},
        "table",
        "um",
        [(400.0, 1.5), (500.0, 1.4)],
        [(400.0, 0.1), (600.0, 0.3)],
    ),
    (
        "rii-table.yml",
        {},
        "refractiveindex_info",
        "um",
        [(400.0, 1.658), (500.0, 0.849), (600.0, 0.249)],
        [(400.0, 1.956), (500.0, 1.895), (600.0, 2.993)],
    ),
    (
        "sopra-ev.nk",
        {},
        "sopra_nk",
        "eV",
        [(HC / 3.0, 1.6), (HC / 2.5, 0.9), (HC / 2.0, 0.2)],
        [(HC / 3.0, 1.9), (HC / 2.5, 1.9), (HC / 2.0, 3.0)],
    ),
    ("sopra-um.nk", {}, "sopra_nk", "um", [(400.0, 1.5), (500.0, 1.49)], None),
    (
        "imd.nk",
        {},
        "imd",
        "A",
        [(121.6, 1.2), (587.6, 0.14), (1200.0, 0.3)],
        [(121.6, 0.6), (587.6, 3.6), (1200.0, 8.0)],
    ),
    (
        "imd-nm.nk",
        {"unit": "nm"},
        "imd",
        "nm",
        [(300.0, 1.5), (800.0, 0.14)],
        [(300.0, 0.9), (800.0, 5.0)],
    ),
    (
        "woollam-ev.mat",
        {},
        "woollam",
        "eV",
        [(HC / 3.0, 5.2), (HC / 2.0, 3.9), (HC, 3.5)],
        [(HC / 3.0, 0.3), (HC / 2.0, 0.02), (HC, 0.0)],
    ),
    (
        "Xx.eta.spd",
        {},
        "spd",
        "nm",
        [(298.757, 1.519), (400.0, 0.173), (885.6, 0.163)],
        None,
    ),
    (
        "nameless.spd",
        {"columns": ("wavelength", "n")},
        "spd",
        "nm",
        [(400.0, 1.5), (500.0, 1.6)],
        None,
    ),
    (
        "cxro.dat",
        {},
        "henke",
        "eV",
        [(HC / 100.0, 0.99), (HC / 30.0, 0.8)],
        [(HC / 100.0, 0.002), (HC / 30.0, 0.05)],
    ),
    (
        "cxro-nm.txt",
        {},
        "henke",
        "nm",
        [(10.0, 0.98), (13.5, 0.978)],
        [(10.0, 0.01), (13.5, 0.012)],
    ),
    (
        "openfilters.mat",
        {},
        "openfilters",
        "nm",
        [(400.0, 0.173), (500.0, 0.13), (600.0, 0.12)],
        [(400.0, 1.95), (500.0, 2.9), (600.0, 3.7)],
    ),
    ("openfilters-dielectric.mat", {}, "openfilters", "nm", [(400.0, 1.5), (500.0, 1.49)], None),
]


@pytest.mark.parametrize(("name", "choices", "kind", "unit", "n", "k"), TABLES)
def test_points_are_those_of_the_file(
    name: str,
    choices: dict[str, object],
    kind: str,
    unit: str,
    n: list[tuple[float, float]],
    k: list[tuple[float, float]] | None,
) -> None:
    found = reading(name, **choices)
    assert (found.format, found.unit) == (kind, unit)
    assert points(found.n) == [pytest.approx(pair, rel=1e-12) for pair in n]
    if k is None:
        assert found.k is None
    else:
        assert points(found.k) == [pytest.approx(pair, rel=1e-12) for pair in k]
    assert {one.what for one in found.assumed}.isdisjoint(choices), "what is set is not assumed"


@pytest.mark.parametrize(
    ("name", "rows"),
    [
        ("woollam-eps.mat", [(400.0, -4.0, 0.4), (500.0, -9.0, 0.6)]),
        ("spectraray.mat", [(HC / 2.5, -6.0, 0.4), (HC / 1.5, -20.0, 1.2)]),
        ("spectraray-nm.mat", [(400.0, 2.25, 0.0), (500.0, 2.25, 0.3)]),
        ("headerless-eps.txt", [(500.0, -9.0, 0.6), (600.0, -12.0, 0.8)]),
        (
            "energy-falling-wavelength.csv",
            [(HC / 3.0, -1.0, 2.0), (HC / 2.0, -9.0, 1.0), (HC, -40.0, 3.0)],
        ),
    ],
)
def test_the_square_of_n_is_the_permittivity(
    name: str, rows: list[tuple[float, float, float]]
) -> None:
    found = reading(name)
    for (wavelength, n), (_, k), (at, eps1, eps2) in zip(
        points(found.n), points(found.k), rows, strict=True
    ):
        assert wavelength == pytest.approx(at, rel=1e-12)
        assert (n + 1j * k) ** 2 == pytest.approx(eps1 + 1j * eps2, rel=1e-12)


def test_eta_and_k_come_in_two_files_whatever_the_order() -> None:
    for names in (("Xx.eta.spd", "Xx.k.spd"), ("Xx.k.spd", "Xx.eta.spd")):
        found = reading(*names)
        assert points(found.n)[1] == (400.0, 0.173)
        assert points(found.k)[1] == (400.0, 1.95)
        assert assumed(found)["unit"] == "nm"
    assert found.name == "Xx"


N_BK7 = [1.03961212, 0.231792344, 1.01046945], [0.00600069867, 0.0200179144, 103.560653]


def test_a_page_with_a_formula_and_k() -> None:
    found = reading("rii-formula-and-k.yml")
    assert isinstance(found.n, Formula)
    assert (found.n.number, found.n.range_nm) == (2, (300.0, 2500.0))
    assert points(found.k) == [(300.0, 2.9e-6), (400.0, 1e-8)]
    assert found.relative_to == "air"


def test_a_page_with_a_formula_and_a_table_of_n_says_which_it_took() -> None:
    table = reading("rii-formula-and-table.yml")
    assert points(table.n) == [(400.0, 1.53), (800.0, 1.51)]
    assert assumed(table)["n_from"] == "table"
    formula = reading("rii-formula-and-table.yml", n_from="formula")
    assert formula.n == Formula(
        kind="formula", number=5, coefficients=(1.5, 0.004, -2.0), range_nm=(400.0, 800.0)
    )
    assert points(formula.k) == points(table.k) == [(400.0, 0.001), (800.0, 0.002)]
    assert table.relative_to == "vacuum"


def test_coefficients_wrapped_onto_lines_without_keyword_are_the_glass_s() -> None:
    found = reading("two-glasses.agf", glass="one")
    assert isinstance(found.n, Formula)
    assert found.n.coefficients[1::2] == pytest.approx(N_BK7[0], rel=1e-9)
    assert found.n.coefficients[2::2] == pytest.approx(N_BK7[1], rel=1e-9)
    assert found.relative_to == "air"
    assert found.name == "ONE"


def test_internal_transmission_gives_k_and_what_is_none_is_left_out() -> None:
    found = reading("two-glasses.agf", glass="ONE")
    expected = [
        (300.0, -np.log(0.05) * 300e-9 / (4 * np.pi * 25e-3)),
        (350.0, -np.log(0.9) * 350e-9 / (4 * np.pi * 10e-3)),
    ]
    assert points(found.k) == [pytest.approx(pair, rel=1e-12) for pair in expected]
    told = {row.line: row.why for row in found.left_out}
    lines = (FILES / "two-glasses.agf").read_text().splitlines()
    for number, words in (
        (lines.index("IT 3.60E-001 0.0 25.0") + 1, "internal transmission 0"),
        (lines.index("IT 3.70E-001 12.0 10.0") + 1, "transmission of 12"),
        (lines.index("IT 3.80E-001 -999.0 10.0") + 1, "-999"),
        (lines.index("IT 3.90E-001 0.9 0.0") + 1, "thickness of 0"),
        (lines.index("IT 4.00E-001  25.0") + 1, "lacks"),
        (lines.index("IT 4.10E-001 _ 25.0") + 1, "lacks"),
    ):
        assert words in told.pop(number)
    assert not told


@pytest.mark.parametrize("name", ["schott-formula.agf", "utf16.agf"])
def test_schott_s_formula_in_any_encoding(name: str) -> None:
    found = reading(name)
    assert isinstance(found.n, Formula)
    value = _evaluated(found.n, 0.5)
    square = 2.27 - 0.01 * 0.25 + 0.0105 / 0.25 + 0.0002 / 0.0625
    assert value == pytest.approx(np.sqrt(square), rel=1e-14)
    assert any("1.9 by its line NM" in sentence for sentence in found.warnings)


def _evaluated(formula: Formula, um: float) -> float:
    return float(refractive_index(formula.number, formula.coefficients, np.array([um]))[0])


COEFFICIENTS = [-0.01, 0.02, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]


def root(x: float, *exponents: int) -> float:
    """n of a polynomial of n^2 with these exponents."""
    terms = zip(COEFFICIENTS, exponents, strict=False)
    return float(np.sqrt(2.2 + sum(a * x**p for a, p in terms)))


POLES = [(1.0, 0.006), (0.2, 0.02), (1.0, 100.0), (0.1, 0.03), (0.05, 0.04)]


def poles(x: float, count: int) -> float:
    K, L = zip(*POLES[:count], strict=True)
    return sellmeier(list(K), list(L), x)


def flat(count: int) -> list[float]:
    return [number for pole in POLES[:count] for number in pole]


HERZBERGER = [1.5, 0.01, 1e-4, -0.01, 1e-4, 1e-5]


def herzberger(x: float) -> float:
    A, B, C, D, E, F = HERZBERGER
    L = 1 / (x**2 - 0.028)
    return A + B * L + C * L**2 + D * x**2 + E * x**4 + F * x**6


def sellmeier_2(x: float) -> float:
    return float(np.sqrt(1 + 0.5 + 0.9 * x**2 / (x**2 - 0.1**2) + 0.02 / (x**2 - 0.2**2)))


def sellmeier_4(x: float) -> float:
    return float(np.sqrt(1.3 + 0.9 * x**2 / (x**2 - 0.02) + 0.01 * x**2 / (x**2 - 90.0)))


AGF: dict[int, tuple[list[float], Callable[[float], float]]] = {
    1: ([2.2, *COEFFICIENTS[:5]], lambda x: root(x, 2, -2, -4, -6, -8)),
    2: (flat(3), lambda x: poles(x, 3)),
    3: (HERZBERGER, herzberger),
    4: ([0.5, 0.9, 0.1, 0.02, 0.2], sellmeier_2),
    5: ([1.5, 0.01, 0.001], lambda x: 1.5 + 0.01 / x + 0.001 / x**3.5),
    6: (flat(4), lambda x: poles(x, 4)),
    7: ([2.2, 0.02, 0.03, 0.01], lambda x: np.sqrt(2.2 + 0.02 / (x**2 - 0.03) - 0.01 * x**2)),
    8: (
        [1.2, 0.9, 0.03, 0.01],
        lambda x: np.sqrt(1.2 + 0.9 * x**2 / (x**2 - 0.03) - 0.01 * x**2),
    ),
    9: ([1.3, 0.9, 0.02, 0.01, 90.0], sellmeier_4),
    10: ([2.2, *COEFFICIENTS[:7]], lambda x: root(x, 2, -2, -4, -6, -8, -10, -12)),
    11: (flat(5), lambda x: poles(x, 5)),
    12: ([2.2, *COEFFICIENTS[:7]], lambda x: root(x, 2, -2, -4, -6, -8, 4, 6)),
    13: ([2.2, *COEFFICIENTS], lambda x: root(x, 2, 4, -2, -4, -6, -8, -10, -12)),
}


@pytest.mark.parametrize("number", AGF)
def test_the_formulas_of_glass_catalogs(number: int) -> None:
    """Each against the formula as OpticStudio's manual writes it."""
    coefficients, function = AGF[number]
    text = f"NM G {number} - 0 0 0 1\nCD {' '.join(map(repr, coefficients))}\nLD 0.4 0.8\n"
    found = read([("g.agf", text.encode())])
    assert isinstance(found.n, Formula)
    for um in (0.4, 0.55, 0.8):
        assert _evaluated(found.n, um) == pytest.approx(float(function(um)), rel=1e-14)


def test_k_negative_throughout_is_the_other_sign_and_here_and_there_noise() -> None:
    other = reading("other-sign.csv")
    assert other.sign == "n-ik"
    assert points(other.k) == [(400.0, 1.95), (500.0, 2.9)]
    assert "sign" in assumed(other)
    noise = reading("noise.csv")
    assert noise.sign == "n+ik"
    assert points(noise.k) == [(400.0, 0.1), (500.0, 0.0), (600.0, 0.05)]
    assert any("line 3" in sentence and "noise" in sentence for sentence in noise.warnings)
    with pytest.raises(Undecided, match="sign=n-ik") as raised:
        reading("either-sign.csv")
    assert raised.value.parameter == "sign"
    assert points(reading("either-sign.csv", sign="n-ik").k) == [(400.0, 0.0), (500.0, 0.08)]


def test_n_that_is_none_is_left_out_with_its_line() -> None:
    found = reading("bad-n.csv")
    assert points(found.n) == [(400.0, 1.5), (550.0, 1.52)]
    assert [row.line for row in found.left_out] == [3, 4]
    zeros = reading("zero-eta.eta.spd")
    assert [row.line for row in zeros.left_out] == [1, 2]


def test_points_given_twice_are_their_mean_and_rows_are_sorted() -> None:
    found = reading("twice-and-unsorted.csv")
    assert points(found.n) == [(400.0, 1.5), (500.0, pytest.approx(1.52)), (600.0, 1.54)]
    assert points(found.k) == [(400.0, 0.1), (500.0, 0.2), (600.0, 0.3)]
    assert (found.order, found.merged) == ("unsorted", 1)
    assert any("line 4" in sentence and "0.02 apart" in sentence for sentence in found.warnings)


def test_numbers_that_stand_for_nothing_are_not_values() -> None:
    found = reading("missing.csv")
    assert points(found.n) == [(500.0, 1.5), (600.0, 1.6), (700.0, 1.7)]
    assert points(found.k) == [(600.0, 0.2), (700.0, 0.3)]


def test_k_of_exactly_0_may_mean_not_measured() -> None:
    found = reading("zero-k.csv")
    assert points(found.k) == [(400.0, 0.01), (500.0, 0.0), (600.0, 0.0)]
    (told,) = [one for one in found.assumed if one.what == "zero_k"]
    assert told.alternatives == ("unknown",)
    assert points(reading("zero-k.csv", zero_k="unknown").k) == [(400.0, 0.01)]
    assert points(reading("sopra-um.nk", zero_k="known").k) == [(400.0, 0.0), (500.0, 0.0)]


def test_falling_wavelengths_and_falling_energies() -> None:
    assert reading("headerless-nm.txt").order == "falling"
    assert points(reading("headerless-nm.txt").n)[0] == (380.0, 1.533)
    rising_energy = reading("energy-falling-wavelength.csv")
    assert rising_energy.order == "rising"
    assert points(rising_energy.n)[0][0] == pytest.approx(HC / 3.0)


def test_rows_that_are_none_are_told_by_line() -> None:
    found = reading("broken-rows.csv")
    assert points(found.n) == [(400.0, 1.5), (500.0, 1.6), (550.0, 1.7)]
    assert [row.line for row in found.left_out] == [3, 4]


def test_announced_counts_that_are_wrong_are_told() -> None:
    found = reading("sopra-broken.mat")
    assert points(found.n) == [(500.0, 1.5), (700.0, 1.3)]
    assert [row.line for row in found.left_out] == [3]
    assert any("announces 4" in sentence for sentence in found.warnings)
    falling = reading("sopra.MAT", sign="n+ik")
    assert points(falling.k) == [(500.0, 0.0), (600.0, 2.99), (700.0, 4.06)]


ASKED = [
    ("headerless-um-or-ev.txt", "unit", "unit=um or unit=eV"),
    ("lambda-a-over-nm.txt", "unit", "unit=A or unit=nm"),
    ("two-glasses.agf", "glass", "which of 2 glasses: ONE, TWO"),
    ("four-columns.txt", "columns", "4 columns"),
    ("nameless.spd", "columns", "eta or k"),
    ("sopra.MAT", "sign", "say sign="),
]


@pytest.mark.parametrize(("name", "parameter", "words"), ASKED)
def test_what_cannot_be_told_is_asked(name: str, parameter: str, words: str) -> None:
    with pytest.raises(Undecided) as raised:
        reading(name)
    assert raised.value.parameter == parameter
    assert words in raised.value.allowed


def test_both_readings_are_told_with_their_ranges() -> None:
    with pytest.raises(
        Undecided, match=r"in um they are 300 to 2500 nm.*in eV they are 495.9 to 4133"
    ):
        reading("headerless-um-or-ev.txt")


REFUSED = [
    ("rii-short-formula-2.yml", "an odd number for formula 2"),
    ("rii-formula-4.yml", "an odd number from 9"),
    ("rii-n2.yml", "nonlinear index n2"),
    ("sopra-short.nk", "3 pairs for 2 intervals; there are 2"),
    ("Xx.k.spd", "the file of eta"),
    ("factors.nff", "f1 and f2"),
    ("openfilters-cauchy.mat", "let OpenFilters write a table"),
    ("nothing.csv", "rows of at least two numbers"),
    ("binary.xlsx", "CSV"),
]


@pytest.mark.parametrize(("name", "words"), REFUSED)
def test_what_cannot_be_read_is_refused_with_what_to_do(name: str, words: str) -> None:
    with pytest.raises(Unreadable) as raised:
        reading(name)
    assert words in raised.value.allowed


def test_every_format_has_two_files_at_least() -> None:
    formats = [reading(name, **choices).format for name, choices, *_ in TABLES]  # type: ignore[arg-type]
    formats += ["agf", "agf", "refractiveindex_info", "sopra_mat", "sopra_mat", "spd", "woollam"]
    formats += ["spectraray", "spectraray"]
    for name in default_formats():
        assert formats.count(name) >= 2, name


@pytest.mark.parametrize(
    "text",
    [
        "DATA:\n  - type: x\n    data: " + "[" * 50_000,
        "DATA: &a\n  - type: formula 1\n    coefficients: *a\n",
        "DATA:\n" + "- " * 30_000 + "type: x",
    ],
)
def test_yaml_that_would_end_the_process_is_refused(text: str) -> None:
    with pytest.raises(Unreadable, match=r"levels deep|YAML"):
        read([("deep.yml", text.encode())])


def test_a_formula_without_n_in_its_own_range_says_where() -> None:
    page = (
        "DATA:\n  - type: formula 2\n    wavelength_range: 0.3 12\n    coefficients: 0 1.5 43.4\n"
    )
    with pytest.raises(Unreadable, match=r"throughout its range; at 300 nm it gives nan|it gives"):
        read([("pole.yml", page.encode())])


def test_k_where_n_is_nowhere_known_is_left_out_and_told() -> None:
    found = read([("far.csv", b"wl,n\n0.4,1.5\n0.5,1.4\n\nwl,k\n0.8,0.1\n0.9,0.3\n")])
    assert found.k is None
    assert any("nowhere together" in sentence for sentence in found.warnings)


def test_choices_that_are_none_are_refused() -> None:
    for choices in ({"unit": "furlong"}, {"columns": ("n", "k")}, {"columns": ("wavelength", "q")}):
        with pytest.raises(NotAllowed):
            reading("comma.csv", **choices)
    with pytest.raises(UnknownName):
        reading("comma.csv", format="tabel")
    with pytest.raises(Unreadable, match="nearest: ONE"):
        reading("two-glasses.agf", glass="ONEE")
    with pytest.raises(Unreadable, match="185"):
        read([("x.csv", b"nm,n\n100,1.2\n200,1.5\n")], Choices(relative_to="air"))


def test_files_have_bounds() -> None:
    with pytest.raises(Unreadable, match="2,000,000 bytes"):
        read([("long.csv", b"1" * 2_000_001)])
    with pytest.raises(Unreadable, match="200,000 rows"):
        read([("rows.csv", b"400 1\n" * 200_001)])
    with pytest.raises(Unreadable, match="one file, or two"):
        read([])
    with pytest.raises(Unreadable, match="come in two"):
        reading("comma.csv", "bom.csv")


def table(text: str, name: str = "x.csv") -> Reading:
    return read([(name, text.encode())])


@pytest.mark.parametrize(
    ("text", "called"),
    [
        ("Wavelength (nm),R,T\n400,0.1,0.8\n500,0.1,0.85\n", "Wavelength (nm), R, T"),
        ("Wavelength (nm),Absorbance\n400,0.1\n500,0.1\n", "Absorbance"),
        ("nm,n,k\n500,1,5,0,1\n600,1,6,0,2\n", "5 columns"),
        ("nm,n (Ag),k (Ag),n (Au),k (Au)\n400,1,2,3,4\n500,1,2,3,4\n", "n (Au)"),
        ("nm,no,ko,ne,ke\n400,1,2,3,4\n500,1,2,3,4\n", "ke"),
        ("wavelength n k\n1 400 1.5 0.1\n2 500 1.5 0.1\n", "4 columns"),
    ],
)
def test_columns_that_are_called_otherwise_are_asked(text: str, called: str) -> None:
    """Reflectance beside transmittance is no n beside k; nor are commas of two kinds."""
    with pytest.raises(Undecided) as raised:
        table(text)
    assert raised.value.parameter == "columns"
    assert called in raised.value.allowed


@pytest.mark.parametrize(
    "text",
    [
        "wavelength_nm,k,n\n400,0.1,1.5\n500,0.2,1.6\n",
        "nm,Extinction coefficient k,Refractive index n\n400,0.1,1.5\n500,0.2,1.6\n",
        '"","wavelength_nm","n","k"\n"1",400,1.5,0.1\n"2",500,1.6,0.2\n',
        ",wavelength_nm,n,k\n0,400,1.5,0.1\n1,500,1.6,0.2\n",
        '"lambda (um)","n","k"\n"0.4","1.5","0.1"\n"0.5","1.6","0.2"\n',
        "thickness (nm),wavelength (nm),n,k\n30,400,1.5,0.1\n30,500,1.6,0.2\n",
        "wavelength nm  n  k\n400 1.5 0.1\n500 1.6 0.2\n",
        "Vacuum wavelength λ (nm);n;k;\n400;1,5;0,1;\n500;1,6;0,2\n",
        "nm,n,k\n400,1.5,\N{MINUS SIGN}0.1\n500,1.6,\N{MINUS SIGN}0.2\n",
    ],
)
def test_columns_as_programs_name_and_quote_them(text: str) -> None:
    found = table(text)
    assert points(found.n) == [(400.0, 1.5), (500.0, 1.6)]
    assert points(found.k) == [(400.0, 0.1), (500.0, 0.2)]


def test_a_permittivity_that_is_infinite_is_left_out() -> None:
    found = table("E (eV),eps1,eps2\n1,-40,0.5\n2,-9,inf\n3,-1,2\n")
    assert [(row.line, row.why[:8]) for row in found.left_out] == [(3, "n = inf ")]
    assert len(points(found.n)) == len(points(found.k)) == 2


def test_columns_that_are_not_used_are_told() -> None:
    found = table("nm,n,alpha (cm-1)\n400,1.5,100\n500,1.6,90\n")
    assert points(found.n) == [(400.0, 1.5), (500.0, 1.6)]
    assert "not used: alpha (cm-1)" in found.warnings


def test_n_and_k_beside_one_another_have_each_their_wavelengths() -> None:
    """As spreadsheets have them; the shorter one ends in empty cells."""
    found = table("wl (nm),n,E (eV),k\n400,1.5,3,0.1\n500,1.6,2,0.2\n600,1.7,,\n")
    assert points(found.n) == [(400.0, 1.5), (500.0, 1.6), (600.0, 1.7)]
    assert [x for x, _ in points(found.k)] == pytest.approx([HC / 3, HC / 2], rel=1e-14)
    assert [k for _, k in points(found.k)] == [0.1, 0.2]
    assert found.columns == ("wavelength", "n", "k")


def test_rows_without_k_at_the_end_keep_their_n() -> None:
    found = table("nm,n,k\n400,1.5,0.1\n500,1.6,\n600,1.7,\n700,1.8,\n")
    assert [n for _, n in points(found.n)] == [1.5, 1.6, 1.7, 1.8]
    assert points(found.k) == [(400.0, 0.1)]
    assert not found.left_out


def test_a_glass_with_fewer_coefficients_than_its_formula_takes_says_so() -> None:
    text = "NM G 2 - 0 0 0 1\nCD 1.1 0.01 0.2 0.02\nLD 0.4 0.8\n"
    warnings = table(text, "g.agf").warnings
    assert any("4 of 6 numbers" in warning for warning in warnings)
