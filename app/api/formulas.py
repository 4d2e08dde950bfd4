"""`/formulas`: everything that is registered as a formula, explained, and its curve."""

from __future__ import annotations

from dataclasses import asdict
from functools import cache
from typing import Annotated, Any, Literal

import numpy as np
import orjson
from fastapi import APIRouter, Query
from pydantic import BaseModel, Field
from starlette.responses import Response

from app.api.answers import Answer, Large
from app.api.responses import ReadyBody, csv_body, json_body
from app.api.schemas import ParameterOut
from app.http.problems import BadParameters, MissingResource, ParameterError
from app.http.query import Count, Number, QueryModel, TableQuery
from app.http.route import QueryRoute
from app.optics.formulas.collection import CONVENTIONS, Formulas, UnknownFormula, symbols_of
from app.optics.formulas.formula import Formula
from app.optics.formulas.sources import links
from app.optics.interface import Interface
from app.optics.parameters import K_T, N_I, N_T, Parameter
from app.optics.registry import Registry

MAX_CURVE_SAMPLES = 2001
_NUMBERS = (N_I, N_T, K_T)


def _unless_given(parameter: Parameter) -> Any:
    return Field(
        None,
        ge=parameter.minimum,
        le=parameter.maximum,
        allow_inf_nan=False,
        description=f"{parameter.description} The formula's own example unless given.",
    )


class FormulasQuery(QueryModel):
    """Which formulas."""

    kind: Literal["model", "albedo", "angle", "conversion"] | None = Field(
        None, description="Only those of a kind."
    )


class FormulaCurveQuery(TableQuery):
    """A formula over its own abscissa."""

    n_i: Number | None = _unless_given(N_I)
    n_t: Number | None = _unless_given(N_T)
    k_t: Number | None = _unless_given(K_T)
    samples: Count = Field(
        181, ge=2, le=MAX_CURVE_SAMPLES, description="Equally spaced points, both ends included."
    )


class SymbolOut(BaseModel):
    """A letter of a formula."""

    latex: str
    meaning: str
    unit: str = Field(description="Empty for pure numbers.")


class AccuracyOut(BaseModel):
    """An error of a formula, which a test measures again."""

    value: float
    of: str = Field(description="What is wrong by it.")
    over: str = Field(description="Where it was measured.")
    against: str
    relative: bool
    at_most: bool = Field(description="Whether the value is a bound, as for rounding.")
    unit: str


class TakenOut(BaseModel):
    """A number of the interface that a formula's curve depends on."""

    name: str
    symbol: str
    value: float = Field(description="Of the example that is shown unless another is given.")
    minimum: float
    maximum: float


class FormulaOut(BaseModel):
    """A formula with all that is to be said of it."""

    id: str = Field(description="Kind and name, as model.schlick.")
    kind: Literal["model", "albedo", "angle", "conversion"]
    title: str
    latex: str
    convention: str
    validity: str
    reference: str
    links: list[str] = Field(description="Where the reference can be read.")
    symbols: list[SymbolOut] = Field(description="Every letter, in the order of appearance.")
    parameters: list[ParameterOut]
    measured: list[AccuracyOut]
    takes: list[TakenOut] = Field(description="What its curve may be given.")


class FormulasOut(BaseModel):
    """All formulas."""

    formulas: list[FormulaOut]


class FormulaAxisOut(BaseModel):
    """What runs along an axis."""

    name: str
    symbol: str
    title: str
    unit: str


class SeriesOut(BaseModel):
    """One quantity along the abscissa."""

    id: str
    title: str
    values: list[float | None]


class FormulaCurveOut(BaseModel):
    """A formula over its own abscissa, beside the exact values where it approximates some."""

    formula: str
    convention: str
    n_i: float
    n_t: float
    k_t: float
    x: FormulaAxisOut
    at: list[float]
    y: FormulaAxisOut
    series: list[SeriesOut]


