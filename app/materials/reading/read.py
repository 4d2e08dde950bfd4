"""Files of n and k, read into one material with everything that was assumed."""

import re
from collections.abc import Sequence

from app.materials.formula_check import refuse_useless
from app.materials.reading.constants import constants
from app.materials.reading.document import Document, document
from app.materials.reading.format import Content, Format
from app.materials.reading.registry import default_formats
from app.materials.reading.report import Choices, Notes, Reading, Undecided, Unreadable
from app.materials.reading.units import UNITS
from app.materials.schema import Formula, Points, Quantity, Reference
from app.optics.errors import NotAllowed

MOST_FILES = 2
LONGEST_NAME = 60
SHORTEST_IN_AIR_NM = 185.0


def read(files: Sequence[tuple[str, bytes]], choices: Choices | None = None) -> Reading:
    """Read a file, or two that hold eta and k, and say how.

    Parameters
    ----------
    files
        Names and contents. Nothing of them is kept.
    choices
        What is set by hand.

    Raises
    ------
    Unreadable
        If a file cannot be used; the error says what could be.
    Undecided
        If something cannot be told from the file; `parameter` of the error decides it.
    NotAllowed, UnknownName
        If a choice is none.
    """
    choices = choices or Choices()
    if not 1 <= len(files) <= MOST_FILES:
        names = ", ".join(name for name, _ in files[:5]) or None
        raise Unreadable("file", names, "one file, or two that hold eta and k of one material")
    if choices.unit is not None and choices.unit not in UNITS:
        raise NotAllowed("unit", choices.unit, f"one of {', '.join(UNITS)}")
    documents = [document(name, content) for name, content in files]
    notes = Notes(choices)
    kind = _format(documents, notes)
    if len(documents) > 1 and kind.id != "spd":
        names = ", ".join(d.name for d in documents)
        raise Unreadable("file", names, "one file; only eta and k of .spd come in two")
    return reading_of(documents[0], kind, kind.read(documents, notes), notes)


def _format(documents: Sequence[Document], notes: Notes) -> Format:
    formats = default_formats()
    if notes.choices.format is not None:
        return formats.find(notes.choices.format)
    fitting = [(kind, why) for kind in formats.values() if (why := kind.sniff(documents[0]))]
    best = [(kind, why) for kind, why in fitting if kind.rank == fitting[0][0].rank]
    if len(best) > 1:
        names = " or ".join(f"format={kind.id}" for kind, _ in best)
        raise Undecided("format", f"the format, which may be several; say {names}")
    kind, why = best[0]
    notes.assume("format", kind.id, why, ["table"] if kind.id != "table" else ())
    return kind


def reading_of(first: Document, kind: Format, content: Content, notes: Notes) -> Reading:
    """Make n and k of what a format found in the first file; errors as of `read`."""
    found = constants(content.tables, notes)
    n: Quantity | None = found.n
    if content.formula is not None:
        n = _formula(first, content.formula)
    if n is None:
        what = f"n at one wavelength at least{notes.first_left_out}"
        raise Unreadable("file", first.name, what)
    if notes.more_left_out:
        notes.warn(f"{notes.more_left_out} more rows are left out than are listed")
    k = _beside(n, found.k, notes)
    relative_to = _relative_to(content, n, notes)
    tables = content.tables
    unit = tables[0].unit if tables else "um"
    columns = content.columns or (
        (UNITS[unit].kind, *dict.fromkeys(role for table in tables for role in table.columns))
        if tables
        else ("wavelength", "n")
    )
    return Reading(
        name=_name(notes.choices.name or content.name or _stem(first.name)),
        format=kind.id,
        unit=unit,
        columns=columns,
        sign=found.sign,
        order=found.order,
        relative_to=relative_to,
        n=n,
        k=k,
        assumed=tuple(notes.assumed),
        left_out=tuple(sorted(notes.left_out, key=lambda row: row.line)),
        merged=notes.merged,
        warnings=tuple(notes.warnings),
    )


def _formula(first: Document, formula: Formula) -> Formula:
    try:
        refuse_useless(formula)
    except NotAllowed as error:
        raise Unreadable("file", first.name, error.allowed) from None
    return formula


def _ends(quantity: Quantity) -> tuple[float, float]:
    if isinstance(quantity, Formula):
        return quantity.range_nm
    return quantity.wavelength_nm[0], quantity.wavelength_nm[-1]


def _beside(n: Quantity, k: Points | None, notes: Notes) -> Points | None:
    """Leave k out where it is known nowhere that n is."""
    if k is None:
        return None
    (low, high), (first, last) = _ends(n), _ends(k)
    if first <= high and low <= last:
        return k
    notes.warn(
        f"n is known from {low:.6g} to {high:.6g} nm, k from {first:.6g} to {last:.6g} nm, nowhere "
        "together: k is left out"
    )
    return None


def _relative_to(content: Content, n: Quantity, notes: Notes) -> Reference | None:
    chosen = notes.choices.relative_to or content.relative_to
    if chosen == "air" and _ends(n)[0] < SHORTEST_IN_AIR_NM:
        what = f"vacuum: air is not transparent below {SHORTEST_IN_AIR_NM:g} nm"
        raise Unreadable("relative_to", "air", what)
    return chosen


def _stem(name: str) -> str:
    return re.sub(r"([._-](eta|k|n))?\.[A-Za-z0-9]{1,5}$", "", name)


def _name(text: str) -> str:
    """A name of one line."""
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())[
        :LONGEST_NAME
    ] or ("own material")
