"""Presets in place of numbers: what answers say of them, and what is said of wrong ones."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from app.http.problems import BadParameters, given
from app.optics.errors import OpticsError


@contextmanager
def reported_as(**names: str) -> Iterator[None]:
    """Turn what the core refuses into the API's own error, its parameters renamed.

    Inside a pydantic validator nothing of the core's errors, which are ValueErrors, would be left.

    Parameters
    ----------
    names
        What the client calls the core's parameters.
    """
    try:
        yield
    except OpticsError as error:
        name = names.get(error.parameter, error.parameter)
        raise BadParameters(
            {"parameter": name, "value": given(error), "message": error.allowed}
        ) from None
