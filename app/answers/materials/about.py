"""What an answer is about: the material, the medium in front of it, and how much may be asked."""

from __future__ import annotations

from dataclasses import fields
from typing import Annotated

from app.answers.answer import SentAs, answer
from app.answers.axes import MOST_CELLS
from app.materials.errors import WavelengthOutOfRange
from app.materials.front import Front
from app.materials.media import default_catalog
from app.materials.schema import (
    Axis,
    Category,
    Channels,
    Confidence,
    Preset,
    RelativeTo,
    Sample,
    WavelengthIn,
)
from app.optics.errors import NotAllowed
from app.optics.parameters import Array

Rgb = Annotated[Array, SentAs(Channels)]
"""Linear sRGB."""


@answer
class About:
    """The material an answer is about, and where its data come from."""

    id: str
    name: str
    category: Category
    axis: Axis
    relative_to: RelativeTo
    wavelength_in: WavelengthIn
    sample: Sample
    confidence: Confidence
    source: str
    doi: tuple[str, ...]
    licence: str

    @classmethod
    def of(cls, preset: Preset) -> About:
        """Describe a preset in a few lines."""
        return cls(**{field.name: getattr(preset, field.name) for field in fields(cls)})


@answer
class FrontMedium:
    """The medium in front."""

    n_i: float | None
    """Null where a preset's index varies."""
    incident: About | None

    @classmethod
    def of(cls, front: Front) -> FrontMedium:
        """Describe a medium in front."""
        return cls(
            n_i=front.n_i if front.spectrum is None else None,
            incident=None if front.preset is None else About.of(front.preset),
        )


def range_within(
    asked: tuple[float | None, float | None],
    known: tuple[float, float],
    default: tuple[float, float],
    material: str,
) -> tuple[float, float]:
    """Return the range of wavelengths asked for.

    Parameters
    ----------
    asked
        minimum_nm and maximum_nm, None for those of `default`.
    known
        What is known of `material`.

    Raises
    ------
    WavelengthOutOfRange
        If an end is outside what is known.
    NotAllowed
        If they are in the wrong order.
    """
    catalog = default_catalog()
    low, high = (d if end is None else end for end, d in zip(asked, default, strict=True))
    for name, value in (("minimum_nm", low), ("maximum_nm", high)):
        if not known[0] <= value <= known[1]:
            elsewhere = catalog.rivals_at(material, value) if catalog.find(material) else ()
            error = WavelengthOutOfRange(material, "n", value, *known, elsewhere)
            error.parameter = name
            raise error
    if low > high:
        raise NotAllowed("minimum_nm", low, f"at most maximum_nm = {high:.10g}")
    return low, high


def refuse_more_than(
    parameter: str, value: object, count: int, what: str, most: int = MOST_CELLS
) -> None:
    """Refuse an answer of too many values.

    Raises
    ------
    NotAllowed
        Naming the parameter that makes it so large.
    """
    if count > most:
        raise NotAllowed(parameter, value, f"at most {most} {what} in an answer")
