"""The route class of the API: strict queries, validated once, and endpoints that are pure functions."""

from collections import defaultdict
from collections.abc import Callable, Coroutine, Mapping
from contextlib import AsyncExitStack
from itertools import islice
from typing import Any, get_args
from urllib.parse import parse_qsl

from annotated_types import Ge, Le
from fastapi import Request
from fastapi.dependencies.models import Dependant
from fastapi.dependencies.utils import solve_dependencies
from fastapi.exceptions import RequestValidationError
from fastapi.routing import APIRoute
from pydantic import ValidationError
from pydantic.fields import FieldInfo
from starlette.responses import Response

from app.http.body import Effort
from app.http.problems import (
    MOST_ERRORS,
    BadParameters,
    ParameterError,
    told_by,
    unknown_parameter,
)
from app.http.query import QueryModel
from app.http.serving import ClientGone, Serving, Unsent
from app.http.writing import write
from app.optics.meant import instead

_NOT_MODIFIED = {"description": "The client has the answer: If-None-Match names its ETag."}
_CSV_AS_WELL = {"content": {"text/csv": {"schema": {"type": "string"}}}}


class QueryRoute(APIRoute):
    """A GET route whose endpoint takes path parameters and one query model, and is a pure function.

    Unknown and repeated parameters are refused, so that nothing a client sends is lost, and the
    query is validated by pydantic in one step, where FastAPI would take it apart field by field in
    Python. What the endpoint returns is written by `app.http.writing`, as the query's `format` and
    `digits` say; what the query says takes long is computed in a thread, once for all who ask at
    the same time. OpenAPI is FastAPI's own, from the endpoint's signature.
    """

    lifetime: bytes | None = None
    """How long answers may be kept, as Cache-Control says it; unless given, as the server does."""

    effort: Effort = "quick"
    """How hard answers are compressed; those that stay the same while the program runs, thoroughly."""

    def __init__(
        self,
        path: str,
        endpoint: Callable[..., Any],
        *,
        responses: Mapping[int | str, dict[str, Any]] | None = None,
        **options: Any,
    ) -> None:
        told = {304: _NOT_MODIFIED, **(responses or {})}
        super().__init__(path, endpoint, responses=told, **options)
        if "format" in self._fields and "csv" in get_args(self._fields["format"].annotation):
            self.responses.setdefault(200, _CSV_AS_WELL)

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Answer requests by the endpoint; its signature is read here."""
        if self.methods != {"GET"} or self.dependant.body_params:
            raise TypeError(f"{self.path}: a QueryRoute answers GET and takes no body")
        self._query_name: str | None = None
        self._model: type[QueryModel] | None = None
        self._fields: Mapping[str, FieldInfo] = {}
        for parameter in self.dependant.query_params:
            model = parameter.field_info.annotation
            if not (isinstance(model, type) and issubclass(model, QueryModel)):
                raise TypeError(f"{self.path}: {parameter.name} must be a query model")
            self._query_name, self._model = parameter.name, model
            self._fields = {info.alias or name: info for name, info in model.model_fields.items()}

        async def handle(request: Request) -> Response:
            await self._meet_dependencies(request)
            scope = request.scope
            serving: Serving = scope["app"].state.serving
            query = self.read(scope["query_string"])
            lifetime = self.lifetime or serving.lifetime

            def work() -> Response:
                response = self.written(scope["path_params"], query)
                response.raw_headers.append((b"cache-control", lifetime))
                return response

            scope["effort"] = "thorough" if query is not None and query.lasts else self.effort
            if query is None:
                return work()
            query.refuse_beyond(serving.max_samples, serving.max_cells)
            if query.takes_long:
                try:
                    key = scope["path"], scope["query_string"]
                    return await serving.shared(
                        key, work, request.receive, is_picture=query.is_picture
                    )
                except ClientGone:
                    return Unsent()
            return work()

        return handle

    async def _meet_dependencies(self, request: Request) -> None:
        """Run what a route, a router or an application depends on, as FastAPI does before endpoints."""
        # Where this route was included, with what dependencies, FastAPI leaves in the scope.
        included = request.scope.get("fastapi", {}).get("effective_route_context", self)
        if not included.dependant.dependencies:
            return
        async with AsyncExitStack() as stack:
            solved = await solve_dependencies(
                request=request,
                dependant=Dependant(dependencies=included.dependant.dependencies),
                dependency_overrides_provider=self.dependency_overrides_provider,
                async_exit_stack=stack,
                embed_body_fields=False,
            )
        if solved.errors:
            raise RequestValidationError(solved.errors)

    @property
    def query_model(self) -> type[QueryModel] | None:
        """What the query is read into; None for a route without parameters."""
        return self._model

    def read(self, query: bytes) -> QueryModel | None:
        """Validate a query string; None for a route without parameters.

        Raises
        ------
        BadParameters
            Naming every parameter that is wrong.
        """
        given = parse_qsl(query.decode("latin-1"), keep_blank_values=True)
        values = dict(given)
        if len(values) < len(given) or not values.keys() <= self._fields.keys():
            refuse_unknown_and_repeated(given, self._fields)
        if self._model is None:
            return None
        try:
            return self._model.model_validate(values)
        except ValidationError as error:
            raise BadParameters(*explain(error, self._fields)) from None

    def answer(self, path: Mapping[str, str], query: QueryModel | None) -> Any:
        """Call the endpoint with the parts of the path and the query that `read` returned."""
        named = {} if self._query_name is None else {self._query_name: query}
        return self.endpoint(**path, **named)

    def written(self, path: Mapping[str, str], query: QueryModel | None) -> Response:
        """Write what the endpoint answers in the way that the query asks for."""
        answer = self.answer(path, query)
        return write(answer, getattr(query, "format", "json"), getattr(query, "digits", 17))


class LastingRoute(QueryRoute):
    """A route whose answers stay the same while the program runs, and are many: most of a page."""

    effort = "thorough"


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
    told: list[ParameterError] = []
    for e in error.errors(include_url=False, include_context=False):
        name = str(e["loc"][0])
        # Of a parameter that was left out pydantic's input is all that was given.
        value = None if e["type"] == "missing" else e["input"]
        message = instead(name, value) or told_by(e) + _range(fields[name])
        told.append({"parameter": name, "value": value, "message": message})
    return told


def _range(field: FieldInfo) -> str:
    low = next((m.ge for m in field.metadata if isinstance(m, Ge)), None)
    high = next((m.le for m in field.metadata if isinstance(m, Le)), None)
    return "" if low is None or high is None else f"; allowed: {low} to {high}"
