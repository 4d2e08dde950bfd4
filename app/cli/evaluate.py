"""`fresnel-explorer evaluate`: a file of rows of any length, answered row by row."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    import pyarrow as pa


def evaluate(
    file: Annotated[
        Path,
        typer.Argument(
            exists=True,
            dir_okay=False,
            help="CSV with a header row, or Parquet, with any of the columns n_i, n_t, k_t, "
            "incident, material, wavelength_nm, theta_i_deg, model, quantity and "
            "<model>.<parameter>; what is empty is left out.",
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option(help="Where to write, .csv or .parquet; FILE with `-evaluated` otherwise."),
    ] = None,
    keep: Annotated[
        list[str] | None, typer.Option(help="Another column, to be copied. May be repeated.")
    ] = None,
    scheduler: Annotated[
        str | None, typer.Option(help="Address of a Dask scheduler whose workers evaluate.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite the output.")] = False,
) -> None:
    """Add to each row of FILE its value, or what is wrong with it, in constant memory."""
    _require("pyarrow", "arrow")
    if scheduler is not None:
        _require("distributed", "cluster")
    import pyarrow as pa

    from app.batch.arrow import WrongColumn
    from app.batch.files import SUFFIXES, RowsFile, added, in_order, writing

    output = output or file.with_name(f"{file.stem}-evaluated{file.suffix}")
    for path, name in ((file, "FILE"), (output, "--output")):
        if path.suffix not in SUFFIXES:
            raise typer.BadParameter(f"{path}: neither {' nor '.join(SUFFIXES)}", param_hint=name)
    if output.exists() and not force:
        raise typer.BadParameter(f"{output} is there; --force overwrites it", param_hint="--output")
    try:
        rows = RowsFile(file, keep or ())
        with _Progress(rows.total, unit="rows" if file.suffix == ".parquet" else "bytes") as shown:
            batches = shown.along(rows.batches())
            results = in_order(batches, keep or ())
            if scheduler is not None:
                from app.batch.cluster import on_cluster

                results = on_cluster(scheduler, batches, keep or ())
            with writing(output, added(rows.schema)) as writer:
                for result in results:
                    writer.write_batch(result)
                    shown.count(result)
    except WrongColumn as error:
        raise typer.BadParameter(str(error), param_hint="FILE") from None
    except (pa.ArrowException, OSError) as error:
        typer.echo(f"{file}: {error}", err=True)
        raise typer.Exit(1) from None
    typer.echo(f"{shown.rows} rows in {output}")
    if shown.wrong:
        typer.echo(f"{shown.wrong} of them are wrong: see the column error", err=True)
        raise typer.Exit(1)


def _require(package: str, extra: str) -> None:
    if importlib.util.find_spec(package) is None:
        typer.echo(f"this needs {package}: pip install 'fresnel-explorer[{extra}]'", err=True)
        raise typer.Exit(1)


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
        self.rows = 0
        self.wrong = 0

    def __enter__(self) -> _Progress:
        self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._bar.stop()

    def along(self, batches: Iterator[tuple[pa.RecordBatch, int]]) -> Iterator[pa.RecordBatch]:
        """Pass batches on while the bar follows how far the file has been read."""
        for batch, done in batches:
            self._bar.update(self._task, completed=done)
            yield batch

    def count(self, result: pa.RecordBatch) -> None:
        """Count the rows of a batch and those that are wrong."""
        errors = result.column("error")
        self.rows += result.num_rows
        self.wrong += result.num_rows - errors.null_count
        self._bar.update(self._task, rows=self.rows)
