"""`/albedo`, `/albedo/fits` and `/albedo/coat`: albedos of one interface."""

# No `from __future__ import annotations` here: the query's type is made from the registry at run
# time, and FastAPI could not look up its name.

from typing import Annotated, Any

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.api.albedo_schemas import AlbedoOut, CoatOut, FitOut, FitsOut
from app.api.answers import Answer, Large
from app.api.model_parameters import (
    model_arguments,
    parse_models,
    refuse_foreign_parameters,
    with_model_parameters,
)
from app.api.params import InterfaceQuery, number
from app.api.responses import (
    CONVENTION,
    csv_body,
    interface_json,
    json_body,
    number_or_null,
)
from app.http.problems import MissingResource
from app.http.query import Number, TableQuery
from app.http.route import QueryRoute
from app.optics.albedo import (
    BODY_ALBEDO,
    FITS,
    Albedo,
    Claim,
    Domain,
    Fit,
    UnknownFit,
    albedo,
    coat_split,
    find_fit,
    flatland_albedo,
    method,
    model_albedo,
)
from app.optics.incidence import Incidence
from app.optics.interface import Interface
from app.optics.parameters import THETA_I_DEG, Array
from app.optics.registry import Model, Registry


class AlbedoQuery(TableQuery, InterfaceQuery):
    """Albedo of one interface."""

    models: str = Field(
        "",
        description="Comma-separated ids of models whose curves are to be averaged too.",
        examples=["schlick"],
    )


class CoatQuery(TableQuery, InterfaceQuery):
    """A diffuse body under a clear coat of index n_t."""

    body_albedo: Number = number(BODY_ALBEDO, examples=[0.5])
    theta_i_deg: Number | None = Field(
        None,
        ge=THETA_I_DEG.minimum,
        le=THETA_I_DEG.maximum,
        allow_inf_nan=False,
        description="Angle of incidence of a ray; diffuse light from everywhere if not given.",
    )


def domain_json(domain: Domain) -> dict[str, Any]:
    """Describe a box of interfaces."""
    return {"kind": domain.kind, "eta": domain.eta, "kappa": domain.kappa}


def _claim_json(claim: Claim) -> dict[str, Any]:
    return {
        "domain": domain_json(claim.domain),
        "claimed": claim.claimed,
        "relative": claim.relative,
        "source": claim.source,
        "measured": claim.measured,
        "at": {"eta": claim.at[0], "kappa": claim.at[1]},
        "measured_over": domain_json(claim.measured_over),
        "holds": claim.holds,
    }


def describe(fit: Fit) -> dict[str, Any]:
    """Turn a fit into what the API says of it."""
    return {
        "id": fit.id,
        "title": fit.title,
        "quantity": fit.quantity,
        "domains": [domain_json(domain) for domain in fit.domains],
        "latex": fit.latex,
        "reference": fit.reference,
        "note": fit.note,
        "claims": [_claim_json(claim) for claim in fit.claims],
    }


def _exact_json(interface: Interface, exact: Albedo) -> dict[str, Any]:
    return {
        "unpolarized": float(exact.unpolarized),
        "s": float(exact.s),
        "p": float(exact.p),
        "method": method(interface),
    }


def _approximations(interface: Interface, exact: Albedo) -> list[dict[str, Any]]:
    answers = []
    for fit in FITS.values():
        value, reason = fit(interface), fit.reason_outside(interface)
        answers.append(
            {
                "id": fit.id,
                "title": fit.title,
                "quantity": fit.quantity,
                "value": number_or_null(value),
                "error": number_or_null(value - getattr(exact, fit.quantity)),
                "in_domain": reason is None,
                "reason": reason,
                "reference": fit.reference,
            }
        )
    return answers


def _numbers(values: Array) -> Any:
    """One number or, of a triple, three."""
    return number_or_null(values) if values.ndim == 0 else values.ravel()


