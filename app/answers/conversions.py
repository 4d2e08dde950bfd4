"""An interface in every other form, of one channel or of three."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import takewhile
from typing import Any, NotRequired

import numpy as np
from typing_extensions import TypedDict

from app.answers.answer import Table, answer
from app.answers.interface import CONVENTION, ResolvedPreset
from app.answers.materials.rgb_nk import RgbNk
from app.engines.measured import engines
from app.materials.media import Resolved, default_catalog
from app.materials.schema import Preset
from app.optics.conversions import Conversion, Form, convert, know, settings
from app.optics.knobs.dispersion import (
    D_LINE_NM,
    DISPERSION_KNOBS,
    DispersionKnob,
)
from app.optics.knobs.knob import Input, Knob, Status, Typed

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


@answer
class KnobInput:
    """A number of a knob, and what to type there."""

    name: str
    """As queries spell it."""
    label: str
    """As the engine spells it."""
    value: float | list[float] | None
    """Null where there is none; red, green and blue of a color."""
    default: float
    """The engine's."""
    minimum: float
    """Where the engine means it to be."""
    maximum: float | None
    """Null for no end."""
    clamps: str
    """What becomes of numbers outside."""

    @classmethod
    def of(cls, given: Input, value: Typed) -> KnobInput:
        """Describe a number."""
        low, high = given.usual
        return cls(
            name=given.parameter.name,
            label=given.label,
            value=list(value) if isinstance(value, tuple) else value,
            default=given.default,
            minimum=low,
            maximum=high,
            clamps=given.clamps,
        )


@answer
class KnobSetting:
    """What to type into one knob of an engine."""

    knob: str
    """Its id; of the reflectance's, the form that `from` takes."""
    title: str
    inputs: list[KnobInput]
    status: Status
    """Whether the way back is exact."""
    why: str
    latex: str
    """What the numbers are to the engine."""
    reference: str
    measured: list[str]
    """Engines, each with its version, in which settings of this knob were measured; empty where none
    was run."""

    @classmethod
    def of(
        cls, knob: Knob | DispersionKnob, values: Mapping[str, Typed], status: Status, why: str
    ) -> KnobSetting:
        """Describe a setting."""
        run = knob.engines if isinstance(knob, Knob) else ()
        return cls(
            knob=knob.id,
            title=knob.title,
            inputs=[KnobInput.of(one, values[one.parameter.name]) for one in knob.inputs],
            status=status,
            why=why,
            latex=knob.latex,
            reference=knob.reference,
            measured=[f"{engines()[name].title} {engines()[name].version}" for name in run],
        )


@answer
class Dispersion:
    """How much the index changes with the wavelength, in the words of engines."""

    abbe: float | None
    """V_d = (n_d - 1) / (n_F - n_C); null where none is known."""
    material: str | None
    """The preset whose measured dispersion it is; null where the number was given."""
    why: str
    """Where the number comes from, or why there is none."""
    n_d: float | None
    """Of the preset, as its source has it, as is all of this; null where the number was given."""
    knobs: list[KnobSetting]


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
        "knobs": list[KnobSetting],
        "dispersion": NotRequired[Dispersion],
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
    abbe: float | None = None,
    dispersion_of: Preset | None = None,
) -> Conversions:
    """Write an interface in every form, and as the knobs of engines.

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
    abbe, dispersion_of
        An Abbe number, or the preset whose measured dispersion tells it; that of the material unless
        given.

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
    answered: Conversions = {
        "from": form,
        "given": told,
        "n_i": n_i,
        "seen_from": seen_from,
        "convention": CONVENTION,
        "material": ResolvedPreset.of(material),
        "results": [Converted.of(same) for same in forms],
        "knobs": [KnobSetting.of(k, s.values, s.status, s.why) for k, s in settings(known)],
    }
    if found := _dispersion(abbe, dispersion_of, material):
        answered["dispersion"] = found
    return answered


_MEASURED = "from the formula of n at the d, F and C lines"
_NONE = (
    "an Abbe number is told of clear materials whose n is a formula at the d, F and C lines; the "
    "difference of a table would be that of its last digits"
)
_VISIBLE_NM = np.arange(380.0, 781.0, 1.0)


def _dispersion(
    abbe: float | None, dispersion_of: Preset | None, material: Resolved | None
) -> Dispersion | None:
    if abbe is not None:
        knobs = [
            KnobSetting.of(knob, knob.write(abbe), "exact", "V_d comes back")
            for knob in DISPERSION_KNOBS
        ]
        return Dispersion(abbe=abbe, material=None, why="as given", n_d=None, knobs=knobs)
    preset = dispersion_of or (None if material is None else material.preset)
    measured = None if preset is None else _abbe_of(preset)
    if preset is None or measured is None:
        if dispersion_of is None:
            return None
        return Dispersion(abbe=None, material=dispersion_of.id, why=_NONE, n_d=None, knobs=[])
    spectrum = default_catalog().spectrum(preset.id)
    n_d = float(spectrum.n(D_LINE_NM))
    low, high = spectrum.n_range_nm
    known = _VISIBLE_NM[(low <= _VISIBLE_NM) & (high >= _VISIBLE_NM)]
    knobs = []
    for knob in DISPERSION_KNOBS:
        at = known if knob.at_nm is None else np.array(knob.at_nm)
        off = float(np.abs(knob.curve(n_d, measured, at) - spectrum.n(at)).max())
        where = (
            f"from {at[0]:g} to {at[-1]:g} nm" if knob.at_nm is None else "at the C, d and F lines"
        )
        why = f"V_d comes back; n is off by at most {off:.2g} {where}"
        knobs.append(KnobSetting.of(knob, knob.write(measured), "lossy", why))
    return Dispersion(abbe=measured, material=preset.id, why=_MEASURED, n_d=n_d, knobs=knobs)


def _abbe_of(preset: Preset) -> float | None:
    """Abbe number of a clear preset, if its dispersion is known well enough."""
    if preset.abbe is None or preset.kind != "spectrum":
        return None
    return default_catalog().spectrum(preset.id).abbe_number


def table(converted: Conversions) -> Table:
    """Lay out a row a number, with a column a channel where there are three."""
    triple = any(result.channels for result in converted["results"])
    header = ("form", "name", "value", *(CHANNELS if triple else ()), "status", "why")
    knobs = [
        {"form": one.knob, "name": given.name, "status": one.status, "why": one.why}
        | (
            dict(zip(CHANNELS, given.value, strict=True))
            if isinstance(given.value, list)
            else {"value": given.value}
        )
        for one in [*converted["knobs"], *_of_dispersion(converted)]
        if one.knob not in {result.form for result in converted["results"]}
        for given in one.inputs
    ]
    rows = [
        # A color's hexadecimal code is one for all three channels.
        vars(result)
        | {"name": name}
        | (dict(zip(CHANNELS, value, strict=True)) if isinstance(value, list) else {"value": value})
        for result in converted["results"]
        for name, value in result.values.items()
    ]
    rows += knobs
    return Table({h: [row.get(h) for row in rows] for h in header}, "fresnel_convert.csv")


def _of_dispersion(converted: Conversions) -> list[KnobSetting]:
    found = converted.get("dispersion")
    return [] if found is None else found.knobs