def describe(formula: Formula) -> dict[str, Any]:
    """Turn a formula into what the API says of it."""
    at = {p.name: float(getattr(formula.at, p.name)) for p in _NUMBERS}
    return {
        "id": formula.id,
        "kind": formula.kind,
        "title": formula.title,
        "latex": formula.latex,
        "convention": CONVENTIONS[formula.kind],
        "validity": formula.validity,
        "reference": formula.reference,
        "links": links(formula.reference),
        "symbols": [asdict(symbol) for symbol in symbols_of(formula)],
        "parameters": [asdict(parameter) for parameter in formula.parameters],
        "measured": [asdict(accuracy) for accuracy in formula.accuracy],
        "takes": [
            {
                "name": p.name,
                "symbol": p.symbol,
                "value": at[p.name],
                "minimum": p.minimum,
                "maximum": p.maximum,
            }
            for p in formula.takes
        ],
    }


def interface_of(formula: Formula, query: FormulaCurveQuery) -> Interface:
    """The formula's example with the numbers that are given in place of its own.

    Raises
    ------
    BadParameters
        If a number is given that the curve does not depend on.
    """
    given = {p.name: getattr(query, p.name) for p in _NUMBERS}
    takes = [p.name for p in formula.takes]
    errors: list[ParameterError] = [
        {
            "parameter": name,
            "value": value,
            "message": f"the curve of {formula.id} depends on {', '.join(takes) or 'nothing else'}",
        }
        for name, value in given.items()
        if value is not None and name not in takes
    ]
    if errors:
        raise BadParameters(*errors)
    own = {p.name: float(getattr(formula.at, p.name)) for p in _NUMBERS}
    return Interface(**own | {name: value for name, value in given.items() if value is not None})


def curve_of(formula: Formula, interface: Interface, query: FormulaCurveQuery) -> Response:
    """The curve as JSON or CSV."""
    curve = formula.curve(interface, query.samples)
    if query.format == "csv":
        columns = {curve.x.name: curve.at} | {series.id: series.values for series in curve.series}
        return csv_body(columns, query.digits, f"{formula.id}.csv")
    payload = {
        "formula": formula.id,
        "convention": CONVENTIONS[formula.kind],
        "n_i": float(interface.n_i),
        "n_t": float(interface.n_t),
        "k_t": float(interface.k_t),
        "x": asdict(curve.x),
        "at": curve.at,
        "y": asdict(curve.y),
        "series": [
            {"id": s.id, "title": s.title, "values": np.ascontiguousarray(s.values)}
            for s in curve.series
        ],
    }
    return json_body(payload, query.digits)


def router(registry: Registry) -> APIRouter:
    """Routes over the formulas of everything that is registered."""
    routes = APIRouter(route_class=QueryRoute, tags=["formulas"])
    formulas = Formulas(registry)

    @cache
    def every_formula(kind: str | None) -> Response:
        shown = [describe(f) for f in formulas.values() if kind in (None, f.kind)]
        return ReadyBody(orjson.dumps({"formulas": shown}), "application/json", effort="thorough")

    def found(formula_id: str) -> Formula:
        try:
            return formulas.find(formula_id)
        except UnknownFormula as error:
            raise MissingResource(error) from None

    @routes.get("/formulas", response_model=FormulasOut, summary="All formulas, explained")
    def all_formulas(query: Annotated[FormulasQuery, Query()]) -> Answer:
        return every_formula(query.kind)

    @routes.get("/formulas/{formula_id}", response_model=FormulaOut, summary="One formula")
    def one_formula(formula_id: str) -> Answer:
        return json_body(describe(found(formula_id)))

    @routes.get(
        "/formulas/{formula_id}/curve",
        response_model=FormulaCurveOut,
        summary="A formula over its own abscissa",
    )
    def curve(formula_id: str, query: Annotated[FormulaCurveQuery, Query()]) -> Answer:
        formula = found(formula_id)
        return Large(curve_of, formula, interface_of(formula, query), query)

    return routes
