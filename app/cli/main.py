"""The command `fresnel-explorer`."""

import os
from typing import Annotated

import typer
from pydantic import ValidationError

from app import __version__
from app.cli import queries
from app.cli.atlas import atlas
from app.cli.evaluate import evaluate
from app.server import run
from app.settings import PREFIX, Settings, without_effect

cli = typer.Typer(
    cls=queries.WithQueries,
    add_completion=True,
    no_args_is_help=False,  # which ends with the status of a wrong call
)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(__version__)
        raise typer.Exit


@cli.callback(invoke_without_command=True)
def default(
    context: typer.Context,
    version: Annotated[  # noqa: ARG001 - typer hands it to the callback
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print it.")
    ] = False,
) -> None:
    """Reflection at smooth surfaces: the page, its REST API and the API's queries."""
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())


@cli.command()
def serve(
    host: Annotated[str | None, typer.Option(help="Address, FRESNEL_HOST otherwise.")] = None,
    port: Annotated[int | None, typer.Option(help="Port, FRESNEL_PORT otherwise.")] = None,
    workers: Annotated[
        int | None, typer.Option(help="Processes, FRESNEL_WORKERS otherwise.")
    ] = None,
) -> None:
    """Serve the page and the API until interrupted."""
    # Told, not refused: Kubernetes, for one, names variables after the services that it runs.
    for sentence in without_effect(os.environ):
        typer.echo(sentence, err=True)
    options = {"host": host, "port": port, "workers": workers}
    given = {name: value for name, value in options.items() if value is not None}
    try:
        settings = Settings.model_validate(given)
    except ValidationError as error:
        for wrong in error.errors():
            name = str(wrong["loc"][0])
            option = f"--{name} or " if name in given else ""
            value, message = wrong["input"], wrong["msg"].removeprefix("Value error, ")
            typer.echo(f"Error: {option}{PREFIX}{name.upper()} = {value}: {message}", err=True)
        raise typer.Exit(2) from None
    try:
        run.serve(
            settings,
            # Standard output is for the access log alone, where there is one.
            announce=lambda url: typer.echo(
                f"Fresnel Explorer {__version__} at {url}", err=settings.access_log
            ),
        )
    except run.CannotServe as error:
        typer.echo(f"Error: {error}", err=True)
        raise typer.Exit(1) from None


cli.command()(evaluate)
cli.command()(atlas)


def main() -> None:
    """Run the command."""
    cli()
