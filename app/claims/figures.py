"""Figures that many claims are judged by."""

from app.claims.claim import Figure
from app.claims.readings import value


def error_of(
    name: str,
    says: str,
    interface: str,
    model: str,
    metric: str = "max_abs",
    *,
    given: str = "",
    unit: str = "",
) -> Figure:
    """A figure of a model's error at an interface.

    Parameters
    ----------
    name, says, unit
        As of every figure.
    interface
        The interface as a query, `n_t=1.5&k_t=2`.
    model, metric
        What is measured.
    given
        More of the query: the model's own parameters.
    """
    request = f"/errors?{interface}&models={model}" + (f"&{given}" if given else "")
    return Figure(name, says, request, value(f"errors[model={model}].{metric}"), unit)
