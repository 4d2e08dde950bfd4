"""Files as instruments, programs and people leave them: footers, words, gaps, several blocks."""

import pytest

from app.materials.reading.columns import role_of
from app.materials.reading.read import read
from app.materials.reading.report import Choices, Reading, Unreadable
from app.materials.schema import Points, Quantity

HC = 6.62607015e-34 * 299792458.0 / 1.602176634e-19 * 1e9
"""h c in eV nm from the SI's defining constants, independent of the reader's."""
GOLD = [(400.0, 1.66, 1.95), (500.0, 0.85, 1.9), (600.0, 0.25, 2.99)]


def reading(text: str, name: str = "x.csv", encoding: str = "utf-8") -> Reading:
    return read([(name, text.encode(encoding))], Choices())


def _values(quantity: Quantity | None) -> list[tuple[float, float]]:
    assert isinstance(quantity, Points)
    return list(zip(quantity.wavelength_nm, quantity.values, strict=True))


def rows(found: Reading) -> list[tuple[float, float, float]]:
    n, k = _values(found.n), _values(found.k)
    assert [x for x, _ in n] == [x for x, _ in k]
    return [(x, y, z) for (x, y), (_, z) in zip(n, k, strict=True)]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        (
            "markdown.md",
            "| λ (nm) | n | k |\n|---:|:-:|---|\n{}",
        ),
        ("open.md", "λ (nm) | n | k\n--- | --- | ---\n{}"),
        ("units.csv", "Wavelength|n|k\nnm|-|-\n{}"),
        ("excel.csv", "sep=|\r\nLambda (nm)|Real refractive index|Imaginary index\r\n{}\r\n"),
        ("dos.csv", "nm|n|k\r\n{}\r\n\x1a"),
    ],
)
def test_tables_between_bars(name: str, text: str) -> None:
    body = "\n".join(f"| {x:g} | {n} | {k} |" for x, n, k in GOLD)
    if name != "markdown.md":
        body = body.replace("| ", "|").replace("\n|", "\n").strip("|")
    assert rows(reading(text.format(body), name)) == GOLD


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("point.nk", "4 400 600 2\n1.66 1.95\n0.85 1.9\n0.25 2.99\n"),
        ("comma.nk", "4 400,0 600 2\r\n1,66 1,95\r\n0,85 1,9\r\n0,25 2,99\r\n\x1a"),
        ("between.nk", "4,400,600,2\n1.66,1.95\n0.85, 1.9\n0.25,2.99\n"),
        ("footer.nk", "4 400 600 2\n1.66 1.95\n0.85 1.9\n0.25 2.99\n\nfrom AU.NK, 1996\n"),
    ],
)
def test_sopra_s_pairs_with_commas_and_a_footer(name: str, text: str) -> None:
    found = reading(text, name)
    assert found.format == "sopra_nk"
    assert rows(found) == GOLD
    left_out = [(6, "below the last pair: from AU.NK, 1996")] if name == "footer.nk" else []
    assert [(row.line, row.why) for row in found.left_out] == left_out
    told = [one.value for one in found.assumed if one.what == "decimal"]
    assert told == ([","] if name == "comma.nk" else [])


def test_words_between_sopra_s_pairs_are_refused_as_they_would_move_the_rest() -> None:
    with pytest.raises(Unreadable, match="line 3 is 'none'"):
        reading("4 400 600 2\n1.66 1.95\nnone\n0.85 1.9\n0.25 2.99\n", "x.nk")


def test_a_german_table_with_thousands_gaps_and_a_footer() -> None:
    text = (
        "Messung vom 03.04.2019; Gerät: SE-850\r\nSchichtdicke: 102,5 nm; Winkel: 65; 70; 75\r\n"
        "Wellenlänge in Nanometer;Brechungsindex n;Extinktionskoeffizient k\r\n"
        "1.000,5;1,502;0,0012\r\n950,5;1,503;0,0013\r\n900,0;1,505;k. A.\r\n"
        "850,0;1,507;0,0020\r\nMittelwert;1,504;0,0015\r\nQuelle: Labor 3\r\n"
    )
    found = reading(text, encoding="latin-1")
    assert [n for _, n in _values(found.n)] == [1.507, 1.505, 1.503, 1.502]
    assert _values(found.k) == [(850.0, 0.002), (950.5, 0.0013), (1000.5, 0.0012)]
    assert [row.line for row in found.left_out] == [8, 9]
    assert "k is missing in 1 of 4 rows" in found.warnings


