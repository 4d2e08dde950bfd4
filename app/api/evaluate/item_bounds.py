"""Where the items of a body of `/evaluate` begin and end, found before they are decoded."""

import re

import msgspec
import numpy as np

from app.api.evaluate.pieces import MOST_VALUES, TooManyValues
from app.http.problems import BadParameters

_LONGEST_ANGLE = 100
"""Bytes of an angle in a long item, blanks before it included."""

_END_OF_ITEM = re.compile(rb"\}[ \t\r\n]*,")
_SPACE = re.compile(rb"[ \t\r\n]*")


def within(body: bytes | bytearray, raw: msgspec.Raw) -> tuple[int, int]:
    """Where the items of a body are, between their brackets.

    Raises
    ------
    msgspec.MsgspecError
        If they are no list, or there twice.
    """
    here = np.frombuffer(raw, np.uint8)
    start = here.ctypes.data - np.frombuffer(body, np.uint8).ctypes.data
    if not body.startswith(b"[", start):
        raise msgspec.ValidationError("Expected `array` of items")
    if body.count(b":", 0, start) > 1:
        raise msgspec.ValidationError("`items` is given more than once")
    first = _SPACE.match(body, start + 1)
    return (first.end() if first else 0), start + here.size - 1


def refuse_unlike_angles(body: bytes | bytearray, start: int, end: int) -> None:
    """Refuse a long item that cannot be one of many angles, before it becomes Python objects.

    Raises
    ------
    TooManyValues
        If it has more commas than there may be angles.
    BadParameters
        If it has so few that it has to hold something else.
    """
    commas = body.count(b",", start, end)
    if commas > MOST_VALUES + 100:
        raise TooManyValues
    if end - start > _LONGEST_ANGLE * (commas + 1):
        message = f"an item of {end - start} bytes, which is not one of many angles"
        raise BadParameters({"parameter": "items", "value": None, "message": message})


def end_of_item(body: bytes | bytearray, start: int, stop: int, size: int) -> int:
    """Where an item may end that is about `size` bytes further on, or the end of all."""
    if start + size >= stop:
        return stop
    last = body.rfind(b"},", start + size // 2, start + size)
    if last >= 0:
        return last + 1
    found = _END_OF_ITEM.search(body, start + size // 2, stop)
    return found.start() + 1 if found else stop


def after_comma(body: bytes | bytearray, end: int, stop: int) -> int:
    """Where the next item begins, or the end of all."""
    return stop if end == stop else body.index(b",", end) + 1
