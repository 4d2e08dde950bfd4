"""What snippets are asked for, and what the models answer: the cases of all languages."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.optics.angles import critical_deg
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.registry import Model, default_registry
from app.snippets.snippet import ETA_ENDS, arguments_of, reason_without

Array = NDArray[np.float64]

MODELS = [model for model in default_registry().values() if reason_without(model) is None]

DIELECTRICS = [(1.0, 1.333), (1.0, 1.5), (1.0, 2.417), (1.333, 1.0), (1.5, 1.0)]
CONDUCTORS = [(1.0, 0.27, 2.9), (1.0, 2.9, 3.0), (1.0, 1.5, 5.0), (1.333, 0.2, 3.4)]
INTERFACES = [(n_i, n_t, 0.0) for n_i, n_t in DIELECTRICS] + CONDUCTORS

CRITICAL_GUARD_DEG = 0.5
"""Where the slope is infinite a 32 bit cosine does not tell on which side it lies."""


@dataclass(frozen=True, slots=True, eq=False)
class Case:
    """Arguments of a snippet, of shape (arguments, angles), and R in 64 bits."""

    interface: tuple[float, float, float]
    arguments: Array
    R: Array


def cases(model: Model, *, exactly: bool = False) -> Iterator[Case]:
    """Yield an interface after the other of those that the model is made for.

    Angles and media are 32 bit floats; so is what is worked out from them, unless `exactly`.
    """
    built = {numbers: Interface(*np.array(numbers, np.float32)) for numbers in INTERFACES}
    inside = [n for n, interface in built.items() if model.reason_outside(interface) is None]
    # A trap has no domain, and is what it is all the same.
    for numbers in inside or [n for n, i in built.items() if i.kind in model.applies_to]:
        interface = built[numbers]
        mu = np.linspace(0.0, 1.0, 481, dtype=np.float32).astype(np.float64)
        critical = critical_deg(interface)
        near = np.abs(np.degrees(np.arccos(mu)) - critical) < CRITICAL_GUARD_DEG
        incidence = Incidence.from_cosine(mu[~near])
        own = model.arguments(interface)
        R = np.asarray(model.evaluate(interface, incidence, own))
        defined = np.isfinite(R)
        quantities = {"mu": incidence.cos[defined]} | own
        given = [
            quantities[a.name] if a.name in quantities else getattr(interface, a.name)
            for a in arguments_of(model)
        ]
        columns = np.array(np.broadcast_arrays(*given))
        if not exactly:
            columns = columns.astype(np.float32).astype(np.float64)
        yield Case(numbers, columns, R[defined])


BEYOND = 1.2e-7
"""One step of 32 bit floats at 1: a dot product of unit vectors may be that much more."""


def at_the_ends(model: Model) -> Array:
    """Every combination of an argument's ends, what lies just beyond them and what lies inside.

    Of shape (arguments, combinations). The cosine changes slowest: just below 0, 0, inside, 1, just
    above. Media are combined as far as their ratio lies within what the code says.
    """
    axes, names = [], [argument.name for argument in arguments_of(model)]
    for a in arguments_of(model):
        least, most = a.minimum, a.maximum
        below = least * (1.0 - BEYOND) if least else -BEYOND
        inside = 0.4 if most <= 2.0 else 1.5
        axes.append(np.array([below, least, inside, most, most * (1.0 + BEYOND)]))
    columns = np.array([column.ravel() for column in np.meshgrid(*axes, indexing="ij")])
    if {"n_i", "n_t"} <= set(names):
        ratio = columns[names.index("n_t")] / columns[names.index("n_i")]
        columns = columns[:, (ratio > 0.99 * ETA_ENDS[0]) & (ratio < 1.01 * ETA_ENDS[1])]
    return columns.astype(np.float32).astype(np.float64)


def check_at_the_ends(model: Model, R: Array, slack: float) -> None:
    """Nothing is undefined, a cosine beyond an end is that end, and R stays in 0 to 1."""
    assert np.isfinite(R).all()
    below, least, _, most, above = R.reshape(5, -1)
    assert np.array_equal(below, least)
    assert np.array_equal(most, above)
    assert model.leaves_0_to_1 or (R.min() > -slack and R.max() < 1.0 + slack)
