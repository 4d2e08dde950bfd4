"""What commands that run long have in common."""

import importlib.util
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

import typer


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """End by what SIGTERM and SIGHUP ask for as by an error, so that nothing half done stays."""

    def end(number: int, _: FrameType | None) -> None:
        raise SystemExit(128 + number)

    asked = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    # What is ignored, as SIGHUP is below nohup, stays so.
    taken = [number for number in asked if signal.getsignal(number) == signal.SIG_DFL]
    for number in taken:
        signal.signal(number, end)
    try:
        yield
    finally:
        for number in taken:
            signal.signal(number, signal.SIG_DFL)


def require(package: str, extra: str) -> None:
    """End with what to install, where a package is missing."""
    if importlib.util.find_spec(package) is None:
        typer.echo(f"this needs {package}: pip install 'fresnel-explorer[{extra}]'", err=True)
        raise typer.Exit(1)
