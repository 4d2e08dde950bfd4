"""`/health`: whether the server works, what it is made of, and whether it wants more to do."""

from importlib.metadata import version
from typing import Literal

from fastapi import APIRouter

from app import __version__
from app.answers.answer import answer
from app.http.route import QueryRoute
from app.server.drain import Drain
from app.server.pool import Overloaded, Pool

_LIBRARIES = {
    name: version(name) for name in ("fastapi", "numpy", "orjson", "pydantic", "scipy", "uvicorn")
}


@answer
class Status:
    """That all is well; anything else is a problem."""

    status: Literal["ok"]


@answer
class Health:
    """Whether the server works, and what it is made of."""

    status: Literal["ok"]
    version: str
    libraries: dict[str, str]


class _NotKept(QueryRoute):
    """A route whose answer may be another the next time."""

    lifetime = b"no-store"


def router(drain: Drain, pool: Pool) -> APIRouter:
    """Routes about the server itself, ready unless it is about to stop or `pool` takes no more."""
    routes = APIRouter(route_class=_NotKept, tags=["server"])

    @routes.get("/health", summary="Is the server well?")
    def health() -> Health:
        return Health(status="ok", version=__version__, libraries=_LIBRARIES)

    @routes.get("/health/live", summary="Is the process alive?")
    def live() -> Status:
        """Answer as long as the event loop turns; a server that does not wants to be restarted."""
        return Status(status="ok")

    @routes.get("/health/ready", summary="Does it take requests?")
    def ready() -> Status:
        """Answer 503 once the server was told to stop, or has no time for large answers."""
        if drain.draining:
            raise Overloaded("the server is about to stop")
        refusal = pool.refusal()
        if refusal is not None:
            raise Overloaded(refusal)
        return Status(status="ok")

    return routes
