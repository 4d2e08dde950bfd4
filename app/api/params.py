"""Query parameters: pydantic models made from the core's declarations, and what is refused."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated, Any, Self

from pydantic import BeforeValidator, Field, PrivateAttr, model_validator
from pydantic_core import PydanticCustomError

from app.answers.films import Coated
from app.answers.interface import PresetInterface
from app.http.problems import BadParameters, ParameterError, parameter_error
from app.http.query import Count, Number, QueryModel
from app.materials.films import SPELLING
from app.materials.media import (
    USELESS_WAVELENGTH,
    Resolved,
    given_beside,
    resolve_incident,
    resolve_material,
)
from app.materials.own.token import LONGEST
from app.optics.ellipsometry import Convention, Normal, TimeFactor
from app.optics.errors import OpticsError
from app.optics.incidence import Incidence
from app.optics.parameters import (
    K_I,
    K_T,
    N_I,
    N_T,
    THETA_I_DEG,
    THETA_I_RAD,
    WAVELENGTH_NM,
    Parameter,
)

MAX_SAMPLES = 20001


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


def preset_name(description: str, *examples: str) -> Any:
    """Pydantic field of a preset's id."""
    return Field(
        None, min_length=1, max_length=LONGEST, description=description, examples=list(examples)
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
        "Id or alias of a preset in place of n_t and k_t, as listed at /materials, or a page of "
        "refractiveindex.info as rii:SHELF/BOOK/PAGE; a k that its "
        "source does not give, or below 1e-6, counts as 0. An index that was measured in air is "
        "made absolute: n_i = 1 is vacuum, and `incident=air` is air.",
        "Au",
        "rii:main/Ag/Johnson",
    )
    incident: str | None = preset_name(
        "Id or alias of a preset in place of n_i. It must not absorb.",
        "water",
    )
    wavelength_nm: Number | None = wavelength(
        None,
        "Wavelength in nm at which the presets are evaluated, in vacuum or in air as the source of "
        "each counts it (`wavelength_in`), within the range of each; by default their own, 587.6 nm "
        "for measured spectra.",
    )
    _incident: Resolved | None = PrivateAttr(None)
    _material: Resolved | None = PrivateAttr(None)

    @property
    def _has_layers(self) -> bool:
        """Whether a wavelength is of use without any preset."""
        return False

    @model_validator(mode="after")
    def _resolve(self) -> Self:
        if self.material is None and self.incident is None and self.wavelength_nm is None:
            return self
        refuse_beside(self, "material", "n_t", "k_t")
        refuse_beside(self, "incident", "n_i")
        if self.material is None and self.incident is None and not self._has_layers:
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
            object.__setattr__(self, "n_t", self._material.constants.n_absolute)
            object.__setattr__(self, "k_t", self._material.k_t)
        if self.incident is not None:
            with reported_as(material="incident"):
                self._incident = resolve_incident(self.incident, self.wavelength_nm)
            object.__setattr__(self, "n_i", self._incident.constants.n_absolute)
        return self

    def interface(self) -> PresetInterface:
        """Build the interface the query describes; it knows its presets."""
        return PresetInterface(self.n_i, self.n_t, self.k_t, self._incident, self._material)


def layers(description: str, *, required: bool = False) -> Any:
    """Pydantic field of layers."""
    return Field(
        ... if required else None,
        min_length=1,
        max_length=LONGEST,
        description=f"Films between the media: {SPELLING}. An incoherent layer is so thick that the "
        "waves reflected at its two faces add as powers; its k is at most 0.01 n. " + description,
        examples=["MgF2:99.6", "SiO2:25,0.055+3.32i:30", "BK7:3000000:incoherent"],
    )


class LayersQuery(InterfaceQuery):
    """The two media, and films between them."""

    layers: str | None = layers(
        "Materials and phases are those at wavelength_nm, 587.6 unless given. "
        "`exact` is the only model of them."
    )

    @property
    def _has_layers(self) -> bool:
        return self.layers is not None

    def coated(self) -> Coated | None:
        """Put the layers on the interface; None where there are none.

        Raises
        ------
        OpticsError
            If they cannot be read, or are not known at the wavelength.
        """
        k_i: float = getattr(self, K_I.name, 0.0)
        if self.layers is None and k_i == 0.0:
            return None
        return Coated.of(self.interface(), self.layers, self.wavelength_nm, k_i)


