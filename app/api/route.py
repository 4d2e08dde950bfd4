"""The route class of the API: strict queries, validated once, without FastAPI's per-field work."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Coroutine, Mapping
from itertools import islice
from typing import Any

from annotated_types import Ge, Le
from fastapi import Request
from fastapi.routing import APIRoute
from pydantic import BaseModel, ValidationError
from pydantic.fields import FieldInfo
from starlette.responses import Response

from app.api.problems import MOST_ERRORS, BadParameters, ParameterError, unknown_parameter


class QueryRoute(APIRoute):
    """A GET route whose endpoint takes the request, path parameters and one query model.

    Unknown and repeated parameters are refused, so that nothing a client sends is lost, and the
    query is validated by pydantic in one step, where FastAPI would take it apart field by field in
    Python. OpenAPI is FastAPI's own, from the endpoint's signature.
    """

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Build the function that answers a request."""
        endpoint, dependant = self.dependant.call, self.dependant
        if endpoint is None or dependant.request_param_name is None or dependant.body_params:
            raise TypeError(f"{self.path}: a QueryRoute takes the request and no body")
        request_name = dependant.request_param_name
        query_name, model = None, None
        fields: Mapping[str, FieldInfo] = {}
        for parameter in dependant.query_params:
            query_name, model = parameter.name, parameter.field_info.annotation
            if not (isinstance(model, type) and issubclass(model, BaseModel)):
                raise TypeError(f"{self.path}: {query_name} must be a query model")
            fields = {info.alias or name: info for name, info in model.model_fields.items()}

        async def answer(request: Request) -> Response:
            given = request.query_params.multi_items()
            refuse_unknown_and_repeated(given, fields)
            arguments: dict[str, Any] = {request_name: request, **request.path_params}
            if query_name is not None and model is not None:
                try:
                    arguments[query_name] = model.model_validate(dict(given))
                except ValidationError as error:
                    raise BadParameters(*explain(error, fields)) from None
            response: Response = await endpoint(**arguments)
            return response

        return answer


def refuse_unknown_and_repeated(
    given: list[tuple[str, str]], fields: Mapping[str, FieldInfo]
) -> None:
    """Refuse names that are not among `fields` and those given more than once.

    Raises
    ------
    BadParameters
        Naming each of them, or as many as an answer lists.
    """
    values: defaultdict[str, list[str]] = defaultdict(list)
    for name, value in given:
        values[name].append(value)
    unknown = (pair for pair in given if pair[0] not in fields)
    repeated = (pair for pair in values.items() if len(pair[1]) > 1)
    # Thousands of wrong names are not worth looking for what comes nearest to each.
    errors: list[ParameterError] = [
        unknown_parameter(name, value, list(fields)) for name, value in islice(unknown, MOST_ERRORS)
    ]
    errors += [
        {"parameter": name, "value": both, "message": "given more than once"}
        for name, both in islice(repeated, MOST_ERRORS)
    ]
    if errors:
        raise BadParameters(*errors)


def explain(error: ValidationError, fields: Mapping[str, FieldInfo]) -> list[ParameterError]:
    """Turn pydantic's errors into ours: the parameter, its value and the whole range allowed."""
    return [
        {
            "parameter": str(e["loc"][0]),
            "value": e["input"],
            "message": e["msg"] + _range(fields[str(e["loc"][0])]),
        }
        for e in error.errors(include_url=False, include_context=False)
    ]


def _range(field: FieldInfo) -> str:
    low = next((m.ge for m in field.metadata if isinstance(m, Ge)), None)
    high = next((m.le for m in field.metadata if isinstance(m, Le)), None)
    return "" if low is None or high is None else f"; allowed: {low} to {high}"
