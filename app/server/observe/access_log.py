"""The access log: one JSON object a line and request, written as the request ends."""

import os
import re
from collections.abc import Iterable
from datetime import UTC, datetime
from itertools import count

import orjson
from starlette.types import Scope

from app.server.observe.lines import Lines

_TARGET_BYTES = 1024
_AGENT_BYTES = 200
"""Longest address and user agent that are logged: a line stays below what a pipe takes at once (4096
bytes), so that lines of several workers never mix."""

_VALID_ID = re.compile(rb"[A-Za-z0-9._-]{1,64}")
_OWN = re.compile(rb"(own(?::|%3A))[A-Za-z0-9_-]+", re.IGNORECASE)
"""Ids of own materials, which are their data: nobody's are logged."""
_PROCESS = os.urandom(8).hex()
_NUMBERS = count(1)


def request_id(headers: Iterable[tuple[bytes, bytes]]) -> bytes:
    """Take a request's own id, X-Request-ID, where it is one; else make one.

    An id is 1 to 64 letters, digits, dots, underscores and hyphens. Those made here are a random
    number of the process and a running one: two never meet.
    """
    for name, value in headers:
        if name == b"x-request-id" and _VALID_ID.fullmatch(value):
            return value
    return f"{_PROCESS}-{next(_NUMBERS)}".encode()


class AccessLog:
    """Writes a line for each request.

    Parameters
    ----------
    lines
        Where to write it.
    """

    def __init__(self, lines: Lines) -> None:
        self._lines = lines

    def write(
        self,
        scope: Scope,
        *,
        identity: bytes,
        route: str,
        status: int,
        sent: int,
        seconds: float,
        error: str | None,
    ) -> None:
        """Write what became of a request; whoever reads it, or does not, no request waits."""
        client = scope.get("client")
        record = {
            "time": datetime.now(UTC),
            "request_id": identity.decode(),
            "client": client[0] if client else None,
            "method": scope["method"],
            "target": _target(scope),
            "route": route,
            "status": status,
            "bytes": sent,
            "duration_ms": round(seconds * 1e3, 3),
            "cache": scope.get("cache"),
            "user_agent": _user_agent(scope),
            "pid": os.getpid(),
        }
        if error is not None:
            record["error"] = error[:_AGENT_BYTES]
        line = orjson.dumps(record, option=orjson.OPT_APPEND_NEWLINE | orjson.OPT_UTC_Z)
        self._lines.write(line)

    def flush(self) -> None:
        """Wait a moment until all is written."""
        self._lines.flush()


def _target(scope: Scope) -> str:
    path: bytes = scope.get("raw_path") or scope["path"].encode()
    query: bytes = scope["query_string"]
    target = path + b"?" + query if query else path
    target = _OWN.sub(rb"\1...", target)
    return target[:_TARGET_BYTES].decode("latin-1")


def _user_agent(scope: Scope) -> str | None:
    for name, value in scope["headers"]:
        if name == b"user-agent":
            return str(value[:_AGENT_BYTES].decode("latin-1"))
    return None
