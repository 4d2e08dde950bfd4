"""Tokens `own:...`: n and k of a material as text that fits into an address.

A token is base64url of a mark, a checksum and JSON compressed by zlib. Formulas are kept as they are;
of points as few as linear interpolation needs, as whole numbers and their differences.
"""

import base64
import binascii
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import orjson

from app.materials.errors import UnknownMaterial
from app.materials.formula_check import refuse_useless
from app.materials.own.resampling import kept, means
from app.materials.schema import Formula, Points, Quantity, Reference
from app.optics.errors import OpticsError
from app.optics.parameters import K_T, N_T, WAVELENGTH_NM, Array, Parameter

PREFIX = "own:"
"""What the ids of own materials begin with."""

LONGEST = 12_000
"""Characters of the longest token, its prefix included."""

CLOSE = 1e-5
"""How far n and k may be from linear interpolation between the points given."""

_CUT = "this one was cut or changed on its way; copy the whole link"
_MARK = b"\x01"
_ALPHABET = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_")
_MOST_BYTES = 400_000
_MOST_POINTS = 4500
_ROUNDED = 6
_ROUNDING = 5e-7
"""Decimals of n and k, and what they cost; of k below 0.1 as many digits more as it has zeros."""
_TOLERANCES = ((CLOSE, 1e-3), (CLOSE, np.inf), (4.0 * CLOSE, np.inf))
"""How far n and k may be from what is given, and k from itself besides: small ones count in glass.
The first that is met within the length is taken."""
_MOST_MEANS = 3000
_FEWEST_DIGITS = 9
_LONGEST_NAME = 60


@dataclass(frozen=True, kw_only=True)
class OwnData:
    """What a token carries."""

    name: str
    relative_to: Reference | None
    n: Quantity
    k: Quantity | None


@dataclass(frozen=True, kw_only=True)
class Kept:
    """A token, and what became of the points in it."""

    token: str
    """The id of the material, with its prefix."""
    points_given: int
    points_kept: int
    """Of n and k together; those of a formula are none."""
    largest_difference_n: float
    largest_difference_k: float | None
    """From the points given, with linear interpolation between those that are kept."""

    @property
    def is_coarse(self) -> bool:
        """Whether one is larger than it should be: the points did not fit."""
        return max(self.largest_difference_n, self.largest_difference_k or 0.0) > CLOSE


class BrokenToken(UnknownMaterial):
    """An id that begins as an own material's and is none."""

    def __init__(self, token: str, why: str) -> None:
        self.nearest = []
        OpticsError.__init__(self, "material", token, f"an own material's id; {why}")


def is_own(material: str) -> bool:
    """Whether an id is that of an own material, broken or not."""
    return material.strip().startswith(PREFIX)


def write(data: OwnData) -> Kept:
    """Write a material into a token.

    Points that lines between the others come close to are left out; where too many stay, means of
    neighbors are taken. What that costs is told.
    """
    groups = _groups(data)
    for close, relative in _TOLERANCES:
        token = _fitting(data, [_thin(group, close, relative) for group in groups])
        if token is not None:
            return _compared(data, read(token), token)
    count = _MOST_MEANS
    while (token := _fitting(data, [_mean(group, count) for group in groups])) is None:
        count //= 2
    return _compared(data, read(token), token)


def read(token: str) -> OwnData:
    """Read a token.

    Raises
    ------
    BrokenToken
        Saying what is wrong with it.
    """
    token = token.strip()
    text = token.removeprefix(PREFIX)
    if len(token) > LONGEST or not set(text) <= _ALPHABET:
        why = f"it has at most {LONGEST} letters, digits, - and _; read the file again"
        raise BrokenToken(token, why)
    try:
        content = base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))
    except binascii.Error:
        raise BrokenToken(token, _CUT) from None
    if content[:1] != _MARK:
        raise BrokenToken(
            token, "this one was made by another version or program; read the file again"
        )
    checksum, compressed = content[1:5], content[5:]
    if zlib.crc32(compressed).to_bytes(4, "big") != checksum:
        raise BrokenToken(token, _CUT)
    try:
        unpacker = zlib.decompressobj()
        body = unpacker.decompress(compressed, _MOST_BYTES)
        if not unpacker.eof:
            raise ValueError
        return _data(orjson.loads(body))
    except (zlib.error, ValueError, TypeError, KeyError, IndexError, OverflowError):
        raise BrokenToken(token, "what is in this one is no material") from None


