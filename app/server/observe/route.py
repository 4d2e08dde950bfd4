"""`/metrics`, where Prometheus looks for it."""

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
        counted: Metrics = request.app.state.metrics
        headers = {"Content-Type": CONTENT_TYPE_LATEST, "Cache-Control": "no-store"}
        return Response(counted.text(), headers=headers)

    return routes
