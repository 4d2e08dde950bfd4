"""Every error as an RFC 9457 problem, in one shape."""

from collections.abc import Callable, Mapping, Sequence
from difflib import get_close_matches
from http import HTTPStatus
from typing import Any, TypedDict

import orjson
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel, Field
from pydantic.json_schema import models_json_schema
from starlette.exceptions import HTTPException
from starlette.responses import Response

from app.optics.errors import OpticsError
from app.optics.meant import in_our_unit
from app.server.pool import Overloaded

MEDIA_TYPE = "application/problem+json"

EXPOSED_HEADERS = ["ETag", "Interpolation-Error", "X-Request-ID"]
"""What pages of other origins may read beside the body."""

_COMPONENT = "#/components/schemas/{model}"
MOST_ERRORS = 20
"""Errors that one answer lists."""

_LONGEST_VALUE = 200


class ParameterError(TypedDict):
    """One offending parameter."""

    parameter: str
    value: object
    message: str


class ParameterProblem(BaseModel):
    """What is wrong with one parameter."""

    parameter: str = Field(description="Its name, as it is spelled in the address.")
    value: Any = Field(description="What was given.")
    message: str = Field(description="What is wrong, and what is allowed.")


class Problem(BaseModel):
    """An error, as RFC 9457 (application/problem+json) lays it out."""

    type: str = Field(description="URI of the kind of problem; about:blank says as much as status.")
    title: str = Field(description="The kind of problem in a few words.")
    status: int = Field(description="HTTP status.")
    detail: str = Field(description="What is wrong and what would be right.")
    instance: str = Field(description="Path of the request.")
    errors: list[ParameterProblem] = Field(description="One entry an offending parameter.")


def problem_as(description: str) -> dict[str, Any]:
    """Describe a problem in OpenAPI; `schemas` holds what it refers to."""
    schema = {"$ref": _COMPONENT.format(model=Problem.__name__)}
    return {"description": description, "content": {MEDIA_TYPE: {"schema": schema}}}


def schemas() -> dict[str, Any]:
    """The components of OpenAPI that describe a problem."""
    _, told = models_json_schema([(Problem, "serialization")], ref_template=_COMPONENT)
    defined: dict[str, Any] = told["$defs"]
    return defined


class ProblemResponse(Response):
    """A problem as it is sent, which says within the process what it is about."""

    detail: str


def problem_response(
    request: Request,
    status: int,
    detail: str,
    errors: Sequence[ParameterError] = (),
    headers: dict[str, str] | None = None,
) -> ProblemResponse:
    """Build the answer for an error.

    The path is the scope's: `request.url` takes the query apart, which may be no UTF-8.
    """
    body = {
        "type": "about:blank",
        "title": HTTPStatus(status).phrase,
        "status": status,
        "detail": detail,
        "instance": request.scope["path"],
        "errors": list(errors),
    }
    response = ProblemResponse(orjson.dumps(body), status, headers, MEDIA_TYPE)
    response.detail = detail
    return response


class BadParameters(Exception):
    """Parameters that were refused by the API itself; each error names its parameter."""

    def __init__(self, *errors: ParameterError) -> None:
        super().__init__(errors)
        self.errors = errors


class MissingResource(Exception):
    """A path that names nothing; the cause says what comes nearest."""

    def __init__(self, cause: OpticsError) -> None:
        super().__init__(cause)
        self.cause = cause


def unknown_parameter(name: str, value: object, known: Sequence[str]) -> ParameterError:
    """Describe a parameter that the endpoint does not take, with the nearest that it does."""
    if not known:
        return {"parameter": name, "value": value, "message": "this route takes no parameters"}
    nearest = get_close_matches(name, known, n=3, cutoff=0.5)
    if converted := in_our_unit(name, known, value):
        return {"parameter": name, "value": value, "message": f"unknown parameter; {converted}"}
    hint = f"nearest: {', '.join(nearest)}" if nearest else f"known: {', '.join(known)}"
    return {"parameter": name, "value": value, "message": f"unknown parameter; {hint}"}


