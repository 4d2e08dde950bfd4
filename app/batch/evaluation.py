"""Rows answered by groups, each by one call of a model."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import repeat
from typing import TypeVar

import numpy as np

from app.batch.presets import LAYERS, resolved
from app.batch.rows import MEDIA, Fault, Hints, Index, Rows, parted
from app.materials.films import Film, film_rows, layer_of, read_layers, resolve_film
from app.materials.media import given_beside
from app.optics.errors import OpticsError, UnknownName
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import (
    K_T,
    N_I,
    N_T,
    THETA_I_DEG,
    THETA_I_RAD,
    WAVELENGTH_NM,
    Array,
    Parameter,
)
from app.optics.quantities import QUANTITIES, of_films
from app.optics.registry import Model, Registry
from app.optics.stack import D_LINE_NM, Stack

T = TypeVar("T")

_QUANTITIES = {name: name for name in QUANTITIES}


@dataclass(slots=True)
class Outcome:
    """One value a row, NaN where it is undefined or the row is wrong; and what is wrong."""

    values: Array
    faults: dict[int, Fault] = field(default_factory=dict)


def evaluate(rows: Rows, registry: Registry) -> Outcome:
    """Answer every row; one that is wrong does not keep the others from their answers."""
    task = _Task(resolved(rows), registry)
    for model, which in task.by_name("model", "exact", registry):
        for quantity, asked in task.by_name("quantity", "R", _QUANTITIES, which):
            own = ("R", "Rs", "Rp") if model.polarized else ("R",)
            if model.id != "exact" and quantity not in own:
                message = (
                    f"{model.id} has {_listed(own)} alone; the other quantities are those of exact"
                )
                task.refuse(asked, "quantity", repeat(quantity), message)
            else:
                task.answer(model, quantity, asked)
    return task.outcome


class _Task:
    """Rows on their way to becoming an outcome."""

    def __init__(self, rows: Rows, registry: Registry) -> None:
        self.rows = rows
        self.registry = registry
        self.outcome = Outcome(np.full(rows.count, np.nan), dict(rows.faults))

    def refuse(self, which: Index, parameter: str, values: Iterable[object], message: str) -> None:
        """Say what is wrong with some rows, each with the value that it gave."""
        for row, value in zip(which.tolist(), values, strict=False):
            self.outcome.faults[row] = Fault(parameter, value, message)

    def by_name(
        self, column: str, default: str, known: Mapping[str, T], which: Index | None = None
    ) -> Iterator[tuple[T, Index]]:
        """Part rows by what a column of names calls for, and refuse those that name nothing."""
        if which is None:
            which = np.arange(self.rows.count)
            if self.rows.faults:
                which = np.delete(which, list(self.rows.faults))
        if column not in self.rows.names:
            yield known[default], which
            return
        hints = Hints()
        codes, distinct = self.rows.names[column]
        for code, asked in parted(codes[which], which):
            name = default if code < 0 else distinct[code]
            found = known.get(name)
            if found is None:
                message = hints.of(name, lambda name: UnknownName(column, name, known).allowed)
                self.refuse(asked, column, repeat(name), message)
            else:
                yield found, asked

    def answer(self, model: Model, quantity: str, which: Index) -> None:
        """Evaluate rows of one model and quantity."""
        own = {f"{model.id}.{p.name}": p for p in model.parameters}
        which = self._without_foreign(model, own, which)
        for parameter in (*MEDIA, THETA_I_RAD):
            which = self._within_bounds(parameter.name, parameter, which)
        which = self._without_two_angles(which)
        for name, parameter in own.items():
            which = self._within_bounds(name, parameter, which)
        # Parameters that are left out may have to be solved, those that are given must not be.
        # Radians are told apart too, since they do not become degrees on the way.
        apart = (*own, THETA_I_RAD.name)
        present = [name for name in apart if name in self.rows.numbers]
        pattern = np.zeros(which.size, dtype=np.intp)
        for bit, name in enumerate(present):
            pattern |= (~np.isnan(self._at(name, which))).astype(np.intp) << bit
        for bits, asked in parted(pattern, which):
            given = [name for bit, name in enumerate(present) if bits >> bit & 1]
            self._evaluate(model, quantity, given, asked)

    def _evaluate(self, model: Model, quantity: str, given: list[str], which: Index) -> None:
        if LAYERS not in self.rows.names:
            self._bare(model, quantity, given, which)
            return
        codes, distinct = self.rows.names[LAYERS]
        for code, asked in parted(codes[which], which):
            if code < 0:
                self._bare(model, quantity, given, asked)
            elif model.id == "exact":
                self._coated(quantity, distinct[code], given, asked)
            else:
                told = "exact where there are layers, which no other knows"
                self.refuse(asked, "model", repeat(model.id), told)

    def _coated(self, quantity: str, text: str, given: list[str], which: Index) -> None:
        """Answer rows that have the same layers."""
        wavelength_nm = np.full(which.size, np.nan)
        if WAVELENGTH_NM.name in self.rows.numbers:
            wavelength_nm = self._at(WAVELENGTH_NM.name, which)
        try:
            films = read_layers(text)
            media = [film_rows(film, wavelength_nm) for film in films]
        except OpticsError as error:
            self.refuse(which, LAYERS, repeat(error.value), error.allowed)
            return
        known = np.ones(which.size, np.bool_)
        for film, (n, k) in zip(films, media, strict=True):
            for place in np.flatnonzero(known & ~(N_T.admits(n) & K_T.admits(k))).tolist():
                known[place] = False
                fault = self._unknown(film, float(wavelength_nm[place]))
                self.outcome.faults[int(which[place])] = fault
        if not known.any():
            return
        which = which[known]
        at = np.where(np.isnan(wavelength_nm[known]), D_LINE_NM, wavelength_nm[known])
        n_i, n_t, k_t = (self._numbers(p.name, p, which) for p in (N_I, N_T, K_T))
        try:
            layers = [
                layer_of(
                    film,
                    _one_if_equal(n[known]),
                    _one_if_equal(k[known]),
                    film.thickness_nm or 0.0,
                )
                for film, (n, k) in zip(films, media, strict=True)
            ]
            stack = Stack(n_i, layers, n_t, k_t, wavelength_nm=_one_if_equal(at))
            values = of_films(quantity, stack, self._incidence(given, which))
        except OpticsError as error:
            self.refuse(which, error.parameter, repeat(error.value), error.allowed)
            return
        self.outcome.values[which] = values

    def _unknown(self, film: Film, wavelength_nm: float) -> Fault:
        """Say why a layer is not known at a wavelength, in the words of `/snell`."""
        try:
            index, _ = resolve_film(film, None if np.isnan(wavelength_nm) else wavelength_nm)
        except OpticsError as error:
            return Fault(error.parameter, error.value, error.allowed)
        return Fault(LAYERS, film.spelled, f"a film of an index that can be; this one is {index:g}")

    def _bare(self, model: Model, quantity: str, given: list[str], which: Index) -> None:
        if which.size == 0:
            return
        n_i, n_t, k_t = (self._numbers(p.name, p, which) for p in (N_I, N_T, K_T))
        interface, incidence = Interface(n_i, n_t, k_t), self._incidence(given, which)
        if model.id == "exact":
            values = QUANTITIES[quantity](interface, incidence)
        else:
            own = {
                name.partition(".")[2]: _one_if_equal(self._at(name, which))
                for name in given
                if "." in name
            }
            arguments = model.arguments(interface, **own)
            if quantity == "R":
                values = model.evaluate(interface, incidence, arguments)
            else:
                Rs, Rp = model.evaluate_polarized(interface, incidence, arguments)
                values = Rs if quantity == "Rs" else Rp
        self.outcome.values[which] = values

    def _incidence(self, given: list[str], which: Index) -> Incidence:
        """The directions of rows that all give radians or all do not."""
        if THETA_I_RAD.name in given:
            return Incidence.from_radians(_one_if_equal(self._at(THETA_I_RAD.name, which)))
        return Incidence.from_degrees(self._numbers(THETA_I_DEG.name, THETA_I_DEG, which))

    def _without_two_angles(self, which: Index) -> Index:
        """Refuse rows that give their angle in degrees and in radians."""
        if not {THETA_I_DEG.name, THETA_I_RAD.name} <= self.rows.numbers.keys():
            return which
        degrees, radians = (self._at(p.name, which) for p in (THETA_I_DEG, THETA_I_RAD))
        both = ~np.isnan(degrees) & ~np.isnan(radians)
        if not both.any():
            return which
        for row, rad, deg in zip(
            *(values[both].tolist() for values in (which, radians, degrees)), strict=True
        ):
            told = given_beside(THETA_I_RAD.name, f"{rad:.17g}")
            self.outcome.faults[row] = Fault(THETA_I_DEG.name, deg, told)
        return which[~both]

    def _at(self, name: str, which: Index) -> Array:
        """A column at some rows, which are distinct and in order: all of them are the column."""
        column = self.rows.numbers[name]
        return column if which.size == self.rows.count else column[which]

    def _without_foreign(self, model: Model, own: Mapping[str, Parameter], which: Index) -> Index:
        """Refuse rows that give a parameter of another model, which would otherwise be lost."""
        for name in self.rows.numbers:
            if "." in name and name not in own:
                column = self._at(name, which)
                given = ~np.isnan(column)
                if given.any():
                    message = f"given although the model is {model.id}"
                    self.refuse(which[given], name, column[given].tolist(), message)
                    which = which[~given]
        return which

    def _within_bounds(self, name: str, parameter: Parameter, which: Index) -> Index:
        """Refuse rows whose number is not allowed."""
        if name not in self.rows.numbers:
            return which
        values = self._at(name, which)
        fine = parameter.admits(values) | np.isnan(values)
        if fine.all():
            return which
        wrong = values[~fine]
        for row, value in zip(which[~fine].tolist(), wrong.tolist(), strict=True):
            self.outcome.faults[row] = Fault(name, value, parameter.instead_of(value))
        return which[fine]

    def _numbers(self, name: str, parameter: Parameter, which: Index) -> Array | float:
        default = parameter.default or 0.0
        if name not in self.rows.numbers:
            return default
        values = self._at(name, which)
        left_out = np.isnan(values)
        return _one_if_equal(np.where(left_out, default, values) if left_out.any() else values)


def _listed(names: Sequence[str]) -> str:
    """Names as one says them."""
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else last


def _one_if_equal(values: Array) -> Array | float:
    """A single number where all are the same, with which the models are fastest."""
    first = values[0]
    return float(first) if values[-1] == first and np.all(values == first) else values
