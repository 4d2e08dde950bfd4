"""The page's files, with the cache and security headers they need."""

from __future__ import annotations

import os
from collections.abc import Mapping, MutableMapping
from functools import lru_cache
from mimetypes import guess_type
from pathlib import Path
from typing import Any

from anyio import to_thread
from starlette.exceptions import HTTPException
from starlette.responses import Response
from starlette.staticfiles import PathLike, StaticFiles
from starlette.types import Receive, Scope, Send

from app.http.body import Effort, EncodedBody, Headers
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


def document_headers(query: bytes) -> Mapping[str, str]:
    """Security headers of the page that was asked for with a query."""
    return (
        EMBEDDED_SECURITY_HEADERS if b"embed=1" in query.split(b"&") else DOCUMENT_SECURITY_HEADERS
    )


_UNDERSTOOD = {".css", ".js"}

# What compression gains nothing on is left to the file system.
_TEXT = {".css", ".html", ".js", ".json", ".svg", ".txt", ".webmanifest"}


class Page(StaticFiles):
    """Static files: text is compressed once, vendored files never change under their path.

    Parameters
    ----------
    directory
        The folder of the files.
    made
        Scripts that stand beside them without being files, by name.
    """

    def __init__(self, directory: Path, made: Mapping[str, bytes] | None = None) -> None:
        super().__init__(directory=directory, html=True)
        self._made = made or {}
        self._scripts = {name: _script(script) for name, script in self._made.items()}

    async def get_response(self, path: str, scope: MutableMapping[str, Any]) -> Response:
        """Answer with a file; what cannot name a file is not found."""
        if path in self._scripts and scope["method"] in {"GET", "HEAD"}:
            return _Text(self._scripts[path])
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
                script = service_worker(Path(str(self.directory)).resolve(), self._made)
                return _Text(_script(script, "quick"))
            return _Text(_encoded(path, stat_result.st_mtime_ns, cache_control))
        response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = cache_control
        return response


class _Text(Response):
    """A file in the encoding that the client asks for; what takes long is made in a thread."""

    def __init__(self, encoded: EncodedBody) -> None:
        super().__init__()
        self._encoded = encoded

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        coding = self._encoded.coding(scope["headers"])
        if self._encoded.takes_long(coding):
            await to_thread.run_sync(self._encoded.encoded, coding)
        self.status_code, self.raw_headers, self.body = self._encoded.reply(
            scope["headers"], coding
        )
        await super().__call__(scope, receive, send)


def _headers(media_type: str, cache_control: str) -> Headers:
    return [
        (b"content-type", media_type.encode()),
        (b"cache-control", cache_control.encode()),
    ]


def _script(script: bytes, effort: Effort = "thorough") -> EncodedBody:
    return EncodedBody(script, _headers("text/javascript; charset=utf-8", "no-cache"), effort)


@lru_cache(maxsize=512)
def _encoded(path: Path, _mtime_ns: int, cache_control: str) -> EncodedBody:
    """A text file to be sent; read again when it has changed."""
    media_type = guess_type(path.name)[0] or "text/plain"
    # Scripts and styles are read as UTF-8 in our documents without being told so in each answer.
    if media_type.startswith("text/") and path.suffix not in _UNDERSTOOD:
        media_type += "; charset=utf-8"
    headers = _headers(media_type, cache_control)
    return EncodedBody(path.read_bytes(), headers, effort="thorough")
