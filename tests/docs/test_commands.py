"""The queries of the command line: the API's answers, its parameters and its words."""

import csv
import io
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any
from urllib.parse import quote, urlencode

import pytest
import typer
from fastapi import FastAPI
from rich.console import Console
from typer.testing import CliRunner

from app.api.table import RouteTable
from app.cli import plots, tables
from app.cli.main import cli
from app.cli.queries import COMMANDS, Command
from tests.api.raw import send

ROOT = Path(__file__).parents[2]
ASKED: dict[str, tuple[str, dict[str, str]]] = {
    "curve": ("", {"n_t": "1.5", "models": "exact,schlick", "samples": "5"}),
    "snell": ("", {"n_t": "1.5", "theta_i_deg": "64"}),
    "albedo": ("", {"n_t": "1.5", "models": "schlick"}),
    "errors": ("", {"n_t": "1.5", "models": "lazanyi2005", "k_t": "5", "lazanyi2005.alpha": "7.7"}),
    "recommend": ("", {"material": "Au", "max_error": "0.01"}),
    "material": ("Au", {"wavelength_nm": "500"}),
    "materials": ("", {"q": "gold"}),
    "convert": ("", {"from": "rg", "r": "0.5", "g": "0.25"}),
    "models": ("", {"fields": "id,title,kind,applies_to"}),
    "shader": ("schlick", {"language": "wgsl"}),
    "lut": ("", {"n_t": "1.5", "size": "5"}),
    "claims": ("", {"verdict": "does not hold"}),
    "film": ("", {"layers": "MgF2:99.6", "material": "BK7", "step_nm": "100"}),
    "film-solve": ("", {"layers": "1.38", "n_t": "1.52", "thickness_nm": "0..200:101"}),
}


def run(*arguments: str) -> Any:
    return CliRunner().invoke(cli, arguments)


def options(query: dict[str, str]) -> list[str]:
    return [word for name, value in query.items() for word in (f"--{name}", value)]


def api(app: FastAPI, command: Command, query: dict[str, str]) -> bytes:
    path = re.sub(r"\{\w+\}", quote(ASKED[command.name][0]), command.route)
    answer = send(app, f"/api/v1{path}?{urlencode(query)}".encode())
    assert answer.status == 200
    return answer.body


def test_every_command_is_tried_here() -> None:
    assert [command.name for command in COMMANDS] == list(ASKED)


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.name)
def test_json_is_the_answer_of_the_api(app: FastAPI, command: Command) -> None:
    argument, query = ASKED[command.name]
    result = run(command.name, *filter(None, [argument]), *options(query), "--format", "json")
    assert result.exit_code == 0, result.output
    assert json.loads(result.output) == json.loads(api(app, command, query))


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command.name)
def test_tables_and_csv_show_it(command: Command) -> None:
    argument, query = ASKED[command.name]
    call = (command.name, *filter(None, [argument]), *options(query))
    table = run(*call)
    assert table.exit_code == 0, table.output
    assert ("───" in table.output) is (command.text is None)
    assert not any(line.endswith(" ") for line in table.output.splitlines())
    written = run(*call, "--format", "csv")
    header, *rows = csv.reader(io.StringIO(written.output))
    assert rows
    assert all(len(row) == len(header) for row in rows)


def test_a_table_holds_the_numbers(app: FastAPI) -> None:
    answer = json.loads(api(app, COMMANDS[3], {"n_t": "1.5", "models": "schlick", "digits": "4"}))
    row = answer["errors"][0]
    printed = run("errors", "--n_t", "1.5", "--models", "schlick", "--digits", "4").output.split()
    for name in ("max_abs", "max_abs_at_deg", "rms", "max_relative"):
        assert f"{row[name]:.12g}" in printed
    csv_of_api = api(app, COMMANDS[0], {"samples": "3", "format": "csv"}).decode()
    assert run("curve", "--samples", "3", "--format", "csv").output == csv_of_api.replace(
        "\r\n", "\n"
    )


