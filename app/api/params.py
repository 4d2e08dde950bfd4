"""Query parameters: pydantic models made from the core's declarations, and what is refused."""

from __future__ import annotations

import math
import re
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import (
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    PrivateAttr,
    model_validator,
)
from pydantic_core import PydanticCustomError

from app.api.presets import PresetInterface, reported_as
from app.http.problems import BadParameters, ParameterError
from app.materials import (
    USELESS_WAVELENGTH,
    Resolved,
    given_beside,
    resolve_incident,
    resolve_material,
)
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, WAVELENGTH_NM, Parameter

_ZERO = re.compile(r"-(0+\.?0*|\.0+)(e[+-]?\d+)?", re.IGNORECASE)

MAX_SAMPLES = 20001


def plain(text: object) -> object:
    """Refuse what Python reads as a number though no one writes it, 1_5 for 15; read -0 as 0."""
    if isinstance(text, str):
        if "_" in text and _is_number(text.replace("_", "")):
            raise PydanticCustomError("number", "a number has no underscore")
        if text.startswith("-") and _ZERO.fullmatch(text):
            return "0"
    return text


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


Number = Annotated[float, BeforeValidator(plain)]
Count = Annotated[int, BeforeValidator(plain)]


def number(parameter: Parameter, **options: Any) -> Any:
    """Pydantic field of a declared parameter: its default, bounds, unit and description."""
    return Field(
        parameter.default,
        ge=parameter.minimum,
        le=parameter.maximum,
        allow_inf_nan=False,
        description=parameter.description,
        json_schema_extra={"unit": parameter.unit, "symbol": parameter.symbol},
        **options,
    )


class QueryModel(BaseModel):
    """Base of all queries; unknown and repeated names are refused by `QueryRoute`."""

    model_config = ConfigDict(frozen=True, validate_default=False)

    cells: ClassVar[tuple[str, ...]] = ()
    """The fields whose product is the number of cells of a map."""

    def refuse_beyond(self, max_samples: int, max_cells: int) -> None:
        """Refuse more than an operator lets the server compute at once.

        Raises
        ------
        BadParameters
            Naming what there is too much of, and the setting.
        """
        samples = getattr(self, "samples", 0)
        if samples > max_samples:
            message = f"this server computes at most {max_samples} (FRESNEL_MAX_SAMPLES)"
            raise BadParameters({"parameter": "samples", "value": samples, "message": message})
        if self.cells and math.prod(getattr(self, name) for name in self.cells) > max_cells:
            first, names = self.cells[0], " times ".join(self.cells)
            message = f"this server computes {names} at most {max_cells} (FRESNEL_MAX_CELLS)"
            value = getattr(self, first)
            raise BadParameters({"parameter": first, "value": value, "message": message})


def preset_name(description: str, *examples: str) -> Any:
    """Pydantic field of a preset's id."""
    return Field(
        None, min_length=1, max_length=100, description=description, examples=list(examples)
    )


def wavelength(default: float | None, description: str, **options: Any) -> Any:
    """Pydantic field of a wavelength."""
    return Field(
        default,
        gt=WAVELENGTH_NM.minimum,
        le=WAVELENGTH_NM.maximum,
        allow_inf_nan=False,
        description=description,
        json_schema_extra={"unit": WAVELENGTH_NM.unit, "symbol": WAVELENGTH_NM.symbol},
        **options,
    )


class InterfaceQuery(QueryModel):
    """The two media, each by its numbers or by a preset.

    Once validated, `n_i`, `n_t` and `k_t` hold what the presets resolve to.
    """

    n_i: Number = number(N_I, examples=[1.0])
    n_t: Number = number(N_T, examples=[1.5])
    k_t: Number = number(K_T, examples=[0.0])
    material: str | None = preset_name(
        "Id or alias of a preset in place of n_t and k_t, as listed at /materials; a k that its "
        "source does not give, or below 1e-6, counts as 0.",
        "Au",
    )
    incident: str | None = preset_name(
        "Id or alias of a preset in place of n_i. It must not absorb.",
        "water",
    )
    wavelength_nm: Number | None = wavelength(
        None,
        "Wavelength in vacuum, in nm, at which the presets are evaluated, within the range of "
        "each; by default their own, 587.6 nm for measured spectra.",
    )
    _incident: Resolved | None = PrivateAttr(None)
    _material: Resolved | None = PrivateAttr(None)

    @model_validator(mode="after")
    def _resolve(self) -> Self:
        if self.material is None and self.incident is None and self.wavelength_nm is None:
            return self
        refuse_beside(self, "material", "n_t", "k_t")
        refuse_beside(self, "incident", "n_i")
        if self.material is None and self.incident is None:
            raise BadParameters(
                {
                    "parameter": "wavelength_nm",
                    "value": self.wavelength_nm,
                    "message": USELESS_WAVELENGTH,
                }
            )
        # The model is frozen to everybody but its own validation.
        if self.material is not None:
            with reported_as():
                self._material = resolve_material(self.material, self.wavelength_nm)
            object.__setattr__(self, "n_t", self._material.constants.n)
            object.__setattr__(self, "k_t", self._material.k_t)
        if self.incident is not None:
            with reported_as(material="incident"):
                self._incident = resolve_incident(self.incident, self.wavelength_nm)
            object.__setattr__(self, "n_i", self._incident.constants.n)
        return self

    def interface(self) -> Interface:
        """Build the interface the query describes; it knows its presets, see `interface_json`."""
        if self._material is None and self._incident is None:
            return Interface(self.n_i, self.n_t, self.k_t)
        return PresetInterface(self.n_i, self.n_t, self.k_t, self._incident, self._material)


def refuse_beside(query: QueryModel, preset: str, *numbers: str) -> None:
    """Refuse numbers that are given beside the preset that takes their place.

    Raises
    ------
    BadParameters
        Naming each of them.
    """
    name = getattr(query, preset)
    errors: list[ParameterError] = [
        {
            "parameter": number,
            "value": getattr(query, number),
            "message": given_beside(preset, name),
        }
        for number in numbers
        if name is not None and number in query.model_fields_set
    ]
    if errors:
        raise BadParameters(*errors)


class DigitsQuery(QueryModel):
    """How numbers are sent."""

    digits: Count = Field(17, ge=3, le=17, description="Significant digits of the numbers sent.")


class AngleQuery(QueryModel):
    """One angle of incidence."""

    theta_i_deg: Number = number(THETA_I_DEG, examples=[64.0])


class TableQuery(DigitsQuery):
    """How an answer that is a table is sent."""

    format: Literal["json", "csv"] = Field("json", description="JSON, or CSV with a header row.")


class SamplesQuery(QueryModel):
    """Which angles a curve is sampled at."""

    samples: Count = Field(
        181,
        ge=2,
        le=MAX_SAMPLES,
        description="Equally spaced angles from 0 to 90 degrees, both ends included.",
    )
    landmarks: bool = Field(
        False,
        description="Add Brewster's, the critical, the pseudo-Brewster and the principal angle to "
        "the samples.",
    )
