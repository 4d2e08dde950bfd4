"""Options of a command, made from the fields of the query that its route declares."""

from __future__ import annotations

from collections.abc import Callable, Collection
from inspect import Parameter
from pathlib import Path
from typing import Annotated, Any, Literal, get_args, get_origin

import typer
from annotated_types import Ge, Gt, Le
from pydantic.fields import FieldInfo

from app.materials.media import default_catalog
from app.optics.registry import default_registry

FILE_PANEL = "How a file is read; what is left out is found out and told"
"""Above the options of files in a command's help."""

OUTPUT = "output_"
"""What the names of the parameters begin with that say what becomes of the answer."""

FORMATS = ("table", "json", "csv")
_PICTURES = ("html", "json", "svg", "png", "pdf")


def _range(info: FieldInfo) -> str:
    low = next((m for m in info.metadata if isinstance(m, Ge | Gt)), None)
    high = next((m.le for m in info.metadata if isinstance(m, Le)), None)
    if low is None or high is None:
        return ""
    if isinstance(low, Gt):
        return f" Above {low.gt:g}, up to {high:g}."
    return f" From {low.ge:g} to {high:g}."


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

    def models(incomplete: str) -> list[str]:
        before, comma, last = incomplete.rpartition(",")
        return [before + comma + one for one in default_registry() if one.startswith(last)]

    def materials(incomplete: str) -> list[str]:
        ids = (preset.id for preset in default_catalog().presets)
        return [one for one in ids if one.startswith(incomplete)]

    if choices:
        return lambda incomplete: [c for c in choices if c.startswith(incomplete)]
    offered = {
        "model": models,
        "model_id": models,
        "models": models,
        "material": materials,
        "incident": materials,
    }
    return offered.get(name)


def _form(text: str) -> str:
    """One of `FORMATS`; what typer says of a choice itself begins with pydantic's "Value error"."""
    if text not in FORMATS:
        raise typer.BadParameter(f"{text!r} is none of {', '.join(FORMATS)}")
    return text


def _keyword(name: str, kind: Any, declared: Any, default: Any = Parameter.empty) -> Parameter:
    annotation = Annotated[kind, declared]
    return Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def argument(name: str) -> Parameter:
    """What is typed first, without a name."""
    completed = typer.Argument(help="Id, alias or name.", autocompletion=_completion(name, ()))
    return _keyword(name, str, completed)


def parameter(name: str, info: FieldInfo, panel: str = "Query") -> Parameter:
    """An option for a field of a query."""
    alias, choices = info.alias or name, _choices(info)
    flag = info.annotation is bool
    option = typer.Option(
        f"--{alias}",
        help=f"{info.description}{_range(info)}{_default(info)}",
        show_default=False,
        metavar=None if flag else "|".join(choices) or ("NUMBER" if _range(info) else "TEXT"),
        autocompletion=None if flag else _completion(alias, choices),
        rich_help_panel="Parameters of the models" if "." in alias else panel,
    )
    return _keyword(name, bool, option, False) if flag else _keyword(name, str | None, option, None)


def in_colors() -> Parameter:
    """Whether errors are those of a material's R, G and B."""
    said = "Errors of R, G and B against the material's spectrum, in place of one wavelength's."
    declared = typer.Option("--rgb", help=said, rich_help_panel="Query")
    return _keyword(f"{OUTPUT}rgb", bool, declared, False)


def output_parameters(*, figure: bool, endings: Collection[str] = ()) -> list[Parameter]:
    """Options that say what becomes of an answer that can be drawn, is a file, or neither."""

    def option(name: str, kind: Any, default: Any, text: str, **more: Any) -> Parameter:
        declared = typer.Option(f"--{name}", help=text, rich_help_panel="Output", **more)
        return _keyword(OUTPUT + name, kind, declared, default)

    printed = "As what to print it; JSON and CSV are those of the API."
    choice = {"metavar": "|".join(FORMATS), "autocompletion": _completion("format", FORMATS)}
    offered = [option("format", str, "table", printed, parser=_form, **choice)]
    if endings:
        saved = f"Write it to a file that ends in {', '.join(filter(None, endings))}."
        offered.append(option("save", Path | None, None, saved, dir_okay=False))
    elif figure:
        saved = f"Write the figure to a file that ends in {', '.join(_PICTURES)}."
        offered += [
            option("plot", bool, False, "Draw it in the terminal."),
            option("open", bool, False, "Show the figure in the browser."),
            option("save", Path | None, None, saved, dir_okay=False),
        ]
    return offered
