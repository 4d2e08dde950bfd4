"""`/export`: any boundary, bare or with a film, as a file of a render engine."""

from typing import Annotated

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.answers.film_shortcuts import AIR
from app.answers.materials.export import Export
from app.api.materials.exporting import FILES, exported
from app.api.materials.queries import ExportQuery
from app.api.params import number, preset_name, refuse_beside
from app.http.query import Number
from app.http.route import QueryRoute
from app.materials.media import default_catalog
from app.materials.own.constant import constant
from app.materials.schema import Preset
from app.optics.errors import NotAllowed
from app.optics.parameters import K_T, N_I, N_T


class BoundaryExportQuery(ExportQuery):
    """The second medium, by a preset or by its numbers, and what is on it."""

    n_i: Number = number(N_I, examples=[1.0])
    n_t: Number = number(N_T, examples=[1.5])
    k_t: Number = number(K_T, examples=[0.0])
    material: str | None = preset_name("Id or alias of a preset in place of n_t and k_t.", "Au")

    def preset(self) -> Preset:
        """Return the second medium.

        Raises
        ------
        NotAllowed
            If the medium in front is not air or vacuum, for which engines' files are.
        UnknownMaterial
            If there is no such preset.
        """
        refuse_beside(self, "material", "n_t", "k_t")
        if abs(self.n_i - 1.0) > AIR:
            raise NotAllowed("n_i", self.n_i, "1: an engine's material is one in air")
        if self.material is None:
            return constant(self.n_t, self.k_t)
        return default_catalog().get(self.material)


def router() -> APIRouter:
    """The route."""
    routes = APIRouter(route_class=QueryRoute, tags=["materials"])

    @routes.get(
        "/export",
        response_model=Export,
        responses=FILES,
        summary="A boundary, bare or with a film, for a render engine",
    )
    def boundary(query: Annotated[BoundaryExportQuery, Query()]) -> Export | Response:
        return exported(query.preset(), query)

    return routes