class _Group(NamedTuple):
    """n or k, or both where they have the same wavelengths."""

    names: tuple[str, ...]
    x: Array
    """Wavelengths in as many digits as matter, as far as those are apart."""
    values: Array
    """A row a name."""


def _groups(data: OwnData) -> list[_Group]:
    """The points of n and of k, together where they share their wavelengths."""
    tables = [(c, q) for c, q in (("n", data.n), ("k", data.k)) if isinstance(q, Points)]
    shared = len({points.wavelength_nm for _, points in tables}) == 1
    return [_distinct(group) for group in ([tables] if shared else [[table] for table in tables])]


def _fitting(data: OwnData, changed: list[dict[str, Points] | None]) -> str | None:
    """A token with other points; None if there are too many, or it is too long."""
    made: dict[str, Any] = {}
    for group in changed:
        if group is None:
            return None
        made |= group
    token = _packed(OwnData(**vars(data) | made))
    return token if len(token) <= LONGEST else None


def _thin(group: _Group, close: float, relative: float) -> dict[str, Points] | None:
    """Leave out the points that lines between the others come close to."""
    bounds = np.full(group.values.shape, close - 2.0 * _ROUNDING)
    for row, name in enumerate(group.names):
        if name == "k" and np.isfinite(relative):
            bounds[row] = np.minimum(bounds[row], np.maximum(relative * group.values[row], 1e-12))
    chosen = kept(group.x, group.values, bounds, _MOST_POINTS)
    return None if chosen is None else _points(group, group.x[chosen], group.values[:, chosen])


def _points(group: _Group, x: Array, values: Array) -> dict[str, Points]:
    nodes = tuple(x.tolist())
    return {
        name: Points(kind="points", wavelength_nm=nodes, values=tuple(map(_rounded, row)))
        for name, row in zip(group.names, values.tolist(), strict=True)
    }


def _mean(group: _Group, count: int) -> dict[str, Points]:
    x, values = means(group.x, group.values, count)
    rounded = _in_digits(x, _FEWEST_DIGITS)
    apart = np.append(np.diff(rounded) > 0.0, True)
    return _points(group, rounded[apart], values[:, apart])


def _in_digits(x: Array, digits: int) -> Array:
    return np.array([float(f"{value:.{digits}g}") for value in x.tolist()])


def _distinct(tables: list[tuple[str, Points]]) -> _Group:
    x = np.array(tables[0][1].wavelength_nm)
    values = np.array([points.values for _, points in tables])
    steepest = np.abs(np.diff(values) / np.diff(x)).max(initial=0.0)
    matter = np.log10(max(x[-1] * steepest / _ROUNDING, 1.0))
    rounded = _in_digits(x, min(max(_FEWEST_DIGITS, int(np.ceil(matter))), 15))
    apart = np.flatnonzero(np.diff(rounded, prepend=-1.0) > 0.0)
    return _Group(tuple(name for name, _ in tables), rounded[apart], values[:, apart])


def _rounded(value: float) -> float:
    return round(value, _ROUNDED) if abs(value) >= 0.1 else float(f"{value:.5g}")


def _packed(data: OwnData) -> str:
    body: dict[str, Any] = {"name": data.name, "n": _written(data.n)}
    if data.relative_to is not None:
        body["relative_to"] = data.relative_to
    if data.k is not None:
        body["k"] = _written(data.k)
        if body["k"].get("x") == body["n"].get("x"):
            body["k"].pop("x", None)
    compressed = zlib.compress(orjson.dumps(body), 9)
    content = _MARK + zlib.crc32(compressed).to_bytes(4, "big") + compressed
    return PREFIX + base64.urlsafe_b64encode(content).decode().rstrip("=")


