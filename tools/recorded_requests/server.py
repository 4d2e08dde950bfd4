"""Asks a running server, one request after the other over one connection."""

from __future__ import annotations

import gzip
from collections.abc import Callable
from http.client import HTTPConnection, HTTPException
from urllib.parse import urlsplit

import brotli
import zstandard

from tools.recorded_requests.question import Answer, Question, text_or_digest

# Left out: Date, the id of the request, and Content-Length, which the body tells where there is one.
KEPT = (
    *("content-type", "content-disposition", "content-encoding", "content-security-policy"),
    *("cache-control", "vary", "allow", "location", "retry-after", "interpolation-error", "link"),
    *("accept-post", "x-content-type-options", "referrer-policy", "permissions-policy"),
    *("cross-origin-opener-policy", "access-control-allow-origin", "access-control-max-age"),
    *("access-control-expose-headers", "access-control-allow-methods"),
    *("access-control-allow-headers",),
)

# Bodies that vary by nature: versions of libraries, counts and durations. Scripts, styles and the
# service worker, which lists them, are what a change of the page changes.
BODY_VARIES = ("/api/v1/health", "/metrics", "/js/", "/css/", "/sw.js")

DECODED: dict[str, Callable[[bytes], bytes]] = {
    "gzip": gzip.decompress,
    "br": brotli.decompress,
    "zstd": lambda content: zstandard.ZstdDecompressor().decompressobj().decompress(content),
}


class Server:
    """A server at `url`.

    A header with the value `{etag}` sends the ETag of the answer before, to be told that nothing
    has changed.
    """

    def __init__(self, url: str) -> None:
        self._connection = HTTPConnection(urlsplit(url).netloc, timeout=120)
        self._etag = ""

    def ask(self, question: Question) -> Answer:
        """Send a request and read its answer; status 0 if there is none, a second time as well."""
        try:
            return self._asked(question)
        except (HTTPException, OSError):
            self._connection.close()
        try:
            return self._asked(question)
        except (HTTPException, OSError) as error:
            self._connection.close()
            return Answer(0, {}, type(error).__name__)

    def _asked(self, question: Question) -> Answer:
        sent = {
            name: value.replace("{etag}", self._etag) for name, value in question.headers.items()
        }
        method, target = question.method, question.target
        self._connection.request(method, target, question.content or None, sent)
        response = self._connection.getresponse()
        content = response.read()
        self._etag = response.getheader("etag", "")
        kept = {
            name: value for name in KEPT if (value := response.getheader(name, None)) is not None
        }
        if self._etag:
            kept["etag"] = "weak" if self._etag.startswith("W/") else "strong"
        if method == "HEAD" and not target.startswith(BODY_VARIES):
            kept["content-length"] = response.getheader("content-length", "")
        if asked_id := sent.get("X-Request-ID"):  # a valid one comes back, else one is drawn
            kept["x-request-id"] = str(response.getheader("x-request-id") == asked_id)
        # Compressed bytes may change with the library; what they hold may not.
        coding = response.getheader("content-encoding", "")
        if content and coding in DECODED:
            content = DECODED[coding](content)
        varies = response.status == 200 and target.startswith(BODY_VARIES)
        return Answer(response.status, kept, "" if varies else text_or_digest(content))
