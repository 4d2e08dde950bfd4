"""The page's files, with the cache and security headers they need."""

from __future__ import annotations

import os
from collections.abc import MutableMapping
from functools import lru_cache
from mimetypes import guess_type
from pathlib import Path
from typing import Any

from starlette.datastructures import MutableHeaders
from starlette.exceptions import HTTPException
from starlette.responses import Response
from starlette.staticfiles import PathLike, StaticFiles
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.http.body import Headers, ReadyBody
from app.page.comments import without_comments
from app.page.service_worker import SCRIPT, service_worker

_CONTENT_SECURITY_POLICY = "; ".join(
    [
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "style-src-elem 'self'",
        "style-src-attr 'unsafe-inline'",  # Plotly and KaTeX place their parts by style attributes
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "connect-src 'self'",
        "worker-src 'self'",
        "manifest-src 'self'",
        "form-action 'none'",
        "base-uri 'none'",
    ]
)

SECURITY_HEADERS = {"X-Content-Type-Options": "nosniff"}
"""On every answer."""

DOCUMENT_SECURITY_HEADERS = {
    "Content-Security-Policy": f"{_CONTENT_SECURITY_POLICY}; frame-ancestors 'none'",
    "Referrer-Policy": "no-referrer",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=()",
    "Cross-Origin-Opener-Policy": "same-origin",
}
"""On documents; browsers heed them on nothing else, and the page consists of many small files."""

EMBEDDED_SECURITY_HEADERS = DOCUMENT_SECURITY_HEADERS | {
    "Content-Security-Policy": f"{_CONTENT_SECURITY_POLICY}; frame-ancestors *"
}
"""On the page without its shell (`?embed=1`), which may stand in any other page."""


class SecurityHeaders:
    """ASGI middleware that adds the security headers to answers that have none of their own."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on and the answer back."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                document = headers.get("content-type", "").startswith("text/html")
                added = SECURITY_HEADERS | (_of_document(scope) if document else {})
                for name, value in added.items():
                    headers.setdefault(name, value)
            await send(message)

        await self.app(scope, receive, send_with_headers)


def _of_document(scope: Scope) -> dict[str, str]:
    embedded = b"embed=1" in scope["query_string"].split(b"&")
    return EMBEDDED_SECURITY_HEADERS if embedded else DOCUMENT_SECURITY_HEADERS


_UNDERSTOOD = {".css", ".js"}

# What compression gains nothing on is left to the file system.
_TEXT = {".css", ".html", ".js", ".json", ".svg", ".txt", ".webmanifest"}


class Page(StaticFiles):
    """Static files: text is compressed once, vendored files never change under their path."""

    def __init__(self, directory: Path) -> None:
        super().__init__(directory=directory, html=True)

    async def get_response(self, path: str, scope: MutableMapping[str, Any]) -> Response:
        """Answer with a file; what cannot name a file is not found."""
        try:
            return await super().get_response(path, scope)
        except (ValueError, OSError):  # a NUL byte or a name longer than the file system takes
            raise HTTPException(404) from None

    def file_response(
        self,
        full_path: PathLike,
        stat_result: os.stat_result,
        scope: Scope,
        status_code: int = 200,
    ) -> Response:
        """Send a file: vendored ones may be kept for ever, our own are asked after every time."""
        path = Path(full_path)
        parts = path.relative_to(Path(str(self.directory)).resolve()).parts
        vendored = parts[0] == "vendor" and path.name != "manifest.json"
        cache_control = "public, max-age=31536000, immutable" if vendored else "no-cache"
        if path.suffix in _TEXT and status_code == 200:
            if parts == (SCRIPT,):
                script = service_worker(Path(str(self.directory)).resolve())
                ready = ReadyBody(script, "text/javascript; charset=utf-8")
            else:
                ready = _ready(path, stat_result.st_mtime_ns, vendored)
            kept: Headers = [(b"cache-control", cache_control.encode())]
            response = Response()
            response.status_code, response.raw_headers, response.body = ready.reply(
                scope["headers"], kept, ready.coding(scope["headers"])
            )
            return response
        response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = cache_control
        return response


@lru_cache(maxsize=512)
def _ready(path: Path, _mtime_ns: int, vendored: bool) -> ReadyBody:
    """A text file to be sent, our own without comments; read again when it has changed."""
    media_type = guess_type(path.name)[0] or "text/plain"
    # Scripts and styles are read as UTF-8 in our documents without being told so in each answer.
    if media_type.startswith("text/") and path.suffix not in _UNDERSTOOD:
        media_type += "; charset=utf-8"
    text = path.read_bytes()
    if not vendored:
        text = without_comments(text, path.suffix)
    return ReadyBody(text, media_type, effort="thorough")
