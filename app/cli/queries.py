"""Commands that ask the API's routes in this process: same parameters, same answers, no server."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote, urlencode

import orjson
import typer
import typer.main
from pydantic.fields import FieldInfo
from starlette.exceptions import HTTPException
from starlette.requests import Request
from typer.core import TyperCommand, TyperGroup

from app.answers.rounding import rounded
from app.api import PREFIX
from app.api.table import RouteTable
from app.cli import plots, reading, tables
from app.cli.options import (
    FILE_PANEL,
    OUTPUT,
    argument,
    in_colors,
    output_parameters,
    parameter,
)
from app.cli.tables import Sheets
from app.http.problems import PROBLEMS, problem_of
from app.http.writing import csv_bytes, write
from app.optics.meant import in_our_unit
from app.settings import Settings

_DIGITS = "6"  # of a table, where nobody asked for more


@dataclass(frozen=True, slots=True, kw_only=True)
class Command:
    """A command and the route that it asks."""

    name: str
    """As typed."""
    route: str
    """Path below /api/v1; a part in braces is the command's argument."""
    help: str
    """What it does, and an example."""
    sheets: Sheets
    """The answer as tables."""
    figure: str | None = None
    """Name of the figure that --plot, --open and --save draw, if any."""
    in_table: Mapping[str, str] = field(default_factory=dict)
    """Parameters that tables take unless they are given."""
    reads_files: bool = False
    """Whether a file may stand in the argument's place."""
    endings: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    """What the endings of the files that --save writes say as parameters; "" are all others."""
    text: Callable[[Any], str] | None = None
    """The answer as it is printed, where that is no table."""
    read: Callable[[Any], Any] = lambda answer: answer
    """What the route's answer is taken for."""
    rgb: Command | None = None
    """What --rgb asks in its place, if anything."""

    @property
    def argument(self) -> str | None:
        """Name of the part of the path that is typed first."""
        return self.route.partition("{")[2].partition("}")[0] or None


_ERRORS = ("max_abs", "max_abs_at_deg", "rms", "cosine_weighted_mean", "max_relative")

_LANGUAGES = {
    "glsl": "glsl",
    "hlsl": "hlsl",
    "wgsl": "wgsl",
    "osl": "osl",
    "js": "javascript",
    "py": "python",
}

_IN_COLORS = Command(
    name="errors",
    route="/materials/{material}/curves",
    help="Errors of R, G and B",
    sheets=tables.color_errors,
    figure="material",
    in_table={"models": "schlick", "wavelengths_nm": "550"},
)