def _with_plus(text: object) -> object:
    """Read the blank as which a + arrives that an address spells as it is."""
    return text.replace("exp( ", "exp(+") if isinstance(text, str) else text


class ConventionQuery(QueryModel):
    """Which signs amplitudes, phases and delta have."""

    convention: Annotated[TimeFactor, BeforeValidator(_with_plus)] = Field(
        "exp(-iwt)",
        description="The time factor of all waves. With exp(+iwt) an absorbing index is n - ik, and "
        "all phases and delta change sign, as ellipsometers print them.",
    )
    r_p_at_normal: Normal = Field(
        "-r_s",
        description="What r_p is at normal incidence: with r_s it has the other sign at every angle, "
        "and delta differs by 180 degrees.",
    )

    def signs(self) -> Convention:
        """The convention."""
        return Convention(self.convention, self.r_p_at_normal)


_NUMBER = re.compile(r"\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*")


def numbers_of(names: str) -> BeforeValidator:
    """Read as many numbers as there are names, all separated by commas."""
    count = names.count(",") + 1

    def read(given: object) -> object:
        if not isinstance(given, str):
            return given
        parts = given.split(",")
        if len(parts) != count or not all(map(_NUMBER.fullmatch, parts)):
            raise PydanticCustomError("numbers", f"{count} numbers {names}")
        return tuple(map(float, parts))

    return BeforeValidator(read, json_schema_input_type=str)


@contextmanager
def reported_as(**names: str) -> Iterator[None]:
    """Turn what the core refuses into the API's own error, its parameters renamed.

    Inside a pydantic validator nothing of the core's errors, which are ValueErrors, would be left.

    Parameters
    ----------
    names
        What the client calls the core's parameters.
    """
    try:
        yield
    except OpticsError as error:
        error.parameter = names.get(error.parameter, error.parameter)
        raise BadParameters(parameter_error(error)) from None


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


class RayQuery(QueryModel):
    """An angle of incidence, in degrees or in radians, or none.

    Once validated, `theta_i_deg` holds it in degrees.
    """

    theta_i_deg: Number | None = Field(
        None,
        ge=THETA_I_DEG.minimum,
        le=THETA_I_DEG.maximum,
        allow_inf_nan=False,
        description="Angle of incidence of a ray; diffuse light from everywhere if not given.",
        json_schema_extra={"unit": THETA_I_DEG.unit, "symbol": THETA_I_DEG.symbol},
    )
    theta_i_rad: Number | None = Field(
        None,
        ge=THETA_I_RAD.minimum,
        le=THETA_I_RAD.maximum,
        allow_inf_nan=False,
        description=THETA_I_RAD.description,
        json_schema_extra={"unit": THETA_I_RAD.unit, "symbol": THETA_I_RAD.symbol},
    )

    @model_validator(mode="after")
    def _one_angle(self) -> Self:
        if self.theta_i_rad is not None:
            refuse_beside(self, "theta_i_rad", "theta_i_deg")
            degrees = float(Incidence.from_radians(self.theta_i_rad).theta_i_deg)
            object.__setattr__(self, "theta_i_deg", degrees)
        return self

    def ray(self) -> Incidence | None:
        """The direction, if there is one."""
        if self.theta_i_rad is not None:
            return Incidence.from_radians(self.theta_i_rad)
        return None if self.theta_i_deg is None else Incidence.from_degrees(self.theta_i_deg)


class AngleQuery(RayQuery):
    """One angle of incidence, in degrees or in radians."""

    theta_i_deg: Number = number(THETA_I_DEG, examples=[64.0])

    def incidence(self) -> Incidence:
        """The direction."""
        return self.ray() or Incidence.from_degrees(self.theta_i_deg)


def equal_samples(default: int) -> Any:
    """Pydantic field of a number of angles."""
    return Field(
        default,
        ge=2,
        le=MAX_SAMPLES,
        description="Equally spaced angles from 0 to 90 degrees, both ends included.",
    )


class SamplesQuery(QueryModel):
    """Which angles a curve is sampled at."""

    samples: Count = equal_samples(181)
    landmarks: bool = Field(
        False,
        description="Add Brewster's, the critical, the pseudo-Brewster and the principal angle to "
        "the samples.",
    )
