"""Shapes of the answers about errors, for OpenAPI."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel, Field

from app.api.schemas import InterfaceOut
from app.optics.metrics import DESCRIPTIONS as SAYS
from app.optics.metrics import Metric

MEASURE = (
    "error = R of the model - R of exact; rms over the solid angle of the hemisphere; "
    "cosine_weighted_mean = 2 * integral of error sin cos = albedo_error; the largest errors are "
    "sought between the samples"
)

_ALBEDO = "The same as cosine_weighted_mean: model albedo less exact albedo."


def figures_json(metrics: Mapping[Metric, Any]) -> dict[str, Any]:
    """Metrics under their names, the albedo's error under both of its names."""
    figures: dict[str, Any] = {name: metrics[name] for name in metrics}
    return figures | {"albedo_error": metrics["cosine_weighted_mean"]}


class FiguresOut(BaseModel):
    """Errors over the hemisphere; null where the model is undefined over part of it."""

    max_abs: float | None = Field(description=SAYS["max_abs"])
    max_abs_at_deg: float | None = Field(description=SAYS["max_abs_at_deg"])
    error_at_max: float | None = Field(description=SAYS["error_at_max"])
    rms: float | None = Field(description=SAYS["rms"])
    cosine_weighted_mean: float | None = Field(description=SAYS["cosine_weighted_mean"])
    albedo_error: float | None = Field(description=_ALBEDO)
    max_relative: float | None = Field(
        description=SAYS["max_relative"] + " Null where the exact R is 0."
    )
    max_relative_at_deg: float | None = Field(description=SAYS["max_relative_at_deg"])


class ModelErrorOut(FiguresOut):
    """How wrong one model is at one interface."""

    model: str
    title: str
    quantity: str = Field(description="R, or R_red, R_green, R_blue of a triple.")
    in_domain: bool
    reason: str | None = Field(description="Why the interface is outside the model's domain.")
    parameters: dict[str, float | None] = Field(
        description="Values of the model's parameters, given or solved from the interface."
    )
    error: list[float | None] = Field(description="R - exact at theta_i_deg.")
    relative_error: list[float | None] | None = Field(
        None, description="(R - exact)/exact at theta_i_deg, with relative=true."
    )


class ErrorsOut(BaseModel):
    """Models against exact, the one of smallest rms first."""

    interface: InterfaceOut
    convention: str
    reference: str = Field(description="The model that the errors are measured against.")
    measure: str = Field(description="How the metrics are defined.")
    theta_i_deg: list[float]
    errors: list[ModelErrorOut]


class ErrorSweepOut(BaseModel):
    """Errors of one model along a line of interfaces; every list has the length of `values`."""

    model: str
    convention: str
    measure: str
    n_i: float
    n_t: float | None = Field(description="Null if it is swept.")
    k_t: float | None = Field(description="Null if it is swept.")
    over: str
    values: list[float]
    in_domain: list[bool]
    max_abs: list[float | None]
    max_abs_at_deg: list[float | None]
    error_at_max: list[float | None]
    rms: list[float | None]
    cosine_weighted_mean: list[float | None]
    albedo_error: list[float | None]
    max_relative: list[float | None]
    max_relative_at_deg: list[float | None]


class AxisOut(BaseModel):
    """One axis of a map."""

    name: str
    values: list[float]


class ErrorMapOut(BaseModel):
    """Errors of one model over a rectangle."""

    model: str
    convention: str
    measure: str
    n_i: float | None = Field(description="Null if it is an axis.")
    n_t: float | None = Field(description="Null if it or eta is an axis.")
    k_t: float | None = Field(description="Null if it is an axis.")
    metric: str
    x: AxisOut
    y: AxisOut
    values: list[list[float | None]] = Field(description="A row for every y, a column for every x.")


class CandidateOut(BaseModel):
    """A model with its figures."""

    model: str
    title: str
    kind: str
    cost: dict[str, int] = Field(description="Operations of one evaluation.")
    weighted_cost: int = Field(description="What the order is by.")
    parameters: dict[str, float | None]
    figures: FiguresOut | None = Field(description="Null outside the model's domain.")
    reason: str | None = Field(description="Why it is refused; null where it is not.")


class RecommendationOut(BaseModel):
    """Models within an error, cheapest first, and all others with the reason."""

    interface: InterfaceOut
    convention: str
    measure: str
    metric: str
    max_error: float
    weights: dict[str, int] = Field(description="Weight of each operation in weighted_cost.")
    models: list[CandidateOut]
    refused: list[CandidateOut]
