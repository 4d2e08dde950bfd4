"""`/metrics`, where Prometheus looks for it."""

import asyncio
from time import monotonic

from anyio import to_thread
from fastapi import APIRouter, Request
from prometheus_client import CONTENT_TYPE_LATEST
from starlette.responses import Response

from app.server.observe.metrics import Metrics

_TEXT = {"content": {"text/plain": {"schema": {"type": "string"}}}}


def metrics_router() -> APIRouter:
    """Routes for the one who watches the server."""
    routes = APIRouter(tags=["server"])

    @routes.get(
        "/metrics",
        response_class=Response,
        responses={200: _TEXT},
        summary="Counts and durations for Prometheus",
    )
    async def metrics(request: Request) -> Response:
        headers = {"Content-Type": CONTENT_TYPE_LATEST, "Cache-Control": "no-store"}
        return Response(await scrapes.text(request.app.state.metrics), headers=headers)

    scrapes = _Scrapes()
    return routes


class _Scrapes:
    """Writes metrics in a thread, once for all who ask meanwhile, and a fifth of the time at most."""

    def __init__(self) -> None:
        self._turn = asyncio.Lock()
        self._began = self._took = 0.0
        self._text = b""

    async def text(self, metrics: Metrics) -> bytes:
        """The metrics as they are from now on."""
        asked = monotonic()
        async with self._turn:
            if self._began < asked:
                await asyncio.sleep(self._began + 5.0 * self._took - monotonic())
                self._began = monotonic()
                self._text = await to_thread.run_sync(metrics.text)
                self._took = monotonic() - self._began
            return self._text
