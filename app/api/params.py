"""Query parameters: pydantic models made from the core's declarations, and what is refused."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, THETA_I_DEG, Parameter

MAX_SAMPLES = 20001


def _plain(text: object) -> object:
    """Refuse what Python reads as a number though no one writes it: 1_5 for 15."""
    if isinstance(text, str) and "_" in text:
        raise ValueError("a number has no underscore")
    return text


Number = Annotated[float, BeforeValidator(_plain)]
Count = Annotated[int, BeforeValidator(_plain)]


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


class InterfaceQuery(QueryModel):
    """The two media."""

    n_i: Number = number(N_I, examples=[1.0])
    n_t: Number = number(N_T, examples=[1.5])
    k_t: Number = number(K_T, examples=[0.0])

    def interface(self) -> Interface:
        """Build the interface the query describes."""
        return Interface(self.n_i, self.n_t, self.k_t)


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
        description="Add Brewster's, the critical and the pseudo-Brewster angle to the samples.",
    )
