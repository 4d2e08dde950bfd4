"""Threads for what takes long, so that short requests are answered meanwhile."""

import asyncio
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from threading import get_ident
from time import monotonic
from typing import Any, TypeVar

T = TypeVar("T")


class Overloaded(Exception):
    """The server has no time for a request now; `limit` says which limit was reached."""

    def __init__(self, limit: str, retry_after_s: int = 1) -> None:
        super().__init__(limit)
        self.limit = limit
        self.retry_after_s = retry_after_s


class Pool:
    """A bounded number of threads with a bounded queue before them.

    Parameters
    ----------
    threads
        How many computations run at a time.
    waiting
        How many more are taken.
    timeout_s
        How long one may take, its time in the queue included.
    name
        What is done in the threads, as who is refused is told it.
    settings
        Those that the number of computations is set by.
    """

    def __init__(
        self,
        threads: int,
        waiting: int,
        timeout_s: float,
        *,
        name: str = "large computations",
        settings: str = "FRESNEL_THREADS, FRESNEL_MAX_WAITING",
    ) -> None:
        self._threads = threads
        self._executor = self._new_executor()
        self._most = threads + waiting
        self._timeout_s = timeout_s
        self._name = name
        self._settings = settings
        self._under_way: set[Future[Any]] = set()
        self._began: dict[int, float] = {}  # by thread

    def refusal(self) -> str | None:
        """Say why a computation would not be taken now, or not be done in time; None if it would."""
        if len(self._under_way) >= self._most:
            return self._full()
        began = list(self._began.values())  # other threads add to it and take from it
        if len(began) >= self._threads and monotonic() - max(began) > self._timeout_s:
            return f"all threads have been busy for {self._timeout_s:g} s (FRESNEL_TIMEOUT_S)"
        return None

    def close(self) -> None:
        """Drop what waits; what runs is left alone, and its thread ends with it."""
        self._executor.shutdown(wait=False, cancel_futures=True)
        self._executor = self._new_executor()  # for an application that is started again

    async def run(self, function: Callable[[], T], *, let_in: bool = False) -> T:
        """Call a function in a thread and wait for what it returns.

        Parameters
        ----------
        function
            The computation, or a part of one.
        let_in
            Whether it goes on with what was begun, and waits in however long a queue for however
            long: an answer is not cut in the middle because others have to be computed too.

        Raises
        ------
        Overloaded
            If the queue is full or the time is over. A computation that has begun is not
            interrupted: its thread is free again when it ends.
        """
        if len(self._under_way) >= self._most and not let_in:
            raise Overloaded(self._full())
        future = self._executor.submit(self._timed, function)
        self._under_way.add(future)
        future.add_done_callback(self._under_way.discard)
        try:
            timeout_s = None if let_in else self._timeout_s
            return await asyncio.wait_for(asyncio.wrap_future(future), timeout_s)
        except TimeoutError:
            limit = f"the computation took longer than {self._timeout_s:g} s (FRESNEL_TIMEOUT_S)"
            raise Overloaded(limit, retry_after_s=10) from None

    def _new_executor(self) -> ThreadPoolExecutor:
        return ThreadPoolExecutor(self._threads, thread_name_prefix="compute")

    def _full(self) -> str:
        return f"{self._most} {self._name} run or wait ({self._settings})"

    def _timed(self, function: Callable[[], T]) -> T:
        """Call a function, and note meanwhile since when."""
        thread = get_ident()
        self._began[thread] = monotonic()
        try:
            return function()
        finally:
            del self._began[thread]
