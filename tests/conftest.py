"""Settings of all tests, and the application that most of them ask."""

import pytest
from fastapi import FastAPI
from hypothesis import settings

from app.main import create_app

# A busy machine must not turn a slow example into a failure.
settings.register_profile("project", deadline=None)
if settings.get_current_profile_name() == "default":
    settings.load_profile("project")


# What is compared by `rel` is meant so: pytest lets pass what is 1e-12 off, too, however small it is.
pytest.MonkeyPatch().setattr(type(pytest.approx(1.0)), "DEFAULT_ABSOLUTE_TOLERANCE", 0.0)


@pytest.fixture(scope="session")
def app() -> FastAPI:
    return create_app()
