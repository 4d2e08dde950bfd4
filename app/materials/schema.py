"""What the files of the data directory may contain; an unknown key is an error.

What answers pass on as it was read, a preset or a provenance, is a dataclass: OpenAPI takes the
descriptions of its fields from here.
"""

import re
from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator
from pydantic.dataclasses import dataclass

from app.materials.dispersion import check_coefficients

Category = Literal[
    "vacuum",
    "gas",
    "liquid",
    "glass",
    "polymer",
    "crystal",
    "metal",
    "alloy",
    "semimetal",
    "semiconductor",
    "ceramic",
    "generic",
]
Axis = Literal["isotropic", "o", "e", "alpha", "beta", "gamma", "para", "perp"]
Sample = Literal["bulk", "film", "model", "calculated", "unstated"]
Confidence = Literal["high", "medium", "low", "unstated"]
Reference = Literal["vacuum", "air"]
RelativeTo = Annotated[
    Reference | None,
    Field(
        description="What the source measured n against: n relative to air is multiplied by air's "
        "index before anything is computed, and is n_absolute then. Null where the source does not "
        "say; n counts as absolute there."
    ),
]
WavelengthIn = Annotated[
    Reference | None,
    Field(
        description="Whether the source counts wavelengths in vacuum or in air, where they are "
        "shorter by 0.03 %; null where it does not say. wavelength_nm is taken as the source counts."
    ),
]
Id = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9.-]*$")]
PresetId = Annotated[
    str,
    Field(
        pattern=r"^(own:[A-Za-z0-9_-]+|rii:[^/]+/[^/]+/[^/]+|[A-Za-z0-9][A-Za-z0-9.-]*)$",
        max_length=12_000,
    ),
]
"""An id of a file, of a page of refractiveindex.info, or of a material that people bring, which is its
data."""
Text = Annotated[str, Field(min_length=1)]
Sha256 = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Channels = tuple[float, float, float]
Range = tuple[float, float]

TRANSPARENT: tuple[Category, ...] = ("vacuum", "gas", "liquid", "glass", "polymer", "crystal")
"""Categories whose members are transparent in the visible, so that an Abbe number says something."""


class Strict(BaseModel):
    """Immutable, with no keys but its own, and no NaN or infinity."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


PASSED_ON = ConfigDict(
    extra="forbid", allow_inf_nan=False, json_schema_serialization_defaults_required=True
)
"""Of what is read as strictly and sent as it is.

