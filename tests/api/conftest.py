"""The whole application, asked in process; a crash is an answer 500, not an exception."""

import asyncio
from collections.abc import Callable
from typing import Any

import httpx
import pytest
from fastapi import FastAPI

from tests.api.shape import check_shape


@pytest.fixture(scope="session")
def ask(app: FastAPI) -> Callable[..., httpx.Response]:
    """`ask(path, headers, **query)`, the path below /api/v1; JSON is of the shape that is told."""

    def get(path: str, headers: dict[str, str] | None = None, **parameters: Any) -> httpx.Response:
        async def request() -> httpx.Response:
            transport = httpx.ASGITransport(app=app, raise_app_exceptions=False)
            async with httpx.AsyncClient(transport=transport, base_url="http://test") as client:
                query = parameters or None  # an empty one would drop what the path brings
                return await client.get(f"/api/v1{path}", params=query, headers=headers)

        answer = asyncio.run(request())
        if answer.status_code == 200 and answer.headers["content-type"] == "application/json":
            check_shape(app, answer.url.path, answer.json())
        return answer

    return get
