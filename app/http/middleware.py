"""How requests reach their route: which hosts and origins, HEAD by the way of GET, the page last."""

import re
from collections.abc import Callable, Collection, Mapping

from starlette.datastructures import Headers
from starlette.middleware.cors import CORSMiddleware
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Match, Mount
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.http.problems import EXPOSED_HEADERS, MEDIA_TYPE, problem_response


class Fallback(Mount):
    """A mount that answers only what no route knows, not even with another method.

    An ordinary mount at / takes a POST to a route that has GET, and calls it a missing file.
    """

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        """Match in part at most, which every route before it does better or as well."""
        match, child_scope = super().matches(scope)
        return (Match.PARTIAL if match is Match.FULL else match), child_scope


class HeadAsGet:
    """ASGI middleware that answers HEAD as GET without the body (RFC 9110, section 9.3.2)."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on and the answer back."""
        if scope["type"] != "http" or scope["method"] != "HEAD":
            await self.app(scope, receive, send)
            return

        async def send_without_body(message: Message) -> None:
            if message["type"] == "http.response.body":
                message = {**message, "body": b""}
            await send(message)

        inner = {**scope, "method": "GET"}
        await self.app(inner, receive, send_without_body)
        for key in ("route", "path_params", "cache"):  # for the log
            if key in inner:
                scope[key] = inner[key]


class KnownHosts:
    """ASGI middleware that answers for some hosts only: an answer to another may be a trap.

    Parameters
    ----------
    app
        The application.
    hosts
        Their names in lower case, without a port; `*.example.org` stands for all below `example.org`.
    open_to_all
        Beginnings of paths that are answered under any name.
    """

    def __init__(self, app: ASGIApp, hosts: Collection[str], open_to_all: tuple[str, ...]) -> None:
        self.app = app
        self.open_to_all = open_to_all
        self.exact = {host for host in hosts if not host.startswith("*.")}
        self.endings = tuple(host[1:] for host in hosts if host.startswith("*."))

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on if it was meant for this server."""
        if scope["type"] == "http" and not scope["path"].startswith(self.open_to_all):
            sent = Headers(scope=scope).get("host", "")
            name = re.sub(r":\d*$", "", sent).lower()
            if name not in self.exact and not name.endswith(self.endings or ("\0",)):
                detail = f"{sent[:200]!r} is not answered for here (FRESNEL_ALLOWED_HOSTS)"
                await problem_response(Request(scope), 421, detail)(scope, receive, send)
                return
        await self.app(scope, receive, send)


class _Cors(CORSMiddleware):
    """Starlette's, with a problem where it refuses a preflight in plain text."""

    def preflight_response(self, request_headers: Headers) -> Response:
        """Answer a preflight."""
        response = super().preflight_response(request_headers)
        if response.status_code < 400:
            return response
        said = bytes(response.body).decode()
        return _Refusal(f"{said}; allowed from any origin: {', '.join(self.allow_methods)}")


class _Refusal(Response):
    def __init__(self, detail: str) -> None:
        super().__init__(status_code=400)
        self.detail = detail

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        problem = problem_response(Request(scope), self.status_code, self.detail)
        await problem(scope, receive, send)


class CommonHeaders:
    """ASGI middleware that adds what every answer carries.

    Nosniff on all; on the API and on problems that any page of any origin may read them; on documents
    the policy that `documents` gives for a query.

    Parameters
    ----------
    app
        The application.
    api
        What the paths of the API start with.
    documents
        The headers of a document that was asked for with a query.
    """

    def __init__(
        self,
        app: ASGIApp,
        *,
        api: tuple[str, ...],
        documents: Callable[[bytes], Mapping[str, str]],
    ) -> None:
        self.app = app
        self._api = api
        self._documents = documents
        self._preflight = _Cors(
            app,
            allow_origins=["*"],
            allow_methods=["GET", "HEAD", "POST"],
            allow_headers=["Content-Type", "If-None-Match", "X-Request-ID"],
        )

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, and the answer back with its headers."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        is_api = scope["path"].removeprefix(scope["root_path"]).startswith(self._api)

        is_preflight = is_api and scope["method"] == "OPTIONS"

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                given = message.get("headers", ())
                named = dict(given)
                kind = named.get(b"content-type", b"")
                added = dict(_ON_ALL)
                if (is_api and not is_preflight) or kind == _PROBLEM:
                    added |= _ON_API
                if kind.startswith(b"text/html"):
                    documents = self._documents(scope["query_string"])
                    added |= {n.lower().encode(): v.encode() for n, v in documents.items()}
                more = [(name, value) for name, value in added.items() if name not in named]
                message = {**message, "headers": [*given, *more]}
            await send(message)

        if is_preflight:
            await self._preflight(scope, receive, send_with_headers)
        else:
            await self.app(scope, receive, send_with_headers)


_PROBLEM = MEDIA_TYPE.encode()

_ON_ALL = {b"x-content-type-options": b"nosniff"}

# Sent to everybody: a cache would hand an answer without them to a page of another origin.
_ON_API = {
    b"access-control-allow-origin": b"*",
    b"access-control-expose-headers": ", ".join(EXPOSED_HEADERS).encode(),
}
