"""Shapes of the answers about albedos, for OpenAPI."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from app.api.schemas import InterfaceOut, ResolvedPresetOut


class DomainOut(BaseModel):
    """A box of interfaces, bounds included."""

    kind: Literal["dielectric", "conductor"]
    eta: tuple[float, float]
    kappa: tuple[float, float]


class FitClaimOut(BaseModel):
    """What a fit was said to achieve in a domain, and what it does."""

    domain: DomainOut
    claimed: float | None = Field(description="Largest error by the source; null if none is given.")
    relative: bool = Field(description="Whether the errors are relative to the albedo.")
    source: str = Field(description="Where the claim stands.")
    measured: float = Field(description="Largest error found, as a test of ours measures it.")
    at: dict[str, float] = Field(description="eta and kappa of the largest error.")
    measured_over: DomainOut
    holds: bool | None = Field(description="Whether the claim holds; null if there is none.")


class FitOut(BaseModel):
    """A closed approximation of the albedo."""

    id: str
    title: str
    quantity: Literal["unpolarized", "s", "p"]
    domains: list[DomainOut]
    latex: str
    reference: str
    note: str
    claims: list[FitClaimOut]


class FitsOut(BaseModel):
    """All fits."""

    fits: list[FitOut]


class ExactOut(BaseModel):
    """Exact hemispherical albedo."""

    unpolarized: float
    s: float
    p: float
    method: str


class ApproximationOut(BaseModel):
    """A fit's value for one interface."""

    id: str
    title: str
    quantity: Literal["unpolarized", "s", "p"]
    value: float | None = Field(description="Null where the formula is undefined.")
    error: float | None = Field(description="value - exact, of the same polarization.")
    in_domain: bool
    reason: str | None
    reference: str


class ModelAlbedoOut(BaseModel):
    """The albedo of a model's curve; three numbers where its parameters are R, G and B."""

    model: str
    value: float | list[float] | None = Field(description="Null where the model is undefined.")
    error: float | list[float] | None
    in_domain: bool
    reason: str | None


class ReverseOut(BaseModel):
    """The same surface met from the second medium."""

    exact: ExactOut
    approximations: list[ApproximationOut]


class AlbedoOut(BaseModel):
    """Albedo of one interface, exact and by every fit."""

    interface: InterfaceOut
    convention: str
    exact: ExactOut
    flatland: float | None = Field(description="Unpolarized, in two dimensions.")
    approximations: list[ApproximationOut]
    models: list[ModelAlbedoOut]
    reverse: ReverseOut | None = Field(
        description="Albedo from the second medium: the internal diffuse reflectance where "
        "n_t > n_i. Null if that medium absorbs."
    )


class SweepCurveOut(BaseModel):
    """One albedo along a sweep."""

    kind: Literal["exact", "fit", "model"]
    id: str
    quantity: str
    values: list[float | None]
    error: list[float | None] | None = Field(description="values - exact; null for the exact ones.")
    in_domain: tuple[float, float] | None = Field(
        description="Part of the sweep within the fit's domain, null if none; of models null."
    )


class SweepOut(BaseModel):
    """Albedos along a sweep."""

    convention: str
    n_i: float
    incident: ResolvedPresetOut | None = Field(description="The preset that n_i comes from.")
    n_t: float | None = Field(description="Null where it is swept.")
    k_t: float | None = Field(description="Null where it is swept.")
    over: Literal["n_t", "k_t", "eta"]
    values: list[float]
    curves: list[SweepCurveOut]


class LargestOut(BaseModel):
    """Where a map's modulus is largest."""

    value: float
    n_t: float
    k_t: float


class BoxOut(BaseModel):
    """A domain in a map's own coordinates."""

    n_t: tuple[float, float]
    k_t: tuple[float, float]


class AlbedoMapOut(BaseModel):
    """A grid of albedos or of a fit's errors over n_t and k_t."""

    convention: str
    n_i: float
    n_t: list[float]
    k_t: list[float]
    fit: str | None
    quantity: Literal["unpolarized", "s", "p"]
    show: Literal["exact", "value", "error"]
    values: list[list[float | None]] = Field(description="A row for each k_t.")
    largest: LargestOut | None = Field(description="Over the whole map.")
    largest_in_domain: LargestOut | None = Field(description="Within the fit's domains.")
    domains: list[BoxOut] = Field(description="The fit's domains, to be outlined.")


class CoatOut(BaseModel):
    """Where the light goes that falls on a diffuse body under a clear coat."""

    interface: InterfaceOut
    convention: str
    body_albedo: float
    theta_i_deg: float | None = Field(description="Null for diffuse light.")
    external: float = Field(description="Albedo of the coat's surface from outside.")
    internal: float = Field(description="Albedo of the coat's surface from the body's side.")
    surface: float = Field(description="Reflected by the surface.")
    body: float = Field(description="Scattered by the body and let out again.")
    absorbed: float = Field(description="Lost in the body.")
