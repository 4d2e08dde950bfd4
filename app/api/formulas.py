"""`/formulas`: everything that is registered as a formula, explained, and its curve."""

from typing import Annotated, Any, Literal

from fastapi import APIRouter, Query
from pydantic import Field

from app.answers.answer import answer
from app.answers.formulas import ExplainedFormula, FormulaCurve
from app.http.problems import BadParameters, MissingResource, ParameterError
from app.http.query import Count, LongQuery, Number, QueryModel, TableQuery
from app.http.route import LastingRoute
from app.optics.formulas.collection import Formulas, UnknownFormula
from app.optics.formulas.formula import Formula
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


class FormulaCurveQuery(LongQuery, TableQuery):
    """A formula over its own abscissa."""

    n_i: Number | None = _unless_given(N_I)
    n_t: Number | None = _unless_given(N_T)
    k_t: Number | None = _unless_given(K_T)
    samples: Count = Field(
        181, ge=2, le=MAX_CURVE_SAMPLES, description="Equally spaced points, both ends included."
    )


@answer
class ExplainedFormulas:
    """All formulas."""

    formulas: list[ExplainedFormula]


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


def router(registry: Registry) -> APIRouter:
    """Routes over the formulas of everything that is registered."""
    routes = APIRouter(route_class=LastingRoute, tags=["formulas"])
    formulas = Formulas(registry)

    def found(formula_id: str) -> Formula:
        try:
            return formulas.find(formula_id)
        except UnknownFormula as error:
            raise MissingResource(error) from None

    @routes.get("/formulas", summary="All formulas, explained")
    def all_formulas(query: Annotated[FormulasQuery, Query()]) -> ExplainedFormulas:
        shown = [formula for formula in formulas.values() if query.kind in (None, formula.kind)]
        return ExplainedFormulas(formulas=[ExplainedFormula.of(formula) for formula in shown])

    @routes.get("/formulas/{formula_id}", summary="One formula")
    def one_formula(formula_id: str) -> ExplainedFormula:
        return ExplainedFormula.of(found(formula_id))

    @routes.get("/formulas/{formula_id}/curve", summary="A formula over its own abscissa")
    def curve(formula_id: str, query: Annotated[FormulaCurveQuery, Query()]) -> FormulaCurve:
        formula = found(formula_id)
        return FormulaCurve.of(formula, interface_of(formula, query), query.samples)

    return routes
