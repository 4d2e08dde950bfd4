"""Shapes of the answers, for OpenAPI; the answers themselves are written as ready bytes."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, Field


class ResolvedPresetOut(BaseModel):
    """A preset that stands in place of numbers, and where those come from."""

    id: str
    name: str
    wavelength_nm: float | None = Field(
        description="Where it was evaluated, in nm; null where the source names no wavelength."
    )
    n: float
    k: float | None = Field(description="Null where the source does not give it.")
    sample: str = Field(description="bulk, film, model, calculated or unstated")
    confidence: Literal["high", "medium", "low"]
    source: str = Field(description="The reference.")
    doi: list[str]
    warnings: list[str]


class InterfaceOut(BaseModel):
    """The interface an answer was computed for, with everything derived from it."""

    n_i: float
    n_t: float
    k_t: float
    eta: float = Field(description="n_t / n_i")
    kappa: float = Field(description="k_t / n_i")
    kind: Literal["dielectric", "conductor"]
    F0: float = Field(description="Reflectance at normal incidence.")
    F82: float = Field(description="Exact reflectance at cos(theta_i) = 1/7.")
    brewster_deg: float | None = Field(description="Angle where Rp = 0; null in absorbers.")
    critical_deg: float | None = Field(description="Angle of total reflection; null if none.")
    pseudo_brewster_deg: float = Field(description="Angle of least Rp.")
    principal_deg: float = Field(
        description="Smallest angle where the phases of r_p and r_s are 90 degrees apart; "
        "Brewster's angle without absorption."
    )
    incident: ResolvedPresetOut | None = Field(
        description="The preset that n_i comes from; null if it was given as a number."
    )
    material: ResolvedPresetOut | None = Field(
        description="The preset that n_t and k_t come from; null if they were given as numbers."
    )


class ComplexOut(BaseModel):
    """A complex amplitude."""

    re: float
    im: float
    abs: float
    phase_deg: float = Field(
        description="Argument in degrees, -180 to 180; at 90 degrees the limit from smaller angles."
    )


class SnellOut(BaseModel):
    """One ray at the surface y = 0 with normal +y, coming from the upper left."""

    interface: InterfaceOut
    convention: str
    theta_i_deg: float
    theta_t_deg: float | None = Field(description="Null at total internal reflection.")
    total_internal_reflection: bool
    reflected: list[float] = Field(description="Unit vector [x, y].")
    refracted: list[float] | None = Field(description="Unit vector [x, y], or null.")
    r_s: ComplexOut
    r_p: ComplexOut
    t_s: ComplexOut
    t_p: ComplexOut
    Rs: float
    Rp: float
    R: float
    Ts: float
    Tp: float
    T: float
    penetration_depth_wavelengths: float | None = Field(
        description="Depth of 1/e of the power in vacuum wavelengths; null if undamped."
    )


class CurveOut(BaseModel):
    """One quantity of one model over the angles."""

    model: str
    quantity: str
    values: list[float | None] = Field(description="Null where the model is undefined.")
    in_domain: bool
    reason: str | None = Field(description="Why the interface is outside the model's domain.")


class CurvesOut(BaseModel):
    """Curves over the angle of incidence."""

    interface: InterfaceOut
    convention: str
    theta_i_deg: list[float]
    curves: list[CurveOut]


class ParameterOut(BaseModel):
    """A declared parameter with its bounds."""

    name: str
    symbol: str = Field(description="LaTeX")
    default: float | None = Field(description="Null where it is solved from the interface.")
    minimum: float
    maximum: float
    unit: str
    description: str
    integer: bool = Field(description="Whether only whole numbers make sense.")
    choices: list[tuple[str, float]] = Field(description="The only values, where not all are.")
    triple: bool = Field(description="Whether three values, for R, G and B, give three curves.")


class MeasuredOut(BaseModel):
    """The error of a model at one interface, which a test measures again."""

    n_i: float
    n_t: float
    k_t: float
    max_abs: float = Field(description="Largest |R - exact| over the hemisphere.")
    at_deg: float = Field(description="Angle where it is reached.")
    rms: float = Field(description="Root mean square over the solid angle.")


class ModelOut(BaseModel):
    """A registered model."""

    id: str
    title: str
    kind: Literal["exact", "approximation"]
    trap: bool = Field(description="Whether the model is kept to show a mistake.")
    applies_to: list[Literal["dielectric", "conductor"]]
    parameters: list[ParameterOut]
    latex: str
    reference: str
    validity: str
    cost: dict[str, int] = Field(description="Operations of one evaluation.")
    measured: list[MeasuredOut] = Field(description="Errors at representative interfaces.")
    shaders: str | None = Field(
        description="Where it is as code for shaders; null where it has no closed form."
    )


def or_chosen_fields(array: dict[str, Any]) -> None:
    """Say in a schema that the objects in an array have the fields alone that `fields` names."""
    chosen = {"type": "object", "description": "The fields named in `fields`, where it is given."}
    array["items"] = {"anyOf": [array["items"], chosen]}


class ModelsOut(BaseModel):
    """All registered models."""

    models: list[ModelOut] = Field(json_schema_extra=or_chosen_fields)


class ParametersOut(BaseModel):
    """The parameters common to all endpoints."""

    parameters: list[ParameterOut]


class StatusOut(BaseModel):
    """That all is well; anything else is a problem."""

    status: Literal["ok"]


class HealthOut(BaseModel):
    """Whether the server works, and what it is made of."""

    status: Literal["ok"]
    version: str
    libraries: dict[str, str]