COMMANDS = (
    Command(
        name="curve",
        route="/curves",
        help="Reflectance over the angle: fresnel-explorer curve --n_t 1.5 --models exact,schlick",
        sheets=tables.curves,
        figure="explore",
        in_table={"samples": "19"},
    ),
    Command(
        name="snell",
        route="/snell",
        help="One ray at a surface: fresnel-explorer snell --n_t 1.5 --theta_i_deg 64",
        sheets=tables.pairs,
        figure="explore",
    ),
    Command(
        name="albedo",
        route="/albedo",
        help="Hemispherical albedo, exact and by every fit: fresnel-explorer albedo --n_t 1.5",
        sheets=tables.several(
            lambda answer: tables.pairs({"exact": answer.exact, "flatland": answer.flatland}),
            tables.listed("models", "model", "value", "error", "reason", title="models"),
            tables.listed("approximations", "id", "value", "error", "reason", title="fits"),
        ),
    ),
    Command(
        name="errors",
        route="/errors",
        help="How wrong models are: fresnel-explorer errors --n_t 1.5 --models "
        "schlick,one_minus_cos; of a metal in color: errors --rgb --material Au --models "
        "f82_tint,schlick",
        sheets=tables.listed("errors", "model", "quantity", *_ERRORS, "reason"),
        figure="compare",
        rgb=_IN_COLORS,
    ),
    Command(
        name="recommend",
        route="/recommend",
        help="The cheapest models within an error: fresnel-explorer recommend --n_t 1.5 "
        "--max_error 0.05",
        sheets=tables.several(
            tables.listed("models", "model", "weighted_cost", "figures.max_abs", "figures.rms"),
            tables.listed("refused", "model", "weighted_cost", "reason", title="ruled out"),
        ),
    ),
    Command(
        name="material",
        route="/materials/{material}",
        help="Index, color and source of a material, or what a file of n and k holds and how it was "
        "read: fresnel-explorer material Au, fresnel-explorer material film.csv --unit um",
        sheets=tables.several(
            tables.pairs,
            tables.listed("rivals", "id", "n", "k", "wavelength_nm", "source", title="rivals"),
        ),
        figure="material",
        reads_files=True,
    ),
    Command(
        name="materials",
        route="/materials",
        help="Search the materials: fresnel-explorer materials --q gold",
        sheets=tables.listed("materials", "id", "name", "category", "n", "k", "wavelength_nm"),
    ),
    Command(
        name="convert",
        route="/convert",
        help="Indices, F0 and engine values into one another: fresnel-explorer convert --from f0 "
        "--F0 0.04",
        sheets=tables.conversions,
    ),
    Command(
        name="models",
        route="/models",
        help="All models, exact and approximate.",
        sheets=tables.listed("models", "id", "title", "kind", "applies_to"),
    ),
    Command(
        name="shader",
        route="/shaders/{model_id}",
        help="A model as code to paste: fresnel-explorer shader schlick --language hlsl, "
        "fresnel-explorer shader f82_tint --channels 3 --save f82_tint.wgsl",
        sheets=tables.listed("arguments", "name", "symbol", "description"),
        text=lambda answer: str(answer.code),
        endings={
            **{end: {"language": language} for end, language in _LANGUAGES.items()},
            "": {},
        },
    ),
    Command(
        name="lut",
        route="/lut",
        help="A lookup table for a renderer: fresnel-explorer lut --n_t 1.5 --size 64 "
        "--save fresnel.exr",
        sheets=tables.lookup,
        read=lambda answer: rounded(tables.lookup_in(answer), int(_DIGITS)),
        in_table={"size": "17"},
        endings={end: {"format": end} for end in ("csv", "exr", "json", "npy", "png")},
    ),
    Command(
        name="claims",
        route="/claims",
        help="What the literature claims, and what is measured.",
        sheets=tables.listed("claims", "verdict", "id", "found"),
    ),
    Command(
        name="film",
        route="/films/spectrum",
        help="Films over the wavelength: fresnel-explorer film --layers MgF2:99.6 --material BK7",
        sheets=tables.curves,
        in_table={"step_nm": "20"},
    ),
    Command(
        name="film-solve",
        route="/films/solve",
        help="Thicknesses that reach something: fresnel-explorer film-solve --layers MgF2 "
        "--material BK7 --wavelength_nm 550",
        sheets=tables.listed("solutions", "layers", "R", "T", "A", "hex", "delta_e"),
    ),
)


_BY_NAME = {command.name: command for command in COMMANDS}


@cache
def _table() -> RouteTable:
    from app.main import create_app

    # The defaults, whatever the environment says: that is for the server.
    table: RouteTable = create_app(Settings.model_construct()).state.table
    return table


@contextmanager
def _told(path: str) -> Iterator[None]:
    """Tell a problem in the API's words, with the exit code of a wrong call."""
    problem: Exception
    try:
        yield
        return
    except LookupError:
        path, problem = unquote(path), HTTPException(404)
    except PROBLEMS as error:
        problem = error
    response = problem_of(Request({"type": "http", "path": PREFIX + path, "headers": []}), problem)
    typer.echo(f"Error: {response.detail}", err=True)
    raise typer.Exit(2)


