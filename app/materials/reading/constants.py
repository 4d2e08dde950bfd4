"""Numbers of a file as n and k over the wavelength: unit, sign, gaps, order, points given twice."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from app.materials.reading.report import Notes, Order, Sign, Undecided, Unreadable
from app.materials.reading.units import UNITS, plausible, ranges
from app.materials.schema import Points
from app.optics.parameters import K_T, N_T, Array, Parameter

MISSING = (-999.0, -9999.0, -99999.0, -999.9, -999.99, -9999.99)
"""Numbers that stand for what was not measured."""

NOISE = 0.1
"""Share of the largest |k| up to which k of the other sign counts as noise."""

ALIKE = 2e-3
"""How far n or k of two tables may be apart that are taken for the same material's."""

ROUNDING = 1e-9
"""Negative k that is rounding wherever it stands."""

_DOUBTFUL_A = (150.0, 2600.0)
"""Between these, numbers said to be in Angstrom are as likely in nanometers: copied headers are
common."""
_LONGEST_NM, _SHORTEST_NM = 1e7, 1e-4

Lines = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Table:
    """Rows of a file with their meaning."""

    x: Array
    unit: str
    columns: Mapping[str, Array]
    """By roles: n and k, eps1 and eps2, delta and beta, or some of them; NaN for what is missing."""
    lines: Lines
    """Numbers of the lines in the file."""


@dataclass(frozen=True)
class Found:
    """n and k of all tables together."""

    n: Points | None
    k: Points | None
    order: Order
    sign: Sign


def decided_unit(
    x: Array,
    notes: Notes,
    *,
    named: str | None = None,
    why: str = "the column is called so",
    hinted: Sequence[str] = (),
    n: Array | None = None,
    is_certain: bool = False,
) -> str:
    """Decide the unit of an abscissa.

    Parameters
    ----------
    x
        The numbers.
    named
        The unit that the file or its format says.
    why
        What says it.
    hinted
        Units that other lines name.
    n
        Refractive indices beside, which tell X-rays from light.
    is_certain
        Whether the format has no other.

    Raises
    ------
    Undecided
        If several are possible.
    """
    if notes.choices.unit is not None:
        return notes.choices.unit
    x = x[np.isfinite(x) & (x > 0.0)]
    if not x.size:
        return named or "nm"

    def looks_solid() -> bool:
        finite = n[np.isfinite(n)] if n is not None else np.zeros(0)
        return bool(finite.size and np.median(np.abs(finite - 1.0)) > 0.2)

    span = f"{x.min():.6g} to {x.max():.6g}"
    fitting = plausible(x, looks_solid)
    if named is not None:
        nm = UNITS[named].nanometers(np.array([x.min(), x.max()]))
        others = [name for name in fitting if name != named]
        doubtful = named == "A" and _DOUBTFUL_A[0] <= x.min() and x.max() <= _DOUBTFUL_A[1]
        if doubtful:
            others = ["nm"]
        if not is_certain and others and (doubtful or (nm.max() < 40.0 and looks_solid())):
            raise Undecided(
                "unit",
                f"the unit of {span}: the file says {named}, but {ranges([named, *others], x)}; "
                f"say {_or([named, *others])}",
            )
        if doubtful:
            notes.warn(f"the abscissa may be in nm, though the format has A: {ranges(['A'], x)}")
        notes.assume("unit", named, why, others if doubtful else ())
        return named
    told = [name for name in hinted if name in fitting]
    if len(told) == 1:
        others = [name for name in fitting if name != told[0]]
        notes.assume("unit", told[0], "a line above the table names it", others)
        return told[0]
    if len(fitting) == 1:
        others = ["cm-1", "THz"] if fitting == ["nm"] else []
        why = f"numbers from {span} are most likely that; {ranges(fitting, x)}"
        notes.assume("unit", fitting[0], why, others)
        return fitting[0]
    if not fitting:
        raise Undecided("unit", f"the unit of {span}, one of {', '.join(UNITS)}")
    raise Undecided(
        "unit",
        f"the unit of {span}, which nothing says: {ranges(fitting, x)}; say {_or(fitting)}, or another "
        f"of {', '.join(UNITS)}",
    )


def _or(units: Sequence[str]) -> str:
    return " or ".join(f"unit={name}" for name in units)


