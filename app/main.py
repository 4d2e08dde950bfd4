"""The application: settings, routers, problem handlers, the page."""

from __future__ import annotations

import logging
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from functools import lru_cache, partial
from typing import Any

import orjson
from anyio import to_thread
from fastapi import APIRouter, FastAPI, Request
from starlette.responses import Response
from starlette.types import ASGIApp

from app import __version__
from app.api import (
    PREFIX,
    albedo,
    atlas,
    benchmarks,
    claims,
    convert,
    curves,
    engines,
    errors,
    evaluate,
    export,
    figures,
    films,
    formulas,
    health,
    lut,
    materials,
    models,
    mystery,
    polarization,
    recommend,
    shaders,
    snell,
    vectors,
)
from app.api.materials import reading
from app.api.table import RouteTable
from app.figures.pictures import Pictures
from app.http import problems
from app.http.body import EncodedBody
from app.http.bounds import Bounded
from app.http.cache import AnswerCache
from app.http.encoded import Encoded
from app.http.middleware import CommonHeaders, Fallback, HeadAsGet, KnownHosts
from app.http.serving import Serving
from app.optics.registry import Registry, default_registry
from app.page.files import Page, document_headers
from app.page.first_picture import first_picture
from app.page.packed import page_form
from app.server.drain import Drain
from app.server.memory import share_one_heap
from app.server.observe.access_log import AccessLog
from app.server.observe.lines import Lines
from app.server.observe.metrics import Metrics
from app.server.observe.middleware import Observed
from app.server.observe.route import metrics_router
from app.server.pool import Pool
from app.settings import Settings
from app.snippets.kernels import kernels

_DESCRIPTION = """
Reflection at smooth surfaces: exact Fresnel curves for dielectrics and conductors, the formulas
that renderers use in their place, and what each of them gets wrong.

Conventions: time factor exp(-i w t), N = n_t + i k_t with k_t >= 0, angles from the surface normal.
Every error is an `application/problem+json` (RFC 9457) that names the parameter, the value and what
is allowed; nothing is clamped, guessed or ignored.
"""

_OPENAPI = "/openapi.json"

_PROBED = (f"{PREFIX}/health", "/metrics")
"""Paths that are asked by address, not by name."""

_KERNELS = "kernels.js"
"""The models in JavaScript, beside the page's files; pages of other origins may import them too."""


class _Application(FastAPI):
    """FastAPI inside of layers that see every answer, its schema with what a problem looks like."""

    def build_middleware_stack(self) -> ASGIApp:
        """Put the layers around FastAPI's own, which answer crashes too; the outermost last."""
        settings: Settings = self.state.settings
        pool: Pool = self.state.pool
        drain: Drain = self.state.drain
        app: ASGIApp = super().build_middleware_stack()
        app = AnswerCache(app, prefix=f"{PREFIX}/", limit=settings.cache_bytes, pool=pool)
        app = HeadAsGet(app)
        hosts = [host.strip().lower() for host in settings.allowed_hosts.split(",")]
        if "*" not in hosts:
            app = KnownHosts(app, hosts, open_to_all=_PROBED)
        app = Bounded(
            app,
            target_bytes=settings.max_target_bytes,
            header_bytes=settings.max_header_bytes,
            read_timeout_s=settings.read_timeout_s,
            write_timeout_s=settings.write_timeout_s,
        )
        app = CommonHeaders(
            app, api=(f"{PREFIX}/", _OPENAPI, f"/{_KERNELS}"), documents=document_headers
        )
        return Observed(drain.around(app), self.state.metrics, self.state.access_log)

    def openapi(self) -> dict[str, Any]:
        """Describe the API."""
        if self.openapi_schema is None:
            super().openapi()["components"]["schemas"] |= problems.schemas()
        return super().openapi()

    @lru_cache(4)  # noqa: B019 - an application lives as long as the process
    def described(self, root_path: str) -> EncodedBody:
        """The description as it is sent to who found the API below a path."""
        schema = self.openapi()
        if root_path:
            schema = schema | {"servers": [{"url": root_path}]}
        headers = [(b"content-type", b"application/json"), (b"cache-control", b"no-cache")]
        return EncodedBody(orjson.dumps(schema), headers, "thorough")


