"""`fresnel-explorer material FILE`: the report and the numbers of a file."""

import json
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli.main import cli

FILES = Path(__file__).parents[1] / "materials/reading/files"


def run(name: str, *arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(cli, ["material", str(FILES / name), *arguments])
    return result.exit_code, result.output


def test_the_report_and_the_numbers_are_shown() -> None:
    code, printed = run("other-sign.csv")
    assert code == 0
    words = re.sub(r"\s+", " ", printed)
    assert "--sign n-ik k is negative in 100% of the rows" in words
    assert "400 0.17 1.95" in words
    assert "own:" in words
    assert "from vacuum.F0" in words


def test_rows_left_out_are_shown_by_line() -> None:
    words = re.sub(r"\s+", " ", run("bad-n.csv")[1])
    assert "3 n = 0 is not computed with" in words


def test_what_cannot_be_told_is_asked_and_can_be_set() -> None:
    code, printed = run("headerless-um-or-ev.txt")
    assert (code, "unit=um or unit=eV" in printed) == (2, True)
    code, printed = run("headerless-um-or-ev.txt", "--unit", "um", "--format", "csv")
    assert printed == "wavelength_nm,n,k\n300.0,1.55,\n1000.0,1.5,\n2500.0,1.48,\n"


def test_k_beside_eta_is_read_along() -> None:
    told = json.loads(run("Xx.eta.spd", "--format", "json")[1])
    assert told["spectrum"]["k"] == [1.08, 1.95, 5.95]
    own = CliRunner().invoke(cli, ["material", told["material"], "--format", "json"])
    assert json.loads(own.output)["name"] == "Xx"


def test_what_else_is_asked_is_asked_of_the_material() -> None:
    code, printed = run("comma.csv", "--wavelength_nm", "600")
    assert (code, "400 to 500 nm" in printed) == (2, True)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("comma.csv", "--unit", "furlong"), "'nm', 'um'"),
        (("comma.csv", "--file_format", "tabel"), "nearest: table"),
    ],
)
def test_choices_that_are_none_are_refused(arguments: tuple[str, ...], words: str) -> None:
    code, printed = run(*arguments)
    assert (code, words in printed) == (2, True)


def test_choices_of_files_are_not_for_presets() -> None:
    result = CliRunner().invoke(cli, ["material", "Au", "--unit", "nm"])
    assert (result.exit_code, "no file" in result.output) == (2, True)


def test_its_figure_is_saved(tmp_path: Path) -> None:
    saved = tmp_path / "film.json"
    code, _ = run("comma.csv", "--save", str(saved))
    assert code == 0
    assert {"n", "k"} <= {trace["name"] for trace in json.loads(saved.read_bytes())["data"]}
