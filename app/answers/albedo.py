"""Albedos of one interface: exact, by every fit and of models, and of a coat over a diffuse body."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields
from typing import Any, get_args

import numpy as np

from app.answers.answer import Gaps, Table, answer, filled, number_or_none
from app.answers.curves import Chosen
from app.answers.interface import CONVENTION, InterfaceFacts
from app.optics.albedo import (
    FITS,
    Albedo,
    Claim,
    CoatSplit,
    Fit,
    Quantity,
    albedo,
    coat_split,
    flatland_albedo,
    method,
    model_albedo,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface, Kind
from app.optics.parameters import Array

QUANTITIES: tuple[Quantity, ...] = get_args(Quantity)
CHANNELS = ("_red", "_green", "_blue")
"""What follows the name of a quantity that is three, for R, G and B."""


@answer
class FitDomain:
    """A box of interfaces, bounds included."""

    kind: Kind
    eta: tuple[float, float]
    kappa: tuple[float, float]


@answer
class FitClaim:
    """What a fit was said to achieve in a domain, and what it does."""

    domain: FitDomain
    claimed: float | None
    """Largest error by the source; null if none is given."""
    relative: bool
    """Whether the errors are relative to the albedo."""
    source: str
    """Where the claim stands."""
    measured: float
    """Largest error found, as a test of ours measures it."""
    at: dict[str, float]
    """eta and kappa of the largest error."""
    measured_over: FitDomain
    holds: bool | None
    """Whether the claim holds; null if there is none."""

    @classmethod
    def of(cls, claim: Claim) -> FitClaim:
        """Describe a claim."""
        return filled(
            cls,
            claim,
            domain=filled(FitDomain, claim.domain),
            at=dict(zip(("eta", "kappa"), claim.at, strict=True)),
            measured_over=filled(FitDomain, claim.measured_over),
        )


@answer
class RegisteredFit:
    """A closed approximation of the albedo."""

    id: str
    title: str
    quantity: Quantity
    domains: list[FitDomain]
    latex: str
    reference: str
    note: str
    claims: list[FitClaim]

    @classmethod
    def of(cls, fit: Fit) -> RegisteredFit:
        """Describe a fit."""
        return filled(
            cls,
            fit,
            domains=[filled(FitDomain, domain) for domain in fit.domains],
            claims=[FitClaim.of(claim) for claim in fit.claims],
        )


@answer
class RegisteredFits:
    """All fits."""

    fits: list[RegisteredFit]


@answer
class ExactAlbedo:
    """Exact hemispherical albedo."""

    unpolarized: float
    s: float
    p: float
    method: str


@answer
class FittedAlbedo:
    """A fit's value for one interface."""

    id: str
    title: str
    quantity: Quantity
    value: float | None
    """Null where the formula is undefined."""
    error: float | None
    """value - exact, of the same polarization."""
    in_domain: bool
    reason: str | None
    reference: str

    @classmethod
    def of(cls, fit: Fit, interface: Interface, exact: Albedo) -> FittedAlbedo:
        """Evaluate a fit."""
        value, reason = fit(interface), fit.reason_outside(interface)
        error = value - getattr(exact, fit.quantity)
        return filled(
            cls,
            fit,
            value=number_or_none(value),
            error=number_or_none(error),
            in_domain=reason is None,
            reason=reason,
        )


@answer
class ModelAlbedo:
    """The albedo of a model's curve; three numbers where its parameters are R, G and B."""

    model: str
    value: float | Gaps | None
    """Null where the model is undefined."""
    error: float | Gaps | None
    in_domain: bool
    reason: str | None

    @classmethod
    def of(cls, chosen: Chosen, interface: Interface, exact: Albedo) -> ModelAlbedo:
        """Average a model's curve."""
        model = chosen.model
        values = model_albedo(model, interface, **chosen.given)
        reason = model.reason_outside(interface)
        return cls(
            model=model.id,
            value=_one_or_three(values),
            error=_one_or_three(np.asarray(values - exact.unpolarized)),
            in_domain=reason is None,
            reason=reason,
        )


