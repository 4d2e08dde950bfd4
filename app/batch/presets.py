"""Rows that name presets, given the numbers that those stand for."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.batch.rows import Fault, Hints, Names, Rows, parted
from app.materials import (
    NEGLIGIBLE_K,
    USELESS_WAVELENGTH,
    Constants,
    Preset,
    UnknownMaterial,
    constants_at,
    default_catalog,
    given_beside,
    warnings_as_incident,
    warnings_as_material,
)
from app.optics.errors import OpticsError
from app.optics.parameters import K_T, N_I, N_T, WAVELENGTH_NM, Array


class _Side(NamedTuple):
    """A column that names presets.

    Attributes
    ----------
    numbers
        What a preset stands for.
    judge
        Refuses what may not stand there.
    is_transparent
        Whether only what does not absorb may.
    """

    numbers: tuple[str, ...]
    judge: Callable[[Preset, Constants], object]
    is_transparent: bool


_SIDES = {
    "material": _Side((N_T.name, K_T.name), warnings_as_material, is_transparent=False),
    "incident": _Side((N_I.name,), warnings_as_incident, is_transparent=True),
}


def resolved(rows: Rows) -> Rows:
    """Put n_i, n_t and k_t in the place of the presets that rows name.

    The rows are those of `/snell`: what it refuses is a fault of the row, in the same words.
    """
    if WAVELENGTH_NM.name not in rows.numbers and not _SIDES.keys() & rows.names.keys():
        return rows
    task = _Task(rows)
    task.refuse_what_contradicts()
    for side in _SIDES:
        task.replace(side)
    numbers = {name: task.numbers[name] for name in task.numbers if name != WAVELENGTH_NM.name}
    names = {name: column for name, column in rows.names.items() if name not in _SIDES}
    return Rows(rows.count, numbers, names, task.faults)


class _Task:
    """Rows on their way to being resolved."""

    def __init__(self, rows: Rows) -> None:
        self.numbers = dict(rows.numbers)
        self.faults = dict(rows.faults)
        self._count = rows.count
        self._given = {side: rows.names[side] for side in _SIDES if side in rows.names}
        self._right = np.ones(rows.count, np.bool_)
        self._right[list(self.faults)] = False
        left_out = np.broadcast_to(np.nan, rows.count)
        self._wavelength_nm = rows.numbers.get(WAVELENGTH_NM.name, left_out)

    def _refuse(self, row: int, fault: Fault) -> None:
        self.faults[row] = fault
        self._right[row] = False

    def _refuse_numbers(
        self, where: NDArray[np.bool_], name: str, message: Callable[[int], str]
    ) -> None:
        for row in np.flatnonzero(where & self._right).tolist():
            self._refuse(row, Fault(name, float(self.numbers[name][row]), message(row)))

    def refuse_what_contradicts(self) -> None:
        """Refuse wavelengths that are none or of no use, and numbers beside what replaces them."""
        anything = np.zeros(self._count, np.bool_)
        for side, column in self._given.items():
            named = column.codes >= 0
            anything |= named
            for name in _SIDES[side].numbers:
                if name in self.numbers:
                    both = named & ~np.isnan(self.numbers[name])

                    def beside(row: int, side: str = side, column: Names = column) -> str:
                        return given_beside(side, column.distinct[column.codes[row]])

                    self._refuse_numbers(both, name, beside)
        if WAVELENGTH_NM.name in self.numbers:
            name, given = WAVELENGTH_NM.name, ~np.isnan(self._wavelength_nm)
            wrong = ~WAVELENGTH_NM.admits(self._wavelength_nm)
            self._refuse_numbers(given & wrong, name, lambda _: WAVELENGTH_NM.allowed)
            self._refuse_numbers(given & ~anything, name, lambda _: USELESS_WAVELENGTH)

    def replace(self, side: str) -> None:
        """Evaluate the presets of one side, each once for all the rows that name it."""
        if side not in self._given:
            return
        codes, distinct = self._given[side]
        named = np.flatnonzero((codes >= 0) & self._right)
        columns = [self._column(name) for name in _SIDES[side].numbers]
        hints = Hints()
        for code, which in parted(codes[named], named):
            name = distinct[code]
            preset = default_catalog().find(name)
            if preset is None:
                fault = Fault(side, name, hints.of(name, _nearest))
                for row in which.tolist():
                    self._refuse(row, fault)
                continue
            at = self._wavelength_nm[which]
            n, k = constants_at(preset, at)
            counts = np.where(k >= NEGLIGIBLE_K, k, 0.0)
            wrong = ~(N_T.admits(n) & K_T.admits(counts))
            if _SIDES[side].is_transparent:
                wrong |= counts > 0.0
            for column, values in zip(columns, (n, counts), strict=False):
                column[which] = values
            if wrong.any():
                told = self._faults(side, name, preset, at[wrong], n[wrong], k[wrong])
                for row, fault in zip(which[wrong].tolist(), told, strict=True):
                    self._refuse(row, fault)

    def _column(self, name: str) -> Array:
        """A column of its own, to be written to."""
        given = self.numbers.get(name)
        column = np.full(self._count, np.nan) if given is None else given.copy()
        self.numbers[name] = column
        return column

    def _faults(
        self, side: str, name: str, preset: Preset, at: Array, n: Array, k: Array
    ) -> Iterator[Fault]:
        """Say what is wrong with rows, in the words that `/snell` has for a single one."""
        told: dict[object, tuple[str, str]] = {}
        for row in zip(at.tolist(), n.tolist(), k.tolist(), strict=True):
            wavelength_nm, *known = (None if math.isnan(number) else number for number in row)
            alike = _alike(preset, wavelength_nm) if known[0] is None else row
            if alike not in told:
                told[alike] = _why(side, preset, wavelength_nm, *known)
            parameter, message = told[alike]
            value = wavelength_nm if parameter == WAVELENGTH_NM.name else name
            yield Fault(parameter, value, message)


def _nearest(name: str) -> str:
    return UnknownMaterial(name, default_catalog().nearest(name)).allowed


def _alike(preset: Preset, wavelength_nm: float | None) -> object:
    """The same of all wavelengths at which a preset is not known for the same reason."""
    if wavelength_nm is not None and preset.kind == "spectrum":
        low, high = default_catalog().spectrum(preset.id).n_range_nm
        return low <= wavelength_nm <= high
    return None


def _why(
    side: str, preset: Preset, wavelength_nm: float | None, n: float | None, k: float | None
) -> tuple[str, str]:
    """Say why a preset is refused: it is not known there, or may not stand where it does.

    Returns
    -------
    tuple
        The parameter that is wrong, and what would be right.
    """
    try:
        if n is None:
            default_catalog().constants(preset.id, wavelength_nm)
        else:
            at = preset.wavelength_nm if wavelength_nm is None else wavelength_nm
            _SIDES[side].judge(preset, Constants(n, k, at))
    except OpticsError as error:
        return error.parameter, error.allowed
    raise RuntimeError(f"{preset.id} at {wavelength_nm} nm is refused for no reason")
