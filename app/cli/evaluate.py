"""`fresnel-explorer evaluate`: a file of rows of any length, answered row by row."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer
from pydantic import ValidationError

from app.cli.running import ended_by_signals, require

if TYPE_CHECKING:
    import pyarrow as pa

    from app.batch.csv_blocks import Block

_MOST_TOLD = 10
"""Rows that are wrong and told one by one; the column `error` has them all."""


def _digits(text: str) -> int:
    """Read as the API does, and refuse in its words."""
    from app.http.query import DigitsQuery
    from app.http.route import explain

    try:
        return DigitsQuery.model_validate({"digits": text}).digits
    except ValidationError as error:
        (told,) = explain(error, DigitsQuery.model_fields)
        raise typer.BadParameter(f"{told['value']}: {told['message']}") from None


def evaluate(
    file: Annotated[
        Path,
        typer.Argument(
            exists=True,
            dir_okay=False,
            help="CSV with a header row, or Parquet, with any of the columns n_i, n_t, k_t, "
            "incident, material, layers, wavelength_nm, theta_i_deg or theta_i_rad, model, quantity "
            "and <model>.<parameter>; n, k, wavelength_um and energy_ev, semicolons, tabs and "
            "decimal commas are understood and told; what is empty is left out.",
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option(help="Where to write, .csv or .parquet; FILE with `-evaluated` otherwise."),
    ] = None,
    keep: Annotated[
        list[str] | None, typer.Option(help="Another column, to be copied. May be repeated.")
    ] = None,
    digits: Annotated[
        int,
        typer.Option(
            parser=_digits, metavar="NUMBER", help="Significant digits of the values, 3 to 17."
        ),
    ] = 17,
    scheduler: Annotated[
        str | None, typer.Option(help="Address of a Dask scheduler whose workers evaluate.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite the output.")] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="Write nothing if any row is wrong.")
    ] = False,
) -> None:
    """Add to each row of FILE its value, or what is wrong with it, in constant memory.

    A row that is wrong does not keep the others from their answers: it is told on standard error with
    its line, and the command ends with status 1.
    """
    require("pyarrow", "arrow")
    if scheduler is not None:
        require("distributed", "cluster")
    from app.batch.arrow import WrongColumn
    from app.batch.files import SUFFIXES, FileFault, RowsFile, added, in_order, writing

    output = output or file.with_name(f"{file.stem}-evaluated{file.suffix}")
    for path, name in ((file, "FILE"), (output, "--output")):
        if path.suffix not in SUFFIXES:
            raise typer.BadParameter(f"{path}: neither {' nor '.join(SUFFIXES)}", param_hint=name)
    if output.exists() and not force:
        raise typer.BadParameter(f"{output} is there; --force overwrites it", param_hint="--output")
    try:
        rows = RowsFile(file, keep or ())
        for sentence in rows.assumed:
            typer.echo(sentence, err=True)
        is_parquet = file.suffix == ".parquet"
        with (
            ended_by_signals(),
            _Progress(rows.total, "row" if is_parquet else "line") as shown,
            writing(output, added(rows.schema)) as writer,
        ):
            blocks = shown.along(rows.blocks())
            results = in_order(blocks, keep or (), digits)
            if scheduler is not None:
                from app.batch.cluster import on_cluster

                results = on_cluster(scheduler, blocks, keep or (), digits)
            for block, result in results:
                shown.count(block, result)
                if strict and shown.wrong:
                    raise _Wrong
                writer.write_batch(result)
    except WrongColumn as error:
        raise typer.BadParameter(str(error), param_hint="FILE") from None
    except FileFault as error:
        typer.echo(error, err=True)
        raise typer.Exit(1) from None
    except OSError as error:
        typer.echo(f"{scheduler}: {error}", err=True)
        raise typer.Exit(1) from None
    except _Wrong:
        shown.tell(file)
        typer.echo(f"{output} was not written (--strict)", err=True)
        raise typer.Exit(1) from None
    typer.echo(f"{shown.rows} rows in {output}")
    if shown.wrong:
        shown.tell(file)
        typer.echo(f"{shown.wrong} of them are wrong: see the column error", err=True)
        raise typer.Exit(1)


class _Wrong(Exception):
    """A row that is wrong although none may be."""


class _Progress:
    """A bar on standard error, and the rows counted."""

    def __init__(self, total: int, unit: str) -> None:
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

        self._bar = Progress(
            TextColumn("{task.percentage:>3.0f} %"),
            BarColumn(),
            TextColumn("{task.fields[rows]:,} rows"),
            TimeRemainingColumn(),
            console=Console(stderr=True),
        )
        self._task = self._bar.add_task(unit, total=total, rows=0)
        self._unit = unit
        self._told: list[str] = []
        self.rows = 0
        self.wrong = 0

    def __enter__(self) -> _Progress:
        self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._bar.stop()

    def along(self, blocks: Iterable[Block]) -> Iterator[Block]:
        """Pass blocks on while the bar follows how far the file has been read."""
        for block in blocks:
            self._bar.update(self._task, completed=block.done)
            yield block

    def count(self, block: Block, result: pa.RecordBatch) -> None:
        """Count the rows of a block and those that are wrong, and note where the first ones are."""
        errors = result.column("error")
        self.rows += result.num_rows
        wrong = result.num_rows - errors.null_count
        if wrong and len(self._told) < _MOST_TOLD:
            which = np.flatnonzero(errors.is_valid().to_numpy(zero_copy_only=False))
            for row in which[: _MOST_TOLD - len(self._told)].tolist():
                self._told.append(f"{self._unit} {block.places[row]}: {errors[row].as_py()}")
        self.wrong += wrong
        self._bar.update(self._task, rows=self.rows)

    def tell(self, file: Path) -> None:
        """Say on standard error what is wrong with the first rows that are."""
        for text in self._told:
            typer.echo(f"{file}, {text}", err=True)
        if self.wrong > len(self._told):
            typer.echo(f"and {self.wrong - len(self._told)} more", err=True)
