"""What a model is, and the registry that finds every one in `app.optics.models`."""

import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from app.optics.collection import Collection
from app.optics.errors import NotAllowed, OutOfRange, UnknownModel
from app.optics.formulas.formula import Symbol
from app.optics.incidence import Incidence
from app.optics.interface import Interface, Kind
from app.optics.numerics.blocks import broadcast, in_blocks
from app.optics.parameters import Array, Parameter

ModelKind = Literal["exact", "approximation"]

COLORS = frozenset({"F0", "F82", "tint"})
"""Parameters that a material's color gives."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Cost:
    """Operations of one evaluation of R from cos(theta_i) and constants of the interface.

    A fused multiply-add counts as one `mul` and one `add`; `trig` counts any sine, cosine, tangent
    or inverse of one.
    """

    add: int = 0
    mul: int = 0
    div: int = 0
    sqrt: int = 0
    pow: int = 0
    trig: int = 0
    lookup: int = 0


@dataclass(frozen=True, slots=True)
class Measured:
    """Error of an approximation at one interface, to the digits that a test measures again."""

    n_i: float
    n_t: float
    k_t: float
    """The interface."""
    max_abs: float
    """Largest |R - exact| over the hemisphere."""
    at_deg: float
    """Angle where it is reached, in degrees."""
    rms: float
    """Root mean square of R - exact over the solid angle."""

    @property
    def media(self) -> tuple[float, float, float]:
        """The interface's three indices."""
        return self.n_i, self.n_t, self.k_t


@dataclass(frozen=True, slots=True, eq=False)
class Peak:
    """A parameter that a curve has at its top: for languages that have to look for it themselves."""

    cosines: Array
    """Ascending; the top lies between the neighbors of the highest, which is not an end."""
    height: Callable[..., Array]
    """Of the cosine mu and quantities of the interface."""
    value: Callable[..., Array]
    """The parameter, of the cosine of the top, quantities of the interface and parameters before it."""