def test_a_flag_is_sent() -> None:
    assert "56.3099" in run("curve", "--landmarks", "--digits", "6").output


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("snell", "--n_t", "-1"), ("n_t = -1", "0.001 to 100")),
        (("snell", "--n_t", "nan"), ("n_t = nan",)),
        (("errors", "--models", "schlik"), ("schlik", "schlick")),
        (("curve", "--material", "Au", "--n_t", "2"), ("n_t = 2", "material = Au")),
        (("material", "Gld"), ("Gld", "nearest")),
        (("material", "../models"), ("../models",)),
        (("convert", "--from", "nonsense"), ("from = nonsense",)),
        (("recommend", "--max_error", "2"), ("max_error = 2",)),
        (("curve", "--save", "figure.gif"), ("format = gif",)),
        (("curve", "--nonsense", "1"), ("nonsense",)),
        (("snell", "--wavelength_um", "0.55"), ("times 1000", "wavelength_nm = 550")),
        (("film", "--minimum_um=0.4"), ("times 1000", "minimum_nm = 400")),
        (("curve", "--format", "xml"), ("xml",)),
        (("material",), ("MATERIAL",)),
    ],
)
def test_what_is_wrong_is_told_in_the_apis_words(
    arguments: tuple[str, ...], words: tuple[str, ...]
) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    for word in words:
        assert word.lower() in result.output.lower()
    assert "Traceback" not in result.output


@pytest.mark.parametrize("command", COMMANDS, ids=lambda c: c.name)
def test_what_typer_refuses_itself_is_told_without_pydantics_prefix(command: Command) -> None:
    argument = ASKED[command.name][0]
    result = run(command.name, *filter(None, [argument]), "--format", "xml")
    assert result.exit_code == 2
    assert "Value error" not in result.output
    said = re.sub(r"[│╭╮╰╯─]+|\s+", " ", result.output)
    assert "'--format': 'xml' is none of table, json, csv" in said


def test_a_table_says_what_it_is_about() -> None:
    for name in ("curve", "errors", "albedo", "recommend", "snell", "lut"):
        wanted = {"max_error": "0.05"} if name == "recommend" else {}
        first = run(name, "--material", "Au", *options(wanted)).output.splitlines()[0]
        assert first.startswith("n_i = 1; n_t = 0.224436, k_t = 2.98068 (Gold, Au, at 587.6 nm)")
    first = run("curve", "--incident", "water", "--n_t", "1.5", "--samples", "2").output
    assert first.startswith("n_i = 1.3334 (Water, 20 °C, water, at 587.6 nm); n_t = 1.5, k_t = 0\n")


def test_errors_of_a_metal_in_color_are_those_against_its_spectrum(app: FastAPI) -> None:
    asked = ("errors", "--rgb", "--material", "Au", "--models", "f82_tint,schlick")
    query = {"models": "f82_tint,schlick"}
    body = send(app, f"/api/v1/materials/Au/curves?{urlencode(query)}".encode()).body
    assert json.loads(run(*asked, "--format", "json").output) == json.loads(body)
    curves = {curve["model"]: curve for curve in json.loads(body)["rgb"]["curves"]}
    printed = run(*asked)
    assert "Gold (Au), its spectrum in linear sRGB under D65" in printed.output
    rows = {tuple(line.split()[:2]): line.split() for line in printed.output.splitlines()}
    for model in ("f82_tint", "schlick"):
        for channel in ("red", "green", "blue"):
            error = curves[model]["errors"][channel]["max_abs"]
            assert float(rows[model, channel][2]) == pytest.approx(error, rel=1e-5)
    refused = run("errors", "--rgb", "--n_t", "1.5")
    assert refused.exit_code == 2
    assert "--material" in refused.output


def test_code_is_printed_and_written_as_the_api_sends_it(app: FastAPI, tmp_path: Path) -> None:
    def sent(language: str) -> bytes:
        path = f"/api/v1/shaders/schlick?language={language}&format=text"
        return send(app, path.encode()).body

    assert run("shader", "schlick", "--language", "hlsl").output.encode() == sent("hlsl")
    for ending, language in (("wgsl", "wgsl"), ("py", "python"), ("frag", "glsl")):
        file = tmp_path / f"schlick.{ending}"
        assert run("shader", "schlick", "--save", str(file)).exit_code == 0
        assert file.read_bytes() == sent(language)
    refused = run("shader", "schlick", "--language", "osl", "--save", str(tmp_path / "a.hlsl"))
    assert refused.exit_code == 2
    assert not (tmp_path / "a.hlsl").exists()
    unknown = run("shader", "schlik")
    assert unknown.exit_code == 2
    assert "schlick" in unknown.output


@pytest.mark.parametrize("ending", ["csv", "exr", "json", "npy", "png"])
def test_a_table_is_written_as_the_api_sends_it(app: FastAPI, tmp_path: Path, ending: str) -> None:
    file = tmp_path / f"table.{ending}"
    result = run("lut", "--material", "Au", "--size", "8", "--save", str(file))
    assert result.exit_code == 0, result.output
    path = f"/api/v1/lut?material=Au&size=8&format={ending}"
    assert file.read_bytes() == send(app, path.encode()).body
    assert run("lut", "--save", str(tmp_path / "table.gif")).exit_code == 2


