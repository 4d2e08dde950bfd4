"""`/health` says that the server is well and what it is made of."""

from collections.abc import Callable
from importlib.metadata import version

import httpx

from app import __version__
from tests.api.shape import fields_of

Ask = Callable[..., httpx.Response]


def test_is_well(ask: Ask) -> None:
    answer = ask("/health")
    assert answer.status_code == 200
    health = fields_of(answer.content)
    assert health.status == "ok"
    assert health.version == __version__
    assert {"fastapi", "numpy", "pydantic", "scipy", "uvicorn"} <= set(vars(health.libraries))
    assert all(version(name) == told for name, told in vars(health.libraries).items())


def test_is_never_kept(ask: Ask) -> None:
    assert ask("/health").headers["cache-control"] == "no-store"


def test_takes_no_parameters(ask: Ask) -> None:
    answer = ask("/health", verbose="true")
    assert answer.status_code == 422
    assert answer.json()["errors"] == [
        {"parameter": "verbose", "value": "true", "message": "this route takes no parameters"}
    ]
