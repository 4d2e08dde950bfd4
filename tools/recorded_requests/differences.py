"""What differs between two answers: JSON and CSV cell by cell, all else as text."""

from __future__ import annotations

import csv
import json
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tools.recorded_requests.question import Answer, Question

_SHOWN = 150


@dataclass(frozen=True)
class Difference:
    """One difference: its kind, where in that it is, and both values."""

    kind: str
    where: str
    text: str


@dataclass
class Closeness:
    """How near numbers are: equal within `relative`, or nearer to one another than `absolute`."""

    relative: float
    absolute: float
    worst: dict[str, float] = field(default_factory=dict)
    """Of each answer whose numbers are close but not equal in every bit, the largest relative."""

    def close(self, a: float, b: float, question: str) -> bool:
        """Whether two numbers count as equal."""
        if repr(a) == repr(b):
            return True
        apart = abs(a - b)
        relative = apart / max(abs(a), abs(b)) if apart else 0.0
        if apart > self.absolute and not relative <= self.relative:  # NaN is not close
            return False
        self.worst[question] = max(self.worst.get(question, 0.0), relative)
        return True


def differences(
    question: Question, old: Answer, new: Answer, closeness: Closeness
) -> Iterator[Difference]:
    """List what differs in headers and body, or of answers that have not one status that alone."""
    if old.status != new.status:
        text = f"{old.status} -> {new.status}: {_against(old.body, new.body)}"
        yield Difference("status", "", text)
        return
    for name in sorted(old.headers.keys() | new.headers.keys()):
        a, b = old.headers.get(name), new.headers.get(name)
        if a != b and not _close_texts(a, b, closeness, str(question)):
            yield Difference("header", name, _against(a, b))
    if old.body != new.body:
        found, asked = False, str(question)
        for where, text in _in_values(_parsed(old), _parsed(new), "", closeness, asked):
            found = True
            yield Difference("body", where, text)
        if not found and asked not in closeness.worst:
            yield Difference("body", "", "the same values, written in other bytes")


def _close_texts(a: str | None, b: str | None, closeness: Closeness, question: str) -> bool:
    try:
        return closeness.close(float(a or ""), float(b or ""), question)
    except ValueError:
        return False


def _against(a: object, b: object) -> str:
    return f"{_short(a)} -> {_short(b)}"


def _short(value: object) -> str:
    shown = repr(value)
    return shown if len(shown) <= _SHOWN else shown[:_SHOWN] + "..."


def _parsed(answer: Answer) -> Any:
    """Take a body apart: JSON, CSV with a dictionary a row, or lines."""
    kind = answer.headers.get("content-type", "")
    if "json" in kind or answer.body[:1] in "{[":
        try:
            return json.loads(answer.body)
        except ValueError:
            return answer.body
    if "csv" in kind and answer.body:
        head, *rows = csv.reader(answer.body.splitlines())
        return [dict(zip(head, map(_cell, row), strict=False)) for row in rows]
    return answer.body.splitlines()


def _cell(text: str) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def _in_values(
    a: Any, b: Any, where: str, closeness: Closeness, question: str
) -> Iterator[tuple[str, str]]:
    """Compare two values of JSON, down to the leaves."""
    if type(a) is not type(b):
        yield where, _against(a, b)
    elif isinstance(a, dict):
        for key in a.keys() | b.keys():
            if key not in a or key not in b:
                yield f"{where}.{key}", "added" if key in b else "missing"
            else:
                yield from _in_values(a[key], b[key], f"{where}.{key}", closeness, question)
        if a.keys() == b.keys() and list(a) != list(b):
            yield where, f"order of keys: {_against(list(a), list(b))}"
    elif isinstance(a, list):
        if len(a) != len(b):
            yield where, f"{len(a)} -> {len(b)} entries"
        for i, (one, other) in enumerate(zip(a, b, strict=False)):
            yield from _in_values(one, other, f"{where}[{i}]", closeness, question)
    elif isinstance(a, float):
        if not closeness.close(a, b, question):
            apart = abs(a - b)
            yield where, f"{_against(a, b)}, {apart / max(abs(a), abs(b)):.2g} relative"
    elif a != b:
        yield where, _first_change(a, b) if isinstance(a, str) else _against(a, b)


