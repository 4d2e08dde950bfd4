"""The catalog that comes with the program."""

import pytest

from app.materials.catalog import Catalog, load_catalog


@pytest.fixture(scope="session")
def catalog() -> Catalog:
    return load_catalog()