def _written(quantity: Quantity) -> dict[str, Any]:
    if isinstance(quantity, Formula):
        return {"f": quantity.number, "c": quantity.coefficients, "r": quantity.range_nm}
    return {"x": _whole(quantity.wavelength_nm), "y": _whole(quantity.values)}


def _whole(values: tuple[float, ...]) -> list[int]:
    """Decimals, how often differences were taken, and whole numbers: of those that are shortest."""
    array = np.array(values)
    decimals = next(
        d
        for d in range(16)
        if d == 15
        or np.abs(array).max() * 10.0 ** (d + 1) > 2.0**52
        or np.all(np.abs(np.rint(array * 10.0**d) / 10.0**d - array) <= 1e-13 * np.abs(array))
    )
    whole = np.rint(array * 10.0**decimals).astype(np.int64)
    orders = [np.diff(whole, n=order, prepend=[0] * order) for order in (0, 1, 2)]
    lists = [[decimals, order, *row.tolist()] for order, row in enumerate(orders)]
    return min(lists, key=lambda numbers: len(orjson.dumps(numbers)))


def _unwhole(numbers: list[int]) -> tuple[float, ...]:
    decimals, order, *whole = numbers
    if not (0 <= decimals <= 15 and 0 <= order <= 2 and 0 < len(whole) <= _MOST_POINTS):
        raise ValueError
    if not all(type(number) is int for number in numbers):
        raise ValueError
    for _ in range(order):
        total, sums = 0, []
        for number in whole:
            total += number
            sums.append(total)
        whole = sums
    return tuple(number / 10**decimals for number in whole)


def _data(body: Any) -> OwnData:
    if not isinstance(body, dict) or not body.keys() <= {"name", "n", "k", "relative_to"}:
        raise ValueError
    name, relative_to = body["name"], body.get("relative_to")
    if not isinstance(name, str) or not 0 < len(name) <= _LONGEST_NAME or not name.isprintable():
        raise ValueError
    if relative_to not in ("vacuum", "air", None):
        raise ValueError
    n = _quantity(body["n"], N_T, None)
    k = None
    if "k" in body:
        k = _quantity(body["k"], K_T, n.wavelength_nm if isinstance(n, Points) else None)
    return OwnData(name=name, relative_to=relative_to, n=n, k=k)


def _quantity(
    body: Mapping[str, Any], bounds: Parameter, shared: tuple[float, ...] | None
) -> Quantity:
    """Read n or k, and refuse what cannot be computed with."""
    if "f" in body:
        low, high = map(float, body["r"])
        formula = Formula(
            kind="formula",
            number=body["f"],
            coefficients=tuple(map(float, body["c"])),
            range_nm=(low, high),
        )
        refuse_useless(formula)
        return formula
    x = _unwhole(body["x"]) if "x" in body else shared
    values = _unwhole(body["y"])
    if x is None or not WAVELENGTH_NM.admits(np.array(x)).all():
        raise ValueError
    if not bounds.admits(np.array(values)).all():
        raise ValueError
    return Points(kind="points", wavelength_nm=x, values=values)


def _compared(given: OwnData, taken: OwnData, token: str) -> Kept:
    pairs = [(given.n, taken.n), (given.k, taken.k)]
    counts = [
        (len(a.values), len(b.values))
        for a, b in pairs
        if isinstance(a, Points) and isinstance(b, Points)
    ]
    return Kept(
        token=token,
        points_given=sum(a for a, _ in counts),
        points_kept=sum(b for _, b in counts),
        largest_difference_n=_difference(given.n, taken.n),
        largest_difference_k=None if given.k is None else _difference(given.k, taken.k),
    )


def _difference(given: Quantity, taken: Quantity | None) -> float:
    if not isinstance(given, Points) or not isinstance(taken, Points):
        return 0.0
    x, values = np.array(given.wavelength_nm), np.array(given.values)
    return float(np.abs(np.interp(x, taken.wavelength_nm, taken.values) - values).max())
