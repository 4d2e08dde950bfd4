"""What an endpoint returns: ready bytes, or the work that makes them."""

from __future__ import annotations

from functools import partial

from app.http.body import ReadyBody

Large = partial[ReadyBody]
"""A computation that others should not wait for: it is called in a thread, see `app.server.pool`."""

Answer = ReadyBody | Large
