"""Which number of an answer a figure is: the rule in words that a reader can follow, and as code."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True, slots=True)
class Reading:
    """How a number is taken out of an answer."""

    words: str
    """The rule, as a path into the JSON with functions around it."""
    read: Callable[[Any], float]
    """The rule as a function of the answer."""


def value(path: str) -> Reading:
    """One number: `interface.F0`, or of a list `errors[model=schlick].max_abs`."""
    return Reading(path, lambda answer: float(follow(answer, path)))


def largest(path: str, over: str) -> Reading:
    """The largest of a list of numbers, between them too: the top of the parabola through three."""
    return Reading(
        f"max({path}), between {over} too",
        lambda answer: _top(_moduli(follow(answer, path)), follow(answer, over)),
    )


def smallest(path: str) -> Reading:
    """The smallest of a list of numbers."""
    return Reading(f"min({path})", lambda answer: min(_numbers(follow(answer, path))))


def most(path: str) -> Reading:
    """The largest modulus of the numbers that there are, where rounding is all that they hold."""
    return Reading(f"max |{path}|", lambda answer: max(_moduli(follow(answer, path))))


def modulus(path: str) -> Reading:
    """One number without its sign."""
    return Reading(f"|{path}|", lambda answer: abs(float(follow(answer, path))))


def spread(path: str) -> Reading:
    """The largest less the smallest of a list of numbers."""

    def read(answer: Any) -> float:
        numbers = list(_numbers(follow(answer, path)))
        return max(numbers) - min(numbers)

    return Reading(f"max({path}) - min({path})", read)


def apart(first: str, second: str, over: str = "theta_i_deg") -> Reading:
    """How far two curves are apart at most, between their samples too."""

    def read(answer: Any) -> float:
        pairs = zip(_numbers(follow(answer, first)), _numbers(follow(answer, second)), strict=True)
        return _top([abs(a - b) for a, b in pairs], follow(answer, over))

    return Reading(f"max |{first} - {second}|, between {over} too", read)


def quotient(first: str, second: str) -> Reading:
    """One number divided by another."""
    return Reading(
        f"{first} / {second}",
        lambda answer: float(follow(answer, first)) / float(follow(answer, second)),
    )


def difference(first: str, second: str) -> Reading:
    """How far two numbers are apart."""
    return Reading(
        f"|{first} - {second}|",
        lambda answer: abs(float(follow(answer, first)) - float(follow(answer, second))),
    )


def offset(path: str, expected: float) -> Reading:
    """How far a number is from the one that was printed."""
    return Reading(
        f"|{path} - {expected}|", lambda answer: abs(float(follow(answer, path)) - expected)
    )


def largest_ratio(first: str, second: str, over: str) -> Reading:
    """The largest modulus of the quotients of two lists, between them too."""

    def read(answer: Any) -> float:
        pairs = zip(_numbers(follow(answer, first)), _numbers(follow(answer, second)), strict=True)
        return _top([abs(a / b) for a, b in pairs], follow(answer, over))

    return Reading(f"max |{first} / {second}|, between {over} too", read)


def unity(*paths: str) -> Reading:
    """How far the sums of lists are from 1."""
    return Reading(
        f"max |{' + '.join(paths)} - 1|",
        lambda answer: max(
            abs(sum(numbers) - 1.0)
            for numbers in zip(*(_numbers(follow(answer, path)) for path in paths), strict=True)
        ),
    )


def cosine(path: str) -> Reading:
    """The cosine of an angle in degrees."""
    return Reading(
        f"cos({path})", lambda answer: math.cos(math.radians(float(follow(answer, path))))
    )


def share_of_cosines(path: str, low: float, high: float) -> Reading:
    """Which part of a grid of angles, in degrees, has its cosine between two numbers."""

    def read(answer: Any) -> float:
        cosines = [math.cos(math.radians(angle)) for angle in _numbers(follow(answer, path))]
        return sum(low <= mu <= high for mu in cosines) / len(cosines)

    return Reading(f"share of cos({path}) from {low:g} to {high:g}", read)


def share_at_most(path: str, limit: float) -> Reading:
    """Which part of a list of numbers does not exceed a limit."""

    def read(answer: Any) -> float:
        numbers = list(_numbers(follow(answer, path)))
        return sum(number <= limit for number in numbers) / len(numbers)

    return Reading(f"share of {path} up to {limit:g}", read)


def follow(answer: Any, path: str) -> Any:
    """Walk a path: names between dots, `[key=value,...]` picks of a list, `[*]` takes all of it.

    Raises
    ------
    LookupError, AttributeError
        If the path leads nowhere.
    """
    for step in _steps(path):
        if step == "[*]":
            rest = path.partition("[*].")[2]
            return [follow(entry, rest) for entry in answer] if rest else answer
        if step.startswith("["):
            wanted = dict(pair.split("=") for pair in step[1:-1].split(","))
            answer = next(
                entry for entry in answer if all(str(_in(entry, k)) == v for k, v in wanted.items())
            )
        else:
            answer = _in(answer, step)
    return answer


def _in(answer: Any, name: str) -> Any:
    """What an answer has of a name: a field, an entry, or the item of a list."""
    if isinstance(answer, Mapping):
        return answer[name]
    if isinstance(answer, Sequence | np.ndarray):
        return answer[int(name)]
    return getattr(answer, name)


def _steps(path: str) -> Iterator[str]:
    """Part a path at its dots and before its brackets; dots inside brackets belong to a name."""
    step, inside = "", False
    for letter in path:
        inside = letter == "[" or (inside and letter != "]")
        if letter in ".[" and not (inside and letter == "."):
            if step:
                yield step
            step = "[" if letter == "[" else ""
        else:
            step += letter
    if step:
        yield step


def _numbers(nested: Iterable[Any]) -> Iterator[float]:
    """Flatten lists and arrays; what is undefined is left out."""
    for entry in nested:
        if isinstance(entry, Sequence | np.ndarray):
            yield from _numbers(entry)
        elif entry is not None and not math.isnan(entry):
            yield float(entry)


def _moduli(numbers: Iterable[Any]) -> list[float]:
    return [abs(number) for number in _numbers(numbers)]


def _top(heights: Sequence[float], over: Sequence[float]) -> float:
    """The top of the parabola through the highest of some samples and its neighbors."""
    best = int(np.argmax(heights))
    if not 0 < best < len(heights) - 1:
        return heights[best]
    near = slice(best - 1, best + 2)
    x, y = np.asarray(over[near], dtype=np.float64), np.asarray(heights[near])
    left, right = x[1] - x[0], x[2] - x[1]
    fall_left, fall_right = (y[1] - y[0]) / left, (y[1] - y[2]) / right
    fall = fall_left + fall_right
    if fall <= 0.0:
        return heights[best]
    shift = 0.5 * (left * fall_right - right * fall_left) / fall
    return float(y[1] + shift**2 * fall / (left + right))
