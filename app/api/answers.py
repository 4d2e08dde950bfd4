"""What an endpoint returns: ready bytes, or the work that makes them."""

from functools import partial

from starlette.responses import Response

Large = partial[Response]
"""A computation that others should not wait for: it is called in a thread, see `app.server.pool`."""

Answer = Response | Large
