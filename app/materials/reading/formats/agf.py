"""Glass catalogs of Zemax OpticStudio (.agf): formulas, their range, and internal transmission."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches

import numpy as np

from app.materials.dispersion import refractive_index
from app.materials.reading.formats import (
    Content,
    Document,
    Format,
    Notes,
    Table,
    Undecided,
    Unreadable,
)
from app.materials.schema import Formula

_KEYWORDS = frozenset({"NM", "GC", "ED", "CD", "TD", "OD", "LD", "IT", "CC", "VER", "MD", "BD"})
_D_UM = 0.5875618
_SAME_ND = 1e-3
_LISTED = 12


@dataclass
class _Glass:
    """The lines of one glass."""

    name: str
    line: int
    fields: list[str]
    """Of its NM line."""
    coefficients: list[str] = field(default_factory=list)
    range_um: list[str] = field(default_factory=list)
    transmission: list[tuple[int, list[str]]] = field(default_factory=list)
    thermal: list[str] = field(default_factory=list)


def _sniff(document: Document) -> str | None:
    starts = {line.split(None, 1)[0] for line in document.lines if line.strip()}
    if {"NM", "CD", "LD"} <= starts:
        return "its lines start with NM, CD and LD, as those of Zemax catalogs do"
    return "it ends in .agf, as catalogs of Zemax do" if document.suffix == ".agf" else None


def _glasses(document: Document) -> dict[str, _Glass]:
    """Part a catalog; lines without a keyword continue the one above."""
    glasses: dict[str, _Glass] = {}
    glass: _Glass | None = None
    target: list[str] | None = None
    for number, line in enumerate(document.lines, start=1):
        words = line.split()
        if not words:
            continue
        keyword = words[0]
        if keyword == "NM" and len(words) > 2:
            glass = _Glass(words[1], number, words)
            glasses.setdefault(glass.name, glass)
            target = None
        elif glass is None:
            continue
        elif keyword == "CD":
            target = glass.coefficients
            target += words[1:]
        elif keyword == "LD":
            glass.range_um += words[1:]
            target = None
        elif keyword == "IT":
            # Blanks inside the line stand for a field that was left out.
            glass.transmission.append((number, words[1:]))
            target = None
        elif keyword == "TD":
            target = glass.thermal
            target += words[1:]
        elif keyword in _KEYWORDS:
            target = None
        elif target is not None:
            target += words
    return glasses


def _read(documents: Sequence[Document], notes: Notes) -> Content:
    document = documents[0]
    glasses = _glasses(document)
    if not glasses:
        raise Unreadable("file", document.name, "a catalog with a glass: a line NM with its name")
    glass = _chosen(glasses, notes)
    formula = _formula(glass, notes)
    _compare_nd(glass, formula, notes)
    table = _transmission(glass, notes)
    notes.assume("relative_to", "air", "catalogs of glasses give n relative to air", ["vacuum"])
    notes.assume("unit", "um", "catalogs of glasses have micrometers")
    return Content(
        tables=[table] if table is not None else (),
        formula=formula,
        name=glass.name,
        relative_to="air",
        columns=("wavelength", "n", "k") if table is not None else ("wavelength", "n"),
    )


def _chosen(glasses: dict[str, _Glass], notes: Notes) -> _Glass:
    wanted = notes.choices.glass
    if wanted is None:
        if len(glasses) == 1:
            return next(iter(glasses.values()))
        shown = ", ".join(list(glasses)[:_LISTED])
        more = f" and {len(glasses) - _LISTED} more" if len(glasses) > _LISTED else ""
        raise Undecided("glass", f"which of {len(glasses)} glasses: {shown}{more}")
    for name, glass in glasses.items():
        if name.casefold() == wanted.strip().casefold():
            return glass
    nearest = get_close_matches(wanted.upper()[:60], list(glasses)[:20_000], n=5, cutoff=0.5)
    hint = f"; nearest: {', '.join(nearest)}" if nearest else ""
    raise Unreadable("glass", wanted, f"the name of one of the {len(glasses)} glasses{hint}")


def _number(text: str) -> float:
    """Read a number, NaN for anything else."""
    try:
        return float(text) if "_" not in text and text.isascii() else np.nan
    except ValueError:
        return np.nan


def _powers(*exponents: int) -> Callable[[list[float]], tuple[int, list[float]]]:
    """A polynomial of n^2 with these exponents after its constant."""

    def made(c: list[float]) -> tuple[int, list[float]]:
        terms = zip(c[1:], exponents, strict=False)
        return 3, [c[0], *(x for a, b in terms if a for x in (a, float(b)))]

    return made


def _sellmeier(count: int) -> Callable[[list[float]], tuple[int, list[float]]]:
    def made(c: list[float]) -> tuple[int, list[float]]:
        return 2, [0.0, *_filled(c, 2 * count)]

    return made


def _filled(c: list[float], count: int) -> list[float]:
    return [*c, *[0.0] * count][:count]


_FORMULAS: dict[int, tuple[str, int, Callable[[list[float]], tuple[int, list[float]]]]] = {
    1: ("Schott", 6, _powers(2, -2, -4, -6, -8)),
    2: ("Sellmeier 1", 6, _sellmeier(3)),
    3: ("Herzberger", 6, lambda c: (7, _filled(c, 6))),
    4: (
        "Sellmeier 2",
        5,
        lambda c: (4, [1.0 + c[0], c[1], 2.0, c[2], 2.0, c[3], 0.0, c[4], 2.0]),
    ),
    5: ("Conrady", 3, lambda c: (5, [c[0], c[1], -1.0, c[2], -3.5])),
    6: ("Sellmeier 3", 8, _sellmeier(4)),
    7: (
        "Handbook of Optics 1",
        4,
        lambda c: (4, [c[0], c[1], 0.0, c[2], 1.0, 0.0, 0.0, 0.0, 1.0, -c[3], 2.0]),
    ),
    8: (
        "Handbook of Optics 2",
        4,
        lambda c: (4, [c[0], c[1], 2.0, c[2], 1.0, 0.0, 0.0, 0.0, 1.0, -c[3], 2.0]),
    ),
    9: ("Sellmeier 4", 5, lambda c: (2, [c[0] - 1.0, c[1], c[2], c[3], c[4]])),
    10: ("Extended 1", 8, _powers(2, -2, -4, -6, -8, -10, -12)),
    11: ("Sellmeier 5", 10, _sellmeier(5)),
    12: ("Extended 2", 8, _powers(2, -2, -4, -6, -8, 4, 6)),
    13: ("Extended 3", 9, _powers(2, 4, -2, -4, -6, -8, -10, -12)),
}
"""By their numbers in the catalog: the name, how many coefficients, and the formula of
`app.materials.dispersion` that is the same."""


def _formula(glass: _Glass, notes: Notes) -> Formula:
    kind = int(_number(glass.fields[2])) if _number(glass.fields[2]) in _FORMULAS else 0
    if kind == 0:
        what = f"a glass of formula 1 to 13; {glass.name} has {glass.fields[2][:20]}"
        raise Unreadable("glass", glass.name, what)
    title, count, same = _FORMULAS[kind]
    given = [_number(text) for text in glass.coefficients]
    if not given or not np.isfinite(given).all() or any(given[count:]):
        what = f"{count} numbers on the line CD for formula {kind} ({title})"
        raise Unreadable("glass", glass.name, what)
    if len(given) < count:
        notes.warn(
            f"CD has {len(given)} of {count} numbers of formula {kind}: the others count as 0"
        )
    limits = [_number(text) for text in glass.range_um[:2]]
    if len(limits) < 2 or not np.isfinite(limits).all() or not 0.0 < limits[0] < limits[1] <= 1e4:
        raise Unreadable("glass", glass.name, "a range of wavelengths on the line LD")
    number, coefficients = same(_filled(given, count))
    low, high = (float(f"{1e3 * x:.15g}") for x in limits)
    return Formula(
        kind="formula", number=number, coefficients=tuple(coefficients), range_nm=(low, high)
    )


def _compare_nd(glass: _Glass, formula: Formula, notes: Notes) -> None:
    """Say where the catalog's n_d is another than the formula's."""
    told = _number(glass.fields[4]) if len(glass.fields) > 4 else np.nan
    low, high = formula.range_nm
    if not 1.01 < told < 5.0 or not low <= 1e3 * _D_UM <= high:
        return
    with np.errstate(all="ignore"):
        at = np.array([_D_UM])
        found = float(refractive_index(formula.number, formula.coefficients, at)[0])
    if not abs(found - told) <= _SAME_ND:
        notes.warn(f"n_d of {glass.name} is {told:g} by its line NM, {found:.6g} by its formula")


def _transmission(glass: _Glass, notes: Notes) -> Table | None:
    """k out of internal transmission: tau = exp(-4 pi k d / lambda)."""
    wavelength_um, k, lines = [], [], []
    for line, words in glass.transmission:
        x, tau, thickness_mm = ([_number(word) for word in words] + [np.nan] * 3)[:3]
        why = _wrong(words, x, tau, thickness_mm)
        if why is not None:
            notes.leave_out(line, why)
            continue
        wavelength_um.append(x)
        k.append(float(-np.log(tau) * x * 1e-3 / (4.0 * np.pi * thickness_mm)) + 0.0)
        lines.append(line)
    if not k:
        return None
    notes.warn("k is that of internal transmission, without reflections")
    return Table(np.array(wavelength_um), "um", {"k": np.array(k)}, np.array(lines))


def _wrong(words: list[str], x: float, tau: float, thickness_mm: float) -> str | None:
    if len(words) < 3 or not np.isfinite([x, tau, thickness_mm]).all():
        return "IT lacks the wavelength, the transmission or the thickness"
    if tau < -900.0:
        return f"IT has {tau:g} for a transmission that is not known"
    if tau == 0.0:
        return "internal transmission 0: k is larger than was measured"
    if not 0.0 < tau <= 1.0:
        return f"an internal transmission of {tau:g}: it is from 0 to 1"
    if not thickness_mm > 0.0:
        return f"a thickness of {thickness_mm:g} mm"
    return None


FORMAT = Format(
    id="agf",
    title="a glass catalog of Zemax",
    sniff=_sniff,
    read=_read,
)
