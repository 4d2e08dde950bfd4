"""Commands that ask the API's routes in this process: same parameters, same answers, no server."""

import inspect
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, NoReturn, get_args, get_origin
from urllib.parse import quote, unquote, urlencode

import orjson
import typer
import typer.main
from annotated_types import Ge, Gt, Le
from pydantic.fields import FieldInfo
from starlette.exceptions import HTTPException
from starlette.requests import Request
from typer.core import TyperGroup

from app.api import PREFIX
from app.api.table import RouteTable
from app.cli import plots, tables
from app.cli.tables import Sheets
from app.http.problems import PROBLEMS, problem_of
from app.settings import Settings

_DIGITS = "6"  # of a table, where nobody asked for more
_FORMATS = ("table", "json", "csv")
_PICTURES = ("html", "json", "svg", "png", "pdf")


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

    @property
    def argument(self) -> str | None:
        """Name of the part of the path that is typed first."""
        return self.route.partition("{")[2].partition("}")[0] or None


_ERRORS = ("max_abs", "max_abs_at_deg", "rms", "cosine_weighted_mean", "max_relative")

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
            lambda answer: tables.pairs({"exact": answer["exact"], "flatland": answer["flatland"]}),
            tables.listed("models", "model", "value", "error", "reason", title="models"),
            tables.listed("approximations", "id", "value", "error", "reason", title="fits"),
        ),
    ),
    Command(
        name="errors",
        route="/errors",
        help="How wrong models are: fresnel-explorer errors --n_t 1.5 --models "
        "schlick,one_minus_cos",
        sheets=tables.listed("errors", "model", "quantity", *_ERRORS, "reason"),
        figure="compare",
    ),
    Command(
        name="recommend",
        route="/recommend",
        help="The cheapest models within an error: fresnel-explorer recommend --n_t 1.5 "
        "--max_error 0.05",
        sheets=tables.several(
            tables.listed("models", "model", "weighted_cost", "figures.max_abs", "figures.rms"),
            tables.listed("refused", "model", "weighted_cost", "reason", title="refused"),
        ),
    ),
    Command(
        name="material",
        route="/materials/{material}",
        help="Index, color and source of a material: fresnel-explorer material Au",
        sheets=tables.several(
            tables.pairs,
            tables.listed("rivals", "id", "n", "k", "wavelength_nm", "source", title="rivals"),
        ),
        figure="material",
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
        name="claims",
        route="/claims",
        help="What the literature claims, and what is measured.",
        sheets=tables.listed("claims", "verdict", "id", "found"),
    ),
)


_BY_NAME = {command.name: command for command in COMMANDS}


@cache
def _table() -> RouteTable:
    from app.main import create_app

    # The defaults, whatever the environment says: that is for the server.
    table: RouteTable = create_app(Settings.model_construct()).state.table
    return table


def _fail(path: str, error: Exception) -> NoReturn:
    """Tell a problem in the API's words, with the exit code of a wrong call."""
    response = problem_of(Request({"type": "http", "path": path, "headers": []}), error)
    typer.echo(f"Error: {orjson.loads(response.body)['detail']}", err=True)
    raise typer.Exit(2)


def _ask(path: str, query: Mapping[str, str]) -> bytes:
    try:
        return _table().written(f"{path}?{urlencode(query)}")
    except LookupError:
        _fail(PREFIX + unquote(path), HTTPException(404))
    except PROBLEMS as error:
        _fail(PREFIX + path, error)


def _of_the_figure(command: Command, given: Mapping[str, str], argument: str) -> dict[str, str]:
    """Those of the parameters that the figure takes too."""
    figure, _ = _table().find(f"/figures/{command.figure}")
    assert figure is not None and figure.query_model is not None  # noqa: S101, PT018 - checked by a test
    known = {info.alias or name for name, info in figure.query_model.model_fields.items()}
    every = {**given, **({command.argument: argument} if command.argument else {})}
    return {name: value for name, value in every.items() if name in known}


def _run(command: Command, given: dict[str, str], output: Mapping[str, Any]) -> None:
    argument = given.pop(command.argument) if command.argument else ""
    path = command.route.replace(f"{{{command.argument}}}", quote(argument, safe=""))
    if output["plot"] or output["open"] or output["save"]:
        _draw(command, _of_the_figure(command, given, argument), output)
        return
    if output["format"] == "table":
        route, _ = _table().find(path)
        fields = (
            {} if route is None or route.query_model is None else route.query_model.model_fields
        )
        usual = {"digits": _DIGITS, **command.in_table}
        given = {name: v for name, v in usual.items() if name in fields} | given
        tables.print_tables(command.sheets(orjson.loads(_ask(path, given))))
        return
    if output["format"] == "csv":
        typer.echo(_csv(command, path, given), nl=False)
        return
    body = _ask(path, given)
    shown = orjson.dumps(orjson.loads(body), option=orjson.OPT_INDENT_2)
    typer.echo(shown if sys.stdout.isatty() else body)


def _csv(command: Command, path: str, given: Mapping[str, str]) -> str:
    """CSV as the route writes it, or of the first table."""
    route, _ = _table().find(path)
    if (
        route is not None
        and route.query_model is not None
        and "format" in route.query_model.model_fields
    ):
        written = _ask(path, {**given, "format": "csv"}).decode()
        return written.replace("\r\n", "\n")
    return tables.write_csv(command.sheets(orjson.loads(_ask(path, given))))