ROUNDED_AT = ((1.0, 1.5, 0.0), (1.0, 1.000001, 0.0))
"""Interfaces at which it is said what rounding costs an exact form: glass, and next to no boundary."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Model:
    """One formula for R(theta_i), exact or approximate.

    Everything a user meets of a model stands here: routes, OpenAPI, the controls on the page, the
    overlay, the README's table and the contract tests are made from this object.
    """

    id: str
    title: str
    """Name in the API (lower case, underscores) and name on the page."""
    latex: str
    """The formula, in KaTeX's subset of LaTeX."""
    reference: str
    """Author, title, year, equation number, and where to read it: `doi:10...` or `https://...`."""
    validity: str
    """Where the formula holds and where it fails, in words."""
    cost: Cost
    """Operations of one evaluation."""
    function: Callable[..., Array]
    """`function(interface, incidence, **parameters) -> R`, broadcasting its arguments; NaN where
    the formula is undefined."""
    polarized: Callable[..., tuple[Array, Array]] | None = None
    """The same arguments to (Rs, Rp), whose mean R is; None of what knows no polarization."""
    applies_to: tuple[Kind, ...] = ("dielectric", "conductor")
    """Kinds of interface the formula was made for, both unless given."""
    parameters: tuple[Parameter, ...] = ()
    """The model's own parameters, passed to `function` by name."""
    solve: Mapping[str, Callable[..., Array]] = field(default_factory=dict, hash=False)
    """How each parameter without a default is worked out where it is not given, by name: a function of
    the interface and of any parameters that stand before it, by their names."""
    peaks: Mapping[str, Peak] = field(default_factory=dict, hash=False)
    """Of those in `solve` that are no closed formula, what they are found by."""
    limits: Callable[[Interface], str | None] = field(default=lambda _: None)
    """Returns why an interface lies outside the domain, or None inside; asked after
    `applies_to`."""
    kinks: Callable[..., Array | None] | None = None
    """`kinks(**parameters)` returns the cosines where the function is not smooth for reasons of its
    own, as at the texels of a table, so that integrals can be split there: one axis for all curves, or
    a few last ones for each, NaN where a curve has fewer; None where there are none."""
    trap: bool = False
    """Whether it is kept to show a mistake; its title ends in "(trap)"."""
    rank: int = 1
    """Its place in lists, lowest first; of one rank by id, and traps behind all others."""
    measured: tuple[Measured, ...] = ()
    """Errors of an approximation at representative interfaces, each of which a test measures
    again."""
    snippet: Callable[..., Array] | str | None = None
    """What is handed out as shader code: `function` itself unless given; another function of mu and
    quantities of the interface, equal to it but fit for 32 bit floats and real arithmetic; or in
    words why there is none."""
    rounding: tuple[float, float] | None = None
    """Of an exact form, which differs from the others by rounding alone: the largest errors
    relative to R at the whole degrees from 0 to 89 at each of `ROUNDED_AT`, rounded up to a
    power of ten, which a test measures against 50-digit arithmetic."""
    leaves_0_to_1: bool = False
    """Whether values that its own parameters may have take R below 0 or above 1."""
    symbols: tuple[Symbol, ...] = ()
    """Letters of `latex` that neither the common glossary nor the parameters explain."""

    def __post_init__(self) -> None:
        """Refuse a parameter without a default that nothing solves."""
        optional = [parameter.name for parameter in self.parameters if parameter.default is None]
        unsolved = [name for name in optional if name not in self.solve]
        if unsolved:
            raise ValueError(f"{self.id}: {unsolved} have neither a default nor a way to be solved")

    @property
    def kind(self) -> ModelKind:
        """'exact' for forms algebraically equal to Fresnel's equations, else 'approximation'."""
        return "approximation" if self.rounding is None else "exact"

    @property
    def takes_color(self) -> bool:
        """Whether a material's color, F0 with F82 or a tint, is all that it has to be given."""
        solved = {parameter.name for parameter in self.parameters if parameter.default is None}
        return "F0" in solved and solved <= COLORS

    def __call__(
        self, interface: Interface, incidence: Incidence, **parameters: ArrayLike | None
    ) -> Array:
        """Evaluate R, an array of the broadcast shape of interface, incidence and parameters.

        Raises
        ------
        NotAllowed
            If a parameter is not the model's own.
        OutOfRange
            If a parameter's value is out of its bounds.
        """
        return self.evaluate(interface, incidence, self.arguments(interface, **parameters))

    def arguments(self, interface: Interface, **parameters: ArrayLike | None) -> dict[str, Array]:
        """Values of all the model's parameters, with a default or solved where left out or None.

        Raises
        ------
        NotAllowed
            If a parameter is not the model's own.
        OutOfRange
            If a parameter's value is out of its bounds.
        """
        complete: dict[str, Array] = {}
        for parameter in self.parameters:
            given = parameters.pop(parameter.name, None)
            value = parameter.default if given is None else given
            try:
                if value is not None:
                    complete[parameter.name] = parameter.check(value)
            except OutOfRange as error:
                name = f"{self.id}.{parameter.name}"
                raise OutOfRange(name, error.value, error.allowed) from None
        if parameters:
            own = [parameter.name for parameter in self.parameters]
            name, value = next(iter(parameters.items()))
            raise NotAllowed(f"{self.id}.{name}", value, f"{self.id} has the parameters {own}")
        if len(complete) == len(self.parameters):
            return complete
        with np.errstate(invalid="ignore", divide="ignore"):
            for parameter in self.parameters:
                if parameter.name not in complete:
                    function = self.solve[parameter.name]
                    known = {name: complete[name] for name in _asked(function)}
                    complete[parameter.name] = function(interface, **known)
        return {parameter.name: complete[parameter.name] for parameter in self.parameters}

    def evaluate(
        self, interface: Interface, incidence: Incidence, arguments: Mapping[str, Array]
    ) -> Array:
        """Evaluate R with the values that `arguments` returned, without looking at them again."""
        # A form undefined at some angle answers NaN there, which is a result and not a fault.
        with np.errstate(invalid="ignore", divide="ignore"):
            (values,) = in_blocks(self._values, interface, incidence, arguments)
        shape = broadcast(interface, incidence, values)
        return values if values.shape == shape else np.broadcast_to(values, shape)

    def evaluate_polarized(
        self, interface: Interface, incidence: Incidence, arguments: Mapping[str, Array]
    ) -> tuple[Array, Array]:
        """Evaluate Rs and Rp, as `evaluate` does R.

        Raises
        ------
        NotAllowed
            If the model knows no polarization.
        """
        if self.polarized is None:
            raise NotAllowed("models", self.id, "models that tell s and p apart")
        with np.errstate(invalid="ignore", divide="ignore"):
            Rs, Rp = in_blocks(self.polarized, interface, incidence, arguments)
        shape = broadcast(interface, incidence, Rs, Rp)
        return np.broadcast_to(Rs, shape), np.broadcast_to(Rp, shape)

    def _values(self, *where: Any, **arguments: Array) -> tuple[Array]:
        return (self.function(*where, **arguments),)

    def reason_outside(self, interface: Interface) -> str | None:
        """Why `interface` lies outside the model's domain, or None inside it."""
        if interface.kind not in self.applies_to:
            return f"made for a {' or '.join(self.applies_to)}, and this is a {interface.kind}"
        return self.limits(interface)


@cache
def _asked(function: Callable[..., Array]) -> tuple[str, ...]:
    """Names of the parameters that a function takes beside the interface."""
    return tuple(inspect.signature(function).parameters)[1:]


class Registry(Collection[Model]):
    """Models in order: `exact`, exact forms, approximations by their rank, traps."""

    def __init__(self, models: Iterable[Model]) -> None:
        ordered = sorted(
            models, key=lambda m: (m.id != "exact", m.kind != "exact", m.trap, m.rank, m.id)
        )
        super().__init__(ordered, UnknownModel, "models")


@cache
def default_registry() -> Registry:
    """Every `MODEL` in the modules of `app.optics.models`; adding a file there adds a model."""
    package = importlib.import_module("app.optics.models")
    names = [info.name for info in pkgutil.iter_modules(package.__path__)]
    modules = [importlib.import_module(f"{package.__name__}.{name}") for name in names]
    return Registry(module.MODEL for module in modules)
