"""`/albedo/sweep` and `/albedo/map`: albedos along a line and over a rectangle of interfaces."""

# No `from __future__ import annotations` here: the query's type is made from the registry at run
# time, and FastAPI could not look up its name.

from collections import Counter
from functools import lru_cache
from typing import Annotated, ClassVar, Literal, NamedTuple

import numpy as np
from fastapi import APIRouter, Query
from pydantic import Field
from starlette.responses import Response

from app.answers.interface import PresetInterface, ResolvedPreset
from app.api.albedo_schemas import AlbedoMapOut, SweepOut
from app.api.answers import Answer, Large
from app.api.model_parameters import (
    model_arguments,
    parse_models,
    refuse_foreign_parameters,
    with_model_parameters,
)
from app.api.params import InterfaceQuery, number
from app.api.responses import CONVENTION, csv_body, json_body
from app.http.query import Count, Number, TableQuery
from app.http.route import QueryRoute
from app.optics.albedo import (
    Albedo,
    Fit,
    Quantity,
    albedo,
    find_fit,
    flatland_albedo,
    model_albedo,
)
from app.optics.errors import NotAllowed, OutOfRange
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, Array
from app.optics.registry import Model, Registry

MOST_STEPS = 20_001
MOST_CELLS = 250_000
# More dielectrics than this take longer than handing them to a thread.
_INLINE_STEPS = 1000

Scale = Literal["linear", "log"]


class SweepQuery(TableQuery, InterfaceQuery):
    """Albedos along a line of interfaces."""

    over: Literal["n_t", "k_t", "eta"] = Field("n_t", description="What is swept; eta = n_t / n_i.")
    minimum: Number = Field(1.0, ge=0.0, allow_inf_nan=False, description="First value.")
    maximum: Number = Field(3.0, ge=0.0, allow_inf_nan=False, description="Last value.")
    steps: Count = Field(201, ge=2, le=MOST_STEPS, description="Number of values.")
    scale: Scale = Field("linear", description="Equal differences or equal ratios.")
    fits: str = Field(
        "",
        description="Comma-separated ids of fits, as listed at /albedo/fits.",
        examples=["deon_2019_log,kulla_conty_2017"],
    )
    models: str = Field(
        "",
        description="Comma-separated ids of models whose curves are to be averaged too.",
        examples=["schlick"],
    )
    flatland: bool = Field(False, description="Add the albedo in two dimensions.")


class MapQuery(TableQuery):
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
    show: Literal["exact", "value", "error"] | None = Field(
        None, description="The exact albedo, the fit's, or their difference (the default of a fit)."
    )
    quantity: Quantity | None = Field(
        None, description="Polarization of the exact albedo; a fit has its own."
    )


class Curve(NamedTuple):
    """One albedo along a sweep."""

    kind: str
    id: str
    quantity: str
    values: Array
    error: Array | None = None
    in_domain: tuple[float, float] | None = None

    @property
    def column(self) -> str:
        """Header in CSV."""
        prefix = "model." if self.kind == "model" else ""
        return f"{prefix}{self.id}.{self.quantity}"


def parse_fits(text: str) -> list[Fit]:
    """Look up comma-separated ids of fits.

    Raises
    ------
    UnknownFit
        If an id is no fit's, naming the nearest.
    NotAllowed
        If an id is given twice.
    """
    ids = [part.strip() for part in text.split(",")] if text else []
    fits = [find_fit(fit_id) for fit_id in ids]
    repeated = [fit_id for fit_id, count in Counter(ids).items() if count > 1]
    if repeated:
        raise NotAllowed("fits", text, f"each fit once; {repeated[0]} is there twice")
    return fits


