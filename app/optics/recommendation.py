"""Which models stay within an error at an interface, cheapest first, and why the others do not."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass

import numpy as np

from app.optics.interface import Interface
from app.optics.metrics import DESCRIPTIONS, Metric, measure
from app.optics.registry import Cost, Model

BUDGET_METRICS: tuple[Metric, ...] = ("max_abs", "rms", "cosine_weighted_mean", "max_relative")

WEIGHTS = {"add": 1, "mul": 1, "div": 5, "sqrt": 4, "pow": 9, "trig": 8, "lookup": 16}
"""Issue slots of an operation on a GPU whose special functions run at a quarter of the rate.

A division is a reciprocal (4) and a multiplication, a power log2, a multiplication and exp2. A
lookup's weight stands for the filtered fetch of a texel, whose latency is another matter.
"""


def weighted(cost: Cost) -> int:
    """One number to sort by: the operations, each with its weight."""
    return sum(WEIGHTS[name] * count for name, count in asdict(cost).items())


@dataclass(frozen=True, slots=True)
class Candidate:
    """A model with its figures at an interface.

    Attributes
    ----------
    model
        The model, with its parameters solved from the interface.
    cost
        Its weighted cost.
    figures
        What was measured; None if the interface is outside its domain or R is undefined there.
    reason
        Why it is refused, or None.
    """

    model: Model
    cost: int
    figures: dict[Metric, float] | None
    reason: str | None


def recommend(
    models: Iterable[Model], interface: Interface, max_error: float, metric: Metric = "max_abs"
) -> tuple[list[Candidate], list[Candidate]]:
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
        One of `BUDGET_METRICS`.

    Returns
    -------
    list, list
        Accepted, cheapest first and the more accurate first among equals; refused, those of the
        smallest excess first and those outside their domain last.
    """
    candidates = [_judge(model, interface, max_error, metric) for model in models]

    def size(candidate: Candidate) -> tuple[float, str]:
        """Rounded, so that equal models stand in the order of their ids."""
        value = abs(candidate.figures[metric]) if candidate.figures else np.inf
        return round(value, 12), candidate.model.id

    accepted = [candidate for candidate in candidates if candidate.reason is None]
    refused = [candidate for candidate in candidates if candidate.reason is not None]
    return sorted(accepted, key=lambda c: (c.cost, *size(c))), sorted(refused, key=size)


def _judge(model: Model, interface: Interface, max_error: float, metric: Metric) -> Candidate:
    cost, outside = weighted(model.cost), model.reason_outside(interface)
    if outside is not None:
        return Candidate(model, cost, None, outside)
    measured = measure(model, interface)
    figures = {name: float(values) for name, values in measured.items()}
    if np.isnan(figures[metric]):
        return Candidate(model, cost, None, "undefined over part of the hemisphere here")
    if abs(figures[metric]) <= max_error:
        return Candidate(model, cost, figures, None)
    name = DESCRIPTIONS[metric].partition(":")[0].rstrip(".")
    at = {"max_abs": "max_abs_at_deg", "max_relative": "max_relative_at_deg"}.get(metric)
    where = f" at {figures[at]:.1f} degrees" if at else ""  # type: ignore[index]
    excess = f"{name} {figures[metric]:.3g}{where}, more than {max_error:g}"
    return Candidate(model, cost, figures, excess)
