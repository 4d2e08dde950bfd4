"""What the routes of one server share: its bounds, its threads, how long answers may be kept."""

import asyncio
from collections.abc import Callable, Hashable

from starlette.responses import Response

from app.server.pool import Pool


class Serving:
    """The state of a server that its routes use.

    Parameters
    ----------
    pool
        Where large answers are computed.
    max_samples, max_cells
        Most angles of a curve and cells of a map.
    max_age_s
        How long caches elsewhere may keep an answer.
    """

    def __init__(self, pool: Pool, *, max_samples: int, max_cells: int, max_age_s: int) -> None:
        self.max_samples = max_samples
        self.max_cells = max_cells
        self._pool = pool
        self.lifetime = b"public, max-age=%d" % max_age_s
        self._under_way: dict[Hashable, asyncio.Task[Response]] = {}

    async def shared(self, key: Hashable, work: Callable[[], Response]) -> Response:
        """Compute in a thread, once for all who ask for the same at the same time."""
        task = self._under_way.get(key)
        if task is None:
            task = asyncio.create_task(self._pool.run(work))
            self._under_way[key] = task
            task.add_done_callback(lambda _: self._under_way.pop(key))
        return await asyncio.shield(task)
