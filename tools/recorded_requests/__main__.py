"""The command line: record, compare, record-cli, compare-cli."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
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
        options.add_argument("--at-a-time", type=int, default=4, help="requests at a time")
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
            options.add_argument("--every", type=int, default=1, help="ask each so manieth only")
            options.add_argument("--show", type=int, default=3, help="answers shown of each group")
    given = parser.parse_args()
    cli = given.task.endswith("cli")
    path = given.to / ("commands.jsonl.gz" if cli else "answers.jsonl.gz")
    server = Server("" if cli else given.url)
    if not cli and not server.ask(Question("GET", "/api/v1/health")).status:
        parser.error(f"nobody answers at {given.url}")
    program = partial(commands.run, given.program.resolve()) if cli else None
    ask: Callable[[Question], Answer] = program or server.ask
    with ThreadPoolExecutor(given.at_a_time) as threads:
        if given.task.startswith("record"):
            listed = list(commands.command_lines()) if cli else questions(server)
            count = store(path, zip(listed, threads.map(ask, listed), strict=True))
            print(f"{count} answers in {path}")
            return 0
        before = [
            (question, old)
            for question, old in stored(path)
            if given.only in f"{question.method} {question.target}"
        ][:: given.every]
        answers = threads.map(ask, (question for question, _ in before))
        compared = ((*pair, new) for pair, new in zip(before, answers, strict=True))
        closeness = Closeness(given.floats, given.zero)
        return min(1, report(compared, closeness, Expected(given.expected), given.show))


sys.exit(main())
