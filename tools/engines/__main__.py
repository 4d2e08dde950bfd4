"""The command line: `python -m tools.engines three babylon` measures these again, without names all."""

from __future__ import annotations

import sys

from tools.engines.engines import ENGINES
from tools.engines.results import write


def main(names: list[str]) -> int:
    """Measure engines and keep what they answer; 2 for an engine that is not known."""
    unknown = [name for name in names if name not in ENGINES]
    if unknown:
        print(f"{', '.join(unknown)}: known are {', '.join(ENGINES)}", file=sys.stderr)
        return 2
    for name in names or ENGINES:
        engine = ENGINES[name]
        path = write(name, engine, engine.run(engine.package, engine.version))
        print(f"{engine.title} {engine.version}: {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
