"""What is refused is answered by what was meant: another sign, unit, spelling or measurement."""

import time

import numpy as np
import pytest
from fastapi import FastAPI
from typer.testing import CliRunner

from app.batch.evaluation import evaluate
from app.batch.rows import Names, Rows
from app.cli.main import cli
from app.materials.catalog import Catalog
from app.materials.errors import WavelengthOutOfRange
from app.materials.media import default_catalog
from app.optics.errors import OutOfRange
from app.optics.interface import Interface
from app.optics.meant import instead
from app.optics.registry import default_registry
from tests.api.shape import Ask, error_of
from tests.api.test_evaluate import poster, results

NO_GAIN = "N = n + i k with k >= 0; for n - i k give "
TWO_NUMBERS = "N = n + i k with k >= 0; for n + i k give n_t = 0.2 and k_t = 3.4"


@pytest.mark.parametrize(
    ("path", "query", "message"),
    [
        *[(path, {"k_t": "-3.4"}, f"{NO_GAIN}3.4") for path in ("/snell", "/curves", "/albedo")],
        ("/formulas/angle.penetration_depth/curve", {"k_t": "-3.4"}, f"{NO_GAIN}3.4"),
        ("/convert", {"from": "nk", "k_t": "-3.4"}, f"{NO_GAIN}3.4"),
        ("/errors", {"k_t": "-1e-3", "models": "schlick"}, f"{NO_GAIN}0.001"),
        ("/albedo/map", {"k_minimum": "-1"}, f"{NO_GAIN}1"),
        ("/errors/sweep", {"over": "k_t", "minimum": "-2"}, f"{NO_GAIN}2"),
        *[
            ("/snell", {"n_t": text}, TWO_NUMBERS)
            for text in ("0.2+3.4j", "0.2 3.4j", "0.2 + 3.4i", "(0.2+3.4j)", "0.2+3.4*i")
        ],
        ("/snell", {"n_t": "0.2-3.4j"}, f"{NO_GAIN}n_t = 0.2 and k_t = 3.4"),
        ("/snell", {"k_t": "3.4j"}, "N = n + i k with k >= 0; for n + i k give k_t = 3.4"),
    ],
)
def test_signs_and_complex_indices(
    ask: Ask, path: str, query: dict[str, str], message: str
) -> None:
    assert error_of(ask(path, **query))["message"] == message


def test_signs_and_complex_indices_in_python() -> None:
    with pytest.raises(OutOfRange, match=r"k_t = -3\.4 is not allowed: N = n .*give 3\.4"):
        Interface(n_t=0.2, k_t=-3.4)
    with pytest.raises(OutOfRange, match=r"give n_t = 0\.2 and k_t = 3\.4"):
        Interface(n_t=0.2 + 3.4j)


@pytest.mark.parametrize(
    ("path", "query"),
    [
        ("/snell", {"material": "Au", "wavelength_nm": "0.55"}),
        ("/snell", {"incident": "water", "wavelength_nm": "0.55"}),
        ("/materials/Au", {"wavelength_nm": "0.55"}),
        ("/materials/Au/spectrum", {"minimum_nm": "0.55"}),
        ("/materials/Au/map", {"minimum_nm": "0.55"}),
        ("/materials/Au/curves", {"wavelengths_nm": "0.55"}),
        ("/snell", {"material": "air-shirley", "wavelength_nm": "0.55"}),
    ],
)
def test_a_wavelength_in_micrometers(ask: Ask, path: str, query: dict[str, str]) -> None:
    assert error_of(ask(path, **query))["message"].endswith("; in nm: did you mean 550?")


def test_a_wavelength_in_meters(ask: Ask) -> None:
    error = error_of(ask("/snell", material="Au", wavelength_nm="5.5e-7"))
    assert error["message"].endswith("; in nm: did you mean 550?")


@pytest.mark.parametrize(
    ("path", "query"),
    [
        ("/films/color", {"layers": "1.33", "thickness_nm": "5..1:3"}),
        ("/films/color", {"layers": "1.33", "thickness_nm": "abc"}),
        ("/films/solve", {"layers": "1.33", "target": "color", "thickness_nm": "1,-2"}),
    ],
)
def test_the_words_of_a_validator_are_told_as_they_are(
    ask: Ask, path: str, query: dict[str, str]
) -> None:
    message = error_of(ask(path, **query))["message"]
    assert message.startswith(("first..last:steps", "each ")), message


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("wavelength_um", "0.55", "wavelength_um times 1000: wavelength_nm = 550"),
        ("wavelength_A", "5876", "wavelength_A times 0.1: wavelength_nm = 587.6"),
    ],
)
def test_a_name_that_ends_in_another_unit_is_told_the_factor(
    ask: Ask, name: str, value: str, message: str
) -> None:
    assert error_of(ask("/snell", **{name: value}))["message"].endswith(message)