def constants(tables: Sequence[Table], notes: Notes) -> Found:
    """Put the rows of all tables together.

    Rows whose n or k cannot be computed with are left out and listed.

    Raises
    ------
    Undecided
        If the sign of k cannot be told.
    Unreadable
        If the tables are of two materials.
    """
    clean = [_measured(table) for table in tables]
    sign = _decided_sign(clean, notes)
    parts: dict[str, list[tuple[Array, Array, Lines]]] = {"n": [], "k": []}
    gone: list[Array] = []
    order: Order = "rising"
    for index, table in enumerate(clean):
        if index == 0:
            order = _order(table, notes)
        kept, wavelength_nm = _wavelengths(table, notes)
        table = _rows(table, kept)
        n, k = _n_and_k(table, sign, notes)
        usable = np.ones(table.x.size, np.bool_)
        for name, values, bounds in (("n", n, N_T), ("k", k, K_T)):
            if values is not None:
                usable &= _within(name, values, bounds, table.lines, usable, notes)
        known = [values for values in (n, k) if values is not None]
        for at in np.flatnonzero(np.all(np.isnan(known), axis=0)).tolist() if known else ():
            notes.leave_out(int(table.lines[at]), "nothing is given there")
        gone.append(wavelength_nm[~usable])
        for name, values in (("n", n), ("k", k)):
            if values is not None:
                there = usable & np.isfinite(values)
                parts[name].append((wavelength_nm[there], values[there], table.lines[there]))
    for name, pieces in parts.items():
        _refuse_two(name, pieces)
    points = {name: _points(name, pieces, notes) for name, pieces in parts.items()}
    _say_gaps(points, parts, np.concatenate([np.zeros(0), *gone]), notes)
    return Found(points["n"], points["k"], order, sign)


def _measured(table: Table) -> Table:
    """Take away the numbers that stand for none."""
    columns = {
        name: np.where(np.isin(values, MISSING), np.nan, values)
        for name, values in table.columns.items()
    }
    return Table(table.x, table.unit, columns, table.lines)


def _rows(table: Table, kept: NDArray[np.bool_]) -> Table:
    columns = {name: values[kept] for name, values in table.columns.items()}
    return Table(table.x[kept], table.unit, columns, table.lines[kept])


def _absorption(table: Table) -> Array | None:
    return next((table.columns[c] for c in ("k", "eps2", "beta") if c in table.columns), None)


def _decided_sign(tables: Sequence[Table], notes: Notes) -> Sign:
    """Tell N = n + i k from n - i k by the sign of most of k."""
    columns = [column for table in tables if (column := _absorption(table)) is not None]
    values = np.concatenate([np.zeros(0), *columns])
    values = values[np.isfinite(values)]
    above, below = (float(max(0.0, side.max(initial=0.0))) for side in (values, -values))
    if notes.choices.sign is not None:
        return notes.choices.sign
    if below <= max(ROUNDING, NOISE * above):
        return "n+ik"
    share = f"{np.mean(values < 0.0):.0%} of the rows"
    if above <= NOISE * below:
        why = f"k is negative in {share}, as it is where N = n - i k is meant"
        notes.assume("sign", "n-ik", why, ["n+ik"])
        return "n-ik"
    raise Undecided(
        "sign",
        f"the sign of k: it is from {-below:.4g} to {above:.4g}, negative in {share}, too much for "
        "noise; say sign=n+ik (what is negative becomes 0) or sign=n-ik",
    )


def _order(table: Table, notes: Notes) -> Order:
    steps = np.diff(table.x)
    if np.all(steps >= 0.0):
        return "rising"
    if np.all(steps <= 0.0):
        return "falling"
    turn = -1.0 if np.mean(steps < 0.0) > 0.5 else 1.0
    slips = np.flatnonzero(turn * steps < 0.0) + 1
    notes.warn(
        f"{slips.size} of {table.x.size} rows are not in order, the first in line "
        f"{int(table.lines[slips[0]])}: sorted"
    )
    return "unsorted"


def _wavelengths(table: Table, notes: Notes) -> tuple[NDArray[np.bool_], Array]:
    """Convert the abscissa; which rows have one, and where those are."""
    unit = UNITS[table.unit]
    positive = np.isfinite(table.x) & (table.x > 0.0)
    nm = np.full(table.x.size, np.nan)
    nm[positive] = unit.nanometers(table.x[positive])
    kept = positive & (nm <= _LONGEST_NM) & (nm >= _SHORTEST_NM)
    for at in np.flatnonzero(~kept).tolist():
        why = "beyond 1e-4 nm to 10 mm" if positive[at] else "none"
        notes.leave_out(
            int(table.lines[at]), f"{unit.kind} = {table.x[at]:.6g} {table.unit} is {why}"
        )
    return kept, nm[kept]


def _n_and_k(table: Table, sign: Sign, notes: Notes) -> tuple[Array | None, Array | None]:
    columns, turn = table.columns, -1.0 if sign == "n-ik" else 1.0
    absorption = _absorption(table)
    if absorption is not None:
        name = next(c for c in ("k", "eps2", "beta") if c in columns)
        absorption = _without_noise(name, turn * absorption, table.lines, notes)
    if "eps1" in columns:
        eps2 = np.zeros_like(columns["eps1"]) if absorption is None else absorption
        epsilon = columns["eps1"].astype(np.complex128)
        epsilon.imag = eps2  # 1j * eps2 is no number where eps2 is infinite
        N = np.sqrt(epsilon)
        return N.real, None if absorption is None else N.imag
    n = 1.0 - columns["delta"] if "delta" in columns else columns.get("n")
    return n, absorption


def _without_noise(name: str, values: Array, lines: Lines, notes: Notes) -> Array:
    negative = np.flatnonzero(values < 0.0)
    if not negative.size:
        return values + 0.0  # turns -0 into 0
    notes.warn(
        f"{name} is of the wrong sign in {negative.size} of {values.size} rows, at most by "
        f"{-values[negative].min():.3g}, first in line {int(lines[negative[0]])}: noise, set to 0"
    )
    return np.where(values < 0.0, 0.0, values)


