"""`/curves`: reflectance over the angle of incidence, of any models."""

from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.curves import CoatedCurves, Curves
from app.answers.curves import curves as evaluated
from app.api.model_parameters import ModelsQuery, with_parameters_of
from app.api.params import ConventionQuery, LayersQuery, SamplesQuery
from app.http.query import TableQuery
from app.http.route import QueryRoute
from app.optics.registry import Registry

# Above this many values a curve is computed in a thread, so that other requests are answered
# meanwhile; below it the hand-over would cost more than the curve.
_INLINE_VALUES = 20_000


class CurvesQuery(ModelsQuery, TableQuery, SamplesQuery, ConventionQuery, LayersQuery):
    """Curves over the angle of incidence."""

    phase: bool = Field(False, description="Add phase_s_deg and phase_p_deg of `exact`.")
    refraction: bool = Field(
        False,
        description="Add of `exact` theta_t_deg, penetration_depth_wavelengths, at which the power "
        "has fallen to 1/e, and field_penetration_depth_wavelengths, the field's, twice as deep.",
    )
    ellipsometry: bool = Field(False, description="Add psi_deg and delta_deg of `exact`.")
    polarized: bool = Field(
        False,
        description="Add Rs and Rp of every other model that tells them apart: the exact forms and "
        "pharr_humphreys.",
    )
    band: bool = Field(
        False,
        description="Add R_minimum and R_maximum of `exact` over the range of n that the source of a "
        "preset gives, as that of garnet.",
    )

    @property
    def takes_long(self) -> bool:
        """Whether there are many values."""
        layers = 1 + (self.layers or "").count(",")
        return self.samples * (self.models.count(",") + layers) > _INLINE_VALUES


def router(registry: Registry) -> APIRouter:
    """Routes over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["optics"])

    @routes.get("/curves", summary="Reflectance over the angle")
    @with_parameters_of(registry)
    def curves(query: Annotated[CurvesQuery, Query()]) -> Curves | CoatedCurves:
        return evaluated(
            query.interface(),
            query.chosen(),
            samples=query.samples,
            landmarks=query.landmarks,
            phase=query.phase,
            refraction=query.refraction,
            ellipsometry=query.ellipsometry,
            band=query.band,
            polarized=query.polarized,
            coated=query.coated(),
            convention=query.signs(),
        )

    return routes