def test_a_wavelength_out_of_range_names_the_measurements_that_cover_it(ask: Ask) -> None:
    query = {"material": "water", "wavelength_nm": "10600"}
    told = (
        "182 to 1129 nm, where n of water is known; water-Hale and water-Segelstein are known there"
    )
    assert error_of(ask("/snell", **query))["message"] == told
    assert error_of(ask("/materials/water/spectrum", maximum_nm="10600"))["message"] == told
    alone = error_of(ask("/snell", material="water", wavelength_nm="100"))["message"]
    assert alone.endswith("; water-Segelstein is known there")


def test_rows_are_answered_in_the_same_words() -> None:
    count, nm = 5, [10600.0, 100.0, 0.55, 0.6, 1e7]
    water = Names(np.zeros(count, np.intp), ["water"])
    faults = evaluate(
        Rows(count, {"wavelength_nm": np.array(nm)}, {"material": water}), default_registry()
    ).faults
    for row, value in enumerate(nm):
        with pytest.raises(WavelengthOutOfRange) as refused:
            default_catalog().constants("water", value)
        assert faults[row].message == refused.value.allowed
    assert [faults[row].message[-4:-1] for row in (2, 3)] == ["550", "600"]
    told = evaluate(Rows(2, {"k_t": np.array([-3.4, -0.5])}, {}), default_registry()).faults
    assert [told[row].message for row in (0, 1)] == [f"{NO_GAIN}3.4", f"{NO_GAIN}0.5"]


def test_items_are_answered_in_the_same_words(app: FastAPI) -> None:
    items = [{"k_t": -3.4}, {"n_t": "0.2+3.4j"}, {"wavelength_um": 0.55}]
    answer = poster(app)(items)
    messages = [result["errors"][0]["message"] for result in results(answer)]
    assert messages[:2] == [f"{NO_GAIN}3.4", TWO_NUMBERS]
    assert messages[2].endswith("give wavelength_nm, which is wavelength_um times 1000")


@pytest.mark.parametrize("text", ["4%", "4 %", "4.0%"])
@pytest.mark.parametrize(
    ("path", "more"),
    [("/convert", {"from": "f0"}), ("/curves", {"models": "hoffman_f82"})],
)
def test_a_percentage_is_told_its_number(
    ask: Ask, path: str, more: dict[str, str], text: str
) -> None:
    name = "F0" if path == "/convert" else "hoffman_f82.F0"
    errors = ask(path, **more, **{name: text}).json()["errors"]
    assert [error["message"] for error in errors] == [
        "a number without a percent sign; did you mean 0.04?"
    ]


@pytest.mark.parametrize("text", ["a", "a,b,c", "1,2", ""])
def test_what_is_no_color_is_one_error_without_words_of_python(ask: Ask, text: str) -> None:
    told = ask("/convert", **{"from": "f0", "F0": text}).json()["errors"]
    assert [error["message"] for error in told] == ["one number, or three separated by commas"]


@pytest.mark.parametrize("letter", ["1", " ", "1,", "1%,", "-", "j"])
@pytest.mark.parametrize("name", ["n_t", "k_t", "F0"])
def test_what_a_long_text_may_mean_takes_no_time(name: str, letter: str) -> None:
    started = time.process_time()
    assert instead(name, f"1{letter * 65_000}x") is None
    assert time.process_time() - started < 0.1


@pytest.fixture(scope="module")
def catalog() -> Catalog:
    return default_catalog()


@pytest.mark.parametrize(
    "kind", ["glass", "crystal", "metal", "liquid", "oil", "garnet", "fluoride"]
)
def test_a_word_or_a_kind_is_answered_by_what_is_called_so(catalog: Catalog, kind: str) -> None:
    nearest = [catalog.get(one) for one in catalog.nearest(kind)]
    assert nearest
    for preset in nearest:
        called = " ".join((preset.name, *preset.aliases)).casefold()
        assert kind == preset.category or kind in called, preset.id


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("alumina", "sapphire-o"),
        ("aluminium oxide", "sapphire-o"),
        ("aluminum oxide", "sapphire-o"),
        ("silicon dioxide", "fused-silica"),
        ("silica", "fused-silica"),
        ("zirconia", "cubic-zirconia"),
        ("zirconium dioxide", "cubic-zirconia"),
        ("titania", "rutile-o"),
        ("titanium dioxide", "rutile-o"),
        ("magnesia", "MgO"),
        ("calcium carbonate", "calcite-o"),
    ],
)
def test_compounds_are_found_by_their_chemical_names(
    catalog: Catalog, name: str, found: str
) -> None:
    assert catalog.get(name).id == found
    assert catalog.search(name)[0].id == found


@pytest.mark.parametrize("command", ["snell", "material"])
def test_help_says_where_a_bound_is_not_among_what_is_allowed(command: str) -> None:
    printed = CliRunner().invoke(cli, [command, "--help"], env={"COLUMNS": "400"}).output
    (line,) = [line for line in printed.splitlines() if "--wavelength_nm" in line]
    assert "Above 0, up to 1e+07." in line
    assert "From 0 to" not in line