def swept(query: SweepQuery) -> tuple[Array, Interface]:
    """Values of the quantity that is swept, and the interfaces they make.

    Raises
    ------
    OutOfRange
        If an end is out of the quantity's bounds.
    NotAllowed
        If the ends are not in order, or what is swept is given too.
    """
    fixed = "k_t" if query.over == "k_t" else "n_t"
    if fixed in query.model_fields_set:
        raise NotAllowed(
            fixed, getattr(query, fixed), f"not beside over={query.over}, which sets it"
        )
    declared = K_T if query.over == "k_t" else N_T
    if query.material is not None:
        raise NotAllowed("material", query.material, "not in a sweep, which sets n_t or k_t")
    unit = query.n_i if query.over == "eta" else 1.0
    low, high = declared.minimum / unit, declared.maximum / unit
    for name in ("minimum", "maximum"):
        value = getattr(query, name)
        if not low <= value <= high:
            raise OutOfRange(name, value, f"from {low:g} to {high:g} for {query.over}")
    values = _spaced("minimum", query.minimum, query.maximum, query.steps, query.scale)
    if query.over == "k_t":
        return values, Interface(query.n_i, query.n_t, values)
    n_t = np.clip(values * unit, N_T.minimum, N_T.maximum)  # eta n_i may round past a bound
    return values, Interface(query.n_i, n_t, query.k_t)


def _incident_json(query: SweepQuery) -> ResolvedPreset | None:
    interface = query.interface()
    named = interface.incident if isinstance(interface, PresetInterface) else None
    return ResolvedPreset.of(named) if named else None


def _spaced(name: str, minimum: float, maximum: float, steps: int, scale: Scale) -> Array:
    if minimum >= maximum:
        raise NotAllowed(name, minimum, f"below the maximum, {maximum:g}")
    if scale == "linear":
        return np.linspace(minimum, maximum, steps)
    if minimum <= 0.0:
        raise NotAllowed(name, minimum, "above 0 where scale=log")
    return np.geomspace(minimum, maximum, steps)


@lru_cache(maxsize=8)
def _exact_over_rectangle(
    n_i: float, n: tuple[float, float, int], k: tuple[float, float, int]
) -> tuple[Interface, Albedo]:
    """Exact albedos over a rectangle; kept, since every fit is compared with the same ones."""
    interface = Interface(n_i, np.linspace(*n)[np.newaxis, :], np.linspace(*k)[:, np.newaxis])
    return interface, albedo(interface)


def _largest(values: Array, interface: Interface) -> dict[str, float] | None:
    """Value of largest modulus and where it is; None if there is none."""
    modulus = np.where(np.isfinite(values), np.abs(values), -1.0)
    row, column = np.unravel_index(np.argmax(modulus), values.shape)
    if modulus[row, column] < 0.0:
        return None
    return {
        "value": float(values[row, column]),
        "n_t": float(interface.n_t[0, column]),
        "k_t": float(interface.k_t[row, 0]),
    }


def _map(query: MapQuery, fit: Fit | None) -> Response:
    show = query.show or ("error" if fit else "exact")
    quantity = fit.quantity if fit else query.quantity or "unpolarized"
    interface, exact = _exact_over_rectangle(
        query.n_i,
        (query.n_minimum, query.n_maximum, query.n_steps),
        (query.k_minimum, query.k_maximum, query.k_steps),
    )
    truth = getattr(exact, quantity)
    domains, inside = [], None
    values = truth
    if fit:
        inside = fit.contains(interface)
        domains = [
            {name: (low * query.n_i, high * query.n_i) for name, (low, high) in box}
            for box in ((("n_t", d.eta), ("k_t", d.kappa)) for d in fit.domains)
        ]
        if show != "exact":
            value = fit(interface)
            values = np.asarray(value - truth) if show == "error" else value
    values = np.ascontiguousarray(values)
    if query.format == "csv":
        n_t, k_t = np.broadcast_arrays(interface.n_t, interface.k_t)
        columns = {"n_t": n_t.ravel(), "k_t": k_t.ravel(), show: values.ravel()}
        return csv_body(columns, query.digits, "albedo_map.csv")
    payload = {
        "convention": CONVENTION,
        "n_i": query.n_i,
        "n_t": interface.n_t.ravel(),
        "k_t": interface.k_t.ravel(),
        "fit": fit.id if fit else None,
        "quantity": quantity,
        "show": show,
        "values": values,
        "largest": _largest(values, interface),
        "largest_in_domain": None
        if inside is None
        else _largest(np.where(inside, values, np.nan), interface),
        "domains": domains,
    }
    return json_body(payload, query.digits)


