"""How requests reach their route: the page after all of the API, HEAD by the way of GET."""

from __future__ import annotations

from starlette.middleware.cors import CORSMiddleware
from starlette.routing import Match, Mount
from starlette.types import ASGIApp, Message, Receive, Scope, Send


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
        scope.update({key: inner[key] for key in ("route", "path_params") if key in inner})


class OpenToOtherPages:
    """ASGI middleware that opens addresses to any page, and leaves all others alone.

    The page's own files need no such headers, and it consists of dozens of them.
    """

    def __init__(self, app: ASGIApp, prefixes: tuple[str, ...]) -> None:
        self.app = app
        self.prefixes = prefixes
        self.opened = CORSMiddleware(
            app,
            allow_origins=["*"],
            allow_methods=["GET", "HEAD", "POST"],
            allow_headers=["Content-Type", "If-None-Match", "X-Request-ID"],
            expose_headers=["ETag", "Interpolation-Error", "X-Request-ID"],
        )

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, and what the address deserves back."""
        is_open = scope["type"] == "http" and scope["path"].startswith(self.prefixes)
        await (self.opened if is_open else self.app)(scope, receive, send)