def _ask(path: str, query: Mapping[str, str]) -> Any:
    """The answer of a route."""
    with _told(path):
        return _table().ask(f"{path}?{urlencode(query)}")


def _written(path: str, query: Mapping[str, str]) -> bytes:
    """The answer of a route as the API sends it."""
    with _told(path):
        return _table().written(f"{path}?{urlencode(query)}")


def _fields(path: str) -> Mapping[str, FieldInfo]:
    """What the route of a path takes; nothing where there is no route."""
    route, _ = _table().find(path)
    return route.query_model.model_fields if route and route.query_model else {}


def _run(command: Command, given: dict[str, str], output: Mapping[str, Any]) -> None:
    path, named = command.route, {}
    if command.reads_files:
        chosen = {name: given.pop(name) for name in reading.FIELDS if name in given}
        name = given["material"]
        if reading.is_file(name):
            asked = {key: value for key, value in given.items() if key != "material"}
            _run_file(command, name, chosen, asked, output)
            return
        if chosen:
            option = next(iter(chosen))
            raise typer.BadParameter(f"{name} is no file", param_hint=f"--{option}")
    if output["rgb"] and command.rgb:
        command = command.rgb
        path = command.route
        if "material" not in given:
            raise typer.BadParameter("it needs a --material with a spectrum", param_hint="--rgb")
    if command.argument:
        named = {command.argument: given.pop(command.argument)}
        path = path.format_map({name: quote(value, safe="") for name, value in named.items()})
    if command is _IN_COLORS:
        given = {"models": command.in_table["models"]} | given
    fields, form = _fields(path), output["format"]
    if output["save"] and command.endings:
        _save(command, path, given, output["save"])
    elif output["plot"] or output["open"] or output["save"]:
        _draw(command, given | named, output)
    elif form == "json" and sys.stdout.isatty():
        indented = orjson.OPT_SERIALIZE_NUMPY | orjson.OPT_INDENT_2
        typer.echo(orjson.dumps(_ask(path, given), option=indented))
    elif form == "json":
        typer.echo(_written(path, given))
    elif form == "csv" and "format" in fields and not command.text:
        written = _written(path, {**given, "format": "csv"}).decode()
        typer.echo(written.replace("\r\n", "\n"), nl=False)
    elif form == "csv":
        typer.echo(tables.write_csv(command.sheets(_ask(path, given))), nl=False)
    else:
        usual = {"digits": _DIGITS, **command.in_table}
        given = {name: v for name, v in usual.items() if name in fields} | given
        answer = command.read(_ask(path, given))
        if command.text:
            typer.echo(command.text(answer), nl=False)
        else:
            tables.print_tables(command.sheets(answer), tables.heading(answer))


def _save(command: Command, path: str, given: Mapping[str, str], file: Path) -> None:
    """Write the answer into a file, whose ending says as what."""
    ending = file.suffix.removeprefix(".").lower()
    meant = command.endings.get(ending, command.endings.get(""))
    if meant is None:
        named = ", ".join(filter(None, command.endings))
        raise typer.BadParameter(f"{file}: it ends in none of {named}", param_hint="--save")
    for name, value in meant.items():
        if given.get(name, value) != value:
            said = f"{file}: its ending says {name} = {value}, and --{name} says {given[name]}"
            raise typer.BadParameter(said, param_hint="--save")
    text = {"format": "text"} if command.text else {}
    body = _written(path, {**given, **meant, **text})
    file.write_bytes(body)
    typer.echo(f"{file}: {len(body)} bytes", err=True)