@pytest.mark.parametrize(
    "cells",
    [("999.5", "1,000.5"), ("999.5", "1 000.5"), ("999.5", "1\u202f000.5"), ("999,5", "1.000,5")],
)
def test_thousands_are_set_apart_in_many_ways(cells: tuple[str, str]) -> None:
    n = "1,5" if "," in cells[0] else "1.5"
    found = reading(f"nm;n\n{cells[0]};{n}\n{cells[1]};{n}\n")
    assert _values(found.n) == [(999.5, 1.5), (1000.5, 1.5)]


def test_a_number_that_may_be_1_or_1000_is_left_out_and_told() -> None:
    text = 'nm,n\n"900","1.50"\n"950","1.50"\n"1,000","1.49"\n'
    found = reading(text)
    assert [(row.line, row.why.split("; ")[-1]) for row in found.left_out] == [
        (4, "write 1000 for 1,000 if it is that")
    ]
    with pytest.raises(Unreadable, match=r"first row left out: line 3.*write 1000"):
        reading('nm,n\n"900","1.50"\n"1,000","1.49"\n"1,100","1.48"\n')


def test_broken_rows_above_the_first_whole_one_are_told() -> None:
    found = reading("nm,n,k\n400,1.5,?!\n500,1.6,0.2\n600,1.7,0.3\n")
    assert [row.line for row in found.left_out] == [2]


def test_rows_with_nothing_in_them_are_told() -> None:
    imd = "; IMD\r\n; A  n  k\r1215.67 1.20 0.95 ; Lyman alpha\n9999.0 NaN NaN\n12000 0.3 8.1D0\n"
    found = reading(imd, "x.nk")
    assert rows(found) == [(121.567, 1.2, 0.95), (1200.0, 0.3, 8.1)]
    assert [row.line for row in found.left_out] == [4]
    cxro = (
        " SiO2 Density=2.20\n Energy(eV), Delta, Beta\n 30. 0.147 0.12\n 31. -9999. -9999.\n"
        " 91.84 0.0123 0.0108\n"
    )
    found = reading(cxro, "x.txt")
    assert [pytest.approx(row) for row in rows(found)] == [
        (HC / 91.84, 1.0 - 0.0123, 0.0108),
        (HC / 30.0, 1.0 - 0.147, 0.12),
    ]
    assert [row.line for row in found.left_out] == [4]


AG = "400 0.17 1.95\n500 0.13 2.9\n600 0.12 3.7\n"
AU = "400 1.66 1.95\n500 0.85 1.9\n600 0.25 3.0\n"


@pytest.mark.parametrize("second", [AU, "410 1.66 1.95\n510 0.85 1.9\n590 0.25 3.0\n"])
def test_tables_of_two_materials_are_not_averaged(second: str) -> None:
    head = "wavelength(nm) n k\n"
    with pytest.raises(Unreadable, match=r"line 3 and from line 9 both have n .*leave one of them"):
        reading(f"# Ag\n{head}{AG}\n# Au\n{head}{second}", "x.txt")


def test_tables_that_continue_one_another_or_are_alike_are_one() -> None:
    head = "wavelength(nm) n k\n"
    further = "600 0.12 3.7\n700 0.14 4.5\n800 0.15 5.3\n"
    found = reading(f"{head}{AG}{head}{further}", "x.txt")
    assert [x for x, _, _ in rows(found)] == [400.0, 500.0, 600.0, 700.0, 800.0]
    again = AG.replace("2.9", "2.901")
    assert rows(reading(f"{head}{AG}{head}{again}", "x.txt"))[1] == (500.0, 0.13, 2.9005)


def test_k_of_a_table_of_its_own_is_not_called_missing() -> None:
    page = (
        "DATA:\n  - type: tabulated n\n    data: |\n"
        "        0.4 1.7\n        0.5 1.68\n        0.6 1.66\n"
        "  - type: tabulated k\n    data: |\n        0.4 0.002\n        0.6 0.001\n"
    )
    assert not any("missing" in sentence for sentence in reading(page, "x.yml").warnings)


def test_both_files_of_pbrt_are_named_as_one() -> None:
    files = [("metal-Cu-eta.spd", b"400 1.2\n500 1.1\n"), ("metal-Cu-k.spd", b"400 2.2\n500 2.6\n")]
    assert read(files).name == "metal-Cu"


