"""Rows that name presets, given the numbers that those stand for."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from app.batch.rows import Fault, Hints, Index, Names, Rows, parted
from app.materials import (
    USELESS_WAVELENGTH,
    Preset,
    Resolved,
    UnknownMaterial,
    default_catalog,
    given_beside,
    indices_at,
    resolve_incident,
    resolve_material,
)
from app.optics.errors import OpticsError
from app.optics.parameters import K_T, N_I, N_T, WAVELENGTH_NM, Array

_SIDES: dict[str, tuple[Callable[[str, float | None], Resolved], tuple[str, ...]]] = {
    "material": (resolve_material, (N_T.name, K_T.name)),
    "incident": (resolve_incident, (N_I.name,)),
}
"""Columns that name presets: what says why one is refused, and the numbers that it stands for."""


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
            for name in _SIDES[side][1]:
                if name in self.numbers:
                    both = named & ~np.isnan(self.numbers[name])

                    def beside(row: int, side: str = side, column: Names = column) -> str:
                        return given_beside(side, column.distinct[column.codes[row]])

                    self._refuse_numbers(both, name, beside)
        if WAVELENGTH_NM.name in self.numbers:
            given, wrong = (
                ~np.isnan(self._wavelength_nm),
                ~WAVELENGTH_NM.admits(self._wavelength_nm),
            )
            name = WAVELENGTH_NM.name
            self._refuse_numbers(given & wrong, name, lambda _: WAVELENGTH_NM.allowed)
            self._refuse_numbers(given & ~anything, name, lambda _: USELESS_WAVELENGTH)

    def replace(self, side: str) -> None:
        """Evaluate the presets of one side, each once for all the rows that name it."""
        if side not in self._given:
            return
        codes, distinct = self._given[side]
        named = np.flatnonzero((codes >= 0) & self._right)
        columns = [self._column(name) for name in _SIDES[side][1]]
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
            n, k = indices_at(preset, at)
            if side == "incident":
                n = np.where(k > 0.0, np.nan, n)
            for column, values in zip(columns, (n, k), strict=False):
                column[which] = values
            wrong = np.isnan(np.broadcast_to(n, which.shape))
            self._explain(side, name, preset, which[wrong])

    def _column(self, name: str) -> Array:
        """A column of its own, to be written to."""
        given = self.numbers.get(name)
        column = np.full(self._count, np.nan) if given is None else given.copy()
        self.numbers[name] = column
        return column

    def _explain(self, side: str, name: str, preset: Preset, which: Index) -> None:
        """Say why rows are refused, in the words that `/snell` has for a single one."""
        wavelengths, asked = np.unique(self._wavelength_nm[which], return_inverse=True)
        told: dict[object, OpticsError] = {}
        faults: list[Fault] = []
        for wavelength_nm in wavelengths.tolist():
            given = None if np.isnan(wavelength_nm) else wavelength_nm
            alike = _alike(preset, given)
            if alike not in told:
                told[alike] = _why(side, preset, given)
            error = told[alike]
            value = given if error.parameter == WAVELENGTH_NM.name else name
            parameter = side if error.parameter == "material" else error.parameter
            faults.append(Fault(parameter, value, error.allowed))
        for row, at in zip(which.tolist(), asked.tolist(), strict=True):
            self._refuse(row, faults[at])


def _nearest(name: str) -> str:
    return UnknownMaterial(name, default_catalog().nearest(name)).allowed


def _alike(preset: Preset, wavelength_nm: float | None) -> object:
    """The same of wavelengths that are refused in the same words: finding them takes long."""
    if wavelength_nm is None or preset.kind == "single":
        return wavelength_nm is None
    spectrum = default_catalog().spectrum(preset.id)
    for quantity, span in (("n", spectrum.n_range_nm), ("k", spectrum.k_range_nm)):
        if span is not None and not span[0] <= wavelength_nm <= span[1]:
            return quantity
    return wavelength_nm


def _why(side: str, preset: Preset, wavelength_nm: float | None) -> OpticsError:
    try:
        _SIDES[side][0](preset.id, wavelength_nm)
    except OpticsError as error:
        return error
    raise RuntimeError(f"{preset.id} at {wavelength_nm} nm is refused for no reason")