def _run_file(
    command: Command,
    name: str,
    chosen: Mapping[str, str],
    given: Mapping[str, str],
    output: Mapping[str, Any],
) -> None:
    """Answer what is asked of a preset for a material out of a file."""
    with _told(command.route):
        answer = reading.read(name, chosen)
    if output["plot"] or output["open"] or output["save"]:
        _draw(command, {**given, "material": answer.material}, output)
        return
    # What else is given is asked of the material, so that what is wrong with it is told.
    path = command.route.format(material=quote(answer.material, safe=""))
    form, digits = output["format"], int(given.get("digits", 17))
    detail = _ask(path, {"digits": _DIGITS, **given} if form == "table" else given)
    if form == "json":
        typer.echo(bytes(write(answer, digits=digits).body))
    elif form == "csv":
        written = csv_bytes(reading.table(answer), digits).decode()
        typer.echo(written.replace("\r\n", "\n"), nl=False)
    else:
        shown = rounded(answer, int(given.get("digits", _DIGITS)))
        constants = tables.pairs({"from vacuum": detail.constants, "color": detail.display})
        tables.print_tables([*reading.sheets(shown), *constants])


def _draw(command: Command, given: Mapping[str, str], output: Mapping[str, Any]) -> None:
    path = f"/figures/{command.figure}"
    known = {info.alias or name for name, info in _fields(path).items()}
    taken = {name: value for name, value in given.items() if name in known}
    if output["plot"]:
        typer.echo(plots.in_terminal(_ask(path, taken).figure))
    if output["save"]:
        file: Path = output["save"]
        body = _written(path, taken | {"format": file.suffix.removeprefix(".")})
        file.write_bytes(body)
        typer.echo(f"{file}: {len(body)} bytes", err=True)
    if output["open"]:
        typer.echo(plots.open_page(_written(path, taken | {"format": "html"})), err=True)


class _InOurUnits(TyperCommand):
    """A command that tells the factor where an option ends in another unit than ours."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Refuse such an option in the API's words; the rest is typer's."""
        known = {option.removeprefix("--") for one in self.params for option in one.opts}
        for word, following in pairwise([*args, ""]):
            name, _, value = word.removeprefix("--").partition("=")
            if word.startswith("--") and name not in known:
                told = in_our_unit(name, known, value or following)
                if told is not None:
                    typer.echo(f"Error: {name}: unknown parameter; {told}", err=True)
                    raise typer.Exit(2)
        return super().parse_args(ctx, args)


def _command(command: Command) -> Callable[..., None]:
    """Write the function of a command; typer reads its options from its signature."""
    fields = _fields(command.route.format(material="Au", model_id="schlick"))
    aliases = {name: info.alias or name for name, info in fields.items()}
    parameters = [argument(command.argument)] if command.argument else []
    parameters += [parameter(n, info) for n, info in fields.items() if n != "format"]
    if command.reads_files:
        parameters += [parameter(name, info, FILE_PANEL) for name, info in reading.FIELDS.items()]
    if command.rgb:
        parameters.append(in_colors())
    parameters += output_parameters(figure=command.figure is not None, endings=command.endings)

    def run(**values: Any) -> None:
        output = {"plot": False, "open": False, "save": None, "rgb": False}
        given = {}
        for name, value in values.items():
            if name.startswith(OUTPUT):
                output[name.removeprefix(OUTPUT)] = value
            elif value not in (None, False):
                given[aliases.get(name, name)] = "true" if value is True else str(value)
        _run(command, given, output)

    run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    run.__annotations__ = {p.name: p.annotation for p in parameters}
    return run


class WithQueries(TyperGroup):
    """A group of commands that makes those of the API when they are asked for.

    To know their options takes the whole API, which `serve` and `--version` need not wait for.
    """

    def list_commands(self, context: Any) -> list[str]:
        """Name those that are there and those that can be made."""
        return list(dict.fromkeys([*super().list_commands(context), *_BY_NAME]))

    def get_command(self, context: Any, name: str) -> Any:
        """Find a command, or make it."""
        if name in _BY_NAME and name not in self.commands:
            single = typer.Typer(add_completion=False)
            made = single.command(name, cls=_InOurUnits, help=_BY_NAME[name].help)
            made(_command(_BY_NAME[name]))
            self.commands[name] = typer.main.get_command(single)
        return super().get_command(context, name)
