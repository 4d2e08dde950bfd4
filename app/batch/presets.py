"""Rows that name presets, given the numbers that those stand for."""

import math
from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.batch.rows import Fault, Hints, Index, Names, Rows, parted
from app.materials.errors import UnknownMaterial
from app.materials.media import (
    NEGLIGIBLE_K,
    USELESS_WAVELENGTH,
    constants_at,
    default_catalog,
    given_beside,
    transparent,
    within,
)
from app.materials.own.token import is_own
from app.materials.schema import Preset
from app.optics.errors import OpticsError
from app.optics.meant import in_nm
from app.optics.parameters import K_T, N_I, N_T, WAVELENGTH_NM, Array


class _Side(NamedTuple):
    """A column that names presets."""

    numbers: tuple[str, ...]
    """What a preset stands for."""
    is_transparent: bool
    """Whether only what does not absorb may."""


LAYERS = "layers"

_SIDES = {
    "material": _Side((N_T.name, K_T.name), is_transparent=False),
    "incident": _Side((N_I.name,), is_transparent=True),
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
    lost = () if LAYERS in rows.names else (WAVELENGTH_NM.name,)
    numbers = {name: task.numbers[name] for name in task.numbers if name not in lost}
    names = {name: column for name, column in rows.names.items() if name not in _SIDES}
    return Rows(rows.count, numbers, names, task.faults)


class _Task:
    """Rows on their way to being resolved."""

    def __init__(self, rows: Rows) -> None:
        self.numbers = dict(rows.numbers)
        self.faults = dict(rows.faults)
        self._count = rows.count
        self._given = {side: rows.names[side] for side in _SIDES if side in rows.names}
        none = np.zeros(rows.count, np.bool_)
        self._layered = rows.names[LAYERS].codes >= 0 if LAYERS in rows.names else none
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
        anything = self._layered.copy()
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
                told = _nearest(name) if is_own(name) else hints.of(name, _nearest)
                fault = Fault(side, name[:200], told)
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
                self._refuse_preset(side, name, preset, which[wrong], n[wrong], k[wrong])

    def _column(self, name: str) -> Array:
        """A column of its own, to be written to."""
        given = self.numbers.get(name)
        column = np.full(self._count, np.nan) if given is None else given.copy()
        self.numbers[name] = column
        return column

    def _refuse_preset(
        self, side: str, name: str, preset: Preset, which: Index, n: Array, k: Array
    ) -> None:
        """Say what is wrong with rows, in the words that `/snell` has for a single one.

        There may be many, each at a wavelength of its own, so what takes long to find out is found
        out once for all that share it.
        """
        wavelength_nm = self._wavelength_nm[which]

        def refuse(
            where: NDArray[np.bool_],
            parameter: str,
            message: str | Callable[[float], str],
            about: Array,
        ) -> None:
            those = where & self._right[which]
            rows = zip(*(x[those].tolist() for x in (which, wavelength_nm, about)), strict=True)
            for row, at, number in rows:
                value = name if parameter != WAVELENGTH_NM.name else None if math.isnan(at) else at
                told = message if isinstance(message, str) else message(number)
                self._refuse(row, Fault(parameter, value, told))

        for alike in _known_alike(preset, wavelength_nm):
            unknown = alike & np.isnan(n)
            if unknown.any():
                first = float(wavelength_nm[unknown][0])
                parameter, why = _why_unknown(preset, first)
                same = why.removesuffix(in_nm(first))
                refuse(unknown, parameter, partial(_with_unit, same), wavelength_nm)
        for quantity, values, bounds in (("n", n, N_T), ("k", k, K_T)):
            beyond = (values < bounds.minimum) | (values > bounds.maximum)
            refuse(beyond, WAVELENGTH_NM.name, within(bounds, quantity, preset), values)
        if _SIDES[side].is_transparent:
            refuse(k >= NEGLIGIBLE_K, side, transparent, k)


def _with_unit(same: str, wavelength_nm: float) -> str:
    return same + in_nm(wavelength_nm)


def _nearest(name: str) -> str:
    try:
        return f"{default_catalog().get(name).id} is one"
    except UnknownMaterial as error:
        return error.allowed


def _known_alike(preset: Preset, wavelength_nm: Array) -> Iterator[NDArray[np.bool_]]:
    """Part wavelengths at which a preset is not known by the reason why."""
    if preset.kind == "spectrum":
        catalog = default_catalog()
        ranges = [catalog.spectrum(preset.id).n_range_nm]
        ranges += [
            catalog.spectrum(rival.id).range_nm
            for rival in catalog.rivals(preset.id)
            if rival.kind == "spectrum"
        ]
        pattern = np.zeros(wavelength_nm.shape, np.intp)
        for bit, (low, high) in enumerate(ranges):
            within = (wavelength_nm >= low) & (wavelength_nm <= high)
            pattern |= within.astype(np.intp) << bit
        for bits in np.unique(pattern):
            yield pattern == bits
    else:
        yield np.ones(wavelength_nm.shape, np.bool_)


def _why_unknown(preset: Preset, wavelength_nm: float) -> tuple[str, str]:
    """Say why a preset is not known at a wavelength.

    Returns
    -------
    tuple
        The parameter that is wrong, and what would be right.
    """
    try:
        default_catalog().constants(preset.id, None if math.isnan(wavelength_nm) else wavelength_nm)
    except OpticsError as error:
        return error.parameter, error.allowed
    raise RuntimeError(f"{preset.id} is known at {wavelength_nm} nm")
