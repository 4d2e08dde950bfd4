"""Bytes in the encodings that clients ask for, each made once, and 304 for who has them."""

import gzip
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Literal, NamedTuple
from zlib import crc32

import brotli
import zstandard

Effort = Literal["quick", "thorough"]
"""How hard to compress: quick for what is sent once, thorough for what is sent for ever."""

Coding = Literal["br", "zstd", "gzip"]
Headers = list[tuple[bytes, bytes]]
"""Names in lower case and values, as ASGI has them."""

# Below these sizes the header that names the encoding takes what compression gains.
_SMALLEST = {"quick": 1024, "thorough": 200}

# Brotli at its best makes small texts a tenth smaller than zstandard, and takes seconds for large ones.
_LARGEST_BROTLI = 262_144

# Compressed in a few milliseconds at most, during which no other request is answered.
_QUICKLY_COMPRESSED = {"quick": 1_000_000, "thorough": 10_000}


class Reply(NamedTuple):
    """What goes over the wire."""

    status: int
    headers: Headers
    body: bytes


class EncodedBody:
    """Bytes to be sent any number of times, tagged once and compressed once an encoding.

    Parameters
    ----------
    body
        The content.
    headers
        Those that belong to it, its type among them.
    effort
        How hard to compress.
    """

    def __init__(self, body: bytes, headers: Headers, effort: Effort = "quick") -> None:
        self._effort: Effort = effort
        self._encoded: dict[Coding | None, bytes] = {None: body}
        # It only tells the versions of one address apart: a checksum and the length will do.
        self.etag = b'W/"%08x-%x"' % (crc32(body), len(body))
        self._headers = [*headers, (b"vary", b"Accept-Encoding"), (b"etag", self.etag)]
        size = len(body)
        self._codings: tuple[Coding, ...] = ("zstd", "gzip")
        if size < _SMALLEST[effort]:
            self._codings = ()
        elif effort == "thorough" and size <= _LARGEST_BROTLI:
            self._codings = ("br", "zstd", "gzip")

    @property
    def size(self) -> int:
        """Bytes of all encodings made so far."""
        return sum(map(len, self._encoded.values()))

    def coding(self, request: Iterable[tuple[bytes, bytes]]) -> Coding | None:
        """Choose the encoding for a client that sent these headers, None for the bytes as is."""
        accepted = b",".join([value for name, value in request if name == b"accept-encoding"])
        return _best(accepted, self._codings) if accepted and self._codings else None

    def is_made(self, coding: Coding | None) -> bool:
        """Whether the encoding is there already."""
        return coding in self._encoded

    def takes_long(self, coding: Coding | None) -> bool:
        """Whether the encoding has yet to be made, and that takes longer than others should wait."""
        return not self.is_made(coding) and (
            len(self._encoded[None]) > _QUICKLY_COMPRESSED[self._effort]
        )

    def encoded(self, coding: Coding | None) -> bytes:
        """The bytes in an encoding, made the first time."""
        if coding not in self._encoded:
            self._encoded[coding] = _compress(self._encoded[None], coding, self._effort)
        return self._encoded[coding]

    def reply(self, request: Headers, coding: Coding | None) -> Reply:
        """Answer a client that sent the headers `request`: 304 where it has the content.

        Parameters
        ----------
        request
            Headers of the request.
        coding
            The encoding, as `coding` chose it.
        """
        for name, held in request:
            if name == b"if-none-match" and self._is_among(held):
                return Reply(304, [h for h in self._headers if h[0] != b"content-type"], b"")
        body = self.encoded(coding)
        headers = [*self._headers, (b"content-length", b"%d" % len(body))]
        if coding is not None:
            headers.append((b"content-encoding", coding.encode()))
        return Reply(200, headers, body)

    def _is_among(self, held: bytes) -> bool:
        """Whether If-None-Match names this content (weak comparison, RFC 9110 section 13.1.2)."""
        tags = {tag.strip().removeprefix(b"W/") for tag in held.split(b",")}
        return b"*" in tags or self.etag.removeprefix(b"W/") in tags


def _compress(body: bytes, coding: Coding | None, effort: Effort) -> bytes:
    if coding == "br":
        return bytes(brotli.compress(body, quality=11))
    if coding == "zstd":
        return zstandard.compress(body, level=1 if effort == "quick" else 19)
    return gzip.compress(body, compresslevel=1 if effort == "quick" else 9, mtime=0)


def _best(accepted: bytes, codings: tuple[Coding, ...]) -> Coding | None:
    """Choose the first of the encodings that a client asks for (RFC 9110 section 12.5.3)."""
    weights = _weights(accepted) if len(accepted) < 200 else _weights.__wrapped__(accepted)
    for coding in codings:
        if weights.get(coding, weights.get("*", 0.0)) > 0.0:
            return coding
    return None


@lru_cache(maxsize=256)  # a few spellings of as many browsers; long ones are read each time
def _weights(accepted: bytes) -> Mapping[str, float]:
    weights: dict[str, float] = {}
    for part in accepted.decode("latin-1").lower().split(","):
        coding, _, quality = part.partition(";")
        try:
            weights[coding.strip()] = float(quality.partition("=")[2] or 1.0)
        except ValueError:
            continue  # a malformed weight asks for nothing
    return weights
