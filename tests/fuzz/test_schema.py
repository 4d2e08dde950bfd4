"""The schema and the server say the same, of requests that schemathesis makes from the schema."""

import os
from typing import Any

import schemathesis
from hypothesis import HealthCheck, settings
from schemathesis import Case
from schemathesis.checks import negative_data_rejection, positive_data_acceptance

from app.main import create_app

# Examples a route; `make fuzz` asks for more.
EXAMPLES = int(os.environ.get("FUZZ_EXAMPLES", "4"))

# Bytes are sent as they are made: no Arrow stream, and to be refused as that.
schemathesis.serializer.alias("application/vnd.apache.arrow.stream", "application/octet-stream")

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
    excluded = [positive_data_acceptance]
    if case.path == "/api/v1/evaluate":  # which answers for each item, for wrong ones by an error
        excluded.append(negative_data_rejection)
    # A busy machine must not turn a slow answer into a failure.
    response = case.call(timeout=60)
    if (
        response.status_code == 414
    ):  # the server's bound, before what the schema bounds is looked at
        return
    case.validate_response(response, excluded_checks=excluded)