@answer
class Side:
    """The same surface met from the second medium."""

    exact: ExactAlbedo
    approximations: list[FittedAlbedo]

    @classmethod
    def of(cls, interface: Interface, exact: Albedo) -> Side:
        """Describe what a surface reflects of diffuse light from the first medium."""
        return cls(
            exact=ExactAlbedo(
                method=method(interface),
                **{name: float(getattr(exact, name)) for name in QUANTITIES},
            ),
            approximations=[FittedAlbedo.of(fit, interface, exact) for fit in FITS.values()],
        )


@answer
class Albedos:
    """Albedo of one interface, exact and by every fit."""

    interface: InterfaceFacts
    convention: str = CONVENTION
    exact: ExactAlbedo
    flatland: float | None
    """Unpolarized, in two dimensions."""
    approximations: list[FittedAlbedo]
    models: list[ModelAlbedo]
    reverse: Side | None
    """Albedo from the second medium: the internal diffuse reflectance where n_t > n_i. Null if that
    medium absorbs."""

    def table(self) -> Table:
        """Lay the numbers out as one row."""
        row: dict[str, float | Array | None] = {
            **{name: getattr(self.interface, name) for name in ("n_i", "n_t", "k_t")},
            **{f"exact.{name}": getattr(self.exact, name) for name in QUANTITIES},
            "flatland": self.flatland,
        }
        for fitted in self.approximations:
            row |= {f"{fitted.id}.value": fitted.value, f"{fitted.id}.error": fitted.error}
        for averaged in self.models:
            for name in ("value", "error"):
                numbers = np.atleast_1d(np.array(getattr(averaged, name), dtype=np.float64))
                pairs = zip(CHANNELS if numbers.size > 1 else ("",), numbers, strict=True)
                row |= {f"model.{averaged.model}.{name}{color}": value for color, value in pairs}
        columns = {name: np.array([value], dtype=np.float64) for name, value in row.items()}
        return Table(columns, "albedo.csv")


@answer
class Coat:
    """Where the light goes that falls on a diffuse body under a clear coat."""

    interface: InterfaceFacts
    convention: str = CONVENTION
    body_albedo: float
    theta_i_deg: float | None
    """Null for diffuse light."""
    external: float
    """Albedo of the coat's surface from outside."""
    internal: float
    """Albedo of the coat's surface from the body's side."""
    surface: float
    """Reflected by the surface."""
    body: float
    """Scattered by the body and let out again."""
    absorbed: float
    """Lost in the body."""

    def table(self) -> Table:
        """Lay the shares out as one row."""
        parts = (part.name for part in fields(CoatSplit))
        return Table({name: np.array([getattr(self, name)]) for name in parts}, "coat.csv")


def albedos(interface: Interface, models: Iterable[Chosen] = ()) -> Albedos:
    """Evaluate the albedo of an interface by all that is known, and average the curves of models."""
    exact = albedo(interface)
    outer, inner = Side.of(interface, exact), None
    if not interface.is_conductor:
        reverse = Interface(interface.n_t, interface.n_i)
        inner = Side.of(reverse, albedo(reverse))
    return Albedos(
        interface=InterfaceFacts.of(interface),
        exact=outer.exact,
        flatland=float(flatland_albedo(interface)),
        approximations=outer.approximations,
        models=[ModelAlbedo.of(chosen, interface, exact) for chosen in models],
        reverse=inner,
    )


def coat(interface: Interface, body_albedo: float, ray: Incidence | None = None) -> Coat:
    """Split the light that falls on a coat, diffuse or, at an angle, a ray."""
    split = coat_split(interface, body_albedo, ray)
    shares: dict[str, Any] = {p.name: float(getattr(split, p.name)) for p in fields(split)}
    return Coat(
        interface=InterfaceFacts.of(interface),
        body_albedo=body_albedo,
        theta_i_deg=None if ray is None else float(ray.theta_i_deg),
        **shares,
    )


def _one_or_three(values: Array) -> float | Array | None:
    return number_or_none(values) if values.ndim == 0 else values.ravel()