def router(registry: Registry) -> APIRouter:
    """Routes over the fits, and over the models of `registry`."""
    routes = APIRouter(route_class=QueryRoute, tags=["albedo"])
    Query_ = with_model_parameters(SweepQuery, registry)

    def curves(
        query: SweepQuery, fits: list[Fit], models: list[Model]
    ) -> tuple[Array, list[Curve]]:
        values, interface = swept(query)
        exact = albedo(interface)
        found = [
            Curve("exact", "exact", "unpolarized", exact.unpolarized),
            Curve("exact", "exact", "s", exact.s),
            Curve("exact", "exact", "p", exact.p),
        ]
        if query.flatland:
            found.append(Curve("exact", "flatland", "unpolarized", flatland_albedo(interface)))
        for fit in fits:
            fitted = np.ascontiguousarray(fit(interface))
            inside = values[fit.contains(interface)]
            found.append(
                Curve(
                    "fit",
                    fit.id,
                    fit.quantity,
                    fitted,
                    np.asarray(fitted - getattr(exact, fit.quantity)),
                    (float(inside[0]), float(inside[-1])) if inside.size else None,
                )
            )
        for model in models:
            averages = model_albedo(model, interface, **model_arguments(query, model))
            colors = ("",) if averages.ndim == 1 else ("_red", "_green", "_blue")
            found += [
                Curve(
                    "model",
                    model.id,
                    f"unpolarized{color}",
                    np.ascontiguousarray(row),
                    np.asarray(row - exact.unpolarized),
                )
                for color, row in zip(colors, np.atleast_2d(averages), strict=True)
            ]
        return values, found

    def respond(query: SweepQuery, fits: list[Fit], models: list[Model]) -> Response:
        values, found = curves(query, fits, models)
        if query.format == "csv":
            columns: dict[str, Array] = {query.over: values}
            for curve in found:
                columns[curve.column] = curve.values
                if curve.error is not None:
                    columns[f"{curve.column}.error"] = curve.error
            return csv_body(columns, query.digits, "albedo_sweep.csv")
        payload = {
            "convention": CONVENTION,
            "n_i": query.n_i,
            "incident": _incident_json(query),
            "n_t": query.n_t if query.over == "k_t" else None,
            "k_t": None if query.over == "k_t" else query.k_t,
            "over": query.over,
            "values": values,
            "curves": [curve._asdict() for curve in found],
        }
        return json_body(payload, query.digits)

    @routes.get("/albedo/sweep", response_model=SweepOut, summary="Albedos along n_t, k_t or eta")
    def sweep(query: Annotated[Query_, Query()]) -> Answer:  # type: ignore[valid-type]
        return answer(query)

    def answer(query: SweepQuery) -> Answer:
        models = parse_models(query.models, registry) if query.models else []
        fits = parse_fits(query.fits)
        refuse_foreign_parameters(query, models, registry)
        clear = query.over != "k_t" and query.k_t == 0.0 and not query.flatland and not models
        if clear and query.steps <= _INLINE_STEPS:
            return respond(query, fits, models)
        return Large(respond, query, fits, models)

    @routes.get("/albedo/map", response_model=AlbedoMapOut, summary="Albedos over n_t and k_t")
    def albedo_map(query: Annotated[MapQuery, Query()]) -> Answer:
        fit = None if query.fit is None else find_fit(query.fit, "fit")
        refuse_map(query, fit)
        return Large(_map, query, fit)

    return routes


def refuse_map(query: MapQuery, fit: Fit | None) -> None:
    """Refuse what makes no map.

    Raises
    ------
    NotAllowed
        If there are too many cells, ends out of order, or parameters that contradict the fit.
    """
    cells = query.n_steps * query.k_steps
    if cells > MOST_CELLS:
        raise NotAllowed("n_steps", query.n_steps, f"n_steps times k_steps at most {MOST_CELLS}")
    for axis in ("n", "k"):
        low, high = getattr(query, f"{axis}_minimum"), getattr(query, f"{axis}_maximum")
        if low >= high:
            raise NotAllowed(f"{axis}_minimum", low, f"below {axis}_maximum, {high:g}")
    if fit is None and query.show in ("value", "error"):
        raise NotAllowed("show", query.show, "exact, unless a fit is given")
    if fit is not None and query.quantity not in (None, fit.quantity):
        raise NotAllowed("quantity", query.quantity, f"{fit.id} approximates {fit.quantity}")