Descriptions stand in the annotations: answers that add fields keep them, and the order of the keys.
"""


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Color:
    """Linear sRGB of the reflected light, not clamped.

    In the files it is that under D65 for the 2 degree observer, rounded to six decimals;
    `app.materials.appearance` has it in full.
    """

    F0: Annotated[Channels, Field(description="At normal incidence, from the exact spectrum.")]
    F82: Annotated[Channels, Field(description="At cos(theta_i) = 1/7.")]
    F82_tint: Annotated[
        Channels,
        Field(description="F82 over Schlick's there, of the light's white: the tint of F82-tint."),
    ]
    luminance: Annotated[float, Field(description="Luminous reflectance Y at normal incidence.")]


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Page:
    """A page of refractiveindex.info."""

    shelf: Text
    book: Text
    page: Text
    title: Annotated[Text, Field(description="What the book and the page are called there.")]


def called(preset_id: str, name: str) -> str:
    """What a preset is called in sentences and names of files."""
    kind, colon, rest = preset_id.partition(":")
    if not colon:
        return preset_id
    words = re.sub(r"[^A-Za-z0-9.]+", "-", name if kind == "own" else rest)
    return f"{kind}-{words.strip('-.') or 'material'}"


class Row(Strict):
    """A line of a published table of single indices.

    `n_min` and `n_max` stand where the source prints a range; `n` is then its middle.
    `wavelength_nm` is None where the source names no wavelength.
    """

    id: Id
    name: Text
    category: Category
    aliases: tuple[Text, ...] = ()
    n: float = Field(gt=0)
    n_min: float | None = Field(default=None, gt=0)
    n_max: float | None = Field(default=None, gt=0)
    relative_to: Literal["vacuum"] | None = None
    wavelength_nm: float | None
    note: Text | None = None
    source: Text

    @model_validator(mode="after")
    def _range_holds_n(self) -> Self:
        if (self.n_min is None) != (self.n_max is None):
            raise ValueError("n_min and n_max come together")
        if self.n_min is not None and self.n_max is not None:
            middle = 0.5 * (self.n_min + self.n_max)
            if not self.n_min < self.n_max or abs(self.n - middle) > 1e-9:
                raise ValueError("n is the middle of n_min and n_max")
        return self


class Table(Strict):
    """A published table of single indices, edited by hand."""

    id: Id
    title: Text
    source: Text
    confidence: Confidence
    licence: Text
    rows: tuple[Row, ...]


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Preset:
    """A material as lists show it, with its constants at one reference wavelength to ten digits."""

    id: PresetId
    name: Text
    category: Category
    aliases: tuple[Text, ...] = ()
    kind: Annotated[
        Literal["single", "spectrum"],
        Field(
            description="`spectrum` has n over the wavelength; `single` is one index of a table."
        ),
    ]
    rival_of: Annotated[
        Id | None, Field(description="The preset this is another measurement of.")
    ] = None
    axis: Axis = "isotropic"
    n: Annotated[
        float, Field(gt=0, description="At wavelength_nm, relative to what the source measured it.")
    ]
    n_absolute: Annotated[
        float, Field(gt=0, description="The same against vacuum, which F0 and color are made from.")
    ]
    n_min: Annotated[
        float | None, Field(description="Where the source gives a range, n is its middle.")
    ] = None
    n_max: float | None = None
    k: Annotated[
        float | None, Field(ge=0, description="Null where the source does not give it: not 0.")
    ] = None
    wavelength_nm: Annotated[
        float | None,
        Field(description="Reference wavelength in nm; null where the source names none."),
    ]
    relative_to: RelativeTo = None
    wavelength_in: WavelengthIn = None
    n_range_nm: Annotated[Range | None, Field(description="Where n is known, in nm.")]
    k_range_nm: Annotated[Range | None, Field(description="Where k is known, in nm.")]
    sample: Annotated[Sample, Field(description="What was measured.")]
    confidence: Confidence
    source: Annotated[Text, Field(description="The reference.")]
    doi: tuple[Text, ...] = ()
    licence: Text
    note: Text | None = None
    warnings: tuple[Text, ...] = ()
    F0: Annotated[
        float,
        Field(ge=0, le=1, description="From vacuum at wavelength_nm; a k not known counts as 0."),
    ]
    color: Annotated[Color, Field(description="Under D65, to six decimals.")]
    abbe: Annotated[float | None, Field(description="Abbe number of transparent materials.")] = None
    page: Annotated[
        Page | None,
        Field(description="The page of refractiveindex.info that it is; null of all others."),
    ] = None

    @property
    def called(self) -> str:
        """Its id; of a material that people bring, whose id is its data, something shorter."""
        return called(self.id, self.name) if self.id.startswith("own:") else self.id


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Database:
    """The release that the spectra were taken from."""

    name: Text
    tag: Text
    commit: Text
    package: Text
    licence: Text


class Index(Strict):
    """`index.json`: every preset, materials first, then their rivals, then the tables."""

    database: Database
    presets: tuple[Preset, ...]


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Points:
    """Native points of a table, in order, between which values are interpolated linearly."""

    kind: Literal["points"]
    wavelength_nm: tuple[float, ...]
    values: tuple[float, ...]

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if len(self.wavelength_nm) != len(self.values) or not self.values:
            raise ValueError("as many values as wavelengths, and at least one")
        pairs = zip(self.wavelength_nm, self.wavelength_nm[1:], strict=False)
        if any(later <= earlier for earlier, later in pairs):
            raise ValueError("wavelengths rise strictly")
        return self


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Formula:
    """A dispersion formula by its number in the database, wavelengths in micrometers."""

    kind: Literal["formula"]
    number: Annotated[int, Field(ge=1, le=9, description="Of refractiveindex.info's formulas.")]
    coefficients: tuple[float, ...]
    range_nm: Range

    @model_validator(mode="after")
    def _whole(self) -> Self:
        check_coefficients(self.number, self.coefficients)
        return self


Quantity = Annotated[Points | Formula, Field(discriminator="kind")]


@dataclass(frozen=True, kw_only=True, config=PASSED_ON)
class Provenance:
    """Where a spectrum comes from, down to the bytes of the file."""

    database: Text
    tag: Text
    page: Text
    file: Text
    sha256: Sha256
    reference: Text
    doi: tuple[Text, ...]
    links: tuple[Text, ...]
    licence: Text
    comments: Text | None


class SpectrumFile(Strict):
    """`spectra/<id>.json`: n and k of one material, each with its own range.

    The keys of `conditions` carry their unit: `temperature_k`, `pressure_pa`, `film_thickness_nm`.
    """

    id: PresetId
    name: Text
    category: Category
    axis: Axis
    sample: Sample
    confidence: Confidence
    conditions: dict[Text, float | Text]
    relative_to: RelativeTo
    wavelength_in: WavelengthIn
    note: Text | None
    warnings: tuple[Text, ...]
    provenance: Provenance
    n: Quantity
    k: Quantity | None
