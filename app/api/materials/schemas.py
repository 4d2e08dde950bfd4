"""Shapes of the answers about materials, for OpenAPI; every wavelength is one in vacuum."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from app.api.schemas import or_chosen_fields
from app.materials.schema import Axis, Category, Confidence, Sample
from app.optics.color import Adaptation, Gamut, Illuminant, Observer

Rgb = tuple[float, float, float]
RangeNm = tuple[float, float]


class Answer(BaseModel):
    """Base: no key that is not declared."""

    model_config = ConfigDict(extra="forbid")


class SwatchOut(Answer):
    """A color as a screen shows it."""

    gamut: Gamut = Field(description="What was done about channels outside 0 to 1.")
    hex: str | None = Field(description="#rrggbb; null where unclamped channels leave 0 to 1.")


class ColorOut(Answer):
    """Linear sRGB of the reflected light, not clamped."""

    F0: Rgb = Field(description="At normal incidence, from the exact spectrum.")
    F82: Rgb = Field(description="At cos(theta_i) = 1/7.")
    F82_tint: Rgb = Field(description="F82 over Schlick's there: the tint of the F82-tint model.")
    luminance: float = Field(description="Luminous reflectance Y at normal incidence.")


class MaterialOut(Answer):
    """A preset as lists show it."""

    id: str
    name: str
    category: Category
    aliases: list[str]
    kind: Literal["single", "spectrum"] = Field(
        description="`spectrum` has n over the wavelength; `single` is one index of a table."
    )
    rival_of: str | None = Field(description="The preset this is another measurement of.")
    axis: Axis
    n: float = Field(description="At wavelength_nm.")
    n_min: float | None = Field(description="Where the source gives a range, n is its middle.")
    n_max: float | None
    k: float | None = Field(description="Null where the source does not give it: not 0.")
    wavelength_nm: float | None = Field(
        description="Reference wavelength in nm; null where the source names none."
    )
    n_range_nm: RangeNm | None = Field(description="Where n is known, in nm.")
    k_range_nm: RangeNm | None = Field(description="Where k is known, in nm.")
    sample: Sample = Field(description="What was measured.")
    confidence: Confidence
    source: str = Field(description="The reference.")
    doi: list[str]
    licence: str
    note: str | None
    warnings: list[str]
    F0: float = Field(description="From vacuum at wavelength_nm; a k not known counts as 0.")
    color: ColorOut = Field(description="Under D65, to six decimals.")
    abbe: float | None = Field(description="Abbe number of transparent materials.")
    swatch: SwatchOut = Field(description="F0 as sRGB.")


class DatabaseOut(Answer):
    """The release that the spectra were taken from."""

    name: str
    tag: str
    commit: str
    package: str
    licence: str


class MaterialsOut(Answer):
    """Presets, a page of those that the query fits."""

    materials: list[MaterialOut] = Field(json_schema_extra=or_chosen_fields)
    total: int = Field(description="How many fit, on all pages.")
    offset: int
    limit: int | None
    suggestions: list[str] = Field(description="Ids that resemble `q`, where nothing fits it.")
    categories: dict[Category, int] = Field(description="How many presets each category has.")
    database: DatabaseOut


class ConstantsOut(Answer):
    """Constants at one wavelength, with what they give from vacuum."""

    wavelength_nm: float | None
    n: float
    k: float | None
    F0: float
    F82: float = Field(description="Exact reflectance at cos(theta_i) = 1/7.")


class SeenColorOut(ColorOut):
    """Linear sRGB in full precision, with the light and the observer."""

    illuminant: Illuminant
    observer: Observer
    adaptation: Adaptation


class DisplayOut(SwatchOut):
    """The color by a gamut policy."""

    F0: Rgb = Field(description="Linear sRGB.")
    F82: Rgb = Field(description="Linear sRGB.")
    F82_tint: Rgb = Field(description="The tint that belongs to this F0 and F82.")
    in_gamut: bool = Field(description="Whether the unclamped F0 is within 0 and 1.")


class ProvenanceOut(Answer):
    """Where a spectrum comes from, down to the bytes of the file."""

    database: str
    tag: str
    page: str
    file: str
    sha256: str
    reference: str
    doi: list[str]
    links: list[str]
    licence: str
    comments: str | None


class RivalOut(Answer):
    """Another measurement of the same material."""

    id: str
    name: str
    n: float
    k: float | None
    wavelength_nm: float | None
    sample: Sample
    confidence: Confidence
    source: str
    F0: Rgb = Field(description="Linear sRGB under D65, not clamped.")
    luminance: float


class SpreadOut(Answer):
    """How far the measurements lie apart: luminous reflectance at normal incidence, D65."""

    minimum: float
    maximum: float
    ids: list[str]


class MaterialDetailOut(MaterialOut):
    """All that is known of a preset."""

    color: SeenColorOut
    constants: ConstantsOut
    display: DisplayOut
    conditions: dict[str, float | str] = Field(description="Keys carry their unit.")
    provenance: ProvenanceOut | None = Field(description="Null for an index out of a table.")
    rivals: list[RivalOut]
    spread: SpreadOut
    database: DatabaseOut


class AboutOut(Answer):
    """The material an answer is about, and where its data come from."""

    id: str
    name: str
    category: Category
    axis: Axis
    sample: Sample
    confidence: Confidence
    source: str
    doi: list[str]
    licence: str


class NativeOut(Answer):
    """What the source gives: points, or a formula whose wavelengths are in micrometers."""

    kind: Literal["points", "formula"]
    wavelength_nm: list[float] | None = None
    values: list[float] | None = None
    number: int | None = Field(None, description="Of refractiveindex.info's formulas.")
    coefficients: list[float] | None = None
    range_nm: RangeNm | None = None


class NativePairOut(Answer):
    """What the source gives for n and for k."""

    n: NativeOut
    k: NativeOut | None


class SpectrumOut(Answer):
    """n, k and F0 over the wavelength; null where one is not known."""

    material: AboutOut
    n_range_nm: RangeNm
    k_range_nm: RangeNm | None = Field(description="Null where the source gives no k.")
    sampling: Literal["native", "step"] = Field(
        description="`native`: the points of the source, and 241 in equal ratios over the range of "
        "a formula; `step`: every step_nm."
    )
    wavelength_nm: list[float]
    n: list[float | None]
    k: list[float | None] | None
    F0: list[float | None] = Field(description="At normal incidence from vacuum.")
    native: NativePairOut | None = Field(description="Null when a step is asked for.")
    warnings: list[str]


class FrontOut(Answer):
    """The medium in front."""

    n_i: float | None = Field(description="Null where a preset's index varies.")
    incident: AboutOut | None


class MaterialMapOut(Answer):
    """Reflectance over angle and wavelength."""

    material: AboutOut
    front: FrontOut
    convention: str
    quantity: Literal["R", "Rs", "Rp"]
    theta_i_deg: list[float]
    wavelength_nm: list[float]
    n_i: list[float]
    n: list[float]
    k: list[float]
    values: list[list[float]] = Field(description="A row for each wavelength.")
    warnings: list[str]


class WavelengthCurveOut(Answer):
    """Reflectance over the angle at one wavelength."""

    wavelength_nm: float
    n_i: float
    n: float
    k: float | None
    F0: float
    F82: float
    R: list[float]


class ChannelErrorOut(Answer):
    """Error against the spectrum, over the hemisphere; null where the model is undefined."""

    max_abs: float | None = Field(description="Largest absolute error, to about 1e-4.")
    max_abs_at_deg: float | None
    error_at_max: float | None = Field(description="Signed error there.")
    rms: float | None = Field(description="Root mean square, each solid angle alike.")
    cosine_weighted_mean: float | None = Field(description="Signed: the error of the albedo.")


class RgbErrorsOut(Answer):
    """Errors of the three channels."""

    red: ChannelErrorOut
    green: ChannelErrorOut
    blue: ChannelErrorOut


class RgbCurveOut(Answer):
    """R, G and B over the angle, by the spectrum or by what a renderer makes of three numbers."""

    model: str = Field(description="`spectral` is the truth; others are ids of /models.")
    title: str
    inputs: dict[str, Rgb] = Field(description="The colors the model was given.")
    R_red: list[float | None]
    R_green: list[float | None]
    R_blue: list[float | None]
    errors: RgbErrorsOut | None = Field(description="Null for the truth.")


class RgbOut(Answer):
    """Curves in linear sRGB."""

    illuminant: Illuminant
    observer: Observer
    adaptation: Adaptation
    gamut: Gamut = Field(
        description="Applied to the colors that the models are given; no curve is clamped."
    )
    curves: list[RgbCurveOut]


class MaterialCurvesOut(Answer):
    """Reflectance over the angle per wavelength and per channel."""

    material: AboutOut
    front: FrontOut
    convention: str
    theta_i_deg: list[float]
    wavelengths: list[WavelengthCurveOut]
    rgb: RgbOut | None
    warnings: list[str]
