"""The command line: record, compare, record-cli, compare-cli."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

from tools.recorded_requests import commands
from tools.recorded_requests.differences import Closeness, Expected, report
from tools.recorded_requests.question import Answer, Question, store, stored
from tools.recorded_requests.questions import questions
from tools.recorded_requests.server import Server

PROGRAM = Path(sys.executable).parent / "fresnel-explorer"


def main() -> int:
    """Run the command line; 1 if a comparison finds a difference."""
    parser = argparse.ArgumentParser(prog="python -m tools.recorded_requests", description=__doc__)
    tasks = parser.add_subparsers(dest="task", required=True)
    for task in ("record", "compare", "record-cli", "compare-cli"):
        options = tasks.add_parser(task)
        if task.endswith("cli"):
            options.add_argument("--program", type=Path, default=PROGRAM, help="what to run")
        else:
            options.add_argument("--url", required=True, help="http://127.0.0.1:PORT of the server")
        if task.startswith("record"):
            options.add_argument("--to", type=Path, required=True, help="folder to write into")
        else:
            options.add_argument("--with", dest="to", type=Path, required=True, help="that folder")
            options.add_argument("--floats", type=float, default=1e-12, help="relative tolerance")
            options.add_argument("--zero", type=float, default=1e-15, help="absolute tolerance")
            options.add_argument(
                "--expected", type=Path, help="file of differences that are wanted"
            )
            options.add_argument("--only", default="", help='a part of "METHOD target" to ask only')
            options.add_argument("--show", type=int, default=3, help="answers shown of each group")
    given = parser.parse_args()
    cli = given.task.endswith("cli")
    path = given.to / ("commands.jsonl.gz" if cli else "answers.jsonl.gz")
    ask: Callable[[Question], Answer]
    if cli:
        ask = lambda question: commands.run(given.program.resolve(), question)  # noqa: E731
    else:
        server = Server(given.url)
        ask = server.ask
    if given.task.startswith("record"):
        asked = list(commands.command_lines()) if cli else questions(server)
        print(f"{store(path, ((q, ask(q)) for q in asked))} answers in {path}")
        return 0
    compared = (
        (question, old, ask(question))
        for question, old in stored(path)
        if given.only in f"{question.method} {question.target}"
    )
    closeness = Closeness(given.floats, given.zero)
    return min(1, report(compared, closeness, Expected(given.expected), given.show))


sys.exit(main())
