"""What one writes first with FastAPI, tolist() and list[float], in two ways. The yardsticks.

`/curves` returns a pydantic model, which recent FastAPI writes by pydantic's compiled serializer;
`/curves/dict` returns the same as a dict, which FastAPI's default encoder walks number by number.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from fastapi import FastAPI
from numpy.typing import NDArray
from pydantic import BaseModel

app = FastAPI()


class Curve(BaseModel):
    """One curve."""

    model: str
    quantity: str
    values: list[float]


class Curves(BaseModel):
    """The answer."""

    n_i: float
    n_t: float
    k_t: float
    theta_i_deg: list[float]
    curves: list[Curve]


def textbook(
    n_i: float, n_t: float, k_t: float, samples: int
) -> tuple[NDArray[np.float64], dict[str, NDArray[np.float64]]]:
    """Angles, and six curves over them by the shortest formulas."""
    theta_i_deg = np.linspace(0.0, 90.0, samples)
    mu, sin2 = np.cos(np.radians(theta_i_deg)), np.sin(np.radians(theta_i_deg)) ** 2
    index = n_t + 1j * k_t
    q = np.sqrt(index**2 - n_i**2 * sin2)
    Rs = np.abs((n_i * mu - q) / (n_i * mu + q)) ** 2
    Rp = np.abs((index**2 * mu - n_i * q) / (index**2 * mu + n_i * q)) ** 2
    R = (Rs + Rp) / 2.0
    F0 = ((n_t - n_i) ** 2 + k_t**2) / ((n_t + n_i) ** 2 + k_t**2)
    schlick = F0 + (1.0 - F0) * (1.0 - mu) ** 5
    quantities = {"R": R, "Rs": Rs, "Rp": Rp, "T": 1.0 - R, "schlick": schlick, "again": R}
    return theta_i_deg, quantities


@app.get("/curves")
def curves(n_i: float = 1.0, n_t: float = 1.5, k_t: float = 0.0, samples: int = 181) -> Curves:
    """Answer with a model."""
    theta_i_deg, quantities = textbook(n_i, n_t, k_t, samples)
    return Curves(
        n_i=n_i,
        n_t=n_t,
        k_t=k_t,
        theta_i_deg=theta_i_deg.tolist(),
        curves=[
            Curve(model="exact", quantity=name, values=values.tolist())
            for name, values in quantities.items()
        ],
    )


@app.get("/curves/dict")
def curves_as_dict(n_i: float = 1.0, n_t: float = 1.5, k_t: float = 0.0, samples: int = 181) -> Any:
    """Answer the same as a dict."""
    answer = curves(n_i, n_t, k_t, samples)
    return {
        "n_i": n_i,
        "n_t": n_t,
        "k_t": k_t,
        "theta_i_deg": answer.theta_i_deg,
        "curves": [
            {"model": c.model, "quantity": c.quantity, "values": c.values} for c in answer.curves
        ],
    }
