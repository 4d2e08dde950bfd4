"""Bytes that are ready to be sent: tagged, compressed once, answered with 304 where known."""

from __future__ import annotations

import gzip
from base64 import urlsafe_b64encode
from collections.abc import Mapping
from hashlib import blake2b
from typing import Literal

import brotli
import zstandard
from starlette.requests import Request
from starlette.responses import Response

Effort = Literal["quick", "thorough"]
"""How hard to compress: quick for what is sent once, thorough for what is sent for ever."""

# Below these sizes the header that names the encoding takes what compression gains.
_SMALLEST = {"quick": 1024, "thorough": 200}

# Brotli at its best makes small texts a tenth smaller than zstandard, and takes seconds for large ones.
_LARGEST_BROTLI = 262_144


class ReadyBody:
    """Bytes to be sent any number of times, tagged once and compressed once an encoding."""

    def __init__(
        self,
        body: bytes,
        media_type: str,
        headers: Mapping[str, str] | None = None,
        *,
        effort: Effort = "quick",
    ) -> None:
        self._media_type = media_type
        self._effort: Effort = effort
        self._encoded: dict[str | None, bytes] = {None: body}
        # Short, for the page is dozens of files: it only tells the versions of one address apart.
        tag = urlsafe_b64encode(blake2b(body, digest_size=9).digest()).decode()
        etag = f'W/"{tag}"'
        self._headers = {**(headers or {}), "ETag": etag, "Vary": "Accept-Encoding"}

    def response(self, request: Request, cache_control: str | None = None) -> Response:
        """Answer a request: 304 where the client has the content, else in the best encoding.

        Answers of the API may be kept as long as the settings say, unless `cache_control` is given.
        """
        if cache_control is None:
            cache_control = f"public, max-age={request.app.state.settings.max_age_s}"
        headers = {**self._headers, "Cache-Control": cache_control}
        if _has_copy(request, self._headers["ETag"]):
            return Response(status_code=304, headers=headers)
        encoding = _encoding(request, self._codings())
        if encoding is not None:
            headers["Content-Encoding"] = encoding
        return Response(self._in(encoding), headers=headers, media_type=self._media_type)

    def _codings(self) -> tuple[str, ...]:
        """Name the encodings worth their while, best first."""
        size = len(self._encoded[None])
        if size < _SMALLEST[self._effort]:
            return ()
        if self._effort == "thorough" and size <= _LARGEST_BROTLI:
            return ("br", "zstd", "gzip")
        return ("zstd", "gzip")

    def _in(self, encoding: str | None) -> bytes:
        if encoding not in self._encoded:
            self._encoded[encoding] = _compress(self._encoded[None], encoding, self._effort)
        return self._encoded[encoding]


def _compress(body: bytes, encoding: str | None, effort: Effort) -> bytes:
    if encoding == "br":
        return bytes(brotli.compress(body, quality=11))
    if encoding == "zstd":
        return zstandard.compress(body, level=1 if effort == "quick" else 19)
    return gzip.compress(body, compresslevel=1 if effort == "quick" else 9, mtime=0)


def _has_copy(request: Request, etag: str) -> bool:
    """Whether If-None-Match names this content (weak comparison, RFC 9110 section 13.1.2)."""
    held = request.headers.get("if-none-match")
    if held is None:
        return False
    tags = {tag.strip().removeprefix("W/") for tag in held.split(",")}
    return "*" in tags or etag.removeprefix("W/") in tags


def _encoding(request: Request, codings: tuple[str, ...]) -> str | None:
    """Choose the first of the encodings that the client asks for (RFC 9110 section 12.5.3)."""
    accepted: dict[str, float] = {}
    for part in request.headers.get("accept-encoding", "").lower().split(","):
        coding, _, quality = part.partition(";")
        try:
            accepted[coding.strip()] = float(quality.partition("=")[2] or 1.0)
        except ValueError:
            continue  # a malformed weight asks for nothing
    for coding in codings:
        if accepted.get(coding, accepted.get("*", 0.0)) > 0.0:
            return coding
    return None