INSTEAD = [
    ("material,nm,n,k\ngold,400,1.66,1.95\ngold,500,0.85,1.9\n", "column 1 holds words, as gold"),
    ("nm n k quality\n400 1.66 1.95 good\n500 0.85 1.9 poor\n", "column 4 holds words, as good"),
    ("| nm | n | by |\n|---|---|---|\n| 400 | 1.5 | me |\n| 500 | 1.4 | me |\n", "column 3 holds"),
    ("wavelength,n\n400 nm,1.66\n500 nm,0.85\n", "column 1 holds units, as 400 nm"),
    ("nm N\n400 1.66+1.95i\n500 0.85+1.9i\n", r"column 2 holds n and k in one, as 1.66\+1.95i"),
    ("nm,N\n400,(1.66-1.95j)\n500,(0.85-1.9j)\n", "column 2 holds n and k in one"),
    ("wavelength (nm),400,500,600\nn,1.66,0.85,0.25\nk,1.95,1.9,3\n", "turn the table"),
    ('{"nm": [400, 500], "n": [1.5, 1.6]}', "this is JSON"),
    ("%PDF-1.4\n1 0 obj\n", "this is PDF"),
    ("<table><tr><td>400</td><td>1.5</td></tr></table>", "this is HTML"),
]


@pytest.mark.parametrize(("text", "words"), INSTEAD)
def test_what_is_no_table_is_told_what_to_do(text: str, words: str) -> None:
    with pytest.raises(Unreadable, match=words):
        reading(text)


@pytest.mark.parametrize(
    "cell", ["1" * 100_000, "1" * 100_000 + "x", "1," * 50_000 + "+", "(" * 100_000]
)
def test_endless_cells_take_no_time(cell: str) -> None:
    with pytest.raises(Unreadable):
        reading(f"nm;n\n400;{cell}\n500;{cell}x\n")


@pytest.mark.parametrize(
    "head",
    [
        "Longueur d'onde (nm);Indice de réfraction;Coefficient d'extinction",
        "Longitud de onda (nm);Índice de refracción;Coeficiente de extinción",
        "Lunghezza d'onda (nm);Indice di rifrazione;Coefficiente di estinzione",
        "Wellenlänge (nm);Brechungsindex;Extinktionskoeffizient",
    ],
)
def test_columns_in_other_languages(head: str) -> None:
    text = f"{head}\n400;1,66;1,95\n500;0,85;1,9\n600;0,25;2,99\n"
    assert rows(reading(text, encoding="latin-1")) == GOLD


def test_comments_behind_numbers_are_no_cells() -> None:
    text = "# nm n k\n400 1.66 1.95 # first\n500 0.85 1.9\n600 0.25 2.99 ! noisy, 2 %\n"
    assert rows(reading(text, "x.txt")) == GOLD


def test_a_catalog_without_a_range_says_so() -> None:
    text = "NM X 2 0 1.5168 60 0\nCD 1.03961212 0.006 0.231 0.02 1.01 103.5\n"
    with pytest.raises(Unreadable, match="range of wavelengths on the line LD"):
        reading(text, "x.agf")


PARTS = {
    "n": ["Re(n)", "Re{n}", "n_real", "n (real)", "real index", "Refractive index (real part)"],
    "k": ["Im(n)", "n_imag", "k (imag)", "imaginary index", "Refractive index (imag)"],
    "eps1": ["real(eps)", "Re[ε]", "ε'", "Real (permittivity)", "dielectric constant (real)"],
    "eps2": ["imag(eps)", "ε''", "Im epsilon", "imaginary part of the permittivity"],
    "-": ["real", "imaginary part", "eps", "n2", "absorption coefficient"],
    "wavenumber": ["k [cm-1]", "Wavenumber (per cm)"],
}


@pytest.mark.parametrize(
    ("role", "name"), [(r, name) for r, names in PARTS.items() for name in names]
)
def test_parts_of_n_are_told_from_parts_of_the_permittivity(role: str, name: str) -> None:
    """Real(eps) is not n, and k in 1/cm no k."""
    assert role_of(name)[0] == role


def test_real_and_imaginary_permittivity_beside_one_another() -> None:
    text = "wavelength (m) , real(eps) , imag(eps)\n4e-7 , 2.25 , 0\n5e-7, -9 , 0.6\n"
    (_, n, _), (at, n2, k2) = rows(reading(text, "x.txt"))
    assert n == pytest.approx(1.5)
    assert at == pytest.approx(500.0)
    assert (n2 + 1j * k2) ** 2 == pytest.approx(-9.0 + 0.6j)