def _first_change(a: str, b: str) -> str:
    """Show two texts from shortly before where they part."""
    same = next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), 0)
    start = max(0, same - 40) if len(a) > _SHOWN or len(b) > _SHOWN else 0
    return _against(a[start:], b[start:])


class Expected:
    r"""Differences that are wanted: a file of lines `QUESTION WHERE REASON`.

    QUESTION is a regular expression searched for in "METHOD target", WHERE one that is searched
    for in "kind where" (`^header.vary`, `^body.*\.title`); neither holds a blank (`.` stands for
    one), and the rest of the line says why. Lines that start with # are comments.
    """

    def __init__(self, path: Path | None) -> None:
        lines = path.read_text("utf-8").splitlines() if path else []
        kept = [line.split(maxsplit=2) for line in lines if line.strip() and line[0] != "#"]
        for fields in kept:
            if len(fields) != 3:
                raise SystemExit(f"{path}: {' '.join(fields)}: a reason is missing")
        self._lines = [(re.compile(asked), re.compile(where)) for asked, where, _ in kept]
        self.used = dict.fromkeys((" ".join(fields) for fields in kept), 0)

    def holds(self, question: Question, difference: Difference) -> bool:
        """Whether a line expects this."""
        asked = f"{question.method} {question.target}"
        found = f"{difference.kind} {difference.where}"
        for name, (first, second) in zip(self.used, self._lines, strict=True):
            if first.search(asked) and second.search(found):
                self.used[name] += 1
                return True
        return False


def report(
    compared: Iterable[tuple[Question, Answer, Answer]],
    closeness: Closeness,
    expected: Expected,
    shown: int,
) -> int:
    """Print what differs, grouped by route and kind, and return how many answers do."""
    groups: dict[str, list[tuple[Question, list[Difference]]]] = defaultdict(list)
    differ: set[str] = set()
    count = 0
    for question, old, new in compared:
        count += 1
        by_kind: dict[str, list[Difference]] = defaultdict(list)
        for difference in differences(question, old, new, closeness):
            if not expected.holds(question, difference):
                by_kind[_group(question, difference)].append(difference)
        for group, found in by_kind.items():
            groups[group].append((question, found))
            differ.add(str(question))
    for group, cases in sorted(groups.items()):
        print(f"\n{group}: {len(cases)} answers")
        for question, found in cases[:shown]:
            print(f"  {question}\n    {found[0].where} {found[0].text}", end="")
            print(f" (and {len(found) - 1} more)" if len(found) > 1 else "")
    print()
    for line, times in expected.used.items():
        print(f"expected {times} times: {line}")
    if closeness.worst:
        worst = max(closeness.worst, key=closeness.worst.__getitem__)
        print(f"close, but not in every bit: {len(closeness.worst)} answers;", end=" ")
        print(f"the largest is {closeness.worst[worst]:.2g} relative, {worst}")
    print(f"{len(differ)} of {count} answers differ")
    return len(differ)


def _group(question: Question, difference: Difference) -> str:
    """Headers by what became of them, all else by the route, or the command, and the first key."""
    if difference.kind == "header":
        return f"header {difference.where}: {difference.text}"
    first = re.match(r"\.?[^.\[]*", difference.where)
    path = question.target.partition("?")[0].removeprefix("/api/v1/")
    noun, *rest = path.split(maxsplit=1)[0].split("/") if path.split() else [path]
    route = "/".join([noun, *(["*"] if rest[1:] else []), *rest[-1:]]) if rest else noun
    return f"{question.method} {route}: {difference.kind} {first.group() if first else ''}".strip()
