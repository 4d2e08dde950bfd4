"""Run every comparison: `python -m benchmarks [name ...]`."""

from __future__ import annotations

import importlib
import pkgutil
import sys

import benchmarks


def main(wanted: list[str]) -> None:
    """Run the named comparisons, or each module of this package that has a `main`."""
    names = wanted or [info.name for info in pkgutil.iter_modules(benchmarks.__path__)]
    for name in names:
        if name == "__main__":
            continue
        module = importlib.import_module(f"benchmarks.{name}")
        if hasattr(module, "main"):
            print(f"\n{name}: {(module.__doc__ or '').splitlines()[0]}")
            module.main()


if __name__ == "__main__":
    main(sys.argv[1:])
