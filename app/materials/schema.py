"""What the files of the data directory may contain; an unknown key is an error."""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

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
Axis = Literal["isotropic", "o", "e"]
Sample = Literal["bulk", "film", "model", "calculated", "unstated"]
Confidence = Literal["high", "medium", "low"]
Id = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9.-]*$")]
Text = Annotated[str, Field(min_length=1)]
Sha256 = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Channels = tuple[float, float, float]
Range = tuple[float, float]

TRANSPARENT: tuple[Category, ...] = ("vacuum", "gas", "liquid", "glass", "polymer", "crystal")
"""Categories whose members are transparent in the visible, so that an Abbe number says something."""


class Strict(BaseModel):
    """Immutable, with no keys but its own, and no NaN or infinity."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Color(Strict):
    """Linear sRGB of the reflected light under D65 for the 2 degree observer, not clamped.

    Values are rounded to six decimals; `app.materials.appearance` has them in full.

    Attributes
    ----------
    F0, F82
        Reflectance at normal incidence and at cos(theta_i) = 1/7, integrated over the spectrum.
    F82_tint
        F82 over Schlick's value there, what the F82-tint model takes.
    luminance
        Luminous reflectance Y at normal incidence.
    """

    F0: Channels
    F82: Channels
    F82_tint: Channels
    luminance: float


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


class Preset(Strict):
    """A material as lists show it, with its constants at one reference wavelength.

    Attributes
    ----------
    kind
        "spectrum" has a file of its own in `spectra/`; "single" is one index of a table.
    rival_of
        Id of the material that this is another measurement of.
    n, k
        Constants at `wavelength_nm`, to ten digits. `k` is None where the source does not give it,
        which is not the same as 0.
    n_range_nm, k_range_nm
        Where they are known. None where the source names no wavelength or no k.
    source
        The reference, in the words of its authors' citation.
    F0
        Reflectance at normal incidence from vacuum at `wavelength_nm`; a k that is not known
        counts as 0.
    abbe
        Abbe number of the d, F and C lines, for transparent materials known at all three.
    """

    id: Id
    name: Text
    category: Category
    aliases: tuple[Text, ...] = ()
    kind: Literal["single", "spectrum"]
    rival_of: Id | None = None
    axis: Axis = "isotropic"
    n: float = Field(gt=0)
    n_min: float | None = None
    n_max: float | None = None
    k: float | None = Field(default=None, ge=0)
    wavelength_nm: float | None
    n_range_nm: Range | None
    k_range_nm: Range | None
    sample: Sample
    confidence: Confidence
    source: Text
    doi: tuple[Text, ...] = ()
    licence: Text
    note: Text | None = None
    warnings: tuple[Text, ...] = ()
    F0: float = Field(ge=0, le=1)
    color: Color
    abbe: float | None = None


class Database(Strict):
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


class Points(Strict):
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


class Formula(Strict):
    """A dispersion formula by its number in the database, wavelengths in micrometers."""

    kind: Literal["formula"]
    number: int = Field(ge=1, le=9)
    coefficients: tuple[float, ...]
    range_nm: Range


Quantity = Annotated[Points | Formula, Field(discriminator="kind")]


class Provenance(Strict):
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

    id: Id
    name: Text
    category: Category
    axis: Axis
    sample: Sample
    confidence: Confidence
    conditions: dict[Text, float | Text]
    note: Text | None
    warnings: tuple[Text, ...]
    provenance: Provenance
    n: Quantity
    k: Quantity | None