@asynccontextmanager
async def _running(app: FastAPI) -> AsyncIterator[None]:
    """Once the last request is answered, or given up, nothing that was begun holds the process."""
    yield
    for closed in (app.state.pictures, app.state.pool, app.state.drawing):
        closed.close()
    if app.state.access_log is not None:
        app.state.access_log.flush()
    for handler in logging.getLogger().handlers:
        handler.flush()


def create_app(settings: Settings | None = None, registry: Registry | None = None) -> FastAPI:
    """Build the application.

    Parameters
    ----------
    settings
        Read from the environment if not given.
    registry
        The models to serve; every one in `app.optics.models` if not given.
    """
    share_one_heap()
    settings = settings or Settings()
    registry = registry or default_registry()
    app = _Application(
        title="Fresnel Explorer",
        version=__version__,
        description=_DESCRIPTION,
        license_info={"name": "MIT", "identifier": "MIT"},
        docs_url=None,  # the page at /docs is served with the other files, from this server alone
        redoc_url=None,
        openapi_url=None,  # it is made once, see `described`
        lifespan=_running,
        responses={
            "4XX": problems.problem_as("What is wrong with the request, and what would be right."),
            "5XX": problems.problem_as("The server failed, or has no time for this now."),
        },
    )
    app.state.settings = settings
    app.state.metrics = metrics = Metrics()
    app.state.access_log = None
    if settings.access_log:
        app.state.access_log = AccessLog(Lines(sys.stdout.fileno(), metrics.dropped))
    app.state.drain = drain = Drain(settings.drain_s)
    app.state.pool = pool = Pool(settings.threads, settings.max_waiting, settings.timeout_s)
    app.state.pictures = pictures = Pictures(settings.static_dir, settings.picture_timeout_s)
    app.state.drawing = drawing = Pool(
        1, settings.max_waiting, settings.timeout_s, name="pictures", settings="FRESNEL_MAX_WAITING"
    )
    app.state.serving = Serving(
        pool,
        drawing,
        max_samples=settings.max_samples,
        max_cells=settings.max_cells,
        max_age_s=settings.max_age_s,
    )
    routers: list[APIRouter] = [
        curves.router(registry),
        snell.router(),
        vectors.router(),
        benchmarks.router(registry),
        polarization.router(),
        films.router(),
        health.router(drain, pool),
        models.router(registry, settings.static_dir),
        errors.router(registry),
        recommend.router(registry),
        convert.router(),
        albedo.router(registry),
        reading.router(pool, settings.max_body_bytes),  # before materials, whose ids are any word
        materials.router(registry),
        shaders.router(registry),
        lut.router(registry),
        engines.router(registry),
        atlas.router(registry),
        export.router(),
        formulas.router(registry),
        mystery.router(),
        evaluate.router(registry, pool, settings.max_body_bytes),
    ]
    table = RouteTable(routers)
    routers += [
        claims.router(table),
        figures.router(table, registry, settings.static_dir, pictures),
    ]
    app.state.table = RouteTable(routers)
    problems.install(app)
    for router in routers:
        app.include_router(router, prefix=PREFIX)
    app.include_router(metrics_router())

    @app.get(_OPENAPI, include_in_schema=False)
    async def described(request: Request) -> Response:
        return Encoded(await to_thread.run_sync(app.described, request.scope["root_path"]))

    made = {_KERNELS: kernels(registry).encode()}
    picture = partial(first_picture, app.state.table.ask)
    page = Page(settings.static_dir, made, picture, page_form(settings.page, settings.static_dir))
    app.router.routes.append(Fallback("/", page, name="page"))
    return app
