"""Queries of the routes over materials: lists, the medium in front, ranges and colors."""

from typing import Any, ClassVar, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from app.answers.materials.export import one_film
from app.answers.materials.listing import MOST_PAGES, Collected
from app.answers.materials.map import Quantity
from app.api.model_parameters import ModelsParameter, each_once
from app.api.params import (
    MAX_SAMPLES,
    equal_samples,
    layers,
    number,
    preset_name,
    refuse_beside,
    reported_as,
    wavelength,
)
from app.export.target import ModeId, TargetId
from app.http.problems import BadParameters, ParameterError
from app.http.query import Count, DigitsQuery, Number, QueryModel, TableQuery
from app.materials.appearance import Viewing
from app.materials.covered import COVER_N, Cover, CoverKind
from app.materials.films import Film, read_layers
from app.materials.front import Front
from app.materials.rgb_models import has_rgb_form
from app.materials.schema import Category
from app.optics.color import Adaptation, Gamut, Illuminant, Observer, Space
from app.optics.errors import NotAllowed
from app.optics.parameters import N_I, Array
from app.optics.registry import Model, Registry


def _gamut(default: Gamut) -> Any:
    return Field(
        default,
        description="What is done about colors that sRGB cannot show: `unclamped` nothing, "
        "`clamped` cuts each channel to 0 and 1, `scaled` divides by the largest channel where that "
        "exceeds 1.",
    )


class ListQuery(DigitsQuery):
    """Which presets."""

    q: str | None = Field(
        None,
        max_length=100,
        description="Part of a name, an alias, an id, a title or a reference; best matches come "
        "first.",
        examples=["gold"],
    )
    category: Category | None = Field(None, description="Only presets of this category.")
    kind: Literal["spectrum", "single"] | None = Field(
        None, description="Only measured spectra, or only single indices of tables."
    )
    catalog: Collected | None = Field(
        None,
        description="`curated`: only our presets; `pages`: only pages of refractiveindex.info, each "
        "under `page` with its shelf, book and page. With `q` both unless given, ours first unless the "
        "page alone is called so, or has it as a word; without, ours.",
    )
    offset: Count = Field(0, ge=0, le=100_000, description="How many to leave out at the start.")
    limit: Count | None = Field(
        None,
        ge=1,
        le=1000,
        description=f"How many to send at most; all of ours and {MOST_PAGES} pages unless given.",
    )
    gamut: Gamut = _gamut("scaled")
    fields: str | None = Field(
        None,
        max_length=500,
        description="Comma-separated names of what to send of each preset; all unless given.",
        examples=["id,name,category,n,k"],
    )

    @property
    def lasts(self) -> bool:
        """Whether it is the whole list, or some fields of it, that pages start with."""
        return self.model_fields_set <= {"fields"}


class ColorQuery(QueryModel):
    """Under which light, by which observer colors are seen."""

    illuminant: Illuminant = Field("D65", description="What lights the surface.")
    observer: Observer = Field("cie1931_2deg", description="Color-matching functions.")
    adaptation: Adaptation = Field(
        "bradford",
        description="How the illuminant's white becomes that of sRGB, D65; `none` leaves its cast.",
    )

    def viewing(self) -> Viewing:
        """Return the three together."""
        return Viewing(self.illuminant, self.observer, self.adaptation)


class DetailQuery(ColorQuery, DigitsQuery):
    """How one preset is shown."""

    wavelength_nm: Number | None = wavelength(
        None,
        "Where the constants are evaluated, in nm, within the preset's own range; by default its "
        "reference wavelength.",
        examples=[587.6],
    )
    gamut: Gamut = _gamut("scaled")


class RgbNkQuery(ColorQuery, DigitsQuery):
    """How the three channels are made that n and k are fitted to."""

    gamut: Gamut = _gamut("clamped")
    space: Space = Field("srgb", description="Linear sRGB or ACEScg.")

    @property
    def takes_long(self) -> bool:
        """Always: three searches over the hemisphere."""
        return True


class CoveredQuery(ColorQuery, DigitsQuery):
    """What is in front of the material."""

    cover: CoverKind = Field(
        "coat",
        description="`medium` fills the space in front of the material, `coat` is a clear layer on it "
        "in air, `pane` a clear plate with air on both sides; coat and pane are so thick that their "
        "faces do not interfere.",
    )
    n: Number = number(COVER_N, examples=[1.5])
    of: str | None = preset_name(
        "Id or alias of a transparent preset with a spectrum, in place of n.", "water"
    )
    gamut: Gamut = _gamut("clamped")

    @model_validator(mode="after")
    def _one_of_them(self) -> Self:
        refuse_beside(self, "of", "n")
        return self

    @property
    def takes_long(self) -> bool:
        """Always: integrals over the wavelength at each angle."""
        return True

    def covered_by(self) -> Cover:
        """Look up the cover.

        Raises
        ------
        BadParameters
            If there is no such preset, or it is a single index.
        """
        if self.of is None:
            return Cover(self.cover, Front(self.n))
        with reported_as(material="of"):
            return Cover(self.cover, Front.named(self.of))


