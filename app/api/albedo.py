"""`/albedo`, its fits, sweep and map, and `/albedo/coat`: what a surface reflects of diffuse light."""

from typing import Annotated, ClassVar

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.albedo import Albedos, Coat, RegisteredFit, RegisteredFits
from app.answers.albedo import albedos as evaluated
from app.answers.albedo import coat as split
from app.answers.albedo_grids import AlbedoMap, AlbedoSweep, Shown, albedo_map, albedo_sweep
from app.answers.axes import MOST_CELLS, MOST_STEPS, Scale, SweptName, refuse_many_cells
from app.answers.curves import Chosen
from app.api.axes import swept
from app.api.model_parameters import (
    ModelsQuery,
    each_once,
    refuse_foreign_parameters,
    with_parameters_of,
)
from app.api.params import InterfaceQuery, RayQuery, number
from app.http.problems import MissingResource
from app.http.query import Count, LongQuery, Number, TableQuery
from app.http.route import QueryRoute
from app.optics.albedo import BODY_ALBEDO, FITS, Quantity, UnknownFit, find_fit
from app.optics.parameters import K_T, N_I, N_T
from app.optics.registry import Registry

# More dielectrics than this take longer than handing them to a thread.
_INLINE_STEPS = 1000


class AveragedQuery(ModelsQuery):
    """Which models are averaged; none unless asked for."""

    models: str = Field(
        "",
        description="Comma-separated ids of models whose curves are to be averaged too.",
        examples=["schlick"],
    )

    def chosen(self) -> list[Chosen]:
        """Look up the models, if any."""
        if self.models:
            return super().chosen()
        refuse_foreign_parameters(self, [], self.registry)
        return []


class AlbedoQuery(AveragedQuery, TableQuery, InterfaceQuery):
    """Albedo of one interface."""

    @property
    def takes_long(self) -> bool:
        """Whether models are averaged."""
        return bool(self.models)


class CoatQuery(RayQuery, TableQuery, InterfaceQuery):
    """A diffuse body under a clear coat of index n_t."""

    body_albedo: Number = number(BODY_ALBEDO, examples=[0.5])


class FitsSweepQuery(TableQuery, InterfaceQuery):
    """A line of interfaces, and fits."""

    over: SweptName = Field("n_t", description="What is swept; eta = n_t / n_i.")
    minimum: Number = Field(1.0, ge=0.0, allow_inf_nan=False, description="First value.")
    maximum: Number = Field(3.0, ge=0.0, allow_inf_nan=False, description="Last value.")
    steps: Count = Field(201, ge=2, le=MOST_STEPS, description="Number of values.")
    scale: Scale = Field("linear", description="Equal differences or equal ratios.")
    fits: str = Field(
        "",
        description="Comma-separated ids of fits, as listed at /albedo/fits.",
        examples=["deon_2019_log,kulla_conty_2017"],
    )


class AlbedoSweepQuery(AveragedQuery, FitsSweepQuery):
    """Albedos along a line of interfaces."""

    flatland: bool = Field(False, description="Add the albedo in two dimensions.")

    @property
    def takes_long(self) -> bool:
        """Whether there is more than closed forms for not too many dielectrics."""
        absorbing = self.over == "k_t" or self.k_t > 0.0
        return absorbing or self.flatland or bool(self.models) or self.steps > _INLINE_STEPS


class AlbedoMapQuery(TableQuery, LongQuery):
    """Albedos, or a fit's errors, over a rectangle of n_t and k_t."""

    cells: ClassVar[tuple[str, ...]] = ("n_steps", "k_steps")

    n_i: Number = number(N_I)
    n_minimum: Number = Field(
        0.1, ge=N_T.minimum, le=N_T.maximum, allow_inf_nan=False, description="Smallest n_t."
    )
    n_maximum: Number = Field(
        4.0, ge=N_T.minimum, le=N_T.maximum, allow_inf_nan=False, description="Largest n_t."
    )
    n_steps: Count = Field(60, ge=2, le=MOST_CELLS // 2, description="Number of n_t.")
    k_minimum: Number = Field(
        0.0, ge=K_T.minimum, le=K_T.maximum, allow_inf_nan=False, description="Smallest k_t."
    )
    k_maximum: Number = Field(
        8.0, ge=K_T.minimum, le=K_T.maximum, allow_inf_nan=False, description="Largest k_t."
    )
    k_steps: Count = Field(60, ge=2, le=MOST_CELLS // 2, description="Number of k_t.")
    fit: str | None = Field(None, description="Id of a fit.", examples=["deon_2019_rg"])
    show: Shown | None = Field(
        None, description="The exact albedo, the fit's, or their difference (the default of a fit)."
    )
    quantity: Quantity | None = Field(
        None, description="Polarization of the exact albedo; a fit has its own."
    )


def router(registry: Registry) -> APIRouter:
    """Routes over the fits, and over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["albedo"])

    @routes.get("/albedo", summary="Albedo of one interface")
    @with_parameters_of(registry)
    def albedos(query: Annotated[AlbedoQuery, Query()]) -> Albedos:
        return evaluated(query.interface(), query.chosen())

    @routes.get("/albedo/fits", summary="All fits of the albedo")
    def fits() -> RegisteredFits:
        return RegisteredFits(fits=[RegisteredFit.of(fit) for fit in FITS.values()])

    @routes.get("/albedo/fits/{fit_id}", summary="One fit of the albedo")
    def one_fit(fit_id: str) -> RegisteredFit:
        try:
            return RegisteredFit.of(find_fit(fit_id, "fit_id"))
        except UnknownFit as error:
            raise MissingResource(error) from None

    @routes.get("/albedo/coat", summary="A diffuse body under a coat")
    def coat(query: Annotated[CoatQuery, Query()]) -> Coat:
        return split(query.interface(), query.body_albedo, query.ray())

    @routes.get("/albedo/sweep", summary="Albedos along n_t, k_t or eta")
    @with_parameters_of(registry)
    def sweep(query: Annotated[AlbedoSweepQuery, Query()]) -> AlbedoSweep:
        models = query.chosen()
        fits = each_once(query.fits, find_fit, "fit") if query.fits else []
        axis = swept(query, query.over, "", query.steps, query.scale)
        return albedo_sweep(
            query.interface(), axis, fits=fits, models=models, flatland=query.flatland
        )

    @routes.get("/albedo/map", summary="Albedos over n_t and k_t")
    def rectangle(query: Annotated[AlbedoMapQuery, Query()]) -> AlbedoMap:
        fit = None if query.fit is None else find_fit(query.fit, "fit")
        refuse_many_cells("n_steps", n_steps=query.n_steps, k_steps=query.k_steps)
        return albedo_map(
            query.n_i,
            (query.n_minimum, query.n_maximum, query.n_steps),
            (query.k_minimum, query.k_maximum, query.k_steps),
            fit=fit,
            show=query.show,
            quantity=query.quantity,
        )

    return routes
