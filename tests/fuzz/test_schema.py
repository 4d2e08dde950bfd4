"""The schema and the server say the same, of requests that schemathesis makes from the schema."""

from __future__ import annotations

import os
from typing import Any

import schemathesis
from hypothesis import HealthCheck, settings
from schemathesis import Case
from schemathesis.checks import positive_data_acceptance

from app.main import create_app

# Examples a route; `make fuzz` asks for more.
EXAMPLES = int(os.environ.get("FUZZ_EXAMPLES", "8"))

schema = schemathesis.openapi.from_asgi("/openapi.json", create_app())


@schema.parametrize()
@settings(
    max_examples=EXAMPLES,
    derandomize=True,
    database=None,
    deadline=None,
    suppress_health_check=list(HealthCheck),
)
def test_answers_are_those_that_the_schema_promises(case: Case[Any]) -> None:
    # A schema cannot say that a preset takes the place of an index, or that ends are in order.
    case.call_and_validate(excluded_checks=[positive_data_acceptance])
