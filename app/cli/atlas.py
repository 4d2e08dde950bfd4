"""`fresnel-explorer atlas`: the errors of every model at every material, worked out on a cluster."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from app.cli.running import ended_by_signals, require


def atlas(
    output: Annotated[
        Path, typer.Option(help="Where to write; what is finished meanwhile is kept beside it.")
    ] = Path("atlas.parquet"),
    scheduler: Annotated[
        str | None,
        typer.Option(help="Address of a Dask scheduler; a cluster on this machine unless given."),
    ] = None,
    workers: Annotated[
        int,
        typer.Option(min=1, max=256, help="Processes of the cluster on this machine."),
    ] = os.cpu_count() or 1,
    pages: Annotated[
        list[str] | None,
        typer.Option(help="Materials alone whose id begins so. May be repeated."),
    ] = None,
    fresh: Annotated[
        bool, typer.Option("--fresh", help="Begin again, whatever was finished before.")
    ] = False,
    force: Annotated[bool, typer.Option("--force", help="Overwrite the output.")] = False,
) -> None:
    """Measure every model at every material over the wavelength, as the atlas of errors is made.

    A run that was stopped goes on where it was: the same command again does only what is missing.
    """
    require("pyarrow", "arrow")
    require("distributed", "cluster")
    from app.batch.atlas import OtherParts, Parts, materials_beginning_with, part_of
    from app.batch.cluster import connected, in_turn
    from app.batch.files import FileFault

    if output.suffix != ".parquet":
        raise typer.BadParameter(f"{output}: not .parquet", param_hint="--output")
    if output.exists() and not force:
        raise typer.BadParameter(f"{output} is there; --force overwrites it", param_hint="--output")
    materials = materials_beginning_with(pages or ())
    if not materials:
        raise typer.BadParameter(f"no material's id begins with {pages}", param_hint="--pages")
    try:
        parts = Parts(output, materials, afresh=fresh)
        missing = parts.missing
        finished = len(parts.parts) - len(missing)
        if finished:
            typer.echo(f"{finished} of {len(parts.parts)} parts are there already", err=True)
        if missing:
            todo = sum(len(parts.parts[number]) for number in missing)
            asked = ((number, (parts.parts[number],)) for number in missing)
            with (
                ended_by_signals(),
                connected(scheduler, workers) as client,
                _bar(len(materials), len(materials) - todo) as advance,
            ):
                for number, part in in_turn(client, part_of, asked):
                    parts.keep(number, part)
                    advance(len(parts.parts[number]))
        about = parts.joined()
    except OtherParts as error:
        typer.echo(
            f"{error} holds parts of another atlas: of other materials, models or another release; "
            "--fresh begins again",
            err=True,
        )
        raise typer.Exit(1) from None
    except FileFault as error:
        typer.echo(error, err=True)
        raise typer.Exit(1) from None
    except OSError as error:
        typer.echo(f"{scheduler or 'the cluster'}: {error}", err=True)
        raise typer.Exit(1) from None
    told = f"{about['materials'] - len(about['left_out'])} materials, {about['rows']} rows"
    typer.echo(f"{told}, {about['seconds']} s of processors: {output}")
    for name in about["left_out"]:
        typer.echo(f"left out, n and k are nowhere known together: {name}", err=True)


@contextmanager
def _bar(total: int, done: int) -> Iterator[Callable[[int], None]]:
    """A bar on standard error, and how to tell it of further materials."""
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeRemainingColumn,
    )

    with Progress(
        TextColumn("{task.percentage:>3.0f} %"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("materials"),
        TimeRemainingColumn(),
        console=Console(stderr=True),
    ) as bar:
        task = bar.add_task("materials", total=total, completed=done)
        yield lambda count: bar.advance(task, count)
