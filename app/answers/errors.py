"""How wrong models are at one interface."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from app.answers.answer import Gaps, Table, Values, answer
from app.answers.curves import COLORS, Chosen, of_channel, sampled_incidence
from app.answers.interface import CONVENTION, InterfaceFacts
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.metrics import DESCRIPTIONS as SAYS
from app.optics.metrics import METRICS, Metric, measure, point_error

MEASURE = (
    "error = R of the model - R of exact; rms over the solid angle of the hemisphere; "
    "cosine_weighted_mean = 2 * integral of error sin cos = albedo_error; the largest errors are "
    "sought between the samples"
)

FigureName = Literal[Metric, "albedo_error"]
FIGURES: tuple[FigureName, ...] = (*METRICS, "albedo_error")


def metric_of(name: FigureName) -> Metric:
    """Metric that a figure is: the error of the albedo is a mean."""
    return "cosine_weighted_mean" if name == "albedo_error" else name


@answer
class Figures:
    """Errors over the hemisphere; null where the model is undefined over part of it."""

    max_abs: Annotated[float | None, Field(description=SAYS["max_abs"])]
    max_abs_at_deg: Annotated[float | None, Field(description=SAYS["max_abs_at_deg"])]
    error_at_max: Annotated[float | None, Field(description=SAYS["error_at_max"])]
    rms: Annotated[float | None, Field(description=SAYS["rms"])]
    cosine_weighted_mean: Annotated[float | None, Field(description=SAYS["cosine_weighted_mean"])]
    max_relative: Annotated[
        float | None, Field(description=SAYS["max_relative"] + " Null where the exact R is 0.")
    ]
    max_relative_at_deg: Annotated[float | None, Field(description=SAYS["max_relative_at_deg"])]
    albedo_error: float | None
    """The same as cosine_weighted_mean: model albedo less exact albedo."""


@answer
class Measured:
    """Which model, at which values of its parameters."""

    model: str
    title: str
    quantity: str
    """R, or R_red, R_green, R_blue of a triple."""
    in_domain: bool
    reason: str | None
    """Why the interface is outside the model's domain."""
    parameters: dict[str, float | None]
    """Values of the model's parameters, given or solved from the interface."""


@answer
class ModelError(Figures, Measured):
    """How wrong one model is at one interface."""

    error: Gaps
    """R - exact at theta_i_deg."""


@answer
class ModelErrors(ModelError):
    """How wrong one model is at one interface, relative to the exact R as well."""

    relative_error: Gaps
    """(R - exact)/exact at theta_i_deg, with relative=true."""


@answer
class Errors:
    """Models against exact, the one of smallest rms first."""

    interface: InterfaceFacts
    convention: str = CONVENTION
    reference: str = "exact"
    """The model that the errors are measured against."""
    measure: str = MEASURE
    """How the metrics are defined."""
    theta_i_deg: Values
    errors: list[ModelError | ModelErrors]

    def table(self) -> Table:
        """Lay out a row each model."""
        names = ("model", "quantity", "in_domain", "reason", *FIGURES)
        columns = {name: [getattr(row, name) for row in self.errors] for name in names}
        return Table(columns, "fresnel_errors.csv")

    def curves(self) -> Table:
        """Lay out the errors over the angle, a column each."""
        columns = {
            f"{row.model}.{row.quantity}.{name}": getattr(row, name)
            for row in self.errors
            for name in ("error", "relative_error")
            if hasattr(row, name)
        }
        return Table({"theta_i_deg": self.theta_i_deg} | columns, "fresnel_errors.csv")


def errors(
    interface: Interface,
    models: Iterable[Chosen],
    *,
    samples: int = 181,
    landmarks: bool = False,
    relative: bool = False,
) -> Errors:
    """Measure models at one interface.

    Parameters
    ----------
    interface
        The boundary, one of plain numbers.
    models
        What to measure; a color counts as three.
    samples, landmarks
        The angles of the curves, as `sampled_incidence` takes them.
    relative
        Whether to add the relative error over the angle.
    """
    incidence = sampled_incidence(interface, samples, landmarks)
    rows = [
        row for chosen in models for row in _model_errors(chosen, interface, incidence, relative)
    ]
    rows.sort(key=lambda row: (math.inf, "") if row.rms is None else (row.rms, row.model))
    return Errors(
        interface=InterfaceFacts.of(interface),
        theta_i_deg=incidence.theta_i_deg,
        errors=rows,
    )


def _model_errors(
    chosen: Chosen, interface: Interface, incidence: Incidence, relative: bool
) -> Iterator[ModelError]:
    """Describe the errors of a model, once or, of a color, three times."""
    model, arguments = chosen.model, chosen.arguments(interface)
    reason = model.reason_outside(interface)
    metrics = measure(model, interface, arguments)
    curves = {"error": point_error(model, interface, incidence, arguments)}
    if relative:
        curves["relative_error"] = point_error(model, interface, incidence, arguments, "relative")
    kind = ModelErrors if relative else ModelError
    for channel, quantity in enumerate(COLORS if metrics["rms"].ndim > 0 else ("R",)):
        measured: dict[str, Any] = {
            **figures({n: of_channel(values, channel) for n, values in metrics.items()}),
            **{
                name: np.ascontiguousarray(np.atleast_2d(curve)[channel])
                for name, curve in curves.items()
            },
        }
        yield kind(
            model=model.id,
            title=model.title,
            quantity=quantity,
            in_domain=reason is None,
            reason=reason,
            parameters={n: of_channel(value, channel) for n, value in arguments.items()},
            **measured,
        )


def figures(metrics: Mapping[Metric, Any]) -> dict[str, Any]:
    """Metrics under their names, the albedo's error under both of its names."""
    named: dict[str, Any] = {name: metrics[name] for name in metrics}
    return named | {"albedo_error": metrics["cosine_weighted_mean"]}
