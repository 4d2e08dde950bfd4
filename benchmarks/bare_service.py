"""The least that an ASGI application can do: send the same bytes to whoever asks, or compute them.

What `/` costs, every answer costs; what `/curves` costs, no Python service that evaluates six curves
with NumPy and writes them with orjson can undercut.
"""

from __future__ import annotations

import os
from pathlib import Path

import orjson
from starlette.types import Receive, Scope, Send

from benchmarks.plain_service import textbook

BODY = Path(os.environ["BENCHMARK_BODY"]).read_bytes() if "BENCHMARK_BODY" in os.environ else b""


def curves(n_t: float) -> bytes:
    """Six curves by the textbook: no query model, no other parameter, nothing said about them."""
    theta_i_deg, quantities = textbook(1.0, n_t, 0.0, 181)
    return orjson.dumps(
        {"theta_i_deg": theta_i_deg, **quantities}, option=orjson.OPT_SERIALIZE_NUMPY
    )


async def app(scope: Scope, _receive: Receive, send: Send) -> None:
    """Answer."""
    if scope["type"] == "http":
        fresh = scope["path"] == "/curves"
        body = curves(float(scope["query_string"].partition(b"=")[2])) if fresh else BODY
        headers = [(b"content-type", b"application/json"), (b"content-length", b"%d" % len(body))]
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        await send({"type": "http.response.body", "body": body})
