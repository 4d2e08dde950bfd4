"""What stands in the collection of formulas: equation, symbols, domain, source, error and curve.

Models and fits of the albedo have declarations of their own, of each of which
`app.optics.formulas.collection` makes a `Formula`. Everything else, angles, exact albedos and
conversions, is declared as a `Formula` beside this file.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Literal, cast, get_args

import numpy as np

from app.optics.interface import Interface
from app.optics.parameters import Array, Parameter

FormulaKind = Literal["model", "albedo", "angle", "conversion"]
KINDS: tuple[FormulaKind, ...] = get_args(FormulaKind)


@dataclass(frozen=True, slots=True)
class Symbol:
    """A letter of a formula."""

    latex: str
    """As it is written in the formula."""
    meaning: str
    """In words, without a full stop."""
    unit: str = ""
    """Empty for pure numbers."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Accuracy:
    """The largest error of a formula, which a test measures again."""

    value: float
    """The error."""
    of: str
    """What is wrong by it: `R`, `A`, an angle, the value that comes back."""
    over: str
    """Where it was measured."""
    against: str
    """What it was measured against."""
    relative: bool = False
    """Whether the error is relative to the value."""
    at_most: bool = False
    """Whether `value` is a bound, as for rounding, which differs from one machine to another; else
    it is the largest error itself, to the digits given."""
    unit: str = ""
    """Of an absolute error."""


def rounding(value: float, of: str, over: str, against: str = "50-digit arithmetic") -> Accuracy:
    """State the error of what is exact but for rounding: a relative bound, on any machine."""
    return Accuracy(value=value, of=of, over=over, against=against, relative=True, at_most=True)


@dataclass(frozen=True, slots=True)
class Plotted:
    """What runs along an axis: name in the API, LaTeX, words, unit."""

    name: str
    symbol: str
    title: str
    unit: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """Values of one quantity along the abscissa."""

    id: str
    title: str
    values: Array


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A formula over its natural abscissa."""

    x: Plotted
    at: Array
    y: Plotted
    series: tuple[Series, ...]


Curves = Callable[[Interface, int], Curve]
Columns = Iterable[tuple[str, str, Array]]
"""Id, title and values of each series."""


def over(
    x: Plotted, low: float, high: float, y: Plotted, columns: Callable[[Interface, Array], Columns]
) -> Curves:
    """Plot what `columns(interface, x)` gives at equally spaced x, both ends included."""

    def curve(interface: Interface, samples: int) -> Curve:
        at = np.linspace(low, high, samples)
        return Curve(x, at, y, tuple(Series(*column) for column in columns(interface, at)))

    return curve


THETA = Plotted("theta_i_deg", r"\theta_i", "angle of incidence", "deg")
ETA = Plotted("eta", r"\eta", "relative index n_t/n_i")


@dataclass(frozen=True, slots=True, kw_only=True)
class Formula:
    """One formula as a reader meets it."""

    id: str
    """Kind and name, as `model.schlick`."""
    title: str
    """Name on the page."""
    latex: str
    """The formula, in KaTeX's subset of LaTeX."""
    reference: str
    """Author, year, title."""
    validity: str
    """Where it holds and where it fails, in words."""
    accuracy: tuple[Accuracy, ...]
    """Its largest errors, at least one."""
    curve: Curves
    """`curve(interface, samples) -> Curve`."""
    at: Interface
    """The interface of the curve unless another is given."""
    takes: tuple[Parameter, ...] = ()
    """Which of the interface's numbers the curve depends on."""
    printed: str = ""
    """What its source prints otherwise, in words; empty where nothing was lost."""
    symbols: tuple[Symbol, ...] = ()
    """Letters that the common glossary and the parameters do not explain."""
    parameters: tuple[Parameter, ...] = ()
    """The formula's own parameters."""

    @property
    def kind(self) -> FormulaKind:
        """The part of the id before the dot."""
        return cast("FormulaKind", self.id.partition(".")[0])