def _refused(request: Request, status: int, errors: Sequence[ParameterError]) -> ProblemResponse:
    shown: list[ParameterError] = [
        {
            "parameter": _clipped(e["parameter"]),
            "value": _clipped(e["value"]),
            "message": e["message"],
        }
        for e in errors[:MOST_ERRORS]
    ]
    detail = "; ".join(f"{_given(e)}: {e['message']}" for e in shown)
    if len(errors) > MOST_ERRORS:
        detail += "; and more"
    return problem_response(request, status, detail, shown)


def _given(error: ParameterError) -> str:
    """The parameter with its value, where it was given one."""
    name, value = error["parameter"], error["value"]
    return name if value is None else f"{name} = {value}"


def _clipped(value: Any) -> Any:
    """Shorten what a client sent, so that an answer is not a multiple of a hostile request."""
    if isinstance(value, str) and len(value) > _LONGEST_VALUE:
        return f"{value[:_LONGEST_VALUE]}\N{HORIZONTAL ELLIPSIS}"
    if isinstance(value, list):
        return [_clipped(item) for item in value[:MOST_ERRORS]]
    return value


def _on_bad_parameters(request: Request, error: BadParameters) -> ProblemResponse:
    return _refused(request, 422, error.errors)


def told_by(error: Mapping[str, Any]) -> str:
    """The words of one of pydantic's errors, without what it puts before those of a validator."""
    message: str = error["msg"]
    return message.removeprefix("Value error, ")


def _on_validation(request: Request, error: RequestValidationError) -> ProblemResponse:
    return _refused(
        request,
        422,
        [
            {
                "parameter": ".".join(str(part) for part in e["loc"][1:]) or str(e["loc"][0]),
                "value": e.get("input"),
                "message": told_by(e),
            }
            for e in error.errors()
        ],
    )


def given(error: OpticsError) -> str | None:
    """What was given, as it is written in an address."""
    return None if error.value is None else str(error.value).removesuffix(".0")


def parameter_error(error: OpticsError) -> ParameterError:
    """What is wrong with the parameter that the core refused."""
    return {"parameter": error.parameter, "value": given(error), "message": error.allowed}


def _on_optics(request: Request, error: OpticsError) -> ProblemResponse:
    return _refused(request, 422, [parameter_error(error)])


def _on_missing(request: Request, error: MissingResource) -> ProblemResponse:
    return _refused(request, 404, [parameter_error(error.cause)])


def _on_overload(request: Request, error: Overloaded) -> ProblemResponse:
    detail = f"the server has no time for this now: {error.limit}; try again later"
    return problem_response(request, 503, detail, headers={"Retry-After": str(error.retry_after_s)})


def _on_http(request: Request, error: HTTPException) -> ProblemResponse:
    headers = dict(error.headers) if error.headers else None
    detail = error.detail
    if error.status_code == 404 and detail == HTTPStatus.NOT_FOUND.phrase:
        detail = f"nothing is at {request.scope['path']}; the API is described at /docs"
    if error.status_code == 405:
        if headers and "GET" in headers.get("Allow", "").split(", "):
            headers["Allow"] = "GET, HEAD"
        detail = f"{request.method} is not answered at {request.scope['path']}"
    return problem_response(request, error.status_code, detail, headers=headers)


def _on_crash(request: Request, _: Exception) -> ProblemResponse:
    return problem_response(request, 500, "the server failed; the fault was logged")


_ANSWERS: dict[type[Exception], Callable[[Request, Any], ProblemResponse]] = {
    BadParameters: _on_bad_parameters,
    RequestValidationError: _on_validation,
    OpticsError: _on_optics,
    MissingResource: _on_missing,
    Overloaded: _on_overload,
    HTTPException: _on_http,
}

PROBLEMS = tuple(_ANSWERS)
"""What is raised for a request that cannot be answered."""


def problem_of(request: Request, error: Exception) -> ProblemResponse:
    """Answer a request that one of `PROBLEMS` was raised for; anything else is a crash."""
    kind = next((kind for kind in type(error).__mro__ if kind in _ANSWERS), None)
    return _on_crash(request, error) if kind is None else _ANSWERS[kind](request, error)


def install(app: FastAPI) -> None:
    """Answer every error of `app` as a problem."""

    async def answer(request: Request, error: Exception) -> ProblemResponse:
        return problem_of(request, error)

    for kind in (*PROBLEMS, Exception):
        app.exception_handler(kind)(answer)
