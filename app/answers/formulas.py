"""Everything that is registered as a formula, explained, and its curve."""

from __future__ import annotations

from typing import Literal

import numpy as np

from app.answers.answer import Gaps, Table, Values, answer, filled
from app.optics.formulas.collection import CONVENTIONS, symbols_of
from app.optics.formulas.formula import Accuracy, Formula, Plotted, Symbol
from app.optics.formulas.sources import links
from app.optics.interface import Interface
from app.optics.parameters import Parameter


@answer
class Taken:
    """A number of the interface that a formula's curve depends on."""

    name: str
    symbol: str
    value: float
    """Of the example that is shown unless another is given."""
    minimum: float
    maximum: float


@answer
class ExplainedFormula:
    """A formula with all that is to be said of it."""

    id: str
    """Kind and name, as model.schlick."""
    kind: Literal["model", "albedo", "angle", "conversion"]
    title: str
    latex: str
    convention: str
    validity: str
    printed: str
    """What its source prints otherwise, in words; empty where nothing was lost."""
    reference: str
    links: list[str]
    """Where the reference can be read."""
    symbols: tuple[Symbol, ...]
    """Every letter, in the order of appearance."""
    parameters: tuple[Parameter, ...]
    measured: tuple[Accuracy, ...]
    takes: list[Taken]
    """What its curve may be given."""

    @classmethod
    def of(cls, formula: Formula) -> ExplainedFormula:
        """Explain a formula."""
        return filled(
            cls,
            formula,
            convention=CONVENTIONS[formula.kind],
            links=list(links(formula.reference)),
            symbols=tuple(symbols_of(formula)),
            measured=formula.accuracy,
            takes=[
                filled(Taken, p, value=float(getattr(formula.at, p.name))) for p in formula.takes
            ],
        )


@answer
class FormulaSeries:
    """One quantity along the abscissa."""

    id: str
    title: str
    values: Gaps


@answer
class FormulaCurve:
    """A formula over its own abscissa, beside the exact values where it approximates some."""

    formula: str
    convention: str
    n_i: float
    n_t: float
    k_t: float
    x: Plotted
    at: Values
    y: Plotted
    series: list[FormulaSeries]

    @classmethod
    def of(cls, formula: Formula, interface: Interface, samples: int) -> FormulaCurve:
        """Evaluate a formula over its abscissa at an interface."""
        curve = formula.curve(interface, samples)
        return cls(
            formula=formula.id,
            convention=CONVENTIONS[formula.kind],
            **{name: float(getattr(interface, name)) for name in ("n_i", "n_t", "k_t")},
            x=curve.x,
            at=curve.at,
            y=curve.y,
            series=[
                filled(FormulaSeries, s, values=np.ascontiguousarray(s.values))
                for s in curve.series
            ],
        )

    def table(self) -> Table:
        """Lay out the abscissa and a column each quantity."""
        columns = {self.x.name: self.at} | {series.id: series.values for series in self.series}
        return Table(columns, f"{self.formula}.csv")
