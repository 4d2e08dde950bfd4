"""The API's routes by their paths: for the front, and to be asked within the process."""

from collections.abc import Iterable, Mapping
from typing import Any
from urllib.parse import unquote

from fastapi import APIRouter

from app.answers.rounding import rounded
from app.http.route import QueryRoute


class RouteTable:
    """Routes that are found by path; claims, figures and the command line ask them, without HTTP.

    Parameters
    ----------
    routers
        Whose routes to hold; their paths come without the API's prefix.
    """

    def __init__(self, routers: Iterable[APIRouter]) -> None:
        routes = [r for router in routers for r in router.routes if isinstance(r, QueryRoute)]
        self._plain = {route.path: route for route in routes if "{" not in route.path}
        self._matched = [route for route in routes if "{" in route.path]

    def find(self, path: str) -> tuple[QueryRoute | None, Mapping[str, str]]:
        """Find the route of a path, and the parts of the path that are its parameters."""
        route = self._plain.get(path)
        if route is not None:
            return route, {}
        for route in self._matched:
            match = route.path_regex.match(path)
            if match:
                return route, match.groupdict()
        return None, {}

    def ask(self, target: str) -> Any:
        """Return the answer to a path and query, percent-encoded, with as many digits as it asks for.

        Raises
        ------
        LookupError
            If no route has the path.
        BadParameters, OpticsError
            As the route does.
        """
        route, parts, text = self._routed(target)
        query = route.read(text)
        answer = route.answer(parts, query)
        return rounded(answer, getattr(query, "digits", 17))

    def written(self, target: str) -> bytes:
        """Return the bytes that the route of a path and query sends; errors are raised."""
        route, parts, query = self._routed(target)
        return bytes(route.written(parts, route.read(query)).body)

    def _routed(self, target: str) -> tuple[QueryRoute, Mapping[str, str], bytes]:
        path, _, query = target.partition("?")
        route, parts = self.find(unquote(path))
        if route is None:
            raise LookupError(path)
        return route, parts, query.encode()
