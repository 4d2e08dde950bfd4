"""The page's files, with the cache and security headers they need."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, MutableMapping
from functools import lru_cache
from mimetypes import guess_type
from pathlib import Path
from time import monotonic
from typing import Any
from urllib.parse import quote

from anyio import to_thread
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.staticfiles import PathLike, StaticFiles
from starlette.types import Message, Receive, Scope, Send

from app.http.body import EncodedBody, Headers
from app.http.encoded import Encoded
from app.http.problems import problem_response
from app.page.document import NAME, Document
from app.page.first_picture import FirstPicture
from app.page.packed import FOLDER, MANIFEST, Packed
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
_LOOKS_AFTER_S = 1.0
"""How long the service worker's list of files is taken to be what it was."""

_MEDIA_TYPES = {".map": "application/json"}
_TEXT = {".css", ".html", ".js", ".json", ".map", ".svg", ".txt", ".webmanifest"}


class Page(StaticFiles):
    """Static files: text is compressed once, vendored files never change under their path.

    Parameters
    ----------
    directory
        The folder of the files.
    made
        Scripts that stand beside them without being files, by name.
    picture
        Draws the state in an address, for the document to start with.
    packed
        The files that stand in the document in place of its sources.
    """

    def __init__(
        self,
        directory: Path,
        made: Mapping[str, bytes] | None = None,
        picture: Callable[[bytes], FirstPicture | None] = lambda _: None,
        packed: Packed | None = None,
    ) -> None:
        super().__init__(directory=directory, html=True)
        self._made = made or {}
        self._packed = packed
        self._document = Document(directory, picture, packed.replaced if packed else {})
        self._script: tuple[bytes, EncodedBody] | None = None
        self._looked_at = 0.0
        self._scripts = {name: _script(script) for name, script in self._made.items()}

    async def get_response(self, path: str, scope: MutableMapping[str, Any]) -> Response:
        """Answer with a file; what cannot name a file is not found."""
        if path in self._scripts and scope["method"] in {"GET", "HEAD"}:
            return Encoded(self._scripts[path])
        try:
            if path == SCRIPT and scope["method"] in {"GET", "HEAD"}:
                return Encoded(await self._worker())
            if path in {".", NAME} and scope["method"] in {"GET", "HEAD"}:
                # By its name the document shows nothing yet: so it is kept for any address.
                query = scope["query_string"] if path == "." else None
                return Encoded(await to_thread.run_sync(self._document.body, query))
            response = await super().get_response(path, scope)
            if isinstance(response, RedirectResponse):  # to a folder's own address
                response.headers["Location"] = _below(scope)
            return response
        except (ValueError, OSError):  # a NUL byte or a name longer than the file system takes
            raise HTTPException(404) from None

    async def _worker(self) -> EncodedBody:
        """The service worker's script; whether a file has changed is looked for now and then."""
        if self._script is None or monotonic() - self._looked_at > _LOOKS_AFTER_S:
            self._looked_at = monotonic()
            directory = Path(str(self.directory)).resolve()
            script = await to_thread.run_sync(
                service_worker, directory, self._made, self._packed is not None
            )
            if self._script is None or self._script[0] != script:
                self._script = script, _script(script)
        return self._script[1]

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
        vendored = parts[0] in {"vendor", FOLDER} and path.name != Path(MANIFEST).name
        cache_control = "public, max-age=31536000, immutable" if vendored else "no-cache"
        if path.suffix in _TEXT and status_code == 200:
            return Encoded(_encoded(path, stat_result.st_mtime_ns, cache_control))
        response = super().file_response(full_path, stat_result, scope, status_code)
        response.headers["Cache-Control"] = cache_control
        return _File(response) if isinstance(response, FileResponse) else response


class _File(Response):
    """A file that may be asked for in parts; a part that is not there is a problem."""

    def __init__(self, file: Response) -> None:
        super().__init__()
        self._file = file

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send it."""
        # A unit that is not understood is ignored (RFC 9110, section 14.2).
        kept = [
            (name, value)
            for name, value in scope["headers"]
            if name != b"range" or value.lower().startswith(b"bytes=")
        ]
        refused: Message | None = None

        async def send_problem(message: Message) -> None:
            nonlocal refused
            if message["type"] == "http.response.start" and message["status"] >= 400:
                refused = message
            elif refused is None:
                await send(message)
            elif not message.get("more_body", False):
                said = message["body"].decode() or "no such part is there"
                ranges = {n.decode(): v.decode() for n, v in refused["headers"] if n in _RANGE}
                problem = problem_response(
                    Request(scope), refused["status"], f"Range: {said}", headers=ranges
                )
                await problem(scope, receive, send)

        await self._file({**scope, "headers": kept}, receive, send_problem)


_RANGE = {b"content-range", b"accept-ranges"}


def _headers(media_type: str, cache_control: str) -> Headers:
    return [
        (b"content-type", media_type.encode()),
        (b"cache-control", cache_control.encode()),
    ]


def _below(scope: MutableMapping[str, Any]) -> str:
    """The address of a folder, beside its own without a slash: whichever host and scheme that has."""
    query = scope["query_string"].decode("latin-1")
    name = quote(scope["path"].rpartition("/")[2])
    return f"./{name}/" + (f"?{query}" if query else "")


def _script(script: bytes) -> EncodedBody:
    return EncodedBody(script, _headers("text/javascript; charset=utf-8", "no-cache"), "thorough")


@lru_cache(maxsize=512)
def _encoded(path: Path, _mtime_ns: int, cache_control: str) -> EncodedBody:
    """A text file to be sent; read again when it has changed."""
    media_type = guess_type(path.name)[0] or _MEDIA_TYPES.get(path.suffix, "text/plain")
    # Scripts and styles are read as UTF-8 in our documents without being told so in each answer.
    if media_type.startswith("text/") and path.suffix not in _UNDERSTOOD:
        media_type += "; charset=utf-8"
    headers = _headers(media_type, cache_control)
    return EncodedBody(path.read_bytes(), headers, effort="thorough")
