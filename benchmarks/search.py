"""`GET /materials?q=` over presets and all pages of refractiveindex.info: ms, and memory."""

from __future__ import annotations

import random
import statistics
from urllib.parse import quote

from app.materials.published.index import default_pages
from benchmarks.health import ask
from benchmarks.load import OURS, served

SEARCHES = 400
BAR_MS = 50.0
MEMORY_BAR_MB = 10.0


def queries() -> list[str]:
    """Names, beginnings of names, letters, authors and several words, each asked once."""
    chance = random.Random(14)  # noqa: S311 (no secret)
    pages = list(default_pages().all)
    found: list[str] = [*"abcdefghijklmnopqrstuvwxyz"]
    while len(found) < SEARCHES:
        page = chance.choice(pages)
        name = chance.choice(page.names)
        author = page.source.split(",")[0].split(" and ")[0][:40]
        found += [name, name[: chance.randint(1, len(name))], author, f"{name} {author}"[:100]]
    return found[:SEARCHES]


def main() -> None:
    """Print the spread of the durations beside the bar."""
    with served(*OURS) as server:
        ask(server, "/api/v1/materials")
        before = server.memory_mb("VmRSS")
        first = ask(server, "/api/v1/materials?q=gold&digits=16")
        grown = server.memory_mb("VmRSS") - before
        took = [ask(server, f"/api/v1/materials?q={quote(q)}&digits=15") for q in queries()]
    cuts = statistics.quantiles(took, n=100)
    print(f"  the first {first:.1f} ms, then {statistics.median(took):.1f} ms; 95 % below")
    print(f"  {cuts[94]:.1f} ms (bar {BAR_MS:g}), the longest {max(took):.1f} ms")
    print(f"  the first took {grown:.1f} MB of memory for the list (bar {MEMORY_BAR_MB:g})")


if __name__ == "__main__":
    main()
