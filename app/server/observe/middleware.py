"""The outermost layer of the application: gives requests their id, logs and counts them."""

from time import perf_counter

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.server.observe.access_log import AccessLog, request_id
from app.server.observe.metrics import Metrics

_HUNG_UP = 499
"""Status of a request whose client left before an answer began, as nginx counts it."""


class Observed:
    """ASGI middleware around all others, those that answer crashes and from caches included.

    An inner layer may say by ``scope["cache"]``, "hit" or "miss", whether an answer was ready.

    Parameters
    ----------
    app
        What answers.
    metrics
        Where requests are counted.
    access_log
        Where they are logged, if anywhere.
    """

    def __init__(self, app: ASGIApp, metrics: Metrics, access_log: AccessLog | None) -> None:
        self.app = app
        self._metrics = metrics
        self._access_log = access_log

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on and the answer back."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        started = perf_counter()
        identity = request_id(scope["headers"])
        status, sent, error = _HUNG_UP, 0, None

        async def observed_send(message: Message) -> None:
            nonlocal status, sent
            if message["type"] == "http.response.start":
                status = message["status"]
                headers = [*message.get("headers", ()), (b"x-request-id", identity)]
                message = {**message, "headers": headers}
            else:
                sent += len(message.get("body", b""))
            await send(message)

        self._metrics.began()
        try:
            await self.app(scope, receive, observed_send)
        except Exception as crash:
            error = f"{type(crash).__name__}: {crash}"
            status = 500 if status == _HUNG_UP else status
            raise
        finally:
            seconds = perf_counter() - started
            route = template(scope)
            self._metrics.ended(scope["method"], route, status, seconds, scope.get("cache"))
            if self._access_log is not None:
                self._access_log.write(
                    scope,
                    identity=identity,
                    route=route,
                    status=status,
                    sent=sent,
                    seconds=seconds,
                    error=error,
                )


def template(scope: Scope) -> str:
    """Name the route that took a request: `/api/v1/models/{model_id}`, or `/{path}` for no route.

    What no route takes are the page's files, what is nowhere and what is too long.
    """
    own: str | None = getattr(scope.get("route"), "path_format", None)
    if own is None:
        return "/{path}"
    # A route that was included with a prefix knows only the rest of its path.
    path: str = scope["path"]
    rest = own.format_map(scope.get("path_params", {}))
    return path.removesuffix(rest) + own if path.endswith(rest) else own
