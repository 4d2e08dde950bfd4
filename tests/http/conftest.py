"""The whole application, asked in process; a crash is an answer 500, not an exception."""

import asyncio
from collections.abc import Callable
from typing import Any

import httpx
import pytest
from fastapi import FastAPI

from app.main import create_app


@pytest.fixture(scope="session")
def app() -> FastAPI:
    return create_app()


@pytest.fixture(scope="session")
def ask(app: FastAPI) -> Callable[..., httpx.Response]:
    """`ask(path, headers, **query)`, the path below /api/v1."""

    def get(path: str, headers: dict[str, str] | None = None, **parameters: Any) -> httpx.Response:
        async def request() -> httpx.Response:
            transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
            async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
                query = parameters or None  # an empty one would drop what the path brings
                return await client.get(f"/api/v1{path}", params=query, headers=headers)

        return asyncio.run(request())

    return get