@pytest.mark.parametrize(
    ("channels", "columns"), [("1", ["mu", "R"]), ("3", ["mu", "red", "green", "blue"])]
)
def test_tables_of_films_are_printed(channels: str, columns: list[str]) -> None:
    result = run("lut", "--layers", "1.38:100", "--size", "4", "--channels", channels)
    assert result.exit_code == 0
    assert columns in [line.split() for line in result.stdout.splitlines()]


@pytest.mark.parametrize("width", [40, 60, 80, 120])
def test_tables_stay_within_the_terminal(width: int) -> None:
    header = ("model", "quantity", "cosine_weighted_mean", "max_abs_at_deg", "reason", "empty")
    why = "made for a conductor, and this is a dielectric; from the thinner side"
    rows = [("lagarde_dielectric", "R", 0.123456, 84.9712, why, ""), ("exact", "R", 0, 0, "", "")]
    parts = tables.within(tables.Sheet(header, rows), width)
    text = io.StringIO()
    console = Console(file=text, width=width, highlight=False)
    console.print(*map(tables._drawn, parts))
    lines = text.getvalue().splitlines()
    assert max(map(len, lines)) <= width
    # Numbers and ids stay in one piece, on a line that begins with the model's.
    for number in ("0.123456", "84.9712"):
        assert any(line.split()[:1] == [rows[0][0]] and number in line for line in lines)
    assert width < 60 or set(why.split()) <= set(" ".join(lines).split())


@pytest.mark.parametrize("command", [c for c in COMMANDS if c.figure], ids=lambda c: c.name)
def test_figures_in_the_terminal_and_in_files(command: Command, tmp_path: Path) -> None:
    argument, query = ASKED[command.name]
    call = (command.name, *filter(None, [argument]), *options(query))
    drawn = run(*call, "--plot")
    assert drawn.exit_code == 0, drawn.output
    assert drawn.output.count("┤") > 4
    assert "angle of incidence" in drawn.output
    *_, legend = drawn.output.splitlines()
    assert re.match(r"a \S", legend)  # below the plot, where no curve is
    assert re.search(" → |Gold", drawn.output.splitlines()[0])
    file = tmp_path / "figure.html"
    assert run(*call, "--save", str(file)).exit_code == 0
    assert b"Fresnel Explorer" in file.read_bytes()


def test_a_figure_is_opened(monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    monkeypatch.setattr(typer, "launch", opened.append)
    result = run("snell", "--theta_i_deg", "30", "--open")
    assert result.exit_code == 0
    file = Path(opened[0].removeprefix("file://"))
    assert file.read_bytes().startswith(b"<!doctype html>")
    file.unlink()


def test_every_parameter_of_a_route_is_an_option(
    app: FastAPI, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "400")
    table: RouteTable = app.state.table
    for command in COMMANDS:
        route, _ = table.find(re.sub(r"\{\w+\}", "schlick", command.route))
        assert route is not None
        told = run(command.name, "--help").output
        fields = {} if route.query_model is None else route.query_model.model_fields
        for name, info in fields.items():
            assert f"--{info.alias or name}" in told, (command.name, name)
        if command.figure:
            assert table.find(f"/figures/{command.figure}")[0] is not None


def test_help_names_every_command() -> None:
    told = run("--help").output
    for command in COMMANDS:
        assert command.name in told
    assert "serve" in told


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        ("curve --models exact,schl", "exact,schlick"),
        ("curve --material A", "Au"),
        ("convert --from f0", "f0_srgb"),
        ("rec", "recommend"),
    ],
)
def test_the_shell_completes(typed: str, offered: str) -> None:
    environment = {
        "_FRESNEL_EXPLORER_COMPLETE": "complete_bash",
        "COMP_WORDS": f"fresnel-explorer {typed}",
        "COMP_CWORD": str(len(typed.split())),
    }
    result = CliRunner().invoke(cli, [], env=environment, prog_name="fresnel-explorer")
    assert offered in result.output.split()


def test_the_version_does_not_wait_for_the_api() -> None:
    code = "import sys, app.cli.main; print('app.main' in sys.modules, 'plotly' in sys.modules)"
    told = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True
    )
    assert told.stdout.split() == ["False", "False"]


def test_markup_is_left_out_of_a_terminal() -> None:
    assert plots._plain("n<sub>t</sub>") == "nt"
    assert plots._plain(None) == ""
