"""Which models stay within an error at an interface, cheapest first, and why the others do not."""

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

import numpy as np

from app.answers.answer import Table, answer, filled, number_or_none
from app.answers.errors import FIGURES, MEASURE, FigureName, Figures, figures, metric_of
from app.answers.interface import CONVENTION, InterfaceFacts
from app.optics.interface import Interface
from app.optics.metrics import DESCRIPTIONS, measure
from app.optics.registry import Cost, Model, ModelKind

WEIGHTS = {"add": 1, "mul": 1, "div": 5, "sqrt": 4, "pow": 9, "trig": 8, "lookup": 16}
"""Issue slots of an operation on a GPU whose special functions run at a quarter of the rate.

A division is a reciprocal (4) and a multiplication, a power log2, a multiplication and exp2. A
lookup's weight stands for the filtered fetch of a texel, whose latency is another matter.
"""


def weighted(cost: Cost) -> int:
    """One number to sort by: the operations, each with its weight."""
    return sum(WEIGHTS[name] * count for name, count in asdict(cost).items())


@answer
class Candidate:
    """A model with its figures."""

    model: str
    title: str
    kind: ModelKind
    cost: dict[str, int]
    """Operations of one evaluation."""
    weighted_cost: int
    """What the order is by."""
    parameters: dict[str, float | None]
    figures: Figures | None
    """Null outside the model's domain."""
    reason: str | None
    """Why it is refused; null where it is not."""


@answer
class Recommendation:
    """Models within an error, cheapest first, and all others with the reason."""

    interface: InterfaceFacts
    convention: str = CONVENTION
    measure: str = MEASURE
    metric: str
    max_error: float
    weights: dict[str, int]
    """Weight of each operation in weighted_cost."""
    models: list[Candidate]
    refused: list[Candidate]

    def table(self) -> Table:
        """Lay out a row each model."""
        rows = [*self.models, *self.refused]
        columns: dict[str, list[Any]] = {
            "model": [row.model for row in rows],
            "accepted": [row.reason is None for row in rows],
            "weighted_cost": [row.weighted_cost for row in rows],
            **{name: [getattr(row.figures, name, None) for row in rows] for name in FIGURES},
            "reason": [row.reason for row in rows],
        }
        return Table(columns, "fresnel_models.csv")


def recommendation(
    models: Iterable[Model],
    interface: Interface,
    max_error: float,
    metric: FigureName = "max_abs",
) -> Recommendation:
    """Sort models into those that do and those that do not.

    Parameters
    ----------
    models
        The candidates.
    interface
        One boundary.
    max_error
        The largest modulus of the metric that is acceptable.
    metric
        An error; not an angle.

    Returns
    -------
    Recommendation
        Accepted, cheapest first and the more accurate first among equals; refused, those of the
        smallest excess first and those outside their domain last.
    """
    candidates = [_judged(model, interface, max_error, metric) for model in models]

    def size(candidate: Candidate) -> tuple[float, str]:
        """Rounded, so that equal models stand in the order of their ids."""
        value = abs(getattr(candidate.figures, metric, np.inf))
        return round(value, 12), candidate.model

    accepted = [candidate for candidate in candidates if candidate.reason is None]
    refused = [candidate for candidate in candidates if candidate.reason is not None]
    return Recommendation(
        interface=InterfaceFacts.of(interface),
        metric=metric,
        max_error=max_error,
        weights=WEIGHTS,
        models=sorted(accepted, key=lambda c: (c.weighted_cost, *size(c))),
        refused=sorted(refused, key=size),
    )


def _judged(model: Model, interface: Interface, max_error: float, metric: FigureName) -> Candidate:
    reason, found = model.reason_outside(interface), None
    if reason is None:
        measured = measure(model, interface).items()
        found = Figures(**figures({name: number_or_none(value) for name, value in measured}))
        value = getattr(found, metric)
        if value is None:
            reason, found = "undefined over part of the hemisphere here", None
        elif abs(value) > max_error:
            at = getattr(found, f"{metric}_at_deg", None)
            where = "" if at is None else f" at {at:.1f} degrees"
            name = DESCRIPTIONS[metric_of(metric)].partition(":")[0].rstrip(".")
            reason = f"{name} {value:.3g}{where}, more than {max_error:g}"
    return filled(
        Candidate,
        model,
        model=model.id,
        cost=asdict(model.cost),
        weighted_cost=weighted(model.cost),
        parameters={n: number_or_none(v) for n, v in model.arguments(interface).items()},
        figures=found,
        reason=reason,
    )