def _within(
    name: str,
    values: Array,
    bounds: Parameter,
    lines: Lines,
    among: NDArray[np.bool_],
    notes: Notes,
) -> NDArray[np.bool_]:
    fine = bounds.admits(values) | np.isnan(values)
    for at in np.flatnonzero(~fine & among).tolist():
        allowed = f"{bounds.minimum:g} to {bounds.maximum:g}"
        notes.leave_out(
            int(lines[at]), f"{name} = {values[at]:.6g} is not computed with: {allowed} is"
        )
    return fine


def _points(name: str, pieces: Sequence[tuple[Array, Array, Lines]], notes: Notes) -> Points | None:
    """Sort, and merge what stands at one wavelength into its mean."""
    if name == "k":
        pieces = _measured_k(pieces, notes)
    if not any(values.size for _, values, _ in pieces):
        return None
    wavelength_nm, values, lines = (
        np.concatenate(columns) for columns in zip(*pieces, strict=True)
    )
    order = np.argsort(wavelength_nm, kind="stable")
    wavelength_nm, values, lines = wavelength_nm[order], values[order], lines[order]
    nodes, first, counts = np.unique(wavelength_nm, return_index=True, return_counts=True)
    if nodes.size < wavelength_nm.size:
        notes.merged = max(notes.merged, int(wavelength_nm.size - nodes.size))
        apart = np.maximum.reduceat(values, first) - np.minimum.reduceat(values, first)
        worst = int(np.argmax(apart))
        if apart[worst] > 0.0:
            notes.warn(
                f"{name} is given {int(counts[worst])} times at {nodes[worst]:.10g} nm, "
                f"{apart[worst]:.3g} apart, first in line {int(lines[first[worst]])}: the mean is used"
            )
        means = np.add.reduceat(values, first) / counts
        values = np.where(apart > 0.0, means, values[first])
    return Points(kind="points", wavelength_nm=tuple(nodes.tolist()), values=tuple(values.tolist()))


def _refuse_two(name: str, pieces: Sequence[tuple[Array, Array, Lines]]) -> None:
    """Refuse tables of two materials, or of two axes of one: their mean is that of neither.

    Raises
    ------
    Unreadable
        If two tables are of the same wavelengths, and not alike there.
    """
    for (x, values, lines), (x2, values2, lines2) in combinations(pieces, 2):
        if min(x.size, x2.size) < 2:
            continue
        order = np.argsort(x, kind="stable")
        inside = (x2 >= x.min()) & (x2 <= x.max())
        if 2 * np.count_nonzero(inside) < min(x.size, x2.size):
            continue  # one continues the other
        apart = np.abs(np.interp(x2[inside], x[order], values[order]) - values2[inside])
        if np.median(apart) > ALIKE:
            what = (
                f"one material: the tables from line {lines.min()} and from line {lines2.min()} both "
                f"have {name} from {x2[inside].min():.6g} to {x2[inside].max():.6g} nm, up to "
                f"{apart.max():.3g} apart; leave one of them"
            )
            raise Unreadable("file", None, what)


def _measured_k(
    pieces: Sequence[tuple[Array, Array, Lines]], notes: Notes
) -> Sequence[tuple[Array, Array, Lines]]:
    """Tell k = 0 that was measured from k = 0 that stands for nothing."""
    count = sum(values.size for _, values, _ in pieces)
    zeros = sum(int(np.count_nonzero(values == 0.0)) for _, values, _ in pieces)
    if not zeros:
        return pieces
    if zeros == count:
        why = "k is exactly 0 in every row: not measured, or too small for the file's digits"
    else:
        why = f"k is exactly 0 in {zeros} of {count} rows, which may mean that it was not measured there"
    is_known = notes.choices.zero_k or ("unknown" if zeros == count else "known")
    notes.assume("zero_k", is_known, why, ["known" if is_known == "unknown" else "unknown"])
    if is_known == "known":
        return pieces
    return [(x[v != 0.0], v[v != 0.0], lines[v != 0.0]) for x, v, lines in pieces]


def _say_gaps(
    points: Mapping[str, Points | None],
    parts: Mapping[str, Sequence[tuple[Array, Array, Lines]]],
    gone: Array,
    notes: Notes,
) -> None:
    known = points["n"] or points["k"]
    if known is not None:
        first, last = known.wavelength_nm[0], known.wavelength_nm[-1]
        inside = int(np.count_nonzero((gone > first) & (gone < last)))
        if inside:
            notes.warn(f"in the place of {inside} rows left out, values are interpolated")
    n, k = (sum(values.size for _, values, _ in parts[name]) for name in ("n", "k"))
    is_one = len(parts["n"]) == len(parts["k"]) == 1
    if is_one and 0 < k < n and np.isin(parts["k"][0][2], parts["n"][0][2]).all():
        notes.warn(f"k is missing in {n - k} of {n} rows")