def router(registry: Registry) -> APIRouter:
    """Routes over the fits, and over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["albedo"])
    Query_ = with_model_parameters(AlbedoQuery, registry)

    def model_values(
        query: AlbedoQuery, models: list[Model], interface: Interface, exact: Albedo
    ) -> list[dict[str, Any]]:
        answers = []
        for model in models:
            values = model_albedo(model, interface, **model_arguments(query, model))
            reason = model.reason_outside(interface)
            answers.append(
                {
                    "model": model.id,
                    "value": _numbers(values),
                    "error": _numbers(np.asarray(values - exact.unpolarized)),
                    "in_domain": reason is None,
                    "reason": reason,
                }
            )
        return answers

    def respond(query: AlbedoQuery, models: list[Model]) -> Response:
        interface = query.interface()
        exact = albedo(interface)
        payload: dict[str, Any] = {
            "interface": interface_json(interface),
            "convention": CONVENTION,
            "exact": _exact_json(interface, exact),
            "flatland": float(flatland_albedo(interface)),
            "approximations": _approximations(interface, exact),
            "models": model_values(query, models, interface, exact),
            "reverse": None,
        }
        if not interface.is_conductor:
            reverse = Interface(interface.n_t, interface.n_i)
            exact_reverse = albedo(reverse)
            payload["reverse"] = {
                "exact": _exact_json(reverse, exact_reverse),
                "approximations": _approximations(reverse, exact_reverse),
            }
        if query.format == "csv":
            return csv_body(_columns(payload), query.digits, "albedo.csv")
        return json_body(payload, query.digits)

    @routes.get("/albedo", response_model=AlbedoOut, summary="Albedo of one interface")
    def albedos(query: Annotated[Query_, Query()]) -> Answer:  # type: ignore[valid-type]
        return answer(query)

    def answer(query: AlbedoQuery) -> Answer:
        models = parse_models(query.models, registry) if query.models else []
        refuse_foreign_parameters(query, models, registry)
        if models:
            return Large(respond, query, models)
        return respond(query, models)

    @routes.get("/albedo/fits", response_model=FitsOut, summary="All fits of the albedo")
    def fits() -> Answer:
        return json_body({"fits": [describe(fit) for fit in FITS.values()]})

    @routes.get("/albedo/fits/{fit_id}", response_model=FitOut, summary="One fit of the albedo")
    def one_fit(fit_id: str) -> Answer:
        try:
            found = find_fit(fit_id, "fit_id")
        except UnknownFit as error:
            raise MissingResource(error) from None
        return json_body(describe(found))

    @routes.get("/albedo/coat", response_model=CoatOut, summary="A diffuse body under a coat")
    def coat(query: Annotated[CoatQuery, Query()]) -> Answer:
        return _coat(query)

    return routes


def _coat(query: CoatQuery) -> Response:
    interface = query.interface()
    ray = None if query.theta_i_deg is None else Incidence.from_degrees(query.theta_i_deg)
    split = coat_split(interface, query.body_albedo, ray)
    parts = {
        name: float(getattr(split, name))
        for name in ("external", "internal", "surface", "body", "absorbed")
    }
    if query.format == "csv":
        columns = {name: np.array([value]) for name, value in parts.items()}
        return csv_body(columns, query.digits, "coat.csv")
    payload = {
        "interface": interface_json(interface),
        "convention": CONVENTION,
        "body_albedo": query.body_albedo,
        "theta_i_deg": query.theta_i_deg,
        **parts,
    }
    return json_body(payload, query.digits)


def _columns(payload: dict[str, Any]) -> dict[str, Array]:
    """Lay the numbers of an `/albedo` answer out as one row."""
    row: dict[str, Any] = {
        **{name: payload["interface"][name] for name in ("n_i", "n_t", "k_t")},
        **{f"exact.{name}": payload["exact"][name] for name in ("unpolarized", "s", "p")},
        "flatland": payload["flatland"],
    }
    for entry in payload["approximations"]:
        row |= {f"{entry['id']}.{name}": entry[name] for name in ("value", "error")}
    for entry in payload["models"]:
        for name in ("value", "error"):
            numbers = np.atleast_1d(np.array(entry[name], dtype=np.float64))
            colors = ("",) if numbers.size == 1 else ("_red", "_green", "_blue")
            pairs = zip(colors, numbers, strict=True)
            row |= {f"model.{entry['model']}.{name}{color}": value for color, value in pairs}
    return {name: np.array([value], dtype=np.float64) for name, value in row.items()}
