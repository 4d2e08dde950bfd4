"""`/health` says that the server is well and what it is made of."""

from importlib.metadata import version

from app import __version__
from tests.api.shape import Ask, error_of, json_of


def test_is_well(ask: Ask) -> None:
    health = json_of(ask("/health"))
    libraries = health["libraries"]
    assert (health["status"], health["version"]) == ("ok", __version__)
    assert {"fastapi", "numpy", "pydantic", "scipy", "uvicorn"} <= set(libraries)
    assert all(version(name) == told for name, told in libraries.items())


def test_is_never_kept(ask: Ask) -> None:
    assert ask("/health").headers["cache-control"] == "no-store"


def test_takes_no_parameters(ask: Ask) -> None:
    said = {"value": "true", "message": "this route takes no parameters"}
    assert error_of(ask("/health", verbose="true")) == {"parameter": "verbose", **said}