def _draw(command: Command, given: dict[str, str], output: Mapping[str, Any]) -> None:
    path = f"/figures/{command.figure}"
    if output["plot"]:
        typer.echo(plots.in_terminal(_ask(path, given)))
    if output["save"]:
        file: Path = output["save"]
        body = _ask(path, given | {"format": file.suffix.removeprefix(".")})
        file.write_bytes(body)
        typer.echo(f"{file}: {len(body)} bytes", err=True)
    if output["open"]:
        page = _ask(path, given | {"format": "html"})
        typer.echo(plots.open_page(page), err=True)


def _range(info: FieldInfo) -> str:
    low = next(
        (m.ge if isinstance(m, Ge) else m.gt for m in info.metadata if isinstance(m, Ge | Gt)), None
    )
    high = next((m.le for m in info.metadata if isinstance(m, Le)), None)
    return f" From {low:g} to {high:g}." if low is not None and high is not None else ""


def _default(info: FieldInfo) -> str:
    if info.default in (None, "") or isinstance(info.default, bool):
        return ""
    return f" By default {info.default}."


def _choices(info: FieldInfo) -> tuple[str, ...]:
    kinds = [info.annotation, *get_args(info.annotation)]
    found = next((kind for kind in kinds if get_origin(kind) is Literal), None)
    return tuple(map(str, get_args(found)))


def _completion(name: str, choices: tuple[str, ...]) -> Callable[[str], list[str]] | None:
    """What the shell offers for a parameter: choices, models one after the other, materials."""
    if choices:
        return lambda incomplete: [c for c in choices if c.startswith(incomplete)]
    if name in ("models", "model"):

        def models(incomplete: str) -> list[str]:
            before, comma, last = incomplete.rpartition(",")
            ids = [m["id"] for m in _table().json("/models?fields=id")["models"]]
            return [before + comma + one for one in ids if one.startswith(last)]

        return models
    if name in ("material", "incident"):

        def materials(incomplete: str) -> list[str]:
            ids = [m["id"] for m in _table().json("/materials?fields=id")["materials"]]
            return [one for one in ids if one.startswith(incomplete)]

        return materials
    return None


def _parameter(name: str, info: FieldInfo) -> inspect.Parameter:
    """An option of a command, made from a field of the query that the route declares."""
    alias, choices = info.alias or name, _choices(info)
    flag = info.annotation is bool
    option = typer.Option(
        f"--{alias}",
        help=f"{info.description}{_range(info)}{_default(info)}",
        show_default=False,
        metavar=None if flag else "|".join(choices) or ("NUMBER" if _range(info) else "TEXT"),
        autocompletion=None if flag else _completion(alias, choices),
        rich_help_panel="Parameters of the models" if "." in alias else "Query",
    )
    kind: Any = Annotated[bool, option] if flag else Annotated[str | None, option]
    return inspect.Parameter(
        name, inspect.Parameter.KEYWORD_ONLY, default=False if flag else None, annotation=kind
    )


def _output_parameters(command: Command) -> list[inspect.Parameter]:
    def option(name: str, kind: Any, default: Any, text: str, **more: Any) -> inspect.Parameter:
        declared = typer.Option(f"--{name}", help=text, rich_help_panel="Output", **more)
        return inspect.Parameter(
            f"output_{name}",
            inspect.Parameter.KEYWORD_ONLY,
            default=default,
            annotation=Annotated[kind, declared],
        )

    offered = [
        option(
            "format",
            Literal[_FORMATS],
            "table",
            "As what to print it; JSON and CSV are those of the API.",
        )
    ]
    if command.figure:
        saved = f"Write the figure to a file that ends in {', '.join(_PICTURES)}."
        offered += [
            option("plot", bool, False, "Draw it in the terminal."),
            option("open", bool, False, "Show the figure in the browser."),
            option("save", Path | None, None, saved, dir_okay=False),
        ]
    return offered


def _command(command: Command) -> Callable[..., None]:
    """Write the function of a command; typer reads its options from its signature."""
    route, _ = _table().find(command.route.replace("{material}", "Au"))
    if route is None:
        raise LookupError(command.route)
    fields = {} if route.query_model is None else route.query_model.model_fields
    aliases = {name: info.alias or name for name, info in fields.items()}
    parameters = [_parameter(n, info) for n, info in fields.items() if n != "format"]
    if command.argument:
        completed = typer.Argument(
            help="Id, alias or name.", autocompletion=_completion(command.argument, ())
        )
        parameters.insert(
            0,
            inspect.Parameter(
                command.argument,
                inspect.Parameter.KEYWORD_ONLY,
                annotation=Annotated[str, completed],
            ),
        )
    parameters += _output_parameters(command)

    def run(**values: Any) -> None:
        output = {"plot": False, "open": False, "save": None}
        output |= {
            name.removeprefix("output_"): value
            for name, value in values.items()
            if name.startswith("output_")
        }
        given = {
            aliases.get(name, name): "true" if value is True else str(value)
            for name, value in values.items()
            if not name.startswith("output_") and value not in (None, False)
        }
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
            single.command(name, help=_BY_NAME[name].help)(_command(_BY_NAME[name]))
            self.commands[name] = typer.main.get_command(single)
        return super().get_command(context, name)
