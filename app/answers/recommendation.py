"""Which models are good enough at an interface, cheapest first."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from app.answers.answer import Table, answer, number_or_none
from app.answers.errors import FIGURES, MEASURE, FigureName, Figures, figures, metric_of
from app.answers.interface import CONVENTION, InterfaceFacts
from app.optics.interface import Interface
from app.optics.recommendation import WEIGHTS, recommend
from app.optics.recommendation import Candidate as Judged
from app.optics.registry import Model, ModelKind


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

    @classmethod
    def of(cls, judged: Judged, interface: Interface) -> Candidate:
        """Describe what was found of a model."""
        model, found = judged.model, judged.figures
        return cls(
            model=model.id,
            title=model.title,
            kind=model.kind,
            cost=asdict(model.cost),
            weighted_cost=judged.cost,
            parameters={n: number_or_none(v) for n, v in model.arguments(interface).items()},
            figures=None if found is None else Figures(**figures(found)),
            reason=judged.reason,
        )


@answer
class Recommendation:
    """Models within an error, cheapest first, and all others with the reason."""

    interface: InterfaceFacts
    convention: str
    measure: str
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
    models: Iterable[Model], interface: Interface, max_error: float, metric: FigureName
) -> Recommendation:
    """Sort models into those that stay within an error and those that do not."""
    accepted, refused = (
        [Candidate.of(judged, interface) for judged in some]
        for some in recommend(models, interface, max_error, metric_of(metric))
    )
    return Recommendation(
        interface=InterfaceFacts.of(interface),
        convention=CONVENTION,
        measure=MEASURE,
        metric=metric,
        max_error=max_error,
        weights=WEIGHTS,
        models=accepted,
        refused=refused,
    )