class ExportQuery(DigitsQuery):
    """For which engine, and how."""

    to: TargetId = Field(description="The engine or format.", examples=["materialx"])
    mode: ModeId | None = Field(
        None,
        description="Which of the engine's ways, as `modes` of the answer lists them: `nk` three "
        "fitted pairs of n and k, `f82` F0 and the tint at 82 degrees, `principled` the same in "
        "Blender's Principled BSDF, `spectral` n and k over the wavelength, `schlick` F0 alone, `ior` "
        "one index; the first that the material has unless given.",
    )
    policy: Gamut = _gamut("clamped")
    space: Space = Field(
        "srgb", description="Whose channels the numbers are: linear sRGB or ACEScg."
    )
    format: Literal["file", "json"] = Field(
        "file",
        description="The file alone, or JSON with the file's text, the parameters to type, what is "
        "lost, and the largest error that the engine will show.",
    )
    layers: str | None = layers("Engines take one film, which interferes, in air.")

    @property
    def takes_long(self) -> bool:
        """Always: an integral over the wavelength at each angle."""
        return True

    def film(self) -> Film | None:
        """Return the film.

        Raises
        ------
        NotAllowed
            If the layers cannot be read, or are not one film.
        """
        return None if self.layers is None else one_film(read_layers(self.layers))


class FrontQuery(QueryModel):
    """The medium in front, by a number or by a preset that is evaluated at every wavelength."""

    n_i: Number = number(N_I, examples=[1.0])
    incident: str | None = preset_name(
        "Id or alias of a transparent preset with a spectrum, in place of n_i."
    )

    @model_validator(mode="after")
    def _one_of_them(self) -> Self:
        refuse_beside(self, "incident", "n_i")
        return self

    def front(self) -> Front:
        """Look up the medium in front.

        Raises
        ------
        BadParameters
            If there is no such preset, or it is a single index.
        """
        if self.incident is None:
            return Front(self.n_i)
        with reported_as(material="incident"):
            return Front.named(self.incident)


class RangeQuery(QueryModel):
    """A range of wavelengths."""

    minimum_nm: Number | None = wavelength(
        None, "Shortest wavelength, in nm, within the preset's own range.", examples=[380.0]
    )
    maximum_nm: Number | None = wavelength(
        None, "Longest wavelength, in nm, within the preset's own range.", examples=[780.0]
    )


class SpectrumQuery(RangeQuery, TableQuery):
    """Constants over the wavelength; all that is known unless a range is given."""

    step_nm: Number | None = wavelength(
        None, "Distance of the wavelengths, in nm; the native points unless given.", examples=[5.0]
    )


class MapQuery(FrontQuery, RangeQuery, TableQuery):
    """Reflectance over angle and wavelength; from 380 to 780 nm unless a range is given."""

    cells: ClassVar[tuple[str, ...]] = ("steps", "samples")

    quantity: Quantity = Field("R", description="Unpolarized, s or p.")
    samples: Count = equal_samples(91)
    steps: Count = Field(
        201, ge=2, le=MAX_SAMPLES, description="Equally spaced wavelengths, both ends included."
    )

    @property
    def takes_long(self) -> bool:
        """Always."""
        return True


class RgbQuery(ColorQuery):
    """Whether and how R, G and B are made."""

    rgb: bool = Field(True, description="Whether to add R, G and B.")
    models: ModelsParameter = Field(
        "schlick,f82_tint,exact",
        description="Comma-separated ids of the models that stand beside the spectrum as R, G and "
        "B: `exact` (from n and k averaged to R, G and B), and those whose parameters are F0, F82 "
        "or a tint.",
        examples=["schlick,f82_tint,exact"],
    )
    gamut: Gamut = _gamut("unclamped")

    def chosen(self, registry: Registry) -> list[Model] | None:
        """Look up the models; None where R, G and B are left out.

        Raises
        ------
        BadParameters
            Naming what only R, G and B depend on where they are not asked for.
        UnknownModel, NotAllowed
            If a model is not registered, there twice or cannot be given a color.
        """
        lost = {*RgbQuery.model_fields} - {"rgb"}
        errors: list[ParameterError] = [
            {
                "parameter": name,
                "value": getattr(self, name),
                "message": "given although rgb = false leaves R, G and B out",
            }
            for name in sorted(lost & self.model_fields_set)
        ]
        if errors and not self.rgb:
            raise BadParameters(*errors)
        models = each_once(self.models, registry.find)
        for model in models:
            if not has_rgb_form(model):
                able = [m.id for m in registry.values() if has_rgb_form(m)]
                raise NotAllowed("models", model.id, f"one of {', '.join(able)}")
        return models if self.rgb else None


class MaterialCurvesQuery(FrontQuery, RgbQuery, TableQuery):
    """R over the angle of incidence at wavelengths of choice and as R, G and B."""

    wavelengths_nm: str | None = Field(
        None,
        min_length=1,
        max_length=2000,
        description="Comma-separated wavelengths in nm, within the presets' own range; those of "
        "400, 500, 600, 700 and 800 that are, unless given, or, if none is, five over that range.",
        examples=["400,500,600,700,800"],
    )
    samples: Count = equal_samples(181)

    @property
    def takes_long(self) -> bool:
        """Always: a color is 471 wavelengths at each angle."""
        return True

    def wavelengths(self) -> Array | None:
        """Read the wavelengths; None unless they are given.

        Raises
        ------
        NotAllowed
            If a part is no number, or is there twice.
        """
        if self.wavelengths_nm is None:
            return None
        numbers: list[float] = []
        for part in self.wavelengths_nm.split(","):
            try:
                value = float(part) if "_" not in part else np.nan
            except ValueError:
                value = np.nan
            if not np.isfinite(value):
                raise NotAllowed("wavelengths_nm", part, "comma-separated numbers, in nm")
            if value in numbers:
                raise NotAllowed("wavelengths_nm", part, "each wavelength once")
            numbers.append(value)
        return np.array(numbers)
