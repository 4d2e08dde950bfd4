"""An interface in every other form, of one channel or of three."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import takewhile
from typing import Any, NotRequired

from typing_extensions import TypedDict

from app.answers.answer import Table, answer
from app.answers.interface import CONVENTION, ResolvedPreset
from app.answers.materials.rgb_nk import RgbNk
from app.materials.media import Resolved
from app.optics.conversions import Conversion, Form, Status, convert, know

CHANNELS = ("red", "green", "blue")

_SEVERITY: tuple[Status, ...] = ("exact", "dielectric only", "lossy", "infeasible")


@answer
class ConvertedChannel:
    """Status of one channel."""

    status: Status
    why: str


@answer
class Converted:
    """One form of what was given."""

    form: str
    title: str
    values: dict[str, float | str | list[float | None] | None]
    """Numbers by name, lists of three where three were given; null where there is none."""
    status: Status
    """The worst of the channels."""
    why: str
    channels: list[ConvertedChannel] | None
    """Of red, green and blue, if three."""

    @classmethod
    def of(cls, conversions: Sequence[Conversion]) -> Converted:
        """Merge the same form's conversions of one or three channels."""
        first, single = conversions[0], len(conversions) == 1
        values: dict[str, Any] = {
            name: first.values[name] if single else [c.values[name] for c in conversions]
            for name in first.values
        }
        if "hex" in values and not single:
            values["hex"] = "#" + "".join(str(c.values["hex"])[1:3] for c in conversions)
        worst = max(conversions, key=lambda c: _SEVERITY.index(c.status))
        return cls(
            form=first.form,
            title=first.title,
            values=values,
            status=worst.status,
            why=first.why if single else _of_channels([c.why for c in conversions]),
            channels=None
            if single
            else [ConvertedChannel(status=c.status, why=c.why) for c in conversions],
        )


def _of_channels(whys: Sequence[str]) -> str:
    """Say first, and once, what the clauses of all channels begin with."""
    clauses = [why.split("; ") for why in whys]
    alike = takewhile(lambda same: len(set(same)) == 1, zip(*clauses, strict=False))
    shared = [clause for clause, *_ in alike]
    own = ("; ".join(one[len(shared) :]) for one in clauses)
    return "; ".join(
        [*shared, *(f"{name}: {rest}" for name, rest in zip(CHANNELS, own, strict=True) if rest)]
    )


Conversions = TypedDict(  # a dataclass has no field named `from`
    "Conversions",
    {
        "from": Form,
        "given": dict[str, float | str | list[float]],
        "n_i": float,
        "seen_from": float,
        "convention": str,
        "material": ResolvedPreset | None,
        "results": list[Converted],
        "rgb_nk": NotRequired[RgbNk],
    },
)
"""Every form of what was given."""


def conversions(
    form: Form,
    given: Mapping[str, Sequence[float]],
    *,
    n_i: float = 1.0,
    seen_from: float,
    hex: str | None = None,  # noqa: A002
    material: Resolved | None = None,
) -> Conversions:
    """Write an interface in every form.

    Parameters
    ----------
    form
        The form that is given.
    given
        Its numbers by name, one each or three for red, green and blue.
    n_i, seen_from
        Index of the medium in front, and of another.
    hex, material
        What the numbers come from, as it was given.

    Raises
    ------
    NotAllowed, OutOfRange
        As `know` does.
    """
    known = [
        know(form, n_i, **dict(zip(given, channel, strict=True)))
        for channel in zip(*given.values(), strict=True)
    ]
    told: dict[str, float | str | list[float]] = {
        name: values[0] if len(values) == 1 else list(values) for name, values in given.items()
    }
    if hex is not None:
        told["hex"] = hex
    forms = zip(*(convert(one, seen_from) for one in known), strict=True)
    return {
        "from": form,
        "given": told,
        "n_i": n_i,
        "seen_from": seen_from,
        "convention": CONVENTION,
        "material": ResolvedPreset.of(material),
        "results": [Converted.of(same) for same in forms],
    }


def table(converted: Conversions) -> Table:
    """Lay out a row a number, with a column a channel where there are three."""
    triple = any(result.channels for result in converted["results"])
    header = ("form", "name", "value", *(CHANNELS if triple else ()), "status", "why")
    rows = [
        # A color's hexadecimal code is one for all three channels.
        vars(result)
        | {"name": name}
        | (dict(zip(CHANNELS, value, strict=True)) if isinstance(value, list) else {"value": value})
        for result in converted["results"]
        for name, value in result.values.items()
    ]
    return Table({h: [row.get(h) for row in rows] for h in header}, "fresnel_convert.csv")
