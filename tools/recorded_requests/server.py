"""Asks a running server, and keeps of its answers what matters."""

from __future__ import annotations

import gzip
import threading
from collections.abc import Callable
from http.client import HTTPConnection, HTTPException, HTTPResponse
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
    """A server at `url`, asked by each thread over a connection of its own.

    In a header `{etag}` stands for the ETag of the same address, so that nothing has changed.
    """

    def __init__(self, url: str) -> None:
        self._netloc = urlsplit(url).netloc
        self._thread = threading.local()

    def ask(self, question: Question) -> Answer:
        """Send a request and read its answer; status 0 if there is none.

        It is sent again where none came, and where a busy machine had no time for it (503).
        """
        for _ in range(4):
            try:
                answer = self._asked(question)
            except (HTTPException, OSError) as error:
                answer = Answer(0, {}, type(error).__name__)
                del self._thread.connection
            if answer.status not in (0, 503):
                break
        return answer

    def _sent(self, method: str, target: str, body: bytes, headers: dict[str, str]) -> HTTPResponse:
        if not hasattr(self._thread, "connection"):
            self._thread.connection = HTTPConnection(self._netloc, timeout=300)
        connection: HTTPConnection = self._thread.connection
        connection.request(method, target, body or None, headers)
        return connection.getresponse()

    def _asked(self, question: Question) -> Answer:
        sent = dict(question.headers)
        if "{etag}" in (asked := sent.get("If-None-Match", "")):
            first = self._sent("GET", question.target, b"", {})
            first.read()
            sent["If-None-Match"] = asked.replace("{etag}", first.getheader("etag", ""))
        method, target = question.method, question.target
        response = self._sent(method, target, question.content, sent)
        content = response.read()
        kept = {
            name: value for name in KEPT if (value := response.getheader(name, None)) is not None
        }
        if "location" in kept:  # the port is another each time
            kept["location"] = urlsplit(kept["location"]).path
        if etag := response.getheader("etag", ""):
            kept["etag"] = "weak" if etag.startswith("W/") else "strong"
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
