"""What a knob is: its numbers with their ranges, and what they say of an interface."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from app.optics.parameters import Parameter

Status = Literal["exact", "dielectric only", "lossy", "infeasible"]
"""See `app.optics.conversions`."""

KnobId = Literal[
    "blender", "gltf", "openpbr", "three", "reflectance", "specular", "unreal", "godot"
]
"""The form of `/convert` that takes a knob's numbers."""

Typed = float | tuple[float, ...] | None


@dataclass(frozen=True, slots=True)
class Input:
    """One number of a knob, or a color."""

    label: str
    """As the engine spells it."""
    parameter: Parameter
    """Its name in queries, and the bounds that are taken there."""
    default: float
    """The engine's."""
    usual: tuple[float, float | None]
    """Where the engine means it to be; None for no end."""
    clamps: str
    """What becomes of numbers outside, without a full stop."""


@dataclass(frozen=True, slots=True)
class Setting:
    """What to type for an interface."""

    values: Mapping[str, Typed]
    """By the names of the inputs' parameters; None where there is none."""
    status: Status
    """Whether what was given comes back."""
    why: str


@dataclass(frozen=True, slots=True)
class Seen:
    """What is known of one channel, by its relative index or by its F0 alone."""

    F0: float
    eta: float
    """Relative index; that of the denser dielectric of the F0 where that is all that is known."""
    is_index: bool
    """Whether eta is known, and not made of F0."""
    absorbs: bool
    is_dielectric: bool
    """Whether it is told by a word for dielectrics alone."""
    lost: str = ""
    """What was given besides that no other knob has."""


@dataclass(frozen=True, slots=True)
class Read:
    """What a knob's numbers say of an interface."""

    F0: float
    eta: float | None = None
    """Relative index, where the engine's curve is that of one."""
    lost: str = ""
    """What they say besides that no other knob has."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Knob:
    """One engine's way to say how much a clear medium reflects."""

    id: KnobId
    title: str
    inputs: tuple[Input, ...]
    latex: str
    """F0 by the inputs."""
    reference: str
    read: Callable[..., Read]
    """Of the inputs, a number each."""
    write: Callable[[Sequence[Seen]], Setting]
    """For one channel or three."""
    engines: tuple[str, ...] = ()
    """Ids of the engines in which settings of it were measured; empty where it was not run."""


def way_back(seen: Sequence[Seen]) -> tuple[Status, str]:
    """Say whether an index or F0 comes back from a number that is made of F0."""
    if any(one.absorbs for one in seen):
        return (
            "lossy",
            "right at normal incidence; a metal is typed as a color, and n and k are lost",
        )
    if told := next((one.lost for one in seen if one.lost), ""):
        return "lossy", told
    if any(one.is_index and one.eta < 1.0 for one in seen):
        return "lossy", "right at normal incidence, but it stands for the denser medium of that F0"
    if any(not one.is_index and not one.is_dielectric for one in seen):
        return "dielectric only", "if the second medium does not absorb and is the denser one"
    return "exact", "F0 comes back, and with it n of a clear medium that is the denser one"


def one_of(values: Sequence[float]) -> float | None:
    """Return the number that all channels share, but for rounding, or None."""
    first = float(values[0])
    return first if all(math.isclose(value, first, rel_tol=1e-12) for value in values) else None


def several(label: str, values: Sequence[float]) -> str:
    """Say that an engine has one number where three would be needed."""
    red, green, blue = (f"{value:.4g}" for value in values)
    return (
        f"{label} is one number for all channels; they would have to be {red}, {green} and {blue}"
    )
