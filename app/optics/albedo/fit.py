"""What a fit of the albedo is: its formula, where it comes from, what it claims and what it does."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from app.optics.albedo.exact import Quantity, albedo
from app.optics.formulas.formula import Symbol
from app.optics.interface import Interface, Kind
from app.optics.parameters import Array


@dataclass(frozen=True, slots=True, kw_only=True)
class Domain:
    """A box of interfaces, bounds included."""

    eta: tuple[float, float]
    kappa: tuple[float, float] = (0.0, 0.0)
    """Bounds of n_t / n_i and k_t / n_i; eta below 1 is the view from the dense side."""

    @property
    def kind(self) -> Kind:
        """Whether the box holds dielectrics or conductors."""
        return "conductor" if self.kappa[1] > 0.0 else "dielectric"

    @property
    def words(self) -> str:
        """The box in words."""
        eta = f"{self.eta[0]:g} <= eta <= {self.eta[1]:g}"
        if self.kind == "dielectric":
            return f"{eta}, kappa = 0"
        return f"{eta}, {self.kappa[0]:g} <= kappa <= {self.kappa[1]:g}"

    def contains(self, interface: Interface) -> Array:
        """Whether each interface lies inside."""
        eta, kappa = interface.eta, interface.kappa
        return np.asarray(
            (self.eta[0] <= eta)
            & (eta <= self.eta[1])
            & (self.kappa[0] <= kappa)
            & (kappa <= self.kappa[1])
        )

    def grid(self, steps: int) -> Interface:
        """Interfaces covering the box, edges included, `steps` along each side that has a length."""
        eta = np.geomspace(*self.eta, steps)
        if self.kappa[0] == self.kappa[1]:
            return Interface(1.0, eta, self.kappa[0])
        return Interface(1.0, eta[np.newaxis, :], np.linspace(*self.kappa, steps)[:, np.newaxis])


@dataclass(frozen=True, slots=True, kw_only=True)
class Claim:
    """What a fit was said to achieve in a domain, and what it does achieve."""

    domain: Domain
    """Where the claim is made."""
    claimed: float | None = None
    """Largest error according to the source; None where it gives a domain and no figure."""
    relative: bool = False
    """Whether the errors are relative to the albedo."""
    source: str = "no figure published; measured here"
    """Where the claim stands."""
    measured: float
    """Largest error found, rounded up to three digits; a test measures it."""
    at: tuple[float, float]
    """(eta, kappa) of the largest error."""
    over: Domain | None = None
    """Where it was measured if not over the `domain`, on whose edge a relative error is
    infinite."""

    @property
    def measured_over(self) -> Domain:
        """Where it was measured."""
        return self.over or self.domain

    @property
    def holds(self) -> bool | None:
        """Whether the measured error is within the claimed one; None where nothing was claimed."""
        # Claims have one or two digits: 9.51 % measured is the 9.5 % that was claimed.
        return None if self.claimed is None else self.measured <= 1.005 * self.claimed


@dataclass(frozen=True, slots=True, kw_only=True)
class Fit:
    """A closed approximation of the hemispherical albedo."""

    id: str
    title: str
    """Name in the API (author, year) and name on the page."""
    quantity: Quantity = "unpolarized"
    """Which polarization it approximates."""
    domains: tuple[Domain, ...]
    """Boxes it was made for."""
    latex: str
    """The formula, in KaTeX's subset of LaTeX, with n = eta and k = kappa."""
    reference: str
    """Author, year, title."""
    note: str
    """What a user should know before taking it."""
    claims: tuple[Claim, ...]
    """Its errors, claimed and measured; at least one for each domain."""
    function: Callable[[Interface], Array]
    """`function(interface) -> A`; NaN where the formula is undefined."""
    printed: str = ""
    """What its source prints otherwise, in words."""
    symbols: tuple[Symbol, ...] = ()
    """Letters of `latex` that are neither n, k nor in the common glossary."""

    def __call__(self, interface: Interface) -> Array:
        """Evaluate the fit, an array of the interface's shape, inside the domain and outside it."""
        shape = np.broadcast_shapes(interface.n_i.shape, interface.n_t.shape, interface.k_t.shape)
        # Outside its domain a fit may divide by 0 or take a logarithm of less: a result, no fault.
        with np.errstate(all="ignore"):
            return np.broadcast_to(self.function(interface), shape)

    def contains(self, interface: Interface) -> Array:
        """Whether each interface lies in one of the domains."""
        return np.asarray(np.any([d.contains(interface) for d in self.domains], axis=0))

    def reason_outside(self, interface: Interface) -> str | None:
        """Why an interface (any of them) lies outside every domain, or None inside."""
        if np.all(self.contains(interface)):
            return None
        return "made for " + " or ".join(domain.words for domain in self.domains)

    def error(self, interface: Interface) -> Array:
        """Fit minus exact albedo, of the fit's own polarization."""
        return np.asarray(self(interface) - getattr(albedo(interface), self.quantity))
